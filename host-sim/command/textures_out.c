/*
 * textures_out.c - --texture-out: textures as they are drawn.
 */
#include "textures_out.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "frame_name.h"
#include "png_file.h"

static int write_one(const char *path, const struct sheen_texels *texels, struct sheen_problem *problem)
{
    const struct sheen_texture *texture = &texels->texture;
    unsigned width = 1u << texture->width_log2, height = 1u << texture->height_log2;
    uint8_t *rgba = malloc(4 * (size_t)width * height);

    if (!rgba)
        return sheen_problem(problem, SHEEN_ERR_MEMORY, "%s: not enough memory", path);
    for (size_t i = 0; i < (size_t)width * height; i++) {
        sheen_from_565(texels->values[i], rgba + 4 * i);
        rgba[4 * i + 3] = texture->keyed && texels->values[i] == texture->key ? 0 : 255;
    }
    int error = sheen_png_write_rgba(path, rgba, width, height, problem);
    free(rgba);
    return error;
}

int sheen_textures_out_check(const struct sheen_options *options, struct sheen_problem *problem)
{
    const char *ending = options->texture_out ? sheen_ending(options->texture_out) : "";

    if (*ending && strcasecmp(ending, ".png") != 0)
        return sheen_problem(problem, SHEEN_ERR_ARGUMENT, "%s: no textures in %s are written, only .png",
                             options->texture_out, ending);
    if (options->texture_out && options->out && strcmp(options->texture_out, options->out) == 0)
        return sheen_problem(problem, SHEEN_ERR_ARGUMENT, "--texture-out and -o name the same file, %s", options->out);
    return SHEEN_OK;
}

int sheen_textures_out(const struct sheen_options *options, const struct sheen_texels *texels, size_t count,
                       struct sheen_problem *problem)
{
    const char *out = options->texture_out;
    int error = SHEEN_OK;

    if (!out)
        return SHEEN_OK;
    if (count == 0)
        return sheen_problem(problem, SHEEN_ERR_ARGUMENT, "%s: shows no texture for --texture-out", options->mesh);
    if (count > 1 && !sheen_frame_name_varies(out))
        return sheen_problem(problem, SHEEN_ERR_ARGUMENT, "%s: %zu textures need one %%d or %%0Nd in the name", out,
                             count);
    for (size_t i = 0; !error && i < count; i++) {
        char path[4096];
        error = sheen_frame_name(path, sizeof path, out, (int)i, count)
                    ? sheen_problem(problem, SHEEN_ERR_ARGUMENT, "%s: %s", out, strerror(ENAMETOOLONG))
                    : write_one(path, &texels[i], problem);
    }
    return error;
}
