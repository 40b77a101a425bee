/*
 * fogged_texels.c - parts of runs of texels, with fog that is linear along the part.
 */
#include "texel_loops.h"

#if FAST_LOOPS
SPLIT struct texel_way fogged_way(const struct texel_run *r, unsigned uv_packed, unsigned glossy, unsigned dither,
                                  unsigned swap)
{
    struct texel_way way = way_of(uv_packed, 1, glossy, dither, swap);

    way_through(&way, r->d->fog);
    return way;
}

SPECIALISED void faded_part(const struct texel_run *r, const struct texel_part *part, unsigned uv_packed,
                            unsigned dither)
{
    struct texel_way way = fogged_way(r, uv_packed, 0, dither, 1);

    fade(&way);
    nearest_part(r, *part, way);
}

HOT static APART void glossy_fogged_part(const struct texel_run *r, const struct texel_part *part)
{
    if (!r->d->texel.uv_packed)
        nearest_part(r, *part, fogged_way(r, 0, 1, r->t->dither, 1));
    else
        r->t->dither ? nearest_part(r, *part, fogged_way(r, 1, 1, 1, 1))
                     : nearest_part(r, *part, fogged_way(r, 1, 1, 0, 1));
}

HOT void sheen_fogged_part(const struct texel_run *r, const struct texel_part *part)
{
    const struct sheen_texture *texture = r->d->texel.texture;

    if (!r->t->format->swap || (texture->bits & 15) != 0 || texture->keyed || texture->bilinear)
        any_part(r, part, FOG_DIMS);
    else if (is_glossy(part))
        glossy_fogged_part(r, part);
    else if (r->t->dither)
        r->d->texel.uv_packed ? nearest_part(r, *part, fogged_way(r, 1, 0, 1, 1))
                              : nearest_part(r, *part, fogged_way(r, 0, 0, 1, 1));
    else
        r->d->texel.uv_packed ? nearest_part(r, *part, fogged_way(r, 1, 0, 0, 1))
                              : nearest_part(r, *part, fogged_way(r, 0, 0, 0, 1));
}
#else
HOT void sheen_fogged_part(const struct texel_run *r, const struct texel_part *part)
{
    any_part(r, part, FOG_DIMS);
}
#endif

HOT void sheen_faded_part(const struct texel_run *r, const struct texel_part *part)
{
#if FAST_LOOPS
    const struct sheen_texture *texture = r->d->texel.texture;

    if (r->t->format->swap && (texture->bits & 15) == 0 && !texture->keyed) {
        if (!r->d->texel.uv_packed)
            r->t->dither ? faded_part(r, part, 0, 1) : faded_part(r, part, 0, 0);
        else
            r->t->dither ? faded_part(r, part, 1, 1) : faded_part(r, part, 1, 0);
        return;
    }
#endif
    any_part(r, part, FOG_FADES);
}
