/*
 * setup_flat.c - one colour a polygon: what flat shading and degenerate triangles use.
 */
#include "stages.h"

void sheen_setup_constant(const struct sheen_frame *f, struct setup *s, const struct lit *lit)
{
    const struct colour_terms *terms = &s->draw->colour;
    const uint32_t half = 1u << (terms->fraction - 1);
    uint32_t level[3];

    for (int k = 0; k < 3; k++) {
        uint32_t channel = colour_channel(terms, k, lit);
        s->shade.flat.channel[k] = channel < terms->top[k] ? channel : terms->top[k];
        level[k] = (s->shade.flat.channel[k] + half) >> terms->fraction;
    }
    s->way = SHEEN_WAY_FLAT;
    s->fast = sheen_rounds_early(f);
    s->shade.flat.pixel = pixel_order(level[0] << 11 | level[1] << 5 | level[2], f->format.swap);
}

/* The normal of a triangle from its corners, for meshes that have none. Range: differences < 2^17. */
static int corner_normal(const struct sheen_mesh *mesh, uint32_t triangle, sheen_q30_t normal[3])
{
    int32_t points[9];
    const uint32_t corners[3] = {0, 1, 2};

    for (uint32_t k = 0; k < 3; k++)
        for (uint32_t i = 0; i < 3; i++)
            points[3 * k + i] = mesh->positions[3 * mesh_index(mesh, 3 * triangle + k) + i];
    return sheen_polygon_normal(points, corners, 3, normal);
}

/* Unit normal of the polygon that a triangle is of; zero where it has no area. */
static void polygon_normal(const struct sheen_mesh *mesh, uint32_t triangle, int16_t normal[3])
{
    if (mesh->polygon_normals != NULL) {
        uint32_t polygon = mesh->polygons != NULL ? mesh->polygons[triangle] : triangle;
        for (uint32_t i = 0; i < 3; i++)
            normal[i] = mesh->polygon_normals[3 * polygon + i];
        return;
    }
    sheen_q30_t unit[3] = {0, 0, 0};
    int known = corner_normal(mesh, triangle, unit) == SHEEN_OK;
    for (int i = 0; i < 3; i++)
        normal[i] = (int16_t)(known ? min32(asr32(unit[i] + (1 << 14), 15), 32767) : 0);
}

void sheen_setup_flat(const struct sheen_frame *f, struct setup *s, const struct surface_corners *c)
{
    int16_t normal[3];
    struct lit lit;

    polygon_normal(s->draw->mesh, c->at.triangle, normal);
    if (c->back)
        for (int i = 0; i < 3; i++)
            normal[i] = (int16_t)-max32(normal[i], -32767);
    sheen_light_normal(&s->draw->light, s->draw->material, normal, &lit);
    sheen_setup_constant(f, s, &lit);
}
