/*
 * gif_file.c - frames to an animated GIF.
 */
#include "gif_file.h"

#include <gif_lib.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "out_file.h"

#define COLORS 256

struct sheen_gif {
    GifFileType *file;
    FILE *stream; /* into bytes */
    char *bytes;
    size_t size;
    unsigned width, height, delay_cs;
    GifByteType *planes; /* red, green and blue of a frame, then its palette indices */
};

static int write_bytes(GifFileType *file, const GifByteType *bytes, int count)
{
    return (int)fwrite(bytes, 1, (size_t)count, file->UserData);
}

/* The extension by which a GIF asks to be repeated, 0 times meaning for ever. */
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
    made->planes = malloc((size_t)4 * width * height);
    made->stream = open_memstream(&made->bytes, &made->size);
    if (!made->planes || !made->stream)
        return SHEEN_ERR_MEMORY;
    made->file = EGifOpen(made->stream, write_bytes, NULL);
    if (!made->file)
        return SHEEN_ERR_MEMORY;
    EGifSetGifVersion(made->file, true);
    if (EGifPutScreenDesc(made->file, (int)width, (int)height, 8, 0, NULL) != GIF_OK || !put_repeat(made->file))
        return SHEEN_ERR_MEMORY;
    return SHEEN_OK;
}

/* Up to 256 colours into a palette in the order of appearance. How many there are, or 0 for more. */
static int exact_palette(const GifByteType *red, const GifByteType *green, const GifByteType *blue, size_t pixels,
                         GifByteType *index, GifColorType *palette)
{
    int count = 0, last = 0;

    for (size_t i = 0; i < pixels; i++) {
        GifColorType color = {red[i], green[i], blue[i]};
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

/* The frame's delay, then its palette and pixels. */
static int put_frame(const struct sheen_gif *gif, GifByteType *index, const GifColorType *palette)
{
    GraphicsControlBlock control = {.DelayTime = (int)gif->delay_cs, .TransparentColor = NO_TRANSPARENT_COLOR};
    GifByteType extension[4];
    ColorMapObject *map = GifMakeMapObject(COLORS, palette);
    size_t size = EGifGCBToExtension(&control, extension);
    int done = map && EGifPutExtension(gif->file, GRAPHICS_EXT_FUNC_CODE, (int)size, extension) == GIF_OK &&
               EGifPutImageDesc(gif->file, 0, 0, (int)gif->width, (int)gif->height, false, map) == GIF_OK;

    for (unsigned y = 0; done && y < gif->height; y++)
        done = EGifPutLine(gif->file, index + (size_t)y * gif->width, (int)gif->width) == GIF_OK;
    GifFreeMapObject(map);
    return done ? SHEEN_OK : SHEEN_ERR_MEMORY;
}

int sheen_gif_add(struct sheen_gif *gif, const uint8_t *rgb)
{
    size_t pixels = (size_t)gif->width * gif->height;
    GifByteType *red = gif->planes, *green = red + pixels, *blue = green + pixels, *index = blue + pixels;
    GifColorType palette[COLORS] = {{0, 0, 0}};
    int colors = COLORS;

    for (size_t i = 0; i < pixels; i++) {
        red[i] = rgb[3 * i];
        green[i] = rgb[3 * i + 1];
        blue[i] = rgb[3 * i + 2];
    }
    if (exact_palette(red, green, blue, pixels, index, palette) == 0 &&
        GifQuantizeBuffer(gif->width, gif->height, &colors, red, green, blue, index, palette) != GIF_OK)
        return SHEEN_ERR_MEMORY;
    return put_frame(gif, index, palette);
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
    free(gif->planes);
    free(gif);
}
