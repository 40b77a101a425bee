/*
 * textured_rows.c - runs of texels, which take the place of a base colour: which loop draws them.
 */
#include "texel_loops.h"

/* U's step is brought into -width/2 .. width/2, because a step to the left must not carry into V. */
static uint32_t packed_step(uint32_t du, uint32_t dv, unsigned width)
{
    return (uint32_t)asr32((int32_t)((du + 32) << (16 - width)), 22 - width) +
           ((dv + 32) >> 6 << (PACKED_BITS + width));
}

/* What TEXEL_PART packed steps lack: each one -32..31 / 2^16 texel. */
static uint32_t packed_rest(uint32_t d)
{
    return (uint32_t)asr32((int32_t)((d + 32) & 63u) - 31, 1);
}

HOT void sheen_textured_step(struct texel_run *r, const struct texel_at *step)
{
    const unsigned width = r->d->texel.texture->width_log2;

    r->step = *step;
    if (r->d->texel.uv_packed) {
        r->packed_step = packed_step(step->u, step->v, width);
        r->mend = packed_rest(step->u) + (packed_rest(step->v) << (PACKED_BITS + width));
    } else {
        r->packed_step = r->mend = 0;
    }
}

void sheen_textured_begin(struct texel_run *r, const struct tile *t, const struct setup *s)
{
    const struct sheen_texture *texture = s->draw->texel.texture;

    r->t = t;
    r->d = s->draw;
    r->special_loop = s->special_loop;
    r->columns = ((1u << texture->width_log2) - 1);
    r->rows = ((1u << texture->height_log2) - 1) << texture->width_log2;
}

/* ---- any texels, by a way that is known when a program runs ---- */

void sheen_any_bilinear(const struct texel_run *r, const struct texel_part *part, enum fogging fogging)
{
    struct texel_way way;

    any_way(&way, r, part, fogging);
    bilinear_loop(r, part, &way);
}

void sheen_any_nearest(const struct texel_run *r, const struct texel_part *part, enum fogging fogging)
{
    struct texel_way way;

    any_way(&way, r, part, fogging);
    nearest_loop(r, part, &way);
}

/* ---- which loop ---- */

SPECIALISED struct texel_part whole_run(const struct texel_run *r, const struct texel_at *from)
{
    struct texel_part whole = {r->depth, r->count, from, &r->step, 0, 0};

    return whole;
}

#if FAST_LOOPS

SPECIALISED void nearest_as(const struct texel_run *r, const struct texel_at *at, unsigned lit, unsigned glossy,
                            unsigned dither)
{
    const unsigned swap = r->t->format->swap;

    if (r->d->texel.uv_packed)
        swap ? nearest_part(r, whole_run(r, at), way_of(1, lit, glossy, dither, 1))
             : nearest_part(r, whole_run(r, at), way_of(1, lit, glossy, dither, 0));
    else
        swap ? nearest_part(r, whole_run(r, at), way_of(0, lit, glossy, dither, 1))
             : nearest_part(r, whole_run(r, at), way_of(0, lit, glossy, dither, 0));
}

HOT static APART void unlit_run(const struct texel_run *r, const struct texel_at *at)
{
    nearest_as(r, at, 0, 0, 0);
}

HOT static APART void lit_run(const struct texel_run *r, const struct texel_at *at)
{
    nearest_as(r, at, 1, 0, 0);
}

HOT static APART void dithered_run(const struct texel_run *r, const struct texel_at *at)
{
    nearest_as(r, at, 1, 0, 1);
}

HOT static APART void glossy_run(const struct texel_run *r, const struct texel_at *at)
{
    r->t->dither ? nearest_as(r, at, 1, 1, 1) : nearest_as(r, at, 1, 1, 0);
}

HOT static APART void other_run(const struct texel_run *r, const struct texel_at *at)
{
    const struct texel_part whole = whole_run(r, at);
    struct texel_way way;

    any_way(&way, r, &whole, NOT_FOGGED);
    nearest_loop(r, &whole, &way);
}

HOT static APART void mixed_run(const struct texel_run *r, const struct texel_at *at)
{
    const unsigned swap = r->t->format->swap;

    if (r->d->texel.uv_packed)
        swap ? bilinear_part(r, whole_run(r, at), way_of(1, 0, 0, 0, 1))
             : bilinear_part(r, whole_run(r, at), way_of(1, 0, 0, 0, 0));
    else
        swap ? bilinear_part(r, whole_run(r, at), way_of(0, 0, 0, 0, 1))
             : bilinear_part(r, whole_run(r, at), way_of(0, 0, 0, 0, 0));
}

HOT static APART void other_mixed_run(const struct texel_run *r, const struct texel_at *at)
{
    const struct texel_part whole = whole_run(r, at);
    struct texel_way way;

    any_way(&way, r, &whole, NOT_FOGGED);
    bilinear_loop(r, &whole, &way);
}

HOT void sheen_textured_run(const struct texel_run *r, const struct texel_at *at)
{
    switch (r->special_loop) {
    case TEXTURED_UNLIT:
        unlit_run(r, at);
        return;
    case TEXTURED_LIT:
        r->t->dither ? dithered_run(r, at) : lit_run(r, at);
        return;
    case TEXTURED_GLOSSY:
        glossy_run(r, at);
        return;
    case TEXTURED_OTHER:
        other_run(r, at);
        return;
    case TEXTURED_BILINEAR:
        r->t->dither ? other_mixed_run(r, at) : mixed_run(r, at);
        return;
    case TEXTURED_BILINEAR_OTHER:
        other_mixed_run(r, at);
        return;
    default:
        (r->d->fog ? r->d->fog->mixer->texel_run : sheen_any_texels)(r, at);
    }
}

#else

HOT void sheen_textured_run(const struct texel_run *r, const struct texel_at *at)
{
    const struct texel_part whole = whole_run(r, at);

    if (r->special_loop == TEXTURED_ANY || r->special_loop == TEXTURED_FOGGED)
        (r->d->fog ? r->d->fog->mixer->texel_run : sheen_any_texels)(r, at);
    else
        any_part(r, &whole, NOT_FOGGED);
}

#endif
