/*
 * count.c - adds up what the core's taps count, by feature.
 */
#include "count.h"

#include <string.h>

#include "shading/matcap.h"
#include "shading/phong.h"
#include "shading/slerp.h"
#include "taps.h"
#include "triangle/quadric.h"
#include "triangle/quotient.h"
#include "triangle/tinted.h"

#define LONG 2048 /* 1/64 px: without a divider, only shorter edges use the table of reciprocals (edge.c) */

uint32_t sheen_plan_counted[SHEEN_PLAN_COUNTS];
static struct sheen_plan_counts taken; /* what sheen_plan_counts_take has already returned */
static int is_new;                     /* 1: the set-up whose rows are drawn next has just been made */

/* 1 if loops for any target draw it: on 565 they draw ramps, patterns and fog, which 565's own loops do not know. */
static int is_general(const struct setup *s)
{
    return !s->draw->is_565 || !s->draw->loop.usable;
}

/* ---- kinds of rows ---- */

enum {
    OF_SETUP,
    OF_ROW,
    OF_COVERED,
    OF_SHADED
};

static unsigned linear_kind(const struct tile *t, const struct setup *s)
{
    if (!s->special_loop)
        return t->format->grey ? SHEEN_PLAN_CLAMPED_GREY_SETUP : SHEEN_PLAN_CLAMPED_SETUP;
    return t->dither ? SHEEN_PLAN_COLUMNS_DITHERED_SETUP : SHEEN_PLAN_COLUMNS_SETUP;
}

static unsigned dithered_constant_kind(const struct tile *t, const struct setup *s)
{
    (void)t;
    return s->special_loop ? SHEEN_PLAN_CONSTANT_DITHERED_SETUP : SHEEN_PLAN_CONSTANT_GREY_DITHERED_SETUP;
}

static unsigned shades_kind(const struct tile *t, const struct setup *s)
{
    if (t->dither)
        return SHEEN_PLAN_SHADES_DITHERED_SETUP;
    return s->detail ? SHEEN_PLAN_SHADES_WIDE_SETUP : SHEEN_PLAN_SHADES_SETUP;
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

/* 1 if fog's own loops for 565 draw it. */
static int is_fogged(const struct tile *t, const struct setup *s)
{
    return s->draw->fog && !t->format->grey && !s->draw->pixel_ramp && !s->draw->stippled;
}

/* Chooses as sheen_take_quadric_rows() does. */
static unsigned quadric_kind(const struct tile *t, const struct setup *s)
{
    if (is_fogged(t, s))
        return SHEEN_PLAN_FOGGED_CURVED_SETUP;
    if (s->detail == SECOND_NONE && s->draw->shades != NULL)
        return t->dither ? SHEEN_PLAN_CURVED_SHADES_DITHERED_SETUP : SHEEN_PLAN_CURVED_SHADES_SETUP;
    if (is_general(s))
        return s->detail == SECOND_NONE ? SHEEN_PLAN_CURVED_GENERAL_SETUP : SHEEN_PLAN_CURVED_GENERAL_TWO_SETUP;
    if (s->detail == SECOND_SPECULAR)
        return t->dither ? SHEEN_PLAN_CURVED_SPECULAR_DITHERED_SETUP : SHEEN_PLAN_CURVED_SPECULAR_SETUP;
    if (s->detail == SECOND_NONE)
        return SHEEN_PLAN_CURVED_DITHERED_SETUP;
    return t->dither ? SHEEN_PLAN_CURVED_POWER_DITHERED_SETUP : SHEEN_PLAN_CURVED_POWER_SETUP;
}

static unsigned cells_kind(const struct tile *t, const struct setup *s)
{
    if (is_fogged(t, s))
        return SHEEN_PLAN_FOGGED_CELLS_SETUP;
    if (is_general(s))
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
    if (is_fogged(t, s))
        return SHEEN_PLAN_FOGGED_ARCS_SETUP;
    if (is_general(s))
        return SHEEN_PLAN_SLERP_GENERAL_SETUP;
    return t->dither ? SHEEN_PLAN_SLERP_DITHERED_SETUP : SHEEN_PLAN_SLERP_SETUP;
}

/* Kinds of rows by the function that draws them: what `choose` returns, or `kind` if that is NULL. */
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
    {sheen_tinted_rows, NULL, SHEEN_PLAN_TINTED_SETUP},
    {sheen_tinted_quadric_rows, NULL, SHEEN_PLAN_TINTED_CURVED_SETUP},
    {sheen_slerp_rows, slerp_kind, 0},
};

