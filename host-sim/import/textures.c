/*
 * textures.c - chooses the textures of a mesh that are shown, and reads their pictures.
 */
#include "textures.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "mesh_bytes.h"
#include "picture.h"

static int no_memory(const char *name, struct sheen_problem *problem)
{
    return sheen_problem(problem, SHEEN_ERR_MEMORY, "%s: not enough memory", name);
}

static void drop_all(struct sheen_polygons *polygons)
{
    sheen_polygons_drop_pictures(polygons);
    free(polygons->uvs);
    polygons->uvs = NULL;
}

/* ---- which textures are shown ---- */

/* Shows one picture in all groups, with the wrapping and cut-off of the pictures that it replaces. */
static int replace(struct sheen_polygons *polygons, const char *file)
{
    struct sheen_picture *old = polygons->picture;
    size_t old_count = polygons->picture_count;
    int error = SHEEN_OK;

    polygons->picture = NULL;
    polygons->picture_count = 0;
    for (size_t g = 0; !error && g < polygons->group_count; g++) {
        struct sheen_picture picture = {.cutoff = .5};
        if (polygons->group[g].picture) {
            const struct sheen_picture *from = &old[polygons->group[g].picture - 1];
            picture.cutoff = from->cutoff;
            memcpy(picture.wrap, from->wrap, sizeof picture.wrap);
        }
        picture.name = strdup(file);
        polygons->group[g].picture = sheen_polygons_picture(polygons, &picture);
        error = polygons->group[g].picture ? SHEEN_OK : SHEEN_ERR_MEMORY;
    }
    for (size_t i = 0; i < old_count; i++)
        sheen_picture_free(&old[i]);
    free(old);
    return error;
}

static void override(struct sheen_polygons *polygons, const struct sheen_texture_options *options)
{
    for (size_t i = 0; i < polygons->picture_count; i++) {
        struct sheen_picture *picture = &polygons->picture[i];
        if (options->wrap != SHEEN_WRAP_OF_FILE)
            memset(picture->wrap, options->wrap == SHEEN_ALL_CLAMP ? SHEEN_WRAP_CLAMP : SHEEN_WRAP_REPEAT,
                   sizeof picture->wrap);
        if (options->cutoff >= 0)
            picture->cutoff = options->cutoff;
    }
}

/* Removes the pictures that no face shows, without reading them, and renumbers the others. */
static int keep_shown(struct sheen_polygons *polygons)
{
    uint32_t *number = calloc(polygons->picture_count + 1, sizeof *number), kept = 0; /* from 1; 0: not shown */
    struct sheen_picture *picture = polygons->picture;
    size_t count = polygons->picture_count;

    if (!number)
        return SHEEN_ERR_MEMORY;
    for (size_t p = 0; p < polygons->polygon_count; p++) {
        if (sheen_polygons_is_textured(polygons, p))
            number[polygons->group[polygons->groups[p]].picture] = 1;
    }
    for (size_t i = 0; i < count; i++) {
        if (!number[i + 1]) {
            sheen_picture_free(&picture[i]);
            continue;
        }
        picture[kept] = picture[i];
        number[i + 1] = ++kept;
    }
    polygons->picture_count = kept;
    for (size_t g = 0; g < polygons->group_count; g++)
        polygons->group[g].picture = number[polygons->group[g].picture];
    free(number);
    return SHEEN_OK;
}

/* ---- their pictures ---- */

/* Doubles the picture's width or height by appending its mirror image. */
static int unfold(struct sheen_image *image, int down)
{
    unsigned width = image->size[0], height = image->size[1], wide = down ? width : 2 * width;
    unsigned high = down ? 2 * height : height;
    uint8_t *rgba = malloc(4 * (size_t)wide * high);

    if (!rgba)
        return SHEEN_ERR_MEMORY;
    for (unsigned y = 0; y < high; y++) {
        for (unsigned x = 0; x < wide; x++) {
            unsigned from_x = x < width ? x : 2 * width - 1 - x, from_y = y < height ? y : 2 * height - 1 - y;
            memcpy(rgba + 4 * ((size_t)y * wide + x), image->rgba + 4 * ((size_t)from_y * width + from_x), 4);
        }
    }
    free(image->rgba);
    image->rgba = rgba;
    image->size[down] = (uint16_t)(2 * image->size[down]);
    return SHEEN_OK;
}

/*
 * Reads the picture from its bytes or its file. A mirrored picture is reduced before it is unfolded, to half the size:
 * each texel is the mean of the same area as if it were unfolded first.
 */
static int read_picture(struct sheen_picture *picture, const struct sheen_texture_options *options,
                        struct sheen_problem *problem)
{
    struct sheen_bytes file = {NULL, 0};
    struct sheen_image image;
    unsigned most[2];
    int error = picture->bytes ? SHEEN_OK : sheen_bytes_load(&file, picture->name, problem);

