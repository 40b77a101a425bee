/*
 * ref_pixel.c - an unrounded colour to what a panel's memory holds.
 */
#include "ref_vector.h"
#include "reference.h"

static double clamp01(double c)
{
    return c < 0 ? 0 : c > 1 ? 1 : c;
}

/* B(x, y): row y, column x of B8, built by B2n = [[4 B, 4 B + 2], [4 B + 3, 4 B + 1]] from B2 = [[0, 2], [3, 1]]. */
int ref_bayer8(int x, int y)
{
    static const int b2[2][2] = {{0, 2}, {3, 1}};
    int entry = 0;

    /* The innermost block is the low bit of x and y and carries the largest weight. */
    for (int bit = 0; bit < 3; bit++)
        entry = entry * 4 + b2[y >> bit & 1][x >> bit & 1];
    return entry;
}

static int to_level(double c, int max_level, bool dither, int x, int y)
{
    double up = dither ? (ref_bayer8(x & 7, y & 7) + 0.5) / 64 : 0.5;
    int level = (int)floor(max_level * clamp01(c) + up);

    return level > max_level ? max_level : level;
}

uint16_t ref_565(const double color[3])
{
    int r = to_level(color[0], 31, false, 0, 0);
    int g = to_level(color[1], 63, false, 0, 0);
    int b = to_level(color[2], 31, false, 0, 0);

    return (uint16_t)(r << 11 | g << 5 | b);
}

uint16_t ref_value(const struct ref_scene *scene, const double color[3], int x, int y, bool background)
{
    bool dither = scene->dither && !background;

    if (scene->levels) {
        double grey = 0.2126 * clamp01(color[0]) + 0.7152 * clamp01(color[1]) + 0.0722 * clamp01(color[2]);
        return (uint16_t)to_level(grey, scene->levels - 1, dither, x, y);
    }
    int r = to_level(color[0], 31, dither, x, y);
    int g = to_level(color[1], 63, dither, x, y);
    int b = to_level(color[2], 31, dither, x, y);
    return (uint16_t)(r << 11 | g << 5 | b);
}
