/*
 * lit.c - what light a triangle's set-up begins with: at its corners, or at the polygon that it is of.
 */
#include "triangle.h"

/*
 * The normal of a triangle from its corners, for meshes that have none: the cross
 * product of two edges. Range: differences < 2^17, so its parts are below 2^35 and
 * 32 bits of the largest are kept.
 */
static int corner_normal(const struct sheen_mesh *mesh, uint32_t triangle, sheen_q30_t normal[3])
{
    const int16_t *p[3];
    int64_t cross[3];
    int32_t kept[3], a[3], b[3];
    uint64_t all = 0;

    for (uint32_t k = 0; k < 3; k++)
        p[k] = mesh->positions + 3 * mesh_index(mesh, 3 * triangle + k);
    for (int i = 0; i < 3; i++) {
        a[i] = p[1][i] - p[0][i];
        b[i] = p[2][i] - p[0][i];
    }
    for (int i = 0; i < 3; i++) {
        int j = i == 2 ? 0 : i + 1, k = i == 0 ? 2 : i - 1;
        cross[i] = (int64_t)a[j] * b[k] - (int64_t)a[k] * b[j];
        all |= (uint64_t)(cross[i] < 0 ? -cross[i] : cross[i]);
    }
    unsigned zeros = clz64(all);
    for (int i = 0; i < 3; i++)
        kept[i] = (int32_t)asr64(cross[i], zeros < 33 ? 33 - zeros : 0);
    return sheen_normalize(kept, normal);
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

void sheen_facet_lit(const struct setup *s, const struct surface_corners *c, struct lit *lit)
{
    int16_t normal[3];

    polygon_normal(s->draw->mesh, c->at.triangle, normal);
    if (c->back)
        for (int i = 0; i < 3; i++)
            normal[i] = (int16_t)-max32(normal[i], -32767);
    light_normal(&s->draw->light, &s->draw->power, normal, lit);
}

void sheen_light_back(const struct setup *s, const int16_t normal[3], struct lit *lit)
{
    const int16_t negated[3] = {(int16_t)-max32(normal[0], -32767), (int16_t)-max32(normal[1], -32767),
                                (int16_t)-max32(normal[2], -32767)};

    light_normal(&s->draw->light, &s->draw->power, negated, lit);
}
