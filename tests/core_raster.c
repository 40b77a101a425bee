/*
 * core_raster.c - runs one triangle through the core's set-up and edge stepping.
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
    sheen_colour_reach(&r->draw.colour, &r->format);
}

unsigned core_raster_set_up(struct core_raster *r, struct sheen_rect rect, struct span *spans, struct core_setup *to)
{
    const int16_t *parts = corner_parts(&r->mesh, r->draw.shader);
    const int size = r->draw.shader->needs_uvs ? 2 : 3;
    struct lit_facet facet = {.draw = NULL};
    struct surface_corners c = {.at.triangle = 0, .facet = &facet};
    struct gradients g;

    for (int k = 0; k < 3; k++) {
        int corner = (3 - k) % 3; /* reversed, because meshes are counter-clockwise */
        c.at.v[k] = &r->vertex[corner];
        c.at.normal[k] = parts != NULL ? parts + size * corner : NULL;
    }
    if (sheen_twice_area(&r->vertex[0], &r->vertex[1], &r->vertex[2]) == 0)
        return 0; /* the core never lists triangles without area */
    to->s.draw = &r->draw;
    unsigned rows = sheen_triangle_begin(&r->screen, rect, spans, &c, &g, &to->s);
    if (rows > 0)
        r->draw.shader->setup(&to->s, &c, c.flat ? NULL : &g);
    return rows;
}

int core_raster_spans(struct core_raster *r, const struct cover_triangle *t, struct sheen_rect rect, struct span *spans,
                      int *first)
{
    struct core_setup setup;
    struct sheen_rect upper = rect;

    for (int k = 0; k < 3; k++) {
        r->vertex[k].x = (int16_t)(t->x[k] - r->screen.centre_x);
        r->vertex[k].y = (int16_t)(t->y[k] - r->screen.centre_y);
        r->vertex[k].z = 1000;
        r->vertex[k].flags = t->x[k] < 64 * rect.x0 || t->x[k] > 64 * rect.x1 ? OFF_VIEW : 0;
    }
    *first = rect.y0;
    /* As in two bands: set up in the upper one and continued below or, if the upper one has no row, set up later. */
    upper.y1 = (int16_t)((rect.y0 + rect.y1) / 2);
    unsigned rows = core_raster_set_up(r, upper, spans, &setup);
    if (rows == 0 && (rows = core_raster_set_up(r, rect, spans, &setup)) == 0)
        return 0;
    *first = setup.s.row - (int)rows;
    return (int)(rows + sheen_spans(&setup.s, rect, spans + rows));
}

void core_raster_depths(struct core_raster *r, uint16_t *depth)
{
    static uint16_t pixels[640 * 480];

    core_raster_draw(r, depth, pixels);
}

void core_raster_draw(struct core_raster *r, uint16_t *depth, uint16_t *pixels)
{
    static struct span spans[480];
    const struct sheen_rect all = r->screen.viewport;
    struct tile tile = {.rect = all,
                        .pitch = (unsigned)all.x1,
                        .pixels = pixels,
                        .depth = depth,
                        .to_pixel = (char *)pixels - (char *)depth,
                        .format = &r->format,
                        .thresholds = sheen_thresholds,
                        .centre_x = r->screen.centre_x,
                        .centre_y = r->screen.centre_y,
                        .spans = spans};
    struct core_setup setup;

#if FAST_LOOPS
    static const threshold_t *dither_rows[8];

    tile.dither_rows = dither_rows;
    sheen_dither_begin(&tile, dither_rows);
#endif
#if SHEEN_STATS
    uint32_t shaded = 0;
    tile.shaded = &shaded;
#endif

    tile.rows = core_raster_set_up(r, all, spans, &setup);
    tile.first_row = (int16_t)(setup.s.row - (int32_t)tile.rows);
    if (tile.rows > 0)
        setup.s.rows(&tile, &setup.s);
}
