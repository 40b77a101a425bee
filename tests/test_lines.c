/*
 * test_lines.c - what is drawn of edges: the same pixels in whatever bands, by whichever worker; and where.
 */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "edge_picture.h"
#include "sheen_arena.h"

#define WIDTH 160
#define HEIGHT 120
#define PIXELS (WIDTH * HEIGHT)

static struct edge_mesh meshes[EDGE_MESHES];

static void scene_of(struct ref_scene *scene, const struct edge_mesh *mesh, double yaw, double distance)
{
    ref_scene_default(scene, mesh->reference);
    ref_scene_orbit(scene, yaw, 20, 0, distance);
    scene->width = WIDTH;
    scene->height = HEIGHT;
}

static void picture(uint16_t *values, const struct ref_scene *scene, const struct edge_mesh *mesh,
                    const struct edge_drawing *drawing)
{
    assert_int_equal(edge_picture(values, scene, &mesh->mesh, drawing), SHEEN_OK);
}

/* Bands of any height, from below, by two workers: what they draw is what one band does. */
static void check_bands(const struct ref_scene *scene, const struct edge_mesh *mesh, struct edge_drawing drawing)
{
    static const struct edge_drawing other[] = {{.band_rows = 1},
                                                {.band_rows = 3, .bottom_up = true},
                                                {.band_rows = 5, .second = true},
                                                {.band_rows = 7, .workers = 2},
                                                {.band_rows = 16, .buffers = 2},
                                                {.band_rows = 61, .workers = 3, .bottom_up = true}};
    static uint16_t whole[PIXELS], banded[PIXELS];

    drawing.band_rows = HEIGHT;
    picture(whole, scene, mesh, &drawing);
    for (size_t i = 0; i < sizeof other / sizeof other[0]; i++) {
        drawing.band_rows = other[i].band_rows;
        drawing.buffers = other[i].buffers;
        drawing.workers = other[i].workers;
        drawing.bottom_up = other[i].bottom_up;
        drawing.second = other[i].second;
        picture(banded, scene, mesh, &drawing);
        for (int at = 0; at < PIXELS; at++)
            if (whole[at] != banded[at])
                fail_msg("%s, bands of %d rows: pixel %d, %d is %04x, not %04x", mesh->name, drawing.band_rows,
                         at % WIDTH, at / WIDTH, banded[at], whole[at]);
    }
}

static void test_bands(void **state)
{
    static const enum sheen_pixel pixel[] = {SHEEN_RGB565_BE, SHEEN_GREY2, SHEEN_GREY16, SHEEN_GREY256};
    static const double distance[] = {3.5, 1.15, 12};
    int scenes = 0;

    (void)state;
    for (int m = 0; m < EDGE_MESHES; m++)
        for (unsigned edging = SHEEN_SMOOTH; edging < SHEEN_EDGINGS; edging++)
            for (unsigned k = 0; k < 12; k++, scenes++) {
                struct ref_scene scene;
                scene_of(&scene, &meshes[m], 30 + 47 * scenes, distance[k / 4]);
                scene.shading = (enum ref_shading)(scenes % 4);
                scene.two_sided = k / 4 == 1;
                scene.affine = k == 6;
                const struct edge_drawing drawing = {
                    .edges = sheen_edges_of(edging), .pixel = pixel[k % 4], .line = {255, 128, 40}};
                check_bands(&scene, &meshes[m], drawing);
            }
}

/* ---- lines against edges of the reference ---- */

enum {
    FINE = 4 /* pixels of the reference a side of the picture's */
};

#define NEARER                                                                                                         \
    1.01 /* of depth: what lies so far before an edge hides it; what does not lie before a contour at all does not */
#define AROUND 1.0    /* px: no edge is called seen or hidden where that changes so near */
#define BESIDE 1.5    /* px: from a point of a line to the centre of a pixel of it, at the most: no gap is 2 px long */
#define SMOOTHED 1.0  /* px: the same of a contour and what is smoothed there */
#define SAMPLES_PX 4. /* of an edge */

