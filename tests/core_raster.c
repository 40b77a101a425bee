/*
 * core_raster.c - the core's set-up and edge stepping.
 */
#include "core_raster.h"

#include <string.h>

static const uint16_t indices[3] = {0, 1, 2};
static const int16_t positions[9], polygon_normals[3] = {0, 0, 32767};

void core_raster_begin(struct core_raster *r, int width, int height)
{
    memset(r, 0, sizeof *r);
    r->mesh = (struct sheen_mesh){.positions = positions,
                                  .polygon_normals = polygon_normals,
                                  .indices = indices,
                                  .index_bytes = 2,
                                  .vertices = 3,
                                  .triangles = 1,
                                  .scale = 1};
    r->material = (struct sheen_material){.ambient = SHEEN_Q16(1), .shininess = 1};
    (void)sheen_material_prepare(&r->material);
    r->target = (struct sheen_target){.width = (uint16_t)width, .height = (uint16_t)height};
    r->frame.target = &r->target;
    r->frame.viewport = (struct sheen_rect){0, 0, (int16_t)width, (int16_t)height};
    r->frame.vertex = r->vertex;
    r->frame.entry = r->entry;
    r->frame.cut = r->cut;
    r->frame.draw = &r->draw;
    r->frame.vertices = 3;
    r->frame.entries = 1;
    r->frame.draws = 1;
    r->entry[0].next = NONE;
    r->draw = (struct draw_record){
        .mesh = &r->mesh, .material = &r->material, .end_entry = 1, .shading = SHEEN_FLAT, .two_sided = 1};
    sheen_format_begin(&r->frame.format, &r->target);
    sheen_colour_begin(&r->draw.colour, &r->frame.format, &r->material, &r->draw.light);
}

int core_raster_spans(struct core_raster *r, const struct cover_triangle *t, struct sheen_rect rect, struct span *spans,
                      int *first)
{
    struct setup setup;
    int16_t first_row = 0;

    for (int k = 0; k < 3; k++) {
        r->vertex[k].x = (int16_t)(t->x[k] - SUBPIXEL_HALF * r->frame.viewport.x1);
        r->vertex[k].y = (int16_t)(t->y[k] - SUBPIXEL_HALF * r->frame.viewport.y1);
        r->vertex[k].z = 1000;
    }
    *first = rect.y0;
    if (twice_area(&r->vertex[0], &r->vertex[1], &r->vertex[2]) == 0)
        return 0; /* such triangles are never listed */
    if (!sheen_setup(&r->frame, &r->draw, 0, rect.y0, &setup))
        return 0;
    unsigned rows = sheen_spans(&r->frame, &setup, rect, spans, &first_row);
    *first = first_row;
    return (int)rows;
}
