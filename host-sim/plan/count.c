/*
 * count.c - what the core's taps count, by feature.
 */
#include "count.h"

#include <string.h>

#include "shading/phong.h"
#include "shading/slerp.h"
#include "taps.h"
#include "triangle/quadric.h"
#include "triangle/quotient.h"

#define LONG 2048 /* 1/64 px: where a processor that does not divide leaves the table of reciprocals (edge.c) */

uint32_t sheen_plan_counted[SHEEN_PLAN_COUNTS];
static struct sheen_plan_counts taken; /* of them by sheen_plan_counts_take */
static int is_new;                     /* the set-up that is drawn next has just been made */

/* ---- kinds of rows ---- */

enum {
    OF_SETUP,
    OF_ROW,
    OF_COVERED,
    OF_SHADED
};

static unsigned linear_kind(const struct tile *t, const struct setup *s)
{
    if (!s->fast)
        return t->format->grey ? SHEEN_PLAN_CLAMPED_GREY_SETUP : SHEEN_PLAN_CLAMPED_SETUP;
    return t->dither ? SHEEN_PLAN_COLUMNS_DITHERED_SETUP : SHEEN_PLAN_COLUMNS_SETUP;
}

static unsigned dithered_constant_kind(const struct tile *t, const struct setup *s)
{
    (void)s;
    return t->format->grey ? SHEEN_PLAN_CONSTANT_GREY_DITHERED_SETUP : SHEEN_PLAN_CONSTANT_DITHERED_SETUP;
}

static unsigned shades_kind(const struct tile *t, const struct setup *s)
{
    (void)s;
    return t->dither ? SHEEN_PLAN_SHADES_DITHERED_SETUP : SHEEN_PLAN_SHADES_SETUP;
}

static unsigned packed_kind(const struct tile *t, const struct setup *s)
{
    (void)s;
    return t->dither ? SHEEN_PLAN_PACKED_DITHERED_SETUP : SHEEN_PLAN_PACKED_SETUP;
}

static unsigned constant_kind(const struct tile *t, const struct setup *s)
{
    (void)s;
    return t->format->grey ? SHEEN_PLAN_CONSTANT_GREY_SETUP : SHEEN_PLAN_CONSTANT_SETUP;
}

/* As sheen_quadric_own_rows() chooses. */
static unsigned quadric_kind(const struct tile *t, const struct setup *s)
{
    if (s->detail == SECOND_NONE && s->draw->shades != NULL)
        return t->dither ? SHEEN_PLAN_CURVED_SHADES_DITHERED_SETUP : SHEEN_PLAN_CURVED_SHADES_SETUP;
    if (!s->draw->loop.usable)
        return s->detail == SECOND_NONE ? SHEEN_PLAN_CURVED_GENERAL_SETUP : SHEEN_PLAN_CURVED_GENERAL_TWO_SETUP;
    if (s->detail == SECOND_SPECULAR)
        return SHEEN_PLAN_CURVED_SPECULAR_SETUP;
    if (s->detail == SECOND_NONE)
        return SHEEN_PLAN_CURVED_DITHERED_SETUP;
    return t->dither ? SHEEN_PLAN_CURVED_POWER_DITHERED_SETUP : SHEEN_PLAN_CURVED_POWER_SETUP;
}

static unsigned cells_kind(const struct tile *t, const struct setup *s)
{
    if (!s->draw->loop.usable)
        return SHEEN_PLAN_CELLS_GENERAL_SETUP;
    return t->dither ? SHEEN_PLAN_CELLS_DITHERED_SETUP : SHEEN_PLAN_CELLS_SETUP;
}

static unsigned quotient_kind(const struct tile *t, const struct setup *s)
{
    (void)s;
    return t->format->grey ? SHEEN_PLAN_QUOTIENT_GREY_SETUP : SHEEN_PLAN_QUOTIENT_SETUP;
}

static unsigned lights_kind(const struct tile *t, const struct setup *s)
{
    (void)t;
    return s->draw->light.count == 1 ? SHEEN_PLAN_NEEDLE_SETUP : SHEEN_PLAN_LIGHTS_SETUP;
}

static unsigned slerp_kind(const struct tile *t, const struct setup *s)
{
    if (s->way != SHEEN_WAY_SLERP)
        return SHEEN_PLAN_SLERP_NORMALS_SETUP;
    if (!s->draw->loop.usable)
        return SHEEN_PLAN_SLERP_GENERAL_SETUP;
    return t->dither ? SHEEN_PLAN_SLERP_DITHERED_SETUP : SHEEN_PLAN_SLERP_SETUP;
}

/* By the function that draws them: `choose`, or the kind. */
static const struct rows_kind {
    void (*rows)(const struct tile *t, const struct setup *s);
    unsigned (*choose)(const struct tile *t, const struct setup *s);
    unsigned kind;
} rows_kinds[] = {
    {sheen_constant_rows, constant_kind, 0},
    {sheen_dithered_constant_rows, dithered_constant_kind, 0},
    {sheen_shades_rows, shades_kind, 0},
    {sheen_packed_rows, packed_kind, 0},
    {sheen_linear_rows, linear_kind, 0},
    {sheen_quadric_rows, quadric_kind, 0},
    {sheen_quotient_rows, quotient_kind, 0},
    {sheen_phong_cell_rows, cells_kind, 0},
    {sheen_phong_rows, NULL, SHEEN_PLAN_ROOT_SETUP},
    {sheen_phong_lights_rows, lights_kind, 0},
    {sheen_slerp_rows, slerp_kind, 0},
};

