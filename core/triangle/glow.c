/*
 * glow.c - light with colours, and from point lights, at vertices and polygons.
 */
#include "glow.h"
#include "morph.h"

_Static_assert(sizeof(struct tint_terms) <= offsetof(struct loop_terms, usable), "fog marks loops as unusable");

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
    int32_t place[3]; /* Q11.20: raw / 2^15 times reach, Q7.24, less 4 bits */

    for (int i = 0; i < 3; i++)
        place[i] = sheen_mul_round(at[i], d->tint.reach, 19);
    sheen_light_tinted(&d->light, &d->power, &d->tint, place, normal, &lit);
    for (int i = 0; i < 3; i++) {
        const uint32_t low = mul_high(d->tint.low[i], lit.low[i] << 16) * 2; /* lit.low: UQ1.15, up to 1.0 */
        glow->base[i] = terms->a[i] + low + terms->b[i] * lit.diffuse[i];
        glow->highlight[i] = terms->c[i] * lit.specular[i];
    }
}

static inline void glow_light(const struct draw *d, const int16_t at[3], const int16_t seen[3], struct glow *glow)
{
    if (d->tint.is_tinted)
        tinted_light(d, at, seen, glow);
    else
        white_light(d, seen, glow);
}

void sheen_polygon_glow(const struct draw *d, uint16_t triangle, int back, struct glow *glow)
{
    int16_t normal[3], middle[3] = {0, 0, 0};

    if (d->tint.points != NULL)
        d->tint.points->middle(d, triangle, middle);
    sheen_facet_normal(d, triangle, back, normal);
    glow_light(d, middle, normal, glow);
}

void sheen_vertex_glow(const struct draw *d, ptrdiff_t place, int back, struct glow *glow)
{
    int16_t seen[3], store[3];
    const int16_t *normal = normal_of(d, d->mesh->normals + place, seen);

    for (int i = 0; i < 3; i++)
        seen[i] = (int16_t)(back ? -max32(normal[i], -32767) : normal[i]);
    glow_light(d, position_of(d, d->mesh->positions + place, store), seen, glow);
}

/*
 * Collects what lights have in d->tint. Ambient light is multiplied by its colour, except for what a ramp's low added
 * to it, which counts as the lights'.
 */
COLD void sheen_glow_begin(struct draw *d, const struct sheen_material *material, const struct pixel_format *format,
                           const struct sheen_object *object, const struct sheen_pose *view)
{
    const struct sheen_material *own = object->material;
    const uint8_t *ambient = own->ambient_color;
    const int white = (ambient[0] | ambient[1] | ambient[2]) == 0, is_low = own->ambient < material->ambient;
    const uint32_t share = is_low ? sheen_ratio((uint32_t)own->ambient, (uint32_t)material->ambient) : 0;

    (void)format;
    d->tint.texture = material->texture;
    d->tint.is_tinted = 0;
    d->tint.points = NULL;
    d->tint.point_mask = 0;
    for (unsigned i = 0; i < d->light.count; i++) {
        const uint8_t *color = object->lights[i].color;
        const int coloured = (color[0] | color[1] | color[2]) != 0;
        for (int k = 0; k < 3; k++)
            d->tint.color[i][k] = coloured ? color[k] : 255;
        if (object->lights[i].radius > 0)
            d->tint.points = object->lights[i].points;
        d->tint.is_tinted |= (uint8_t)(coloured || d->tint.points != NULL);
    }
    if (d->tint.points != NULL)
        d->tint.points->place(d, object, view);
    for (int k = 0; k < 3; k++) {
        const uint32_t a = d->colour.a[k], part = is_low ? mul_high(a, share) : a;
        d->tint.low[k] = d->tint.is_tinted ? a - part : 0;
        d->colour.a[k] = by_colour(part, white ? 255 : ambient[k]) + (d->tint.is_tinted ? 0 : a - part);
    }
}