static unsigned kind_of(const struct tile *t, const struct setup *s)
{
    for (const struct rows_kind *k = rows_kinds; k < rows_kinds + sizeof rows_kinds / sizeof rows_kinds[0]; k++)
        if (k->rows == s->rows)
            return k->choose ? k->choose(t, s) : k->kind;
    if (s->way == SHEEN_WAY_GOURAUD_QUADRATIC || s->way == SHEEN_WAY_PHONG_QUADRATIC) /* loops are chosen at set-up */
        return quadric_kind(t, s);
    if (s->way == SHEEN_WAY_GOURAUD_QUOTIENT) /* fog's rows, drawn by a static function */
        return quotient_kind(t, s);
    if (s->draw->fog && s->way <= SHEEN_WAY_GOURAUD_LINEAR)
        return t->dither                  ? SHEEN_PLAN_FOGGED_DITHERED_SETUP
               : s->way == SHEEN_WAY_FLAT ? SHEEN_PLAN_FOGGED_CONSTANT_SETUP
                                          : SHEEN_PLAN_FOGGED_SETUP;
    return s->way == SHEEN_WAY_SLERP_NORMALS ? SHEEN_PLAN_TINTED_SETUP : SHEEN_PLAN_SLERP_SETUP;
}

/* ---- texels ---- */

enum {
    OF_TEXELS_COVERED,
    OF_TEXELS_SHADED
};

static int is_texels(const struct setup *s)
{
    return s->way >= SHEEN_WAY_TEXTURED_LINEAR;
}

/* 1 if texels have colours; such draws have no struct texel_terms. */
static int is_colored(const struct draw *d)
{
    return d->shader == &sheen_textured_colored || d->shader == &sheen_textured_flat_colored ||
           d->shader == &sheen_matcap_colored || d->shader == &sheen_matcap_vertex_colored;
}

static void count_colored(const struct setup *s, uint32_t rows, uint32_t covered, uint32_t shaded)
{
    const struct sheen_texture *texture = s->draw->tint.texture;

    SHEEN_TAP(TEXELS_SHARED, is_new);
    SHEEN_TAP(TEXELS_COLORED_COVERED, covered);
    SHEEN_TAP(TEXELS_COLORED_SHADED, shaded);
    SHEEN_TAP(TEXEL_ROW, rows);
    SHEEN_TAP(TEXEL_NIBBLE, texture->bits == 4 ? covered : 0);
    SHEEN_TAP(TEXEL_MIXED, texture->bilinear ? shaded : 0);
    SHEEN_TAP(FOG, s->draw->fog ? shaded : 0);
}

static unsigned texels_kind(const struct tile *t, const struct setup *s)
{
    static const uint16_t kinds[] = {
        [TEXTURED_ANY] = SHEEN_PLAN_TEXELS_ANY_COVERED,
        [TEXTURED_UNLIT] = SHEEN_PLAN_TEXELS_UNLIT_COVERED,
        [TEXTURED_LIT] = SHEEN_PLAN_TEXELS_LIT_COVERED,
        [TEXTURED_GLOSSY] = SHEEN_PLAN_TEXELS_GLOSSY_COVERED,
        [TEXTURED_OTHER] = SHEEN_PLAN_TEXELS_OTHER_LIT_COVERED,
        [TEXTURED_BILINEAR] = SHEEN_PLAN_TEXELS_BILINEAR_COVERED,
        [TEXTURED_BILINEAR_OTHER] = SHEEN_PLAN_TEXELS_BILINEAR_LIT_COVERED,
        [TEXTURED_FOGGED] = SHEEN_PLAN_TEXELS_FOGGED_COVERED,
    };
    const struct texel_terms *terms = &s->draw->texel;
    const struct sheen_texture *texture = terms->texture;

    if (s->special_loop == TEXTURED_ANY && t->format->grey)
        return SHEEN_PLAN_TEXELS_ANY_GREY_COVERED;
    if (s->special_loop == TEXTURED_FOGGED && ((texture->bits & 15) != 0 || texture->keyed || texture->bilinear))
        return SHEEN_PLAN_TEXELS_FOGGED_OTHER_COVERED;
    if (s->special_loop == TEXTURED_FOGGED && !terms->uv_packed)
        return SHEEN_PLAN_TEXELS_FOGGED_APART_COVERED;
    if (s->special_loop == TEXTURED_OTHER && terms->unlit)
        return SHEEN_PLAN_TEXELS_OTHER_COVERED;
    if ((s->special_loop == TEXTURED_BILINEAR && t->dither) ||
        (s->special_loop == TEXTURED_BILINEAR_OTHER && terms->unlit))
        return SHEEN_PLAN_TEXELS_BILINEAR_OTHER_COVERED;
    return kinds[s->special_loop];
}

