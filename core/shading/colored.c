/*
 * colored.c - flat and Gouraud shading with colours of vertices and lights, and with point lights: light and colour are
 * multiplied at each corner, which gives three channels, and these are interpolated over the triangle.
 */
#include "../triangle/glow.h"
#include "../triangle/quotient.h"
#include "shading.h"

/* The channels of vertex `at` / 3 of the mesh. */
HOT static void vertex_channels(const struct draw *d, ptrdiff_t at, const struct glow *glow, uint32_t channel[3])
{
    const uint8_t *color = d->mesh->colors;

    SHEEN_TAP(COLORED, 1);
    for (int i = 0; i < 3; i++)
        channel[i] = (color != NULL ? by_colour(glow->base[i], color[at + i]) : glow->base[i]) + glow->highlight[i];
}

/* Channels of 15 bits, as pieces carry them. */
static APART void carry_corner(const struct draw *d, uint32_t index, const struct glow *glow, int16_t out[3])
{
    uint32_t channel[3];

    vertex_channels(d, 3 * (ptrdiff_t)index, glow, channel);
    for (int i = 0; i < 3; i++)
        out[i] = (int16_t)min32((int32_t)((channel[i] + (1u << 15)) >> 16), 32767);
}

static int is_piece(const struct surface_corners *c)
{
    return (c->at.v[0]->flags & LIT_AS_SEEN) != 0;
}

static void carried_channels(const struct surface_corners *c, uint32_t channel[3][3])
{
    for (int i = 0; i < 9; i++)
        channel[i % 3][i / 3] = (uint32_t)c->at.normal[i / 3][i % 3] << 16;
}

/* ---- flat: light of the polygon ---- */

static APART void flat_corners(const struct setup *s, const struct surface_corners *c, uint32_t channel[3][3])
{
    struct glow glow;

    if (is_piece(c)) {
        carried_channels(c, channel);
        return;
    }
    sheen_polygon_glow(s->draw, c->at.triangle, c->back, &glow);
    for (int k = 0; k < 3; k++) {
        uint32_t corner[3];
        vertex_channels(s->draw, c->at.normal[k] - s->draw->mesh->positions, &glow, corner);
        for (int i = 0; i < 3; i++)
            channel[i][k] = corner[i];
    }
}

static void flat_colored_setup(struct setup *s, struct surface_corners *c, const struct gradients *g)
{
    uint32_t channel[3][3];

    flat_corners(s, c, channel);
    sheen_setup_channels(s, c, g, channel);
}

static void flat_colored_carry(const struct draw *d, uint16_t triangle, int back, int16_t out[3][3])
{
    struct glow glow;

    sheen_polygon_glow(d, triangle, back, &glow);
    for (uint32_t k = 0; k < 3; k++)
        carry_corner(d, mesh_index(d->mesh, 3u * triangle + k), &glow, out[k]);
}

const struct sheen_shader sheen_flat_colored = {
    .begin = sheen_glow_begin, .carry = flat_colored_carry, .setup = flat_colored_setup, .lights = LIGHTS_ALL};

/* ---- Gouraud: light of the vertices ---- */

HOT static APART void gouraud_corners(const struct setup *s, const struct surface_corners *c, uint32_t channel[3][3])
{
    const struct draw *d = s->draw;

    if (is_piece(c)) {
        carried_channels(c, channel);
        return;
    }
    for (int k = 0; k < 3; k++) {
        const ptrdiff_t at = c->at.normal[k] - d->mesh->positions;
        const struct lit kept = {c->at.v[k]->kept[0], c->at.v[k]->kept[1]};
        struct glow glow;
        uint32_t corner[3];
        if (d->tint.is_tinted || c->back)
            sheen_vertex_glow(d, at, c->back, &glow);
        else
            white_glow(d, &kept, &glow);
        vertex_channels(d, at, &glow, corner);
        for (int i = 0; i < 3; i++)
            channel[i][k] = corner[i];
    }
}

static void gouraud_colored_setup(struct setup *s, struct surface_corners *c, const struct gradients *g)
{
    uint32_t channel[3][3];

    gouraud_corners(s, c, channel);
    sheen_setup_channels(s, c, g, channel);
}

static void gouraud_colored_carry(const struct draw *d, uint16_t triangle, int back, int16_t out[3][3])
{
    for (uint32_t k = 0; k < 3; k++) {
        const uint32_t index = mesh_index(d->mesh, 3u * triangle + k);
        struct glow glow;
        sheen_vertex_glow(d, 3 * (ptrdiff_t)index, back, &glow);
        carry_corner(d, index, &glow, out[k]);
    }
}

/* Keeps white light only: the three channels of coloured light do not fit in a vertex. */
static void gouraud_colored_light(const struct draw *d, const int16_t normal[3], uint16_t kept[2])
{
    struct lit lit = {0, 0};

    if (!d->tint.is_tinted)
        light_normal(&d->light, &d->power, normal, &lit);
    kept[0] = (uint16_t)lit.diffuse;
    kept[1] = (uint16_t)lit.specular;
}

const struct sheen_shader sheen_gouraud_colored = {.begin = sheen_glow_begin,
                                                   .light = gouraud_colored_light,
                                                   .carry = gouraud_colored_carry,
                                                   .setup = gouraud_colored_setup,
                                                   .lights = LIGHTS_ALL,
                                                   .needs_normals = 1};
