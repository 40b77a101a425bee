/*
 * test_lines.c - what is drawn of edges: the same pixels whatever the bands and workers, and at the right places,
 * against the edges that the reference shows in a picture 4 times as fine. Lines with faults must be refused.
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

static struct edge_mesh meshes[EDGE_ALL_MESHES];

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

/* Bands of any height, in any order and by several workers must draw what one band draws. */
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
                scene.fog = scenes % 3 == 0;
                scene.fog_from = distance[k / 4] - 0.7;
                scene.fog_to = distance[k / 4] + 0.5;
                const struct edge_drawing drawing = {
                    .edges = sheen_edges_of(edging), .pixel = pixel[k % 4], .line = {255, 128, 40}};
                check_bands(&scene, &meshes[m], drawing);
            }
}

/* ---- lines against edges of the reference ---- */

enum {
    FINE = 4,        /* the reference's pixels along a side of one of the picture's */
    MOST_GAP = 1,    /* consecutive steps of a visible line that may be missing */
    CUT_SHORT = 2,   /* steps removed by a seeded fault */
    FAULTY_STEPS = 6 /* edges that get a fault have more steps than this */
};

/* A ratio of depths: nearer by this factor hides an edge. A contour is seen only if nothing is nearer at all. */
#define NEARER 1.01
#define AROUND 1.0     /* px: an edge counts as seen only if nothing within this distance hides it */
#define ALL_AROUND 1.5 /* px: and as hidden only if everything within this one does: the next pixels' centres too */
#define FARTHEST 0.8   /* px: from a point of a line to the centre of a pixel that it draws, at most */
#define FARTHEST_SMOOTHED 1.0 /* px: the same from a contour to a pixel that is smoothed */
#define SAMPLES_PX 4.         /* samples per pixel of an edge */
#define LINE_IN_FOG                                                                                                    \
    {                                                                                                                  \
        1, 0, 1                                                                                                        \
    }
#define ROUNDED 0.1 /* px: the largest error of the core's corners and slopes */

struct view {
    double yaw, pitch, distance;
    bool ortho;
};

static const struct view views[] = {{30, 20, 3.5, false}, {115, -35, 3.5, false}, {200, 60, 2.6, false},
                                    {285, 5, 1.7, false}, {330, -75, 4, true},    {70, 8, 3.5, true}};

/* An edge in the reference's fine picture. */
struct seen_edge {
    const struct ref_piece *piece;
    int k;
    double out[2]; /* a contour's unit normal, away from the triangle; zero: both sides may hide the edge */
};

/* The steps of an edge in the picture: one per row if it is steep, otherwise one per column. */
struct edge_steps {
    bool steep, diagonal; /* rounding may make it steep or not */
    int first, end;
    double across, slope; /* position in row or column 0, and change per step */
};

/* A picture that holds only lines, or only what smoothing changed, and what it should hold. */
struct line_case {
    const struct edge_mesh *mesh;
    struct ref_scene scene; /* of the reference's fine picture */
    struct ref_picture fine;
    uint8_t *front;
    uint16_t drawn[PIXELS];
    uint16_t fogged[PIXELS]; /* the same lines in fog, if the scene has any */
    uint8_t allowed[PIXELS]; /* pixels near an edge that is not certainly hidden */
    enum sheen_edging edging;
    double farthest;
    long seen, samples;
    long steps, as_fogged;           /* steps seen in fog, and those of them that have the fog's colour */
    int gap;                         /* the longest run of steps that are seen but not drawn */
    int gap_at[2], extra, extra_at;  /* where that run ends; pixels drawn although not allowed */
    struct edge_steps whole, hidden; /* the longest edges seen, or hidden, from end to end */
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

/*
 * 1: nothing hides the point; -1: everything around hides it; 0: uncertain, or too close to the picture's border. An
 * edge's own triangles do not hide it, nor does what lies on the inner side of a contour. depth: as in struct
 * ref_piece.
 */
static int seen_at(const struct line_case *c, const struct seen_edge *edge, double x, double y, double depth)
{
    const bool contour = edge->out[0] != 0 || edge->out[1] != 0;
    const uint32_t own = edge->piece->triangle, across = c->mesh->edges[own].across[edge->k];
    const double m = c->scene.ortho ? -depth : 1 / depth;
    const int fine_x = (int)floor(x * FINE), fine_y = (int)floor(y * FINE), reach = (int)(ALL_AROUND * FINE);
    int before = 0, hidden = 0, all = 0;

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
            if (abs(i - fine_x) <= AROUND * FINE && abs(j - fine_y) <= AROUND * FINE)
                before += p->m * (contour ? 1 : NEARER) < m;
            hidden += p->m * NEARER < m;
        }
    if (x < 1 || y < 1 || x >= WIDTH - 1 || y >= HEIGHT - 1)
        return 0;
    return before == 0 ? 1 : hidden == all ? -1 : 0;
}