    for (int k = 0; k < 2; k++)
        most[k] = picture->wrap[k] == SHEEN_WRAP_MIRROR && options->most > 1 ? options->most / 2 : options->most;
    if (!error)
        error = sheen_image_read(&image, picture->bytes ? picture->bytes : file.bytes,
                                 picture->bytes ? picture->count : file.count, most, picture->name, problem);
    sheen_bytes_free(&file);
    if (!error && options->square && image.from[0] != image.from[1]) {
        free(image.rgba);
        return sheen_problem(problem, SHEEN_ERR_ARGUMENT, "%s: not square but %ux%u", picture->name, image.from[0],
                             image.from[1]);
    }
    for (int k = 0; !error && k < 2; k++) {
        if (picture->wrap[k] == SHEEN_WRAP_MIRROR && options->most > 1)
            error = unfold(&image, k);
        if (error)
            no_memory(picture->name, problem);
    }
    if (error)
        return error;
    picture->rgba = image.rgba;
    memcpy(picture->size, image.size, sizeof picture->size);
    return SHEEN_OK;
}

/* Frees what is no longer needed; a mirrored picture, now unfolded, repeats. */
static void settle(struct sheen_picture *picture)
{
    free(picture->name);
    free(picture->bytes);
    picture->name = NULL;
    picture->bytes = NULL;
    for (int k = 0; k < 2; k++)
        picture->wrap[k] = picture->wrap[k] == SHEEN_WRAP_CLAMP ? SHEEN_WRAP_CLAMP : SHEEN_WRAP_REPEAT;
}

/* ---- uv ---- */

/* The smallest and largest u and v of the faces that show a texture. */
struct span {
    double low[2], high[2];
};

/* Adds a face's uv to the span, halved first where the picture is doubled. */
static int take_uvs(struct sheen_polygons *polygons, size_t p, struct span *span, const char *name,
                    struct sheen_problem *problem)
{
    const struct sheen_picture *picture = &polygons->picture[polygons->group[polygons->groups[p]].picture - 1];

    for (uint32_t c = polygons->first[p]; c < polygons->first[p + 1]; c++) {
        for (int k = 0; k < 2; k++) {
            double *uv = &polygons->uvs[c][k];
            if (isinf(*uv))
                return sheen_problem(problem, SHEEN_ERR_ARGUMENT,
                                     "%s: face %zu has a texture coordinate that is not a finite number", name, p + 1);
            if (picture->wrap[k] == SHEEN_WRAP_MIRROR)
                *uv /= 2;
            span->low[k] = fmin(span->low[k], *uv);
            span->high[k] = fmax(span->high[k], *uv);
        }
    }
    return SHEEN_OK;
}

static int check_uvs(struct sheen_polygons *polygons, const char *name, struct sheen_problem *problem)
{
    struct span *spans = malloc((polygons->picture_count + 1) * sizeof *spans);
    int error = spans ? SHEEN_OK : no_memory(name, problem);

    for (size_t i = 0; !error && i < polygons->picture_count; i++)
        spans[i] = (struct span){{HUGE_VAL, HUGE_VAL}, {-HUGE_VAL, -HUGE_VAL}};
    for (size_t p = 0; !error && p < polygons->polygon_count; p++) {
        if (sheen_polygons_is_textured(polygons, p))
            error = take_uvs(polygons, p, &spans[polygons->group[polygons->groups[p]].picture - 1], name, problem);
    }
    for (size_t i = 0; !error && i < polygons->picture_count; i++) {
        for (int k = 0; !error && k < 2; k++) {
            double texels = (spans[i].high[k] - spans[i].low[k]) * polygons->picture[i].size[k];
            if (!(texels <= SHEEN_UV_SPAN))
                error = sheen_problem(problem, SHEEN_ERR_ARGUMENT,
                                      "%s: its texture coordinates span %.9g texels, at most %.0f can be drawn", name,
                                      ceil(texels), SHEEN_UV_SPAN);
        }
    }
    free(spans);
    return error;
}

/* Marks the uv of faces without a texture as missing, so that later steps ignore them. */
static void clear_others(struct sheen_polygons *polygons)
{
    for (size_t p = 0; polygons->uvs && p < polygons->polygon_count; p++) {
        if (sheen_polygons_is_textured(polygons, p))
            continue;
        for (uint32_t c = polygons->first[p]; c < polygons->first[p + 1]; c++)
            polygons->uvs[c][0] = polygons->uvs[c][1] = NAN;
    }
}

int sheen_textures_read(struct sheen_polygons *polygons, const struct sheen_texture_options *options, const char *name,
                        struct sheen_problem *problem)
{
    int error = SHEEN_OK;

    if (!options || options->most == 0) {
        drop_all(polygons);
        return SHEEN_OK;
    }
    if (options->file)
        error = replace(polygons, options->file);
    override(polygons, options);
    if (!error)
        error = keep_shown(polygons);
    if (error)
        return no_memory(name, problem);
    if (options->file && polygons->picture_count == 0)
        return sheen_problem(problem, SHEEN_ERR_ARGUMENT, "%s: has no texture coordinates for %s", name, options->file);
    for (size_t i = 0; !error && i < polygons->picture_count; i++)
        error = read_picture(&polygons->picture[i], options, problem);
    if (error == SHEEN_ERR_ARGUMENT && !options->file) {
        const struct sheen_problem why = *problem;
        return sheen_problem(problem, error, "%s; --texture off does without", why.text);
    }
    if (!error)
        error = check_uvs(polygons, name, problem);
    clear_others(polygons);
    for (size_t i = 0; i < polygons->picture_count; i++)
        settle(&polygons->picture[i]);
    if (!error && polygons->picture_count == 0)
        drop_all(polygons);
    return error;
}
