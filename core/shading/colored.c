/*
 * colored.c - flat and Gouraud shading with colours at the corners: three channels each, multiplied before they are
 * brought over the triangle.
 */
#include "../triangle/morph.h"
#include "../triangle/quotient.h"
#include "shading.h"

/* Channels of a corner, whose place in the mesh is `at` / 3. */
static void tinted_channels(const struct draw *d, ptrdiff_t at, const struct lit *lit, uint32_t channel[3])
{
    const struct colour_terms *terms = &d->colour;
    const uint8_t *color = d->mesh->colors;

    for (int i = 0; i < 3; i++) {
        uint32_t base = terms->a[i] + terms->b[i] * lit->diffuse;
        if (color != NULL) /* 1.0 is 2^32 - 1 */
            base = mul_high(base, color[at + i] * 0x01010101u);
        channel[i] = base + terms->c[i] * lit->specular;
    }
}

/* channel: by component and corner. lit: of the corners. A piece's are the channels that it carries. */
static void colored_corners(const struct setup *s, const struct surface_corners *c, const struct lit lit[3],
                            uint32_t channel[3][3])
{
    const int piece = (c->at.v[0]->flags & LIT_AS_SEEN) != 0;

    for (int k = 0; k < 3; k++) {
        uint32_t corner[3];
        if (!piece)
            tinted_channels(s->draw, c->at.normal[k] - s->draw->mesh->positions, &lit[k], corner);
        for (int i = 0; i < 3; i++)
            channel[i][k] = piece ? (uint32_t)c->at.normal[k][i] << 16 : corner[i];
    }
}

/* Channels of 15 bits, as pieces carry them. */
static void carry_corner(const struct draw *d, uint16_t triangle, int k, const struct lit *lit, int16_t out[3])
{
    uint32_t channel[3];

    tinted_channels(d, 3 * (ptrdiff_t)mesh_index(d->mesh, 3u * triangle + (uint32_t)k), lit, channel);
    for (int i = 0; i < 3; i++)
        out[i] = (int16_t)min32((int32_t)((channel[i] + (1u << 15)) >> 16), 32767);
}

/* ---- flat: light of the polygon ---- */

static APART void flat_corners(const struct setup *s, const struct surface_corners *c, uint32_t channel[3][3])
{
    struct lit lit[3];

    sheen_facet_lit(s, c, &lit[0]);
    lit[1] = lit[2] = lit[0];
    colored_corners(s, c, lit, channel);
}

static void flat_colored_setup(struct setup *s, struct surface_corners *c, const struct gradients *g)
{
    uint32_t channel[3][3];

    flat_corners(s, c, channel);
    sheen_setup_channels(s, c, g, channel);
}

static void flat_colored_carry(const struct draw *d, uint16_t triangle, int back, int16_t out[3][3])
{
    int16_t normal[3];
    struct lit lit;

    sheen_facet_normal(d, triangle, back, normal);
    light_normal(&d->light, &d->power, normal, &lit);
    for (int k = 0; k < 3; k++)
        carry_corner(d, triangle, k, &lit, out[k]);
}

const struct sheen_shader sheen_flat_colored = {.carry = flat_colored_carry, .setup = flat_colored_setup};

/* ---- Gouraud: light of the vertices ---- */

static APART void gouraud_corners(const struct setup *s, const struct surface_corners *c, uint32_t channel[3][3])
{
    const struct sheen_mesh *mesh = s->draw->mesh;
    const int16_t *normal[3];
    struct lit lit[3];

    for (int k = 0; k < 3; k++) /* those of pieces are not read */
        normal[k] = (c->at.v[k]->flags & LIT_AS_SEEN) != 0 ? NULL : mesh->normals + (c->at.normal[k] - mesh->positions);
    (void)corners_lit(s, c, normal, lit);
    colored_corners(s, c, lit, channel);
}

static void gouraud_colored_setup(struct setup *s, struct surface_corners *c, const struct gradients *g)
{
    uint32_t channel[3][3];

    gouraud_corners(s, c, channel);
    sheen_setup_channels(s, c, g, channel);
}

static void gouraud_colored_carry(const struct draw *d, uint16_t triangle, int back, int16_t out[3][3])
{
    for (int k = 0; k < 3; k++) {
        int16_t seen[3];
        const int16_t *first = d->mesh->normals + 3 * mesh_index(d->mesh, 3u * triangle + (uint32_t)k),
                      *n = normal_of(d, first, seen);
        struct lit lit;
        for (int i = 0; i < 3; i++)
            seen[i] = (int16_t)(back ? -max32(n[i], -32767) : n[i]);
        light_normal(&d->light, &d->power, seen, &lit);
        carry_corner(d, triangle, k, &lit, out[k]);
    }
}

static void gouraud_colored_light(const struct draw *d, const int16_t normal[3], uint16_t kept[2])
{
    struct lit lit;

    light_normal(&d->light, &d->power, normal, &lit);
    kept[0] = (uint16_t)lit.diffuse;
    kept[1] = (uint16_t)lit.specular;
}

const struct sheen_shader sheen_gouraud_colored = {
    .light = gouraud_colored_light, .carry = gouraud_colored_carry, .setup = gouraud_colored_setup, .needs_normals = 1};
