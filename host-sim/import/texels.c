/*
 * texels.c - converts a picture to the core's texels.
 */
#include "texels.h"

#include <stdlib.h>
#include <string.h>

enum {
    VALUES = 65536,
    STRUCT_BYTES = 20 /* struct sheen_texture with 32-bit pointers */
};

/* round(x) = floor(x + 1/2). */
static unsigned rounded(unsigned byte, unsigned most)
{
    return (2 * byte * most + 255) / 510;
}

uint16_t sheen_to_565(const uint8_t rgb[3])
{
    return (uint16_t)(rounded(rgb[0], 31) << 11 | rounded(rgb[1], 63) << 5 | rounded(rgb[2], 31));
}

void sheen_from_565(uint16_t value, uint8_t rgb[3])
{
    rgb[0] = (uint8_t)((510 * (value >> 11) + 31) / 62);
    rgb[1] = (uint8_t)((510 * (value >> 5 & 63) + 63) / 126);
    rgb[2] = (uint8_t)((510 * (value & 31) + 31) / 62);
}

/* Whether alpha / 255 is below the cut-off. */
static int is_transparent(const struct sheen_picture *picture, size_t texel)
{
    return picture->rgba[4 * texel + 3] / 255.0 < picture->cutoff;
}

/* How many opaque texels have each value. Returns how many are transparent. */
static size_t count_values(const struct sheen_picture *picture, const uint16_t *values, size_t count, uint32_t *counts)
{
    size_t transparent = 0;

    for (size_t i = 0; i < count; i++) {
        if (is_transparent(picture, i))
            transparent++;
        else
            counts[values[i]]++;
    }
    return transparent;
}

/* ---- the key ---- */

/* Takes the first free value as the key. If none is free, frees the rarest: its texels take a neighbouring value. */
static void make_key(struct sheen_texels *texels, const struct sheen_picture *picture, uint32_t *counts, size_t count)
{
    uint32_t key = 0;

    for (uint32_t value = 0; value < VALUES && counts[key] > 0; value++) {
        if (counts[value] < counts[key])
            key = value;
    }
    for (size_t i = 0; i < count; i++) {
        if (is_transparent(picture, i))
            texels->values[i] = (uint16_t)key;
        else if (texels->values[i] == key)
            texels->values[i] = (uint16_t)(key ^ 1);
    }
    counts[key ^ 1] += counts[key];
    counts[key] = 0;
    texels->texture.keyed = 1;
    texels->texture.key = (uint16_t)key;
}

/* ---- the palette ---- */

/* number[value] is the value's index in the palette. */
static int set_palette(struct sheen_texels *texels, const uint16_t *chosen, size_t count, const uint32_t *counts)
{
    uint8_t *is_used = calloc(VALUES, 1), *number = calloc(VALUES, 1);

    texels->indices = malloc(count);
    texels->palette = malloc(256 * sizeof *texels->palette);
    if (is_used && number && texels->indices && texels->palette) {
        for (uint32_t value = 0; value < VALUES; value++)
            is_used[chosen[value]] |= counts[value] > 0;
        if (texels->texture.keyed)
            is_used[texels->texture.key] = 1;
        for (uint32_t value = 0; value < VALUES; value++) {
            if (is_used[value]) {
                number[value] = (uint8_t)texels->colors;
                texels->palette[texels->colors++] = (uint16_t)value;
            }
        }
        for (size_t i = 0; i < count; i++) {
            texels->values[i] = chosen[texels->values[i]];
            texels->indices[i] = number[texels->values[i]];
        }
    }
    free(is_used);
    free(number);
    return texels->colors ? SHEEN_OK : SHEEN_ERR_MEMORY;
}

/* An opaque value that the quantiser made equal to the key becomes the key's neighbour. */
static void spread(const struct sheen_histogram_color *colors, size_t count, const struct sheen_texels *texels,
                   uint16_t *chosen)
{
    for (size_t i = 0; i < count; i++) {
        uint16_t value = colors[i].chosen;
        chosen[colors[i].value] = texels->texture.keyed && value == texels->texture.key ? value ^ 1 : value;
    }
}