/* A picture of lines alone, or of what smoothing changed, and what should be there. */
struct line_case {
    const struct edge_mesh *mesh;
    struct ref_picture fine;
    uint8_t *front;
    uint16_t drawn[PIXELS];
    uint8_t allowed[PIXELS]; /* an edge that is not surely hidden passes */
    enum sheen_edging edging;
    double beside;
    long seen, samples;
};

static bool is_contour(const struct line_case *c, uint32_t triangle, int k)
{
    uint16_t across = c->mesh->edges[triangle].across[k];

    return across == SHEEN_NO_TRIANGLE || !c->front[across];
}

/* Whether edge k of a triangle that faces the eye is drawn. */
static bool is_line(const struct line_case *c, uint32_t triangle, int k)
{
    const struct sheen_triangle_edges *e = &c->mesh->edges[triangle];

    if (is_contour(c, triangle, k) || c->edging == SHEEN_SMOOTH)
        return is_contour(c, triangle, k);
    return c->edging == SHEEN_WIRE ? !(e->inner >> k & 1) : (e->sharp >> k & 1) != 0;
}

/* An edge on the fine picture. */
struct seen_edge {
    const struct ref_piece *piece;
    int k;
    double out[2]; /* of a contour: its unit normal, away from the triangle; zero: what is on both sides may hide it */
};

/*
 * 1: nothing hides the point; -1: something does, all around; 0: it may. depth: 1/m. Its own triangles do not hide an
 * edge, nor does what lies on the inner side of a contour.
 */
static int seen_at(const struct line_case *c, const struct seen_edge *edge, double x, double y, double depth)
{
    const bool contour = edge->out[0] != 0 || edge->out[1] != 0;
    const uint32_t own = edge->piece->triangle, across = c->mesh->edges[own].across[edge->k];
    int before = 0, hidden = 0, all = 0, fine_x = (int)floor(x * FINE), fine_y = (int)floor(y * FINE),
        reach = (int)(AROUND * FINE);

    for (int j = fine_y - reach; j <= fine_y + reach; j++)
        for (int i = fine_x - reach; i <= fine_x + reach; i++) {
            if (i < 0 || j < 0 || i >= WIDTH * FINE || j >= HEIGHT * FINE)
                continue;
            const struct ref_pixel *p = &c->fine.pixels[j * WIDTH * FINE + i];
            if ((i + 0.5 - x * FINE) * edge->out[0] + (j + 0.5 - y * FINE) * edge->out[1] < 0)
                continue;
            all++;
            if (!p->covered || p->triangle == own || p->triangle == across)
                continue;
            before += 1 / p->m > depth * (contour ? 1 : NEARER);
            hidden += 1 / p->m > depth * NEARER;
        }
    return before == 0 ? 1 : hidden == all ? -1 : 0;
}

static double line_near(const struct line_case *c, double x, double y)
{
    double least = 1e9;

    for (int j = (int)y - 2; j <= (int)y + 2; j++)
        for (int i = (int)x - 2; i <= (int)x + 2; i++)
            if (i >= 0 && j >= 0 && i < WIDTH && j < HEIGHT && c->drawn[j * WIDTH + i] != 0)
                least = fmin(least, hypot(i + 0.5 - x, j + 0.5 - y));
    return least;
}

static void allow(struct line_case *c, double x, double y)
{
    for (int j = (int)y - 2; j <= (int)y + 2; j++)
        for (int i = (int)x - 2; i <= (int)x + 2; i++)
            if (i >= 0 && j >= 0 && i < WIDTH && j < HEIGHT && hypot(i + 0.5 - x, j + 0.5 - y) <= c->beside)
                c->allowed[j * WIDTH + i] = 1;
}

