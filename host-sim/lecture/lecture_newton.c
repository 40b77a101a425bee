/*
 * lecture_newton.c - Newton's root: each step doubles the number of correct digits. The core starts from a seed
 * in a table, so that one step is enough; a 565 pixel needs none.
 */
#include <math.h>

#include "lecture.h"
#include "math/newton.h"

#define STEPS 6
#define BINS 96    /* intervals that D in [1/4, 1) is divided into */
#define SAMPLES 64 /* per bin */
#define MOST_BITS 36.0

/* The number of correct bits of a value that should be 1, at most 52. */
static double bits_of(double ratio)
{
    double off = fabs(ratio - 1);

    return off > 0 ? fmin(-log2(off), 52) : 52;
}

/* The lecture's x - (x^2 - D) / 2x, started at x = 1; bits[i]: correct bits after i steps. */
static void lecture_steps(double d, double *bits)
{
    double x = 1;

    for (int i = 0; i <= STEPS; i++) {
        bits[i] = bits_of(x / sqrt(d));
        x -= (x * x - d) / (2 * x);
    }
}

/* Fewest correct bits of the core's 1/sqrt(D), per bin and over all bins: of the table's seed and after the step. */
struct core_bits {
    double d[BINS], seed[BINS], step[BINS], worst_seed, worst_step;
};

static void core_steps(struct core_bits *core)
{
    core->worst_seed = core->worst_step = 52;
    for (int bin = 0; bin < BINS; bin++) {
        core->d[bin] = 0.25 + 0.75 * (bin + 0.5) / BINS;
        core->seed[bin] = core->step[bin] = 52;
        for (int i = 0; i < SAMPLES; i++) {
            /* UQ0.32; the 0.37 keeps samples off the D of the table's entries */
            uint32_t x = (uint32_t)((0.25 + 0.75 * (bin + (i + 0.37) / SAMPLES) / BINS) * 4294967296.0);
            double root = sqrt(x / 4294967296.0);
            core->seed[bin] = fmin(core->seed[bin], bits_of(root_seed(x >> 1) / 32768.0 * root));
            core->step[bin] =
                fmin(core->step[bin], bits_of(sheen_root_step(x, root_seed(x >> 1) << 16) / 2147483648.0 * root));
        }
        core->worst_seed = fmin(core->worst_seed, core->seed[bin]);
        core->worst_step = fmin(core->worst_step, core->step[bin]);
    }
}

static void draw_steps(struct sheen_page *page, const struct core_bits *core)
{
    static const double d[3] = {0.25, 0.5, 0.75};
    struct sheen_axes axes = {76, 128, 340, 240, 0, STEPS, 0, MOST_BITS};
    double x[STEPS + 1], bits[STEPS + 1], ours[2] = {core->worst_seed, core->worst_step};

    for (int i = 0; i <= STEPS; i++)
        x[i] = i;
    sheen_page_axes(page, &axes, 1, 0, 6, 0);
    sheen_page_axis_names(page, &axes, "Newton steps", "bits that are right");
    for (int k = 0; k < 3; k++) {
        lecture_steps(d[k], bits);
        sheen_page_curve(page, &axes, SHEEN_INK_FLAT, 1.8, x, bits, STEPS + 1);
        for (int i = 0; i <= STEPS && bits[i] <= MOST_BITS; i++)
            sheen_page_dot(page, &axes, SHEEN_INK_FLAT, x[i], bits[i]);
        if (k == 0)
            sheen_page_number(page, 36, 480, SHEEN_INK_FLAT,
                              "begun at 1, D = 1/4: %.1f, %.1f, %.1f, %.1f, %.1f bits after 1 to 5 steps", bits[1],
                              bits[2], bits[3], bits[4], bits[5]);
    }
    sheen_page_curve(page, &axes, SHEEN_INK_PHONG, 2.6, x, ours, 2);
    sheen_page_dot(page, &axes, SHEEN_INK_PHONG, 0, ours[0]);
    sheen_page_dot(page, &axes, SHEEN_INK_PHONG, 1, ours[1]);
    sheen_page_text(page, 144, 160, SHEEN_LEFT, SHEEN_INK_PHONG, "the core:");
    sheen_page_text(page, 144, 182, SHEEN_LEFT, SHEEN_INK_PHONG, "one step");
    sheen_page_text(page, 278, 318, SHEEN_LEFT, SHEEN_INK_FLAT, "begun at 1, with");
    sheen_page_text(page, 278, 340, SHEEN_LEFT, SHEEN_INK_FLAT, "D = 3/4, 1/2, 1/4");
    page->heart = (struct sheen_box){36, 104, 436, 420};
}

int sheen_lecture_newton(struct sheen_page *page)
{
    static struct core_bits core;
    struct sheen_axes axes = {552, 128, 410, 240, 0.25, 1, 0, MOST_BITS};

    core_steps(&core);
    sheen_page_title(page, "Newton's root",
                     "The root of D that a normal's length needs, by Newton's method: x - (x² - D) / 2x.");
    sheen_page_caption(page,
                       "Every step doubles the bits that are right (grey). The core looks its first guess up in a "
                       "table: good enough for a pixel as it is, and after one step for all else (blue).");
    draw_steps(page, &core);
    sheen_page_axes(page, &axes, 0.25, 2, 6, 0);
    sheen_page_axis_names(page, &axes, "D", "bits of 1/√D that are right at least, in the core");
    sheen_page_curve(page, &axes, SHEEN_INK_FLAT, 1.8, core.d, core.seed, BINS);
    sheen_page_curve(page, &axes, SHEEN_INK_PHONG, 1.8, core.d, core.step, BINS);
    sheen_page_text(page, 757, 300, SHEEN_CENTRE, SHEEN_INK_FLAT, "the table's seed");
    sheen_page_text(page, 757, 202, SHEEN_CENTRE, SHEEN_INK_PHONG, "after one step");
    sheen_page_number(page, 36, 506, SHEEN_INK_FLAT, "the table's seed: %.1f bits at least (a panel shows 5 to 8)",
                      core.worst_seed);
    sheen_page_number(page, 36, 532, SHEEN_INK_PHONG, "after one step, in integers: %.1f bits at least",
                      core.worst_step);
    return SHEEN_OK;
}
