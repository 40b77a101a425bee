/*
 * glow.h - private: light with colours at corners, from white lights too and from point lights: channels.
 */
#ifndef SHEEN_GLOW_H
#define SHEEN_GLOW_H

#include "triangle.h"

/* Channels of light at a corner: what a vertex's colour multiplies, and the highlight. */
struct glow {
    uint32_t base[3], highlight[3];
};

/* What a shader's `begin` does that reads colours of lights: d->tint and ambient light are theirs. */
void sheen_glow_begin(struct draw *d, const struct sheen_material *material, const struct pixel_format *format,
                      const struct sheen_object *object, const struct sheen_pose *view);

/* At the polygon that a triangle is of; at a vertex, `place` is its in the mesh's arrays of three. As seen. */
void sheen_polygon_glow(const struct draw *d, uint16_t triangle, int back, struct glow *glow);
void sheen_vertex_glow(const struct draw *d, ptrdiff_t place, int back, struct glow *glow);

/* Of white lights. */
static inline void white_glow(const struct draw *d, const struct lit *lit, struct glow *glow)
{
    const struct colour_terms *terms = &d->colour;

    for (int i = 0; i < 3; i++) {
        glow->base[i] = terms->a[i] + terms->b[i] * lit->diffuse;
        glow->highlight[i] = terms->c[i] * lit->specular;
    }
}

#endif