static void walk_edge(struct line_case *c, const struct ref_piece *p, int k)
{
    const int to = (k + 1) % 3;
    const double dx = p->x[to] - p->x[k], dy = p->y[to] - p->y[k], length = hypot(dx, dy);
    const int steps = (int)ceil(length / FINE * SAMPLES_PX) + 1;
    struct seen_edge edge = {p, k, {0, 0}};

    if (is_contour(c, p->triangle, k) && length > 0) { /* counter-clockwise, y down: the triangle lies to the left */
        edge.out[0] = -dy / length;
        edge.out[1] = dx / length;
    }
    for (int i = 0; i <= steps; i++) {
        double t = i / (double)steps, x = (1 - t) * p->x[k] + t * p->x[to], y = (1 - t) * p->y[k] + t * p->y[to];
        int seen = seen_at(c, &edge, x / FINE, y / FINE, (1 - t) * p->depth[k] + t * p->depth[to]);
        c->samples++;
        if (seen < 0)
            continue;
        allow(c, x / FINE, y / FINE);
        c->seen += seen;
        if (seen > 0 && c->edging != SHEEN_SMOOTH && line_near(c, x / FINE, y / FINE) > BESIDE)
            fail_msg("%s: no line at %.2f, %.2f, where an edge is seen", c->mesh->name, x / FINE, y / FINE);
    }
}

static void draw_smoothed(struct line_case *c, const struct ref_scene *scene, enum sheen_pixel pixel)
{
    static uint16_t plain[PIXELS];
    struct edge_drawing drawing = {.pixel = pixel};

    picture(plain, scene, c->mesh, &drawing);
    drawing.edges = &sheen_edges_smooth;
    picture(c->drawn, scene, c->mesh, &drawing);
    for (int at = 0; at < PIXELS; at++)
        c->drawn[at] = c->drawn[at] != plain[at];
}

static void draw_lines(struct line_case *c, struct ref_scene scene)
{
    static uint16_t mono[PIXELS];
    struct edge_drawing drawing = {.edges = sheen_edges_of(c->edging), .line = {255, 255, 255}};

    scene.ambient = scene.diffuse = scene.specular = 0;
    memset(scene.background, 0, sizeof scene.background);
    picture(c->drawn, &scene, c->mesh, &drawing);
    drawing.pixel = SHEEN_GREY2;
    picture(mono, &scene, c->mesh, &drawing);
    for (int at = 0; at < PIXELS; at++)
        assert_int_equal(mono[at] != 0, c->drawn[at] != 0);
}

/* Edges of the reference that are seen, and the pixels that something may be drawn at. */
static void find_lines(struct line_case *c, struct ref_scene scene)
{
    scene.width *= FINE;
    scene.height *= FINE;
    assert_int_equal(ref_render(&c->fine, &scene), 0);
    c->front = calloc(c->mesh->mesh.triangles, 1);
    assert_non_null(c->front);
    for (size_t i = 0; i < c->fine.piece_count; i++)
        c->front[c->fine.pieces[i].triangle] = 1;
    for (size_t i = 0; i < c->fine.piece_count; i++)
        for (int k = 0; k < 3; k++)
            if (is_line(c, c->fine.pieces[i].triangle, k))
                walk_edge(c, &c->fine.pieces[i], k);
    free(c->front);
    ref_picture_free(&c->fine);
}

/*
 * Where an edge is seen there is a line, from end to end; where none is, or all are hidden, there is none. Smoothing
 * changes pixels at contours that are seen, no others.
 */
static void check_lines(const struct edge_mesh *mesh, enum sheen_edging edging, enum sheen_pixel pixel)
{
    static struct line_case c;
    struct ref_scene scene;
    int lines = 0;

    memset(&c, 0, sizeof c);
    c.mesh = mesh;
    c.edging = edging;
    c.beside = edging == SHEEN_SMOOTH ? SMOOTHED : BESIDE;
    scene_of(&scene, mesh, 30, 3.5);
    if (edging == SHEEN_SMOOTH)
        draw_smoothed(&c, &scene, pixel);
    else
        draw_lines(&c, scene);
    find_lines(&c, scene);
    for (int at = 0; at < PIXELS; at++) {
        lines += c.drawn[at] != 0;
        if (c.drawn[at] != 0 && !c.allowed[at])
            fail_msg("%s: %d, %d is drawn, where no edge is seen", mesh->name, at % WIDTH, at / WIDTH);
    }
    print_message("%s, edges %d: %d pixels; %ld of %ld points of edges are seen\n", mesh->name, edging, lines, c.seen,
                  c.samples);
    assert_true(c.seen > c.samples / 4);
    assert_true(lines > 50);
}