static void allow(struct line_case *c, double x, double y)
{
    for (int j = (int)y - 2; j <= (int)y + 2; j++)
        for (int i = (int)x - 2; i <= (int)x + 2; i++)
            if (i >= 0 && j >= 0 && i < WIDTH && j < HEIGHT && hypot(i + 0.5 - x, j + 0.5 - y) <= c->farthest)
                c->allowed[j * WIDTH + i] = 1;
}

static struct edge_steps steps_of(const struct ref_piece *p, int k)
{
    const int to = (k + 1) % 3;
    const double dx = fabs(p->x[to] - p->x[k]), dy = fabs(p->y[to] - p->y[k]);
    struct edge_steps s = {.steep = dy >= dx, .diagonal = fabs(dx - dy) < 2 * ROUNDED * FINE};
    const double *along = s.steep ? p->y : p->x, *across = s.steep ? p->x : p->y;
    const double low = fmin(along[k], along[to]) / FINE, high = fmax(along[k], along[to]) / FINE;

    if (high - low < 0.01)
        return s;
    s.first = (int)ceil(low + ROUNDED - 0.5);
    s.end = (int)ceil(high - ROUNDED - 0.5);
    s.slope = (across[to] - across[k]) / (along[to] - along[k]);
    s.across = across[k] / FINE - s.slope * along[k] / FINE;
    return s;
}

/* The pixel of a step, moved across the line by `moved` px; -1 if it is outside the picture. */
static int step_pixel(const struct edge_steps *s, int step, double moved)
{
    const int across = (int)floor(s->across + s->slope * (step + 0.5) + moved), x = s->steep ? across : step,
              y = s->steep ? step : across;

    return x >= 0 && y >= 0 && x < WIDTH && y < HEIGHT ? y * WIDTH + x : -1;
}

static bool step_is_drawn(const struct line_case *c, const struct edge_steps *s, int step)
{
    const double reach = s->diagonal ? 1 : ROUNDED;
    const int low = step_pixel(s, step, -reach), at = step_pixel(s, step, 0), high = step_pixel(s, step, reach);

    return low < 0 || at < 0 || high < 0 || c->drawn[low] != 0 || c->drawn[at] != 0 || c->drawn[high] != 0;
}

/* Whether a pixel has the lines' colour in fog at depth m, within one level. */
static bool is_fogged(const struct line_case *c, int at, double m)
{
    static const double line[3] = LINE_IN_FOG;
    if (at < 0)
        return false;
    const int want = ref_fogged_value(&c->scene, line, ref_fog_share(&c->scene, ref_nearness(&c->scene, m)), 0, 0),
              value = c->fogged[at];

    return abs((value >> 11) - (want >> 11)) <= 1 && abs((value >> 5 & 63) - (want >> 5 & 63)) <= 1 &&
           abs((value & 31) - (want & 31)) <= 1;
}

static void count_fogged(struct line_case *c, const struct edge_steps *s, int step, double m)
{
    const double reach = s->diagonal ? 1 : ROUNDED;

    c->steps++;
    c->as_fogged += is_fogged(c, step_pixel(s, step, 0), m) || is_fogged(c, step_pixel(s, step, -reach), m) ||
                    is_fogged(c, step_pixel(s, step, reach), m);
}

/* Checks that an edge has a pixel at each step at which it is seen. */
static void step_edge(struct line_case *c, const struct seen_edge *edge)
{
    const struct ref_piece *p = edge->piece;
    const int k = edge->k, to = (k + 1) % 3;
    const struct edge_steps s = steps_of(p, k);
    const double *along = s.steep ? p->y : p->x;
    int gap = 0, seen = 0, hidden = 0;

    for (int step = s.first; step < s.end; step++) {
        const double at = step + 0.5, across = s.across + s.slope * at;
        const double t = (at * FINE - along[k]) / (along[to] - along[k]);
        const double depth = (1 - t) * p->depth[k] + t * p->depth[to];
        const int sight = seen_at(c, edge, s.steep ? across : at, s.steep ? at : across, depth);
        seen += sight > 0;
        if (sight > 0 && c->scene.fog)
            count_fogged(c, &s, step, c->scene.ortho ? -depth : 1 / depth);
        hidden += sight < 0;
        gap = sight > 0 && !step_is_drawn(c, &s, step) ? gap + 1 : 0;
        if (gap > c->gap) {
            c->gap = gap;
            c->gap_at[0] = s.steep ? (int)across : step;
            c->gap_at[1] = s.steep ? step : (int)across;
        }
    }
    if (seen == s.end - s.first && seen > c->whole.end - c->whole.first)
        c->whole = s;
    if (hidden == s.end - s.first && hidden > c->hidden.end - c->hidden.first)
        c->hidden = s;
}