static unsigned kind_of(const struct tile *t, const struct setup *s)
{
    for (const struct rows_kind *k = rows_kinds; k < rows_kinds + sizeof rows_kinds / sizeof rows_kinds[0]; k++)
        if (k->rows == s->rows)
            return k->choose ? k->choose(t, s) : k->kind;
    return SHEEN_PLAN_SLERP_SETUP;
}

/* ---- taps ---- */

void sheen_plan_setup(const struct surface_corners *corners, const struct gradients *gradients)
{
    const struct vertex *const *v = corners->at.v;

    is_new = 1;
    for (int k = 0; k < 3; k++) {
        int32_t x = v[k]->x - v[(k + 1) % 3]->x, y = v[k]->y - v[(k + 1) % 3]->y;
        SHEEN_TAP(LONG_EDGE, x <= -LONG || x >= LONG || y <= -LONG || y >= LONG);
    }
    SHEEN_TAP(WIDE, gradients->bits > NARROW_BITS);
}

void sheen_plan_rows(const struct tile *tile, const struct setup *setup)
{
    uint32_t *of = sheen_plan_counted + kind_of(tile, setup), before = *tile->shaded;

    of[OF_SETUP] += (uint32_t)is_new;
    SHEEN_TAP(CARRIED, !is_new);
    SHEEN_TAP(PARTIAL, is_new && setup->row < setup->end_row);
    is_new = 0;
    for (const struct span *span = tile->spans; span < tile->spans + tile->rows; span++) {
        int is_empty = span->x0 >= span->x1;
        SHEEN_TAP(EMPTY_ROW, is_empty);
        of[OF_ROW] += !is_empty;
        of[OF_COVERED] += is_empty ? 0 : (uint32_t)(span->x1 - span->x0);
    }
    setup->rows(tile, setup);
    of[OF_SHADED] += *tile->shaded - before;
    if (of == sheen_plan_counted + SHEEN_PLAN_LIGHTS_SETUP || of == sheen_plan_counted + SHEEN_PLAN_SLERP_NORMALS_SETUP)
        SHEEN_TAP(PIXEL_LIGHT, (*tile->shaded - before) * setup->draw->light.count);
}

/* ---- what is asked for ---- */

#define FEATURE_NAME(name, stage) #name,
#define KIND_NAMES(name) #name "_SETUP", #name "_ROW", #name "_COVERED", #name "_SHADED",
#define FEATURE_STAGE(name, stage) SHEEN_PLAN_##stage,
#define KIND_STAGES(name) SHEEN_PLAN_TRIANGLES, SHEEN_PLAN_ROWS, SHEEN_PLAN_PIXELS, SHEEN_PLAN_PIXELS,

const char *sheen_plan_feature_name(unsigned feature)
{
    static const char *const names[] = {SHEEN_PLAN_FEATURES(FEATURE_NAME) SHEEN_PLAN_KINDS(KIND_NAMES)};

    return names[feature];
}

enum sheen_plan_stage sheen_plan_feature_stage(unsigned feature)
{
    static const uint8_t stages[] = {SHEEN_PLAN_FEATURES(FEATURE_STAGE) SHEEN_PLAN_KINDS(KIND_STAGES)};

    return (enum sheen_plan_stage)stages[feature];
}

void sheen_plan_counts_begin(void)
{
    memset(sheen_plan_counted, 0, sizeof sheen_plan_counted);
    memset(&taken, 0, sizeof taken);
}

void sheen_plan_counts_take(struct sheen_plan_counts *counts)
{
    for (unsigned i = 0; i < SHEEN_PLAN_COUNTS; i++)
        counts->of[i] = sheen_plan_counted[i] - taken.of[i];
    memcpy(taken.of, sheen_plan_counted, sizeof taken.of);
}

void sheen_plan_count_push(struct sheen_plan_counts *counts, enum sheen_pixel pixel, int bits_18, uint32_t pixels)
{
    counts->of[SHEEN_PLAN_PUSH]++;
    counts->of[pixel <= SHEEN_RGB565_LE ? SHEEN_PLAN_CLEARED : SHEEN_PLAN_CLEARED_GREY] += pixels;
    counts->of[SHEEN_PLAN_PACKED_16] += pixel == SHEEN_GREY16 ? pixels : 0;
    counts->of[SHEEN_PLAN_PACKED_2] += pixel == SHEEN_GREY2 ? pixels : 0;
    counts->of[SHEEN_PLAN_PIXEL_18] += bits_18 ? pixels : 0;
}

void sheen_plan_count_draws(struct sheen_plan_counts *counts, const struct sheen_frame *frame, unsigned draws,
                            uint32_t vertices)
{
    struct sheen_stats stats;
    uint32_t *of = counts->of, bands = sheen_band_count(frame);

    sheen_frame_stats(frame, &stats);
    of[SHEEN_PLAN_FRAME]++;
    of[SHEEN_PLAN_OBJECT] += draws;
    of[SHEEN_PLAN_MESH_VERTEX] += vertices;
    of[SHEEN_PLAN_SKIPPED] += stats.triangles - of[SHEEN_PLAN_LOOKED_AT];
    of[SHEEN_PLAN_USED] += stats.used;
    of[SHEEN_PLAN_LISTED] += stats.drawn;
    of[SHEEN_PLAN_CLIPPED] += stats.clipped;
    of[SHEEN_PLAN_BAND] += bands;
    of[SHEEN_PLAN_PENDING_WORD] += bands * ((stats.drawn + 31) / 32);
}
