/*
 * lit.c - what light a triangle's set-up begins with: at its corners, or at the polygon that it is of.
 */
#include "facet.h"
#include "morph.h"

void sheen_facet_normal(const struct draw *d, uint32_t triangle, int back, int16_t normal[3])
{
    facet_normal(d->mesh, d->mesh, triangle, normal);
    if (d->morph != NULL)
        d->morph->morpher->facet(d, triangle, normal);
    if (back)
        for (int i = 0; i < 3; i++)
            normal[i] = (int16_t)-max32(normal[i], -32767);
}

void sheen_facet_lit(const struct setup *s, const struct surface_corners *c, struct lit *lit)
{
    int16_t normal[3];

    sheen_facet_normal(s->draw, c->at.triangle, c->back, normal);
    light_normal(&s->draw->light, &s->draw->power, normal, lit);
}

void sheen_light_back(const struct setup *s, const int16_t normal[3], struct lit *lit)
{
    int16_t store[3];

    normal = normal_of(s->draw, normal, store);
    for (int k = 0; k < 3; k++)
        store[k] = (int16_t)-max32(normal[k], -32767);
    light_normal(&s->draw->light, &s->draw->power, store, lit);
}
