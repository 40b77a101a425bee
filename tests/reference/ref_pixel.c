/*
 * ref_pixel.c - an unrounded colour to the value in a panel's memory.
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

/* c, clamped to 0..1, as a level: mixed with the fog's level by its share, plus `up`, rounded down, clamped. */
static int to_level(double c, int max_level, double fog_level, double share, double up)
{
    double fogged = max_level * clamp01(c) * (1 - share) + fog_level * share;
    int level = (int)(fogged + up); /* neither is negative */

    return level > max_level ? max_level : level;
}

uint16_t ref_565(const double color[3])
{
    int r = to_level(color[0], 31, 0, 0, 0.5);
    int g = to_level(color[1], 63, 0, 0, 0.5);
    int b = to_level(color[2], 31, 0, 0, 0.5);

    return (uint16_t)(r << 11 | g << 5 | b);
}

static double grey_of(const double color[3])
{
    return 0.2126 * clamp01(color[0]) + 0.7152 * clamp01(color[1]) + 0.0722 * clamp01(color[2]);
}

double ref_nearness(const struct ref_scene *scene, double m)
{
    const double near = scene->near, far = scene->far;

    return scene->ortho ? (far - m) / (far - near) : (1 / m - 1 / far) / (1 / near - 1 / far);
}

double ref_fog_share(const struct ref_scene *scene, double z)
{
    double from = scene->fog_from, to = scene->fog_to, near = scene->near, far = scene->far;
    double weight = 1 / far + z * (1 / near - 1 / far);

    if (!scene->fog)
        return 0;
    if (scene->ortho || scene->fog_in_m)
        return clamp01(((scene->ortho ? far - z * (far - near) : 1 / weight) - from) / (to - from));
    return clamp01((1 / from - weight) / (1 / from - 1 / to));
}

/* The dither threshold. Stippled draws use the matrix with the base-4 digits of its entries reversed. */
static double threshold(const struct ref_scene *scene, int x, int y)
{
    int b = ref_bayer8(x & 7, y & 7);

    if (!scene->dither)
        return 0.5;
    return ((scene->left_out > 0 ? 16 * (b % 4) + 4 * (b / 4 % 4) + b / 16 : b) + 0.5) / 64;
}

static uint16_t value(const struct ref_scene *scene, const double color[3], double share, double up)
{
    static const int most[3] = {31, 63, 31};
    const bool fog = share > 0;
    int level[3];

    if (scene->levels) {
        int fogged = fog ? to_level(grey_of(scene->fog_color), scene->levels - 1, 0, 0, 0.5) : 0;
        return (uint16_t)to_level(grey_of(color), scene->levels - 1, fogged, share, up);
    }
    for (int k = 0; k < 3; k++) {
        int fogged = fog ? to_level(scene->fog_color[k], most[k], 0, 0, 0.5) : 0;
        level[k] = to_level(color[k], most[k], fogged, share, up);
    }
    return (uint16_t)(level[0] << 11 | level[1] << 5 | level[2]);
}

uint16_t ref_fogged_value(const struct ref_scene *scene, const double color[3], double share, int x, int y)
{
    return value(scene, color, share, threshold(scene, x, y));
}

uint16_t ref_value(const struct ref_scene *scene, const double color[3], int x, int y, bool background)
{
    return value(scene, color, 0, background ? 0.5 : threshold(scene, x, y));
}
