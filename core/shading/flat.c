/*
 * flat.c - flat shading: one intensity a polygon, from its own normal (lecture, "Uniform Shading").
 */
#include "shading.h"

static void flat_setup(struct setup *s, struct surface_corners *c, const struct gradients *g)
{
    struct lit lit;

    (void)g;
    sheen_facet_lit(s, c, &lit);
    sheen_setup_constant(s, &lit);
}

const struct sheen_shader sheen_flat = {.setup = flat_setup};