static void walk_edge(struct line_case *c, const struct ref_piece *p, int k)
{
    const int to = (k + 1) % 3;
    const double dx = p->x[to] - p->x[k], dy = p->y[to] - p->y[k], length = hypot(dx, dy);
    const int steps = (int)ceil(length / FINE * SAMPLES_PX) + 1;
    struct seen_edge edge = {p, k, {0, 0}};

    /* Corners run counter-clockwise and y points down, so the triangle lies to the left. */
    if (is_contour(c, p->triangle, k) && length > 0) {
        edge.out[0] = -dy / length;
        edge.out[1] = dx / length;
    }
    for (int i = 0; i <= steps; i++) {
        double t = i / (double)steps, x = (1 - t) * p->x[k] + t * p->x[to], y = (1 - t) * p->y[k] + t * p->y[to];
        int seen = seen_at(c, &edge, x / FINE, y / FINE, (1 - t) * p->depth[k] + t * p->depth[to]);
        c->samples++;
        c->seen += seen > 0;
        if (seen >= 0)
            allow(c, x / FINE, y / FINE);
    }
    if (c->edging != SHEEN_SMOOTH)
        step_edge(c, &edge);
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

/* Renders the reference's picture and notes the triangles that face the eye. */
static void open_case(struct line_case *c, const struct ref_scene *scene)
{
    c->scene = *scene;
    c->scene.width *= FINE;
    c->scene.height *= FINE;
    c->scene.shading = REF_FLAT;
    assert_int_equal(ref_render(&c->fine, &c->scene), 0);
    c->front = calloc(c->mesh->mesh.triangles, 1);
    assert_non_null(c->front);
    for (size_t i = 0; i < c->fine.piece_count; i++)
        c->front[c->fine.pieces[i].triangle] = 1;
}

static void close_case(struct line_case *c)
{
    free(c->front);
    ref_picture_free(&c->fine);
}

/*
 * Where an edge is seen there must be a line from end to end; elsewhere there must be none. Smoothing must change
 * pixels at visible contours only.
 */
static bool is_right(struct line_case *c)
{
    memset(c->allowed, 0, sizeof c->allowed);
    c->gap = c->extra = 0;
    c->seen = c->samples = c->steps = c->as_fogged = 0;
    for (size_t i = 0; i < c->fine.piece_count; i++)
        for (int k = 0; k < 3; k++)
            if (is_line(c, c->fine.pieces[i].triangle, k))
                walk_edge(c, &c->fine.pieces[i], k);
    for (int at = 0; at < PIXELS; at++)
        if (c->drawn[at] != 0 && !c->allowed[at]) {
            c->extra++;
            c->extra_at = at;
        }
    return c->gap <= MOST_GAP && c->extra == 0;
}

/* The same after drawing, or erasing, the steps [first, end) of an edge. */
static bool is_right_with(struct line_case *c, const struct edge_steps *s, int first, int end, uint16_t drawn)
{
    static uint16_t sound[PIXELS];

    memcpy(sound, c->drawn, sizeof sound);
    for (int step = first; step < end; step++)
        for (int side = -1; side <= 1; side += 2) {
            const int at = step_pixel(s, step, side * (s->diagonal ? 1 : ROUNDED));
            if (at >= 0)
                c->drawn[at] = drawn;
        }
    const bool right = is_right(c);
    memcpy(c->drawn, sound, sizeof sound);
    return right;
}

/*
 * A line left out, or cut short at either end, must be refused. A hidden line that is drawn must be refused unless
 * visible lines run along it. tried: how many visible lines, how many hidden ones, and how many of the hidden ones are
 * refused.
 */
static void check_faults(struct line_case *c, int tried[3])
{
    const struct edge_steps whole = c->whole, hidden = c->hidden;

    if (whole.end - whole.first > FAULTY_STEPS) {
        tried[0]++;
        assert_false(is_right_with(c, &whole, whole.first, whole.end, 0));
        assert_false(is_right_with(c, &whole, whole.first, whole.first + CUT_SHORT, 0));
        assert_false(is_right_with(c, &whole, whole.end - CUT_SHORT, whole.end, 0));
    }
    if (hidden.end - hidden.first > FAULTY_STEPS) {
        tried[1]++;
        tried[2] += !is_right_with(c, &hidden, hidden.first, hidden.end, 1);
    }
}

static void check_case(const struct edge_mesh *mesh, const struct view *view, enum sheen_edging edging,
                       enum sheen_pixel pixel, int tried[3])
{
    static struct line_case c;
    struct ref_scene scene;
    int lines = 0;

    memset(&c, 0, sizeof c);
    c.mesh = mesh;
    c.edging = edging;
    c.farthest = edging == SHEEN_SMOOTH ? FARTHEST_SMOOTHED : FARTHEST;
    scene_of(&scene, mesh, view->yaw, view->distance);
    ref_scene_orbit(&scene, view->yaw, view->pitch, 0, view->distance);
    scene.ortho = view->ortho;
    if (edging == SHEEN_SMOOTH)
        draw_smoothed(&c, &scene, pixel);
    else
        draw_lines(&c, scene);
    open_case(&c, &scene);
    if (!is_right(&c))
        fail_msg("%s, yaw %g: %d steps of a line are missing before %d, %d; %d pixels are drawn where no edge is seen, "
                 "%d, %d the last",
                 mesh->name, view->yaw, c.gap, c.gap_at[0], c.gap_at[1], c.extra, c.extra_at % WIDTH,
                 c.extra_at / WIDTH);
    for (int at = 0; at < PIXELS; at++)
        lines += c.drawn[at] != 0;
    print_message("%s, yaw %g, edges %d: %d pixels; %ld of %ld points of edges are seen, gaps of %d\n", mesh->name,
                  view->yaw, edging, lines, c.seen, c.samples, c.gap);
    assert_true(c.seen > c.samples / 8);
    assert_true(lines > 50);
    if (edging != SHEEN_SMOOTH)
        check_faults(&c, tried);
    close_case(&c);
}

/* Every mesh, from every side. */
static void check_lines(enum sheen_edging edging)
{
    int tried[3] = {0, 0, 0};

    for (int m = 0; m < EDGE_ALL_MESHES; m++)
        for (size_t i = 0; i < sizeof views / sizeof views[0]; i++)
            check_case(&meshes[m], &views[i], edging, SHEEN_RGB565_BE, tried);
    print_message("%d lines cut short, %d hidden ones drawn, of which %d are told\n", tried[0], tried[1], tried[2]);
    assert_true(tried[0] >= 12 && tried[1] >= 4 && tried[2] >= tried[1] * 3 / 4);
}

static void test_outlines_are_whole(void **state)
{
    (void)state;
    check_lines(SHEEN_OUTLINE);
}

static void test_wire_hides_what_triangles_hide(void **state)
{
    (void)state;
    check_lines(SHEEN_WIRE);
}

static void test_contours_alone_are_smoothed(void **state)
{
    static const enum sheen_pixel pixel[] = {SHEEN_RGB565_BE, SHEEN_RGB565_LE, SHEEN_GREY16, SHEEN_GREY256};

    (void)state;
    for (unsigned i = 0; i < 4 * EDGE_ALL_MESHES; i++)
        for (size_t k = 0; k < sizeof views / sizeof views[0]; k++)
            check_case(&meshes[i / 4], &views[k], SHEEN_SMOOTH, pixel[i % 4], NULL);
}

/*
 * Nearly all steps of lines must have the colour of fog at their own depth; at some of them another line crosses. In a
 * fog that starts elsewhere fewer than half may have it.
 */
static void check_fogged(const struct edge_mesh *mesh, const struct view *view)
{
    static struct line_case c;
    static const double line[3] = LINE_IN_FOG, fog[3] = {0.2, 0.9, 0.4};
    struct edge_drawing drawing = {.edges = &sheen_edges_wire};
    struct ref_scene scene;

    memset(&c, 0, sizeof c);
    c.mesh = mesh;
    c.edging = SHEEN_WIRE;
    c.farthest = FARTHEST;
    scene_of(&scene, mesh, view->yaw, view->distance);
    ref_scene_orbit(&scene, view->yaw, view->pitch, 0, view->distance);
    scene.ortho = view->ortho;
    draw_lines(&c, scene);
    scene.fog = true;
    scene.fog_from = view->distance - 0.8;
    scene.fog_to = view->distance + 0.6;
    for (int k = 0; k < 3; k++) {
        scene.fog_color[k] = fog[k];
        drawing.line[k] = (uint8_t)(255 * line[k]);
    }
    picture(c.fogged, &scene, mesh, &drawing);
    open_case(&c, &scene);
    assert_true(is_right(&c));
    print_message("%s, yaw %g: %ld of %ld steps in fog as it should be", mesh->name, view->yaw, c.as_fogged, c.steps);
    assert_true(c.as_fogged >= 0.92 * c.steps);
    c.scene.fog_from += 0.2; /* a fault, which must be noticed */
    is_right(&c);
    print_message(", %ld as another fog\n", c.as_fogged);
    assert_true(c.as_fogged < 0.5 * c.steps);
    close_case(&c);
}

static void test_lines_are_fogged(void **state)
{
    (void)state;
    for (int m = 0; m < EDGE_ALL_MESHES; m++)
        for (int i = 0; i < 3; i++)
            check_fogged(&meshes[m], &views[2 * i + i / 2]);
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

/* The sizes that sheen_arena.h gives for edges are those that a frame needs. */
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

/* Draws two teapots that the near plane cuts, with their lines, within the capacities of the configuration. */
static int draw_cut(const struct sheen_config *config, enum sheen_subject *about, uint32_t *needed)
{
    static const struct sheen_material material = {.ambient = 65536};
    const struct sheen_view view = {.z_near = SHEEN_Q24(1), .z_far = SHEEN_Q24(8)};
    struct core_frame f;
    int error;

    assert_int_equal(core_frame_make(&f, config), SHEEN_OK);
    error = sheen_begin(f.frame, &view);
    for (int i = 0; i < 2 && error == SHEEN_OK; i++) {
        struct sheen_object object = {.mesh = &meshes[EDGE_TEAPOT].mesh,
                                      .material = &material,
                                      .shader = &sheen_flat,
                                      .edges = &sheen_edges_wire,
                                      .two_sided = 1};
        sheen_pose_orbit(&object.pose, SHEEN_DEGREES(40), SHEEN_DEGREES(20), 0, SHEEN_Q24(1.4));
        error = sheen_draw(f.frame, &object);
    }
    *about = sheen_frame_about(f.frame, needed);
    core_frame_free(&f);
    return error;
}

/* Raising each capacity to what is reported must end in a frame. Ends of cut lines need room besides the vertices. */
static void test_capacities(void **state)
{
    const struct sheen_target target = {.push = no_push, .width = 160, .height = 120};
    const uint16_t vertices = 2 * meshes[EDGE_TEAPOT].mesh.vertices;

    (void)state;
    for (int given = 0; given < 2; given++) {
        struct sheen_config config = {.target = &target,
                                      .max_vertices = vertices,
                                      .max_used = given ? 1 : 0,
                                      .max_triangles = 1,
                                      .clipper = &sheen_clipper};
        enum sheen_subject about;
        uint32_t needed;
        int error, asked = 0;

        while ((error = draw_cut(&config, &about, &needed)) == SHEEN_ERR_CAPACITY) {
            uint16_t *field = about == SHEEN_ABOUT_MAX_VERTICES    ? &config.max_vertices
                              : about == SHEEN_ABOUT_MAX_USED      ? &config.max_used
                              : about == SHEEN_ABOUT_MAX_TRIANGLES ? &config.max_triangles
                              : about == SHEEN_ABOUT_MAX_CLIPPED   ? &config.max_clipped
                                                                   : &config.max_edges;
            assert_true(about == SHEEN_ABOUT_MAX_EDGES || field != &config.max_edges);
            assert_true(needed > *field);
            *field = (uint16_t)needed;
            assert_true(++asked < 20);
        }
        assert_int_equal(error, SHEEN_OK);
        assert_true(config.max_vertices > vertices);
        print_message("%d vertices and %d ends of lines after %d askings\n", vertices, config.max_vertices - vertices,
                      asked);
    }
}

static int make_meshes(void **state)
{
    (void)state;
    for (unsigned m = 0; m < EDGE_ALL_MESHES; m++)
        if (edge_mesh_make(&meshes[m], (enum edge_mesh_name)m) != 0)
            return -1;
    return 0;
}

static int free_meshes(void **state)
{
    (void)state;
    for (int m = 0; m < EDGE_ALL_MESHES; m++)
        edge_mesh_free(&meshes[m]);
    return 0;
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_bands),
                                       cmocka_unit_test(test_outlines_are_whole),
                                       cmocka_unit_test(test_wire_hides_what_triangles_hide),
                                       cmocka_unit_test(test_contours_alone_are_smoothed),
                                       cmocka_unit_test(test_lines_are_fogged),
                                       cmocka_unit_test(test_two_levels_are_not_smoothed),
                                       cmocka_unit_test(test_arena),
                                       cmocka_unit_test(test_capacities)};

    return cmocka_run_group_tests(tests, make_meshes, free_meshes);
}