static int make_palette(struct sheen_texels *texels, const uint32_t *counts, size_t count, unsigned most)
{
    struct sheen_histogram_color *colors = malloc(VALUES * sizeof *colors);
    uint16_t *chosen = malloc(VALUES * sizeof *chosen);
    size_t different = 0;
    int error = colors && chosen ? SHEEN_OK : SHEEN_ERR_MEMORY;

    for (uint32_t value = 0; !error && value < VALUES; value++) {
        chosen[value] = (uint16_t)value;
        if (counts[value])
            colors[different++] = (struct sheen_histogram_color){(uint16_t)value, counts[value], (uint16_t)value};
    }
    if (!error && texels->texture.keyed)
        most--;
    if (!error && different > most) {
        error = sheen_palette_choose(colors, different, most, SHEEN_PALETTE_ROUNDS);
        spread(colors, different, texels, chosen);
    }
    if (!error)
        error = set_palette(texels, chosen, count, counts);
    free(colors);
    free(chosen);
    return error;
}

/* Packs two indices per byte, the left one in the low bits, in place. */
static void pack(uint8_t *indices, size_t count)
{
    for (size_t i = 0; i < count; i += 2)
        indices[i / 2] = (uint8_t)(indices[i] | (i + 1 < count ? indices[i + 1] << 4 : 0));
}

static uint8_t log2_of(unsigned side)
{
    uint8_t log2 = 0;

    while (side >> log2 > 1)
        log2++;
    return log2;
}

static void set_texture(struct sheen_texels *texels, const struct sheen_picture *picture, size_t count, int bilinear)
{
    struct sheen_texture *texture = &texels->texture;

    texture->texels = texels->indices ? (const void *)texels->indices : texels->values;
    texture->palette = texels->palette;
    texture->bits = !texels->indices ? 16 : texels->colors <= 16 ? 4 : 8;
    if (texture->bits == 4)
        pack(texels->indices, count);
    texture->width_log2 = log2_of(picture->size[0]);
    texture->height_log2 = log2_of(picture->size[1]);
    texture->clamp_u = picture->wrap[0] == SHEEN_WRAP_CLAMP;
    texture->clamp_v = picture->wrap[1] == SHEEN_WRAP_CLAMP;
    texture->bilinear = bilinear != 0;
}

size_t sheen_texels_bytes(const struct sheen_texels *texels)
{
    const struct sheen_texture *texture = &texels->texture;
    size_t count = (size_t)1 << (texture->width_log2 + texture->height_log2);

    return STRUCT_BYTES + (count * texture->bits + 7) / 8 + 2 * texels->colors;
}

int sheen_texels_make(struct sheen_texels *texels, const struct sheen_picture *picture, unsigned colors, int bilinear)
{
    size_t count = (size_t)picture->size[0] * picture->size[1];
    uint32_t *counts = calloc(VALUES, sizeof *counts);
    int error = SHEEN_ERR_MEMORY;

    memset(texels, 0, sizeof *texels);
    texels->values = malloc(count * sizeof *texels->values);
    if (counts && texels->values) {
        for (size_t i = 0; i < count; i++)
            texels->values[i] = sheen_to_565(picture->rgba + 4 * i);
        if (count_values(picture, texels->values, count, counts) > 0)
            make_key(texels, picture, counts, count);
        error = colors ? make_palette(texels, counts, count, colors) : SHEEN_OK;
        if (!error)
            set_texture(texels, picture, count, bilinear);
    }
    free(counts);
    return error;
}

void sheen_texels_free(struct sheen_texels *texels)
{
    free(texels->values);
    free(texels->indices);
    free(texels->palette);
    memset(texels, 0, sizeof *texels);
}
