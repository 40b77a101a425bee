/*
 * glow.h - private: light at corners in three channels, from coloured, white and point lights.
 */
#ifndef SHEEN_GLOW_H
#define SHEEN_GLOW_H

#include "triangle.h"

/* Channels of light at a corner: `base`, which a vertex's colour multiplies, and the highlight. */
struct glow {
    uint32_t base[3], highlight[3];
};

/* The `begin` of shaders that read colours of lights: makes d->tint and gives the ambient light its colour. */
void sheen_glow_begin(struct draw *d, const struct sheen_material *material, const struct pixel_format *format,
                      const struct sheen_object *object, const struct sheen_pose *view);

/*
 * Light at a triangle's polygon, and at the vertex whose parts begin at `place` in the mesh's arrays of 3 per vertex;
 * the normal is that of the side that is seen.
 */
void sheen_polygon_glow(const struct draw *d, uint16_t triangle, int back, struct glow *glow);
void sheen_vertex_glow(const struct draw *d, ptrdiff_t place, int back, struct glow *glow);

/* The glow of white lights. */
static inline void white_glow(const struct draw *d, const struct lit *lit, struct glow *glow)
{
    const struct colour_terms *terms = &d->colour;

    for (int i = 0; i < 3; i++) {
        glow->base[i] = terms->a[i] + terms->b[i] * lit->diffuse;
        glow->highlight[i] = terms->c[i] * lit->specular;
    }
}

#endif
