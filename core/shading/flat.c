/*
 * flat.c - flat shading: one intensity a polygon, from its own normal (lecture, "Uniform Shading").
 */
#include "shading.h"

/* With FAST_LOOPS an undithered facet's pixel is finished once and reused for its other triangles. */
HOT static void flat_setup(struct setup *s, struct surface_corners *c, const struct gradients *g)
{
    struct constant_setup *one = (struct constant_setup *)s;
    const int finish = FAST_LOOPS && !s->draw->dither;
    struct lit lit;

    (void)g;
    if (sheen_facet_lit(s, c, &lit) && finish) {
        s->way = SHEEN_WAY_FLAT;
        s->rows = sheen_constant_rows;
        one->pixel = c->facet->pixel;
        return;
    }
    sheen_setup_constant(s, &lit);
    if (finish)
        c->facet->pixel = one->pixel;
}

const struct sheen_shader sheen_flat = {.setup = flat_setup, .quads = QUADS_ANY};
