/*
 * gif_file.c - frames to an animated GIF.
 */
#include "gif_file.h"

#include <gif_lib.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "out_file.h"
#include "texels.h"

#define COLORS 256
#define VALUES 65536 /* of a 565 pixel */
#define ROUNDS 6     /* of k-means for a palette: .2 s for a frame of 10,000 colours; more make no visible difference */

struct sheen_gif {
    GifFileType *file;
    FILE *stream; /* writes to bytes */
    char *bytes;
    size_t size;
    unsigned width, height, delay_cs;
    GifByteType *index;                   /* per pixel of a frame, its index into the palette */
    struct sheen_histogram_color *colors; /* room for VALUES colours */
    uint32_t *counts;                     /* per 565 value: its pixels, later its palette index */
};

static int write_bytes(GifFileType *file, const GifByteType *bytes, int count)
{
    return (int)fwrite(bytes, 1, (size_t)count, file->UserData);
}

/* The extension that makes a GIF repeat; a count of 0 means for ever. */
static int put_repeat(GifFileType *file)
{
    static const GifByteType forever[3] = {1, 0, 0};

    return EGifPutExtensionLeader(file, APPLICATION_EXT_FUNC_CODE) == GIF_OK &&
           EGifPutExtensionBlock(file, 11, "NETSCAPE2.0") == GIF_OK &&
           EGifPutExtensionBlock(file, sizeof forever, forever) == GIF_OK && EGifPutExtensionTrailer(file) == GIF_OK;
}

int sheen_gif_open(struct sheen_gif **gif, unsigned width, unsigned height, unsigned delay_cs)
{
    struct sheen_gif *made = *gif = calloc(1, sizeof *made);

    if (!made)
        return SHEEN_ERR_MEMORY;
    made->width = width;
    made->height = height;
    made->delay_cs = delay_cs;
    made->index = malloc((size_t)width * height);
    made->colors = malloc(VALUES * sizeof *made->colors);
    made->counts = malloc(VALUES * sizeof *made->counts);
    made->stream = open_memstream(&made->bytes, &made->size);
    if (!made->index || !made->colors || !made->counts || !made->stream)
        return SHEEN_ERR_MEMORY;
    made->file = EGifOpen(made->stream, write_bytes, NULL);
    if (!made->file)
        return SHEEN_ERR_MEMORY;
    EGifSetGifVersion(made->file, true);
    if (EGifPutScreenDesc(made->file, (int)width, (int)height, 8, 0, NULL) != GIF_OK || !put_repeat(made->file))
        return SHEEN_ERR_MEMORY;
    return SHEEN_OK;
}

/* Puts up to 256 colours into a palette in the order of appearance. Returns their number, or 0 if there are more. */
static int exact_palette(const uint8_t *rgb, size_t pixels, GifByteType *index, GifColorType *palette)
{
    int count = 0, last = 0;

    for (size_t i = 0; i < pixels; i++) {
        GifColorType color = {rgb[3 * i], rgb[3 * i + 1], rgb[3 * i + 2]};
        if (count == 0 || memcmp(&palette[last], &color, sizeof color) != 0) {
            for (last = 0; last < count && memcmp(&palette[last], &color, sizeof color) != 0; last++)
                ;
            if (last == COLORS)
                return 0;
            if (last == count)
                palette[count++] = color;
        }
        index[i] = (GifByteType)last;
    }
    return count;
}

/* Collects the frame's 565 values in ascending order, each with its number of pixels. Returns how many there are. */
static size_t histogram(const struct sheen_gif *gif, const uint8_t *rgb, size_t pixels)
{
    size_t different = 0;

    memset(gif->counts, 0, VALUES * sizeof *gif->counts);
    for (size_t i = 0; i < pixels; i++)
        gif->counts[sheen_to_565(rgb + 3 * i)]++;
    for (uint32_t value = 0; value < VALUES; value++)
        if (gif->counts[value] > 0)
            gif->colors[different++] =
                (struct sheen_histogram_color){.value = (uint16_t)value, .count = gif->counts[value]};
    return different;
}

