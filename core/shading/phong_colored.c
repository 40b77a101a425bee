/*
 * phong_colored.c - Phong shading with colours of vertices and lights: the normal of each pixel is lit, and the light
 * is multiplied by the pixel's colour.
 */
#include "../triangle/reflection.h"
#include "../triangle/tinted.h"
#include "shading.h"

static void phong_colored_setup(struct setup *s, struct surface_corners *c, const struct gradients *g)
{
    const int piece = (c->at.v[0]->flags & LIT_AS_SEEN) != 0; /* pieces have shares in place of normals */

    if (g == NULL || piece || !sheen_setup_tinted_quadrics(s, c, g, (uint32_t)s->draw->most_apart << 21))
        sheen_setup_tinted(s, c, g);
}

const struct sheen_shader sheen_phong_colored = {.begin = sheen_tinted_quadrics_begin,
                                                 .light = sheen_keep_cosines,
                                                 .carry = sheen_carry_shares,
                                                 .setup = phong_colored_setup,
                                                 .needs_normals = 1,
                                                 .corners = OF_MESH(normals),
                                                 .reads_normals = 1,
                                                 .at_pixels = 1};
