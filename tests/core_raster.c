/*
 * core_raster.c - the core's set-up and edge stepping.
 */
#include "core_raster.h"

#include <string.h>

static const uint16_t indices[3] = {0, 1, 2};
static const int16_t positions[9], polygon_normals[3] = {0, 0, 32767};

void core_raster_begin(struct core_raster *r, int width, int height)
{
    const struct sheen_target target = {.width = (uint16_t)width, .height = (uint16_t)height};

    memset(r, 0, sizeof *r);
    r->mesh = (struct sheen_mesh){.positions = positions,
                                  .polygon_normals = polygon_normals,
                                  .indices = indices,
                                  .index_bytes = 2,
                                  .vertices = 3,
                                  .triangles = 1,
                                  .scale = 1};
    r->material = (struct sheen_material){.ambient = SHEEN_Q16(1)};
    r->screen = (struct screen){.viewport = {0, 0, (int16_t)width, (int16_t)height},
                                .centre_x = SUBPIXEL_HALF * width,
                                .centre_y = SUBPIXEL_HALF * height,
                                .flat_weight = 1};
    r->draw = (struct draw){.mesh = &r->mesh, .power = power_of(NULL), .shader = &sheen_flat, .two_sided = 1};
    sheen_format_begin(&r->format, &target);
    sheen_colour_begin(&r->draw.colour, &r->format, &r->material, 0, 0);
}

int core_raster_set_up(struct core_raster *r, int from, struct core_setup *to)
{
    struct surface_corners c = {.at.triangle = 0};
    struct gradients g;
    int flat;

    for (int k = 0; k < 3; k++) {
        c.at.v[k] = &r->vertex[k];
        c.at.normal[k] = r->mesh.normals != NULL ? r->mesh.normals + 3 * k : NULL;
    }
    if (twice_area(&r->vertex[0], &r->vertex[1], &r->vertex[2]) == 0)
        return 0; /* such triangles are never listed */
    to->s.draw = &r->draw;
    if (!sheen_triangle_begin(&r->screen, from, &c, &g, &flat, &to->s))
        return 0;
    r->draw.shader->setup(&to->s, &c, flat ? NULL : &g);
    return 1;
}

int core_raster_spans(struct core_raster *r, const struct cover_triangle *t, struct sheen_rect rect, struct span *spans,
                      int *first)
{
    struct core_setup setup;
    int16_t first_row = 0;

    for (int k = 0; k < 3; k++) {
        r->vertex[k].x = (int16_t)(t->x[k] - r->screen.centre_x);
        r->vertex[k].y = (int16_t)(t->y[k] - r->screen.centre_y);
        r->vertex[k].z = 1000;
    }
    *first = rect.y0;
    if (!core_raster_set_up(r, rect.y0, &setup))
        return 0;
    unsigned rows = sheen_spans(&r->screen, &setup.s, rect, spans, &first_row);
    *first = first_row;
    return (int)rows;
}
