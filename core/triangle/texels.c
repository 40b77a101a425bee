/*
 * texels.c - texel coordinates of a triangle's corners.
 */
#include "texels.h"

/*
 * Moves f inwards if it lies on a border and is the least or the most of the three. It stays the least or the most,
 * because it moves by less than the corners lie apart.
 */
static inline void inset_corner(int32_t *f, int32_t a, int32_t b, int32_t by)
{
    if ((uint16_t)*f != BORDER_BIAS)
        return;
    if (*f <= a && *f <= b)
        *f += by;
    else if (*f >= a && *f >= b)
        *f -= BORDER_BIAS + by;
}

void sheen_inset_corners(struct at_corners at[2], int32_t by)
{
    for (int i = 0; i < 2; i++) {
        int32_t *const f = at[i].f;
        inset_corner(&f[0], f[1], f[2], by);
        inset_corner(&f[1], f[0], f[2], by);
        inset_corner(&f[2], f[0], f[1], by);
    }
}

/* If the texture repeats, coordinates are brought near 0, because quotients of small numbers are finer. */
void sheen_texels_of(struct at_corners *at, const struct draw *d, const struct sheen_texture *t,
                     const struct corners *c, int i, unsigned finer)
{
    const unsigned size = i == 0 ? t->width_log2 : t->height_log2, clamp = i == 0 ? t->clamp_u : t->clamp_v;
    const unsigned up = 16 - d->mesh->uv_bits - finer + size; /* 1..25 */
    const int32_t own = c->normal[0][i];
    uint32_t first = ((uint32_t)own << up) + ((uint32_t)d->mesh->uv_offset[i] << size);

    if (!clamp)
        first &= (1u << (16 + size)) - 1;
    for (int k = 0; k < 3; k++)
        at->f[k] = (int32_t)(first + BORDER_BIAS + ((uint32_t)(c->normal[k][i] - own) << up));
}