static void count_texels(const struct tile *t, const struct setup *s, uint32_t rows, uint32_t covered, uint32_t shaded)
{
    static const uint16_t ways[] = {SHEEN_PLAN_TEXELS_STRAIGHT, SHEEN_PLAN_TEXELS_SKEWED, SHEEN_PLAN_TEXELS_CURVED,
                                    SHEEN_PLAN_TEXELS_TURNED};
    const struct texel_terms *terms = &s->draw->texel;
    const unsigned kind = texels_kind(t, s);
    const unsigned way = s->way == SHEEN_WAY_TEXTURED_LINEAR && s->draw->shader->axes
                             ? SHEEN_PLAN_TEXELS_SPHERE
                             : ways[s->way - SHEEN_WAY_TEXTURED_LINEAR];

    sheen_plan_counted[way] += (uint32_t)is_new;
    sheen_plan_counted[kind + OF_TEXELS_COVERED] += covered;
    sheen_plan_counted[kind + OF_TEXELS_SHADED] += shaded;
    SHEEN_TAP(TEXELS_LIGHT, is_new && !terms->unlit && s->way == SHEEN_WAY_TEXTURED_LINEAR);
    SHEEN_TAP(TEXELS_SKEWED_LIGHT, is_new && !terms->unlit && s->way == SHEEN_WAY_TEXTURED_QUOTIENT);
    SHEEN_TAP(TEXEL_ROW, rows);
    SHEEN_TAP(TEXEL_DITHERED,
              t->dither && s->special_loop != TEXTURED_ANY && s->special_loop != TEXTURED_UNLIT ? shaded : 0);
    SHEEN_TAP(TEXEL_APART, terms->uv_packed ? 0 : covered);
    SHEEN_TAP(TEXEL_MIXED_APART, terms->uv_packed || !terms->texture->bilinear ? 0 : shaded);
    SHEEN_TAP(TEXEL_NIBBLE, terms->texture->bits == 4 ? covered : 0);
    SHEEN_TAP(TEXEL_MIXED, s->special_loop == TEXTURED_ANY && terms->texture->bilinear ? shaded : 0);
    SHEEN_TAP(FOG, s->special_loop == TEXTURED_ANY && s->draw->fog ? shaded : 0);
}

/* ---- taps ---- */

void sheen_plan_setup(const struct surface_corners *corners, const struct gradients *gradients)
{
    const struct vertex *const *at = corners->at.v, *const last = at[3] != NULL ? at[3] : at[2];
    const struct vertex *const v[5] = {at[0], at[1], last, at[2], at[0]}; /* corner 2 of a triangle twice */

    is_new = 1;
    for (int k = 0; k < 4; k++) {
        int32_t x = v[k]->x - v[k + 1]->x, y = v[k]->y - v[k + 1]->y;
        SHEEN_TAP(LONG_EDGE, x <= -LONG || x >= LONG || y <= -LONG || y >= LONG);
    }
    SHEEN_TAP(WIDE, gradients->bits > NARROW_BITS);
}

