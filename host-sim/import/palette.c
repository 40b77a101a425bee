/*
 * palette.c - chooses few values for many colours: cuts boxes at their median, then assigns every colour to the nearest
 * mean and recomputes the means until none moves.
 *
 * It computes in whole numbers, bytes of colour and means in 1/16, so that the result is the same on every machine.
 */
#include <stdlib.h>

#include "texels.h"

#define ONE 16

/* The colours colors[first .. first + count - 1]. */
struct box {
    size_t first, count;
    uint64_t spread; /* squared distance from the mean along `axis`, summed over the texels; 0: do not cut */
    int axis;
};

struct mean {
    int32_t at[3]; /* bytes in 1/ONE */
};

static int compare_along(const void *a, const void *b, int axis)
{
    const struct sheen_histogram_color *x = a, *y = b;
    uint8_t p[3], q[3];

    sheen_from_565(x->value, p);
    sheen_from_565(y->value, q);
    return p[axis] != q[axis] ? p[axis] - q[axis] : x->value - y->value;
}

static int compare_red(const void *a, const void *b)
{
    return compare_along(a, b, 0);
}

static int compare_green(const void *a, const void *b)
{
    return compare_along(a, b, 1);
}

static int compare_blue(const void *a, const void *b)
{
    return compare_along(a, b, 2);
}

/* Sums of bytes and of their squares fit: fewer than 2^18 texels, whose squares are below 2^16. */
static void measure(struct box *box, const struct sheen_histogram_color *colors)
{
    uint64_t sum[3] = {0, 0, 0}, squares[3] = {0, 0, 0}, texels = 0;

    for (size_t i = box->first; i < box->first + box->count; i++) {
        uint8_t rgb[3];
        sheen_from_565(colors[i].value, rgb);
        for (int k = 0; k < 3; k++) {
            sum[k] += (uint64_t)rgb[k] * colors[i].count;
            squares[k] += (uint64_t)rgb[k] * rgb[k] * colors[i].count;
        }
        texels += colors[i].count;
    }
    box->spread = 0;
    for (int k = 0; k < 3; k++) {
        uint64_t spread = (squares[k] * texels - sum[k] * sum[k]) / texels; /* below 2^52 */
        if (spread > box->spread) {
            box->spread = spread;
            box->axis = k;
        }
    }
}

/* Keeps half of the box's texels, as nearly as possible, and moves the others to *other. */
static void cut(struct box *box, struct box *other, struct sheen_histogram_color *colors)
{
    static int (*const compare[3])(const void *, const void *) = {compare_red, compare_green, compare_blue};
    uint64_t texels = 0, so_far = 0;
    size_t kept = 0;

    qsort(colors + box->first, box->count, sizeof *colors, compare[box->axis]);
    for (size_t i = 0; i < box->count; i++)
        texels += colors[box->first + i].count;
    do {
        so_far += colors[box->first + kept++].count;
    } while (kept + 1 < box->count && 2 * so_far < texels);
    *other = (struct box){.first = box->first + kept, .count = box->count - kept};
    box->count = kept;
    measure(box, colors);
    measure(other, colors);
}

static size_t cut_all(struct box *boxes, unsigned most, struct sheen_histogram_color *colors, size_t count)
{
    size_t made = 1;

    boxes[0] = (struct box){.first = 0, .count = count};
    measure(&boxes[0], colors);
    while (made < most) {
        size_t widest = 0;
        for (size_t i = 1; i < made; i++)
            widest = boxes[i].spread > boxes[widest].spread ? i : widest;
        if (boxes[widest].spread == 0)
            break;
        cut(&boxes[widest], &boxes[made++], colors);
    }
    return made;
}

/* ---- means ---- */

static size_t nearest(const struct mean *means, size_t count, const uint8_t rgb[3])
{
    size_t best = 0;
    int32_t least = INT32_MAX;

    for (size_t m = 0; m < count; m++) {
        int32_t distance = 0; /* below 2^26 */
        for (int k = 0; k < 3; k++) {
            int32_t d = rgb[k] * ONE - means[m].at[k];
            distance += d * d;
        }
        if (distance < least) {
            least = distance;
            best = m;
        }
    }
    return best;
}

/* Returns 1 if any mean has moved. A mean to which no colour is nearest stays where it is. */
static int move_means(struct mean *means, size_t count, const struct sheen_histogram_color *colors, size_t color_count)
{
    uint64_t sums[256][4] = {{0}};
    int moved = 0;

    for (size_t i = 0; i < color_count; i++) {
        uint8_t rgb[3];
        sheen_from_565(colors[i].value, rgb);
        uint64_t *sum = sums[nearest(means, count, rgb)];
        for (int k = 0; k < 3; k++)
            sum[k] += (uint64_t)rgb[k] * colors[i].count;
        sum[3] += colors[i].count;
    }
    for (size_t m = 0; m < count; m++) {
        for (int k = 0; sums[m][3] && k < 3; k++) {
            int32_t at = (int32_t)((sums[m][k] * ONE + sums[m][3] / 2) / sums[m][3]);
            moved |= at != means[m].at[k];
            means[m].at[k] = at;
        }
    }
    return moved;
}

static void begin_means(struct mean *means, const struct box *boxes, size_t count,
                        const struct sheen_histogram_color *colors)
{
    for (size_t m = 0; m < count; m++) {
        uint64_t sum[4] = {0, 0, 0, 0};
        for (size_t i = boxes[m].first; i < boxes[m].first + boxes[m].count; i++) {
            uint8_t rgb[3];
            sheen_from_565(colors[i].value, rgb);
            for (int k = 0; k < 3; k++)
                sum[k] += (uint64_t)rgb[k] * colors[i].count;
            sum[3] += colors[i].count;
        }
        for (int k = 0; k < 3; k++)
            means[m].at[k] = (int32_t)((sum[k] * ONE + sum[3] / 2) / sum[3]);
    }
}

int sheen_palette_choose(struct sheen_histogram_color *colors, size_t count, unsigned most, int rounds)
{
    struct box *boxes = malloc(most * sizeof *boxes);
    struct mean means[256];

    if (!boxes)
        return SHEEN_ERR_MEMORY;
    size_t made = cut_all(boxes, most, colors, count);
    begin_means(means, boxes, made, colors);
    for (int round = 0; round < rounds && move_means(means, made, colors, count); round++)
        ;
    for (size_t i = 0; i < count; i++) {
        uint8_t rgb[3];
        sheen_from_565(colors[i].value, rgb);
        const struct mean *mean = &means[nearest(means, made, rgb)];
        for (int k = 0; k < 3; k++)
            rgb[k] = (uint8_t)((mean->at[k] + ONE / 2) / ONE);
        colors[i].chosen = sheen_to_565(rgb);
    }
    free(boxes);
    return SHEEN_OK;
}
