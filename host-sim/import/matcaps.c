/*
 * matcaps.c - matcaps by name, or from a picture's file.
 */
#include "matcaps.h"

#include <stdlib.h>
#include <string.h>

#include "mesh_file.h"

/* The core's matcap of this name, or NULL. */
static const struct sheen_texture *own_of(const char *name)
{
    static const struct {
        const char *name;
        const struct sheen_texture *texture;
    } own[] = {{"glaze", &sheen_matcap_glaze},
               {"chrome", &sheen_matcap_chrome},
               {"clay", &sheen_matcap_clay},
               {"jade", &sheen_matcap_jade}};

    for (size_t i = 0; i < sizeof own / sizeof own[0]; i++) {
        if (strcmp(own[i].name, name) == 0)
            return own[i].texture;
    }
    return NULL;
}

/* Makes a picture of a matcap of the core; converting it back gives the same texels. */
static int picture_of(struct sheen_picture *picture, const struct sheen_texture *texture)
{
    const uint16_t *texels = texture->texels;
    const size_t count = (size_t)1 << (texture->width_log2 + texture->height_log2);

    *picture =
        (struct sheen_picture){.wrap = {SHEEN_WRAP_CLAMP, SHEEN_WRAP_CLAMP},
                               .size = {(uint16_t)(1u << texture->width_log2), (uint16_t)(1u << texture->height_log2)},
                               .rgba = malloc(4 * count)};
    if (!picture->rgba)
        return SHEEN_ERR_MEMORY;
    for (size_t i = 0; i < count; i++) {
        sheen_from_565(texels[i], picture->rgba + 4 * i);
        picture->rgba[4 * i + 3] = 255;
    }
    return SHEEN_OK;
}

int sheen_matcap_load(struct sheen_texels *texels, const char *name, unsigned colors, int bilinear,
                      struct sheen_problem *problem)
{
    const struct sheen_texture *own = own_of(name);
    struct sheen_picture picture = {.name = NULL};
    int error =
        own ? picture_of(&picture, own) : sheen_picture_file_read(&picture, name, SHEEN_MATCAP_LARGEST, problem);

    memset(texels, 0, sizeof *texels);
    if (!error) {
        error = sheen_texels_make(texels, &picture, colors, bilinear);
        if (error)
            sheen_problem(problem, error, "%s: not enough memory", name);
    }
    sheen_picture_free(&picture);
    return error;
}