/* Counts pixels that cost more than is usual for their kind, in rows without texels. */
static void count_shaded(const struct tile *t, const struct setup *s, unsigned kind, uint32_t shaded)
{
    const uint32_t lights = shaded * s->draw->light.count;
    const int by_normal =
        kind == SHEEN_PLAN_LIGHTS_SETUP || kind == SHEEN_PLAN_SLERP_NORMALS_SETUP || kind == SHEEN_PLAN_TINTED_SETUP;
    const int general =
        kind == SHEEN_PLAN_CURVED_GENERAL_SETUP || kind == SHEEN_PLAN_CURVED_GENERAL_TWO_SETUP ||
        kind == SHEEN_PLAN_CELLS_GENERAL_SETUP || kind == SHEEN_PLAN_SLERP_GENERAL_SETUP ||
        kind == SHEEN_PLAN_CONSTANT_GREY_DITHERED_SETUP ||
        ((by_normal || kind == SHEEN_PLAN_NEEDLE_SETUP) && kind != SHEEN_PLAN_TINTED_SETUP && !s->draw->loop.usable);
    const int own_fog = kind >= SHEEN_PLAN_FOGGED_SETUP && kind <= SHEEN_PLAN_FOGGED_ARCS_SETUP;

    SHEEN_TAP(PIXEL_LIGHT, by_normal ? lights : 0);
    SHEEN_TAP(GENERAL_565, general && !t->format->grey ? shaded : 0);
    SHEEN_TAP(FOG, s->draw->fog && !own_fog ? shaded : 0);
    SHEEN_TAP(FOG_DITHERED, own_fog && kind >= SHEEN_PLAN_FOGGED_CURVED_SETUP && t->dither ? shaded : 0);
    SHEEN_TAP(RAMP, s->draw->pixel_ramp && s->way > SHEEN_WAY_GOURAUD_QUOTIENT ? lights : 0);
}

void sheen_plan_rows(const struct tile *tile, const struct setup *setup)
{
    uint32_t rows = 0, covered = 0, before = *tile->shaded;

    for (const struct span *span = tile->spans; span < tile->spans + tile->rows; span++) {
        int is_empty = span->x0 >= span->x1;
        SHEEN_TAP(EMPTY_ROW, is_empty);
        rows += !is_empty;
        covered += is_empty ? 0 : (uint32_t)(span->x1 - span->x0);
    }
    setup->rows(tile, setup);
    const uint32_t shaded = *tile->shaded - before;
    if (is_texels(setup) && is_colored(setup->draw)) {
        count_colored(setup, rows, covered, shaded);
    } else if (is_texels(setup)) {
        count_texels(tile, setup, rows, covered, shaded);
    } else {
        const unsigned kind = kind_of(tile, setup);
        uint32_t *of = sheen_plan_counted + kind;
        of[OF_SETUP] += (uint32_t)is_new;
        of[OF_ROW] += rows;
        of[OF_COVERED] += covered;
        of[OF_SHADED] += shaded;
        count_shaded(tile, setup, kind, shaded);
    }
    is_new = 0;
}

/* ---- names and results ---- */

#define FEATURE_NAME(name, stage) #name,
#define KIND_NAMES(name) #name "_SETUP", #name "_ROW", #name "_COVERED", #name "_SHADED",
#define TEXELS_NAMES(name) "TEXELS_" #name "_COVERED", "TEXELS_" #name "_SHADED",
#define FEATURE_STAGE(name, stage) SHEEN_PLAN_##stage,
#define KIND_STAGES(name) SHEEN_PLAN_TRIANGLES, SHEEN_PLAN_ROWS, SHEEN_PLAN_PIXELS, SHEEN_PLAN_PIXELS,
#define TEXELS_STAGES(name) SHEEN_PLAN_PIXELS, SHEEN_PLAN_PIXELS,

const char *sheen_plan_feature_name(unsigned feature)
{
    static const char *const names[] = {SHEEN_PLAN_FEATURES(FEATURE_NAME) SHEEN_PLAN_KINDS(KIND_NAMES)
                                            SHEEN_PLAN_TEXELS(TEXELS_NAMES)};

    return names[feature];
}

enum sheen_plan_stage sheen_plan_feature_stage(unsigned feature)
{
    static const uint8_t stages[] = {SHEEN_PLAN_FEATURES(FEATURE_STAGE) SHEEN_PLAN_KINDS(KIND_STAGES)
                                         SHEEN_PLAN_TEXELS(TEXELS_STAGES)};

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
    counts->of[SHEEN_PLAN_LIT] -= counts->of[SHEEN_PLAN_FACET_LIT];
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
    of[SHEEN_PLAN_SKIPPED] += stats.triangles - of[SHEEN_PLAN_LOOKED_AT] - 2 * of[SHEEN_PLAN_QUAD_LISTED];
    of[SHEEN_PLAN_USED] += stats.used;
    of[SHEEN_PLAN_LISTED] += stats.drawn;
    of[SHEEN_PLAN_CLIPPED] += stats.clipped;
    of[SHEEN_PLAN_BAND] += bands;
    of[SHEEN_PLAN_PENDING_WORD] += bands * ((stats.drawn + 31) / 32);
}
