/*
 * colored.c - flat and Gouraud shading with colours of vertices and lights, and with point lights: three channels a
 * corner, multiplied before they are brought over the triangle.
 */
#include "../triangle/morph.h"
#include "../triangle/quotient.h"
#include "shading.h"

_Static_assert(sizeof(struct tint_terms) <= offsetof(struct loop_terms, usable), "fog marks loops as unusable");

/* Channels of light at a corner: what a vertex's colour multiplies, and the highlight. */
struct glow {
    uint32_t base[3], highlight[3];
};

static void white_glow(const struct draw *d, const struct lit *lit, struct glow *glow)
{
    const struct colour_terms *terms = &d->colour;

    for (int i = 0; i < 3; i++) {
        glow->base[i] = terms->a[i] + terms->b[i] * lit->diffuse;
        glow->highlight[i] = terms->c[i] * lit->specular;
    }
}

static APART void white_light(const struct draw *d, const int16_t normal[3], struct glow *glow)
{
    struct lit lit;

    light_normal(&d->light, &d->power, normal, &lit);
    white_glow(d, &lit, glow);
}

/* at: a position of the mesh. */
static APART void tinted_light(const struct draw *d, const int16_t at[3], const int16_t normal[3], struct glow *glow)
{
    const struct colour_terms *terms = &d->colour;
    struct tinted lit;
    int32_t place[3]; /* raw / 2^15 * Q7.24, less 4 bits */

    for (int i = 0; i < 3; i++)
        place[i] = sheen_mul_round(at[i], d->tint.reach, 19);
    sheen_light_tinted(&d->light, &d->power, &d->tint, place, normal, &lit);
    for (int i = 0; i < 3; i++) {
        const uint32_t low = mul_high(d->tint.low[i], lit.low[i] << 16) * 2; /* 15 bits, up to 1.0 */
        glow->base[i] = terms->a[i] + low + terms->b[i] * lit.diffuse[i];
        glow->highlight[i] = terms->c[i] * lit.specular[i];
    }
}

static inline void glow_light(const struct draw *d, const int16_t at[3], const int16_t seen[3], struct glow *glow)
{
    if (d->tint.lights)
        tinted_light(d, at, seen, glow);
    else
        white_light(d, seen, glow);
}

/* Of a corner whose place in the mesh is `at` / 3. */
static void vertex_channels(const struct draw *d, ptrdiff_t at, const struct glow *glow, uint32_t channel[3])
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

/* What lights have; ambient light as its colour has it, apart from what a ramp's low makes of the lights. */
static void colored_begin(struct draw *d, const struct sheen_material *material, const struct pixel_format *format,
                          const struct sheen_object *object, const struct sheen_pose *view)
{
    const struct sheen_material *own = object->material;
    const uint8_t *ambient = own->ambient_color;
    const int white = (ambient[0] | ambient[1] | ambient[2]) == 0, is_low = own->ambient < material->ambient;
    const uint32_t share = is_low ? sheen_ratio((uint32_t)own->ambient, (uint32_t)material->ambient) : 0;

    (void)format;
    d->tint.lights = 0;
    d->tint.points = NULL;
    d->tint.is_point = 0;
    for (unsigned i = 0; i < d->light.count; i++) {
        const uint8_t *color = object->lights[i].color;
        const int coloured = (color[0] | color[1] | color[2]) != 0;
        for (int k = 0; k < 3; k++)
            d->tint.color[i][k] = coloured ? color[k] : 255;
        if (object->lights[i].radius > 0)
            d->tint.points = object->lights[i].points;
        d->tint.lights |= (uint8_t)(coloured || d->tint.points != NULL);
    }
    if (d->tint.points != NULL)
        d->tint.points->place(d, object, view);
    for (int k = 0; k < 3; k++) {
        const uint32_t a = d->colour.a[k], part = is_low ? mul_high(a, share) : a;
        d->tint.low[k] = d->tint.lights ? a - part : 0;
        d->colour.a[k] = by_colour(part, white ? 255 : ambient[k]) + (d->tint.lights ? 0 : a - part);
    }
}

/* ---- flat: light of the polygon ---- */

static APART void facet_glow(const struct draw *d, uint16_t triangle, int back, struct glow *glow)
{
    int16_t normal[3], middle[3] = {0, 0, 0};

    if (d->tint.points != NULL)
        d->tint.points->middle(d, triangle, middle);
    sheen_facet_normal(d, triangle, back, normal);
    glow_light(d, middle, normal, glow);
}

static APART void flat_corners(const struct setup *s, const struct surface_corners *c, uint32_t channel[3][3])
{
    struct glow glow;

    if (is_piece(c)) {
        carried_channels(c, channel);
        return;
    }
    facet_glow(s->draw, c->at.triangle, c->back, &glow);
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

    facet_glow(d, triangle, back, &glow);
    for (uint32_t k = 0; k < 3; k++)
        carry_corner(d, mesh_index(d->mesh, 3u * triangle + k), &glow, out[k]);
}

const struct sheen_shader sheen_flat_colored = {
    .begin = colored_begin, .carry = flat_colored_carry, .setup = flat_colored_setup, .lights = LIGHTS_ALL};

/* ---- Gouraud: light of the vertices ---- */

/* place: of the vertex in the mesh's arrays of three. */
static APART void vertex_light(const struct draw *d, ptrdiff_t place, int back, struct glow *glow)
{
    int16_t seen[3], store[3];
    const int16_t *normal = normal_of(d, d->mesh->normals + place, seen);

    for (int i = 0; i < 3; i++)
        seen[i] = (int16_t)(back ? -max32(normal[i], -32767) : normal[i]);
    glow_light(d, position_of(d, d->mesh->positions + place, store), seen, glow);
}

static APART void gouraud_corners(const struct setup *s, const struct surface_corners *c, uint32_t channel[3][3])
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
        if (d->tint.lights || c->back)
            vertex_light(d, at, c->back, &glow);
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
        vertex_light(d, 3 * (ptrdiff_t)index, back, &glow);
        carry_corner(d, index, &glow, out[k]);
    }
}

/* White light alone: what has colours does not fit a vertex. */
static void gouraud_colored_light(const struct draw *d, const int16_t normal[3], uint16_t kept[2])
{
    struct lit lit = {0, 0};

    if (!d->tint.lights)
        light_normal(&d->light, &d->power, normal, &lit);
    kept[0] = (uint16_t)lit.diffuse;
    kept[1] = (uint16_t)lit.specular;
}

const struct sheen_shader sheen_gouraud_colored = {.begin = colored_begin,
                                                   .light = gouraud_colored_light,
                                                   .carry = gouraud_colored_carry,
                                                   .setup = gouraud_colored_setup,
                                                   .lights = LIGHTS_ALL,
                                                   .needs_normals = 1};