static void test_outlines_are_whole(void **state)
{
    (void)state;
    for (int m = 0; m < EDGE_MESHES; m++)
        check_lines(&meshes[m], SHEEN_OUTLINE, SHEEN_RGB565_BE);
}

static void test_wire_hides_what_triangles_hide(void **state)
{
    (void)state;
    for (int m = 0; m < EDGE_MESHES; m++)
        check_lines(&meshes[m], SHEEN_WIRE, SHEEN_RGB565_BE);
}

static void test_contours_alone_are_smoothed(void **state)
{
    static const enum sheen_pixel pixel[] = {SHEEN_RGB565_BE, SHEEN_RGB565_LE, SHEEN_GREY16, SHEEN_GREY256};

    (void)state;
    for (unsigned i = 0; i < 4 * EDGE_MESHES; i++)
        check_lines(&meshes[i / 4], SHEEN_SMOOTH, pixel[i % 4]);
}

static void test_two_levels_are_not_smoothed(void **state)
{
    static uint16_t plain[PIXELS], smooth[PIXELS];
    struct ref_scene scene;

    (void)state;
    for (int m = 0; m < EDGE_MESHES; m++) {
        struct edge_drawing drawing = {.pixel = SHEEN_GREY2};
        scene_of(&scene, &meshes[m], 30, 3.5);
        picture(plain, &scene, &meshes[m], &drawing);
        drawing.edges = &sheen_edges_smooth;
        picture(smooth, &scene, &meshes[m], &drawing);
        assert_memory_equal(plain, smooth, sizeof plain);
    }
}

static int no_push(void *ctx, struct sheen_rect rect, const void *pixels)
{
    (void)ctx;
    (void)rect;
    (void)pixels;
    return SHEEN_OK;
}

/* What sheen_arena.h says of edges is what they take. */
static void test_arena(void **state)
{
    static const uint16_t width[] = {240, 72, 134}, rows[] = {16, 5, 1};

    (void)state;
    for (unsigned i = 0; i < 36; i++) {
        const unsigned w = width[i % 3], r = rows[i / 3 % 3], workers = 1 + i / 18;
        const unsigned pixel = i / 9 % 2 ? SHEEN_GREY16 : SHEEN_RGB565_BE, bytes = i / 9 % 2 ? 1 : 2;
        const struct sheen_target target = {
            .push = no_push, .align_x = 2, .width = (uint16_t)w, .height = 80, .pixel = (enum sheen_pixel)pixel};
        struct sheen_config config = {.target = &target,
                                      .band_rows = (uint16_t)r,
                                      .buffers = (uint8_t)(1 + i % 2),
                                      .workers = (uint8_t)workers,
                                      .max_vertices = 100,
                                      .max_triangles = 100};
        size_t before = sheen_arena_size(&config);
        config.max_edges = 77;
        size_t edges = sheen_arena_size(&config);
        config.smooth = 1;
        size_t smooth = sheen_arena_size(&config);
        assert_int_equal(edges - before, SHEEN_EDGE_BYTES(w, bytes, r, config.buffers, 77) +
                                             (workers - 1) * SHEEN_EDGE_WORKER_BYTES(w, bytes, r, config.buffers));
        assert_int_equal(smooth - edges, workers * SHEEN_SMOOTH_BYTES(w, r));
    }
}

static int make_meshes(void **state)
{
    (void)state;
    for (unsigned m = 0; m < EDGE_MESHES; m++)
        if (edge_mesh_make(&meshes[m], (enum edge_mesh_name)m) != 0)
            return -1;
    return 0;
}

static int free_meshes(void **state)
{
    (void)state;
    for (int m = 0; m < EDGE_MESHES; m++)
        edge_mesh_free(&meshes[m]);
    return 0;
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_bands),
                                       cmocka_unit_test(test_outlines_are_whole),
                                       cmocka_unit_test(test_wire_hides_what_triangles_hide),
                                       cmocka_unit_test(test_contours_alone_are_smoothed),
                                       cmocka_unit_test(test_two_levels_are_not_smoothed),
                                       cmocka_unit_test(test_arena)};

    return cmocka_run_group_tests(tests, make_meshes, free_meshes);
}
