/*
 * web_picture.c - PNG and JPEG in the page, with stb_image, because libpng and libjpeg return from their errors by
 * longjmp, which WebAssembly as Debian's clang makes it does not have.
 *
 * PNGs give the same pixels as in the command. In a JPEG a channel may be a few steps off, and a JPEG whose data end
 * before its end mark is shown as far as it goes, whereas the command refuses it.
 */
#include <stdlib.h>
#include <string.h>

#define STBI_ONLY_PNG
#define STBI_ONLY_JPEG
#define STBI_NO_STDIO
#define STBI_NO_LINEAR
#define STBI_NO_HDR
#define STBI_NO_THREAD_LOCALS
#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#include "stb_image.h"

#include "picture.h"

/* ---- faults that stb_image does not report ---- */

static uint32_t word_of(const unsigned char *at)
{
    return (uint32_t)at[0] << 24 | (uint32_t)at[1] << 16 | (uint32_t)at[2] << 8 | at[3];
}

static uint32_t checksum(const unsigned char *bytes, size_t count)
{
    uint32_t sum = 0xffffffffu;

    for (size_t i = 0; i < count; i++) {
        sum ^= bytes[i];
        for (int bit = 0; bit < 8; bit++)
            sum = sum >> 1 ^ (0xedb88320u & -(sum & 1));
    }
    return ~sum;
}

/* Checks a file chunk by chunk to its end (PNG, 5.3). Returns what is wrong, or NULL. */
static const char *png_fault(const unsigned char *bytes, size_t count)
{
    size_t at = 8;

    while (count - at >= 12) {
        uint32_t size = word_of(bytes + at);
        if (size > count - at - 12)
            break;
        if (checksum(bytes + at + 4, size + 4) != word_of(bytes + at + 8 + size))
            return "CRC error";
        if (memcmp(bytes + at + 4, "IEND", 4) == 0)
            return NULL;
        at += size + 12;
    }
    return "it ends too early";
}

/* ---- pixels ---- */

/* Reads 16 bits per channel and rounds them to the nearest 8-bit value; 4 channels per pixel. */
static stbi_uc *read_wide(const unsigned char *bytes, size_t count)
{
    int width, height, had;
    stbi_us *wide = stbi_load_16_from_memory(bytes, (int)count, &width, &height, &had, 4);
    stbi_uc *narrow = (stbi_uc *)wide;

    for (size_t i = 0; wide && i < 4 * (size_t)width * (size_t)height; i++)
        narrow[i] = (stbi_uc)((wide[i] * 255u + 32895u) >> 16);
    return narrow;
}

static int reduce(struct sheen_reducing *reducing, const unsigned char *bytes, size_t count, const char *kind,
                  const char *name, struct sheen_problem *problem)
{
    int width, height, had;
    stbi_uc *pixels = stbi_is_16_bit_from_memory(bytes, (int)count)
                          ? read_wide(bytes, count)
                          : stbi_load_from_memory(bytes, (int)count, &width, &height, &had, 4);

    if (!pixels)
        return sheen_problem(problem, SHEEN_ERR_ARGUMENT, "%s: a broken %s: %s", name, kind, stbi_failure_reason());
    for (unsigned y = 0; y < reducing->from[1]; y++)
        sheen_reducing_row(reducing, y, 0, 1, reducing->from[0], pixels + 4 * (size_t)reducing->from[0] * y, 4);
    stbi_image_free(pixels);
    return SHEEN_OK;
}

int sheen_png_reduce(struct sheen_reducing *reducing, const unsigned char *bytes, size_t count, const unsigned most[2],
                     const char *name, struct sheen_problem *problem)
{
    int has_size = count >= 24 && memcmp(bytes + 12, "IHDR", 4) == 0;
    int error = sheen_reducing_open(reducing, has_size ? word_of(bytes + 16) : 1, has_size ? word_of(bytes + 20) : 1,
                                    most, name, problem);
    const char *fault = error ? NULL : png_fault(bytes, count);

    if (fault)
        return sheen_problem(problem, SHEEN_ERR_ARGUMENT, "%s: a broken PNG: %s", name, fault);
    return error ? error : reduce(reducing, bytes, count, "PNG", name, problem);
}

int sheen_jpeg_reduce(struct sheen_reducing *reducing, const unsigned char *bytes, size_t count, const unsigned most[2],
                      const char *name, struct sheen_problem *problem)
{
    int width = 1, height = 1, had;

    stbi_info_from_memory(bytes, (int)count, &width, &height, &had);
    int error = sheen_reducing_open(reducing, (uint32_t)width, (uint32_t)height, most, name, problem);
    return error ? error : reduce(reducing, bytes, count, "JPEG", name, problem);
}