/* A 565 value in 8 bits per channel as in the panels' pictures: its upper bits are repeated in the low ones. */
static GifColorType shown(uint16_t value)
{
    unsigned r = value >> 11, g = value >> 5 & 63, b = value & 31;

    return (GifColorType){(GifByteType)(r << 3 | r >> 2), (GifByteType)(g << 2 | g >> 4),
                          (GifByteType)(b << 3 | b >> 2)};
}

/* For a frame of more than 256 colours: a palette of 256 that a 565 panel can show. 0, or SHEEN_ERR_MEMORY. */
static int near_palette(const struct sheen_gif *gif, const uint8_t *rgb, size_t pixels, GifColorType *palette)
{
    size_t different = histogram(gif, rgb, pixels);
    uint16_t values[COLORS];
    uint32_t count = 0, k;
    int error = sheen_palette_choose(gif->colors, different, COLORS, ROUNDS);

    for (size_t i = 0; !error && i < different; i++) {
        for (k = 0; k < count && values[k] != gif->colors[i].chosen; k++)
            ;
        if (k == count)
            values[count++] = gif->colors[i].chosen;
        gif->counts[gif->colors[i].value] = k;
    }
    for (k = 0; k < count; k++)
        palette[k] = shown(values[k]);
    for (size_t i = 0; !error && i < pixels; i++)
        gif->index[i] = (GifByteType)gif->counts[sheen_to_565(rgb + 3 * i)];
    return error;
}

/* Writes the frame's delay, then its palette and pixels. */
static int put_frame(const struct sheen_gif *gif, const GifColorType *palette)
{
    GraphicsControlBlock control = {.DelayTime = (int)gif->delay_cs, .TransparentColor = NO_TRANSPARENT_COLOR};
    GifByteType extension[4];
    ColorMapObject *map = GifMakeMapObject(COLORS, palette);
    size_t size = EGifGCBToExtension(&control, extension);
    int done = map && EGifPutExtension(gif->file, GRAPHICS_EXT_FUNC_CODE, (int)size, extension) == GIF_OK &&
               EGifPutImageDesc(gif->file, 0, 0, (int)gif->width, (int)gif->height, false, map) == GIF_OK;

    for (unsigned y = 0; done && y < gif->height; y++)
        done = EGifPutLine(gif->file, gif->index + (size_t)y * gif->width, (int)gif->width) == GIF_OK;
    GifFreeMapObject(map);
    return done ? SHEEN_OK : SHEEN_ERR_MEMORY;
}

int sheen_gif_add(struct sheen_gif *gif, const uint8_t *rgb)
{
    size_t pixels = (size_t)gif->width * gif->height;
    GifColorType palette[COLORS] = {{0, 0, 0}};

    if (exact_palette(rgb, pixels, gif->index, palette) == 0 && near_palette(gif, rgb, pixels, palette) != SHEEN_OK)
        return SHEEN_ERR_MEMORY;
    return put_frame(gif, palette);
}

int sheen_gif_write(struct sheen_gif *gif, const char *path, struct sheen_problem *problem)
{
    int closed = EGifCloseFile(gif->file, NULL) == GIF_OK;

    gif->file = NULL;
    if (!closed || fflush(gif->stream) != 0)
        return sheen_problem(problem, SHEEN_ERR_MEMORY, "%s: not enough memory", path);
    return sheen_out_file(path, gif->bytes, gif->size, problem);
}

void sheen_gif_close(struct sheen_gif *gif)
{
    if (!gif)
        return;
    if (gif->file)
        EGifCloseFile(gif->file, NULL);
    if (gif->stream)
        fclose(gif->stream);
    free(gif->bytes);
    free(gif->index);
    free(gif->colors);
    free(gif->counts);
    free(gif);
}
