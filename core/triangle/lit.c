/*
 * lit.c - the light that a triangle's set-up starts from: at its corners, or at its polygon.
 */
#include "../math/vector.h"
#include "morph.h"

/*
 * A triangle's normal from its corners, for meshes without polygon normals: the cross product of two edges. Range:
 * differences < 2^17, so its parts are below 2^35.
 */
static int corner_normal(const struct sheen_mesh *mesh, const int16_t *positions, uint32_t triangle,
                         sheen_q30_t normal[3])
{
    const int16_t *p[3];
    int64_t cross[3];

    for (uint32_t k = 0; k < 3; k++)
        p[k] = positions + 3 * mesh_index(mesh, 3 * triangle + k);
    for (int i = 0; i < 3; i++) {
        int j = i == 2 ? 0 : i + 1, k = i == 0 ? 2 : i - 1;
        cross[i] =
            (int64_t)(p[1][j] - p[0][j]) * (p[2][k] - p[0][k]) - (int64_t)(p[1][k] - p[0][k]) * (p[2][j] - p[0][j]);
    }
    return sheen_normalize_wide(cross, normal);
}

void sheen_frame_normal(const struct sheen_mesh *mesh, const struct sheen_mesh *frame, uint32_t triangle,
                        int16_t normal[3])
{
    if (frame->polygon_normals != NULL) {
        uint32_t polygon = mesh->polygons != NULL ? mesh->polygons[triangle] : triangle;
        for (uint32_t i = 0; i < 3; i++)
            normal[i] = frame->polygon_normals[3 * polygon + i];
        return;
    }
    sheen_q30_t unit[3] = {0, 0, 0};
    int known = corner_normal(mesh, frame->positions, triangle, unit) == SHEEN_OK;
    for (int i = 0; i < 3; i++)
        normal[i] = (int16_t)(known ? min32(asr32(unit[i] + (1 << 14), 15), 32767) : 0);
}

void sheen_facet_normal(const struct draw *d, uint32_t triangle, int back, int16_t normal[3])
{
    sheen_frame_normal(d->mesh, d->mesh, triangle, normal);
    if (d->morph != NULL)
        d->morph->morpher->facet(d, triangle, normal);
    if (back)
        for (int i = 0; i < 3; i++)
            normal[i] = (int16_t)-max32(normal[i], -32767);
}

/*
 * A number that only triangles with the same normal share: the polygon's if it has a stored normal that does not morph,
 * else the triangle's.
 */
static uint32_t facet_of(const struct draw *d, uint32_t triangle)
{
    const struct sheen_mesh *mesh = d->mesh;

    return mesh->polygons != NULL && mesh->polygon_normals != NULL && d->morph == NULL ? mesh->polygons[triangle]
                                                                                       : triangle;
}

HOT int sheen_facet_lit(const struct setup *s, const struct surface_corners *c, struct lit *lit)
{
    const struct draw *d = s->draw;
    struct lit_facet *last = c->facet;
    const uint32_t facet = 2 * facet_of(d, c->at.triangle) + c->back;
    int16_t normal[3];

    if (last->draw == d && last->facet == facet) {
        lit->diffuse = last->diffuse;
        lit->specular = last->specular;
        return 1;
    }
    SHEEN_TAP(FACET_LIT, 1);
    sheen_facet_normal(d, c->at.triangle, c->back, normal);
    light_normal(&d->light, &d->power, normal, lit);
    last->draw = d;
    last->facet = facet;
    last->diffuse = (uint16_t)lit->diffuse;
    last->specular = (uint16_t)lit->specular;
    return 0;
}

void sheen_light_back(const struct setup *s, const int16_t normal[3], struct lit *lit)
{
    int16_t store[3];

    normal = normal_of(s->draw, normal, store);
    for (int k = 0; k < 3; k++)
        store[k] = (int16_t)-max32(normal[k], -32767);
    light_normal(&s->draw->light, &s->draw->power, store, lit);
}
