/*
 * edge_meshes.c - makes a gear: two lids with a toothed outline, sides that meet in sharp edges, a bore; and a rabbit:
 * some 5,000 triangles, round, with ears of which one can hide the other.
 */
#include "edge_meshes.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define PI 3.14159265358979323846
#define CREASE 60

enum {
    TEETH = 12,
    RIM = 4 * TEETH,
    RINGS = 48,
    AROUND = 56
};

/* A ring of points at height y: the outline of a lid or, with as many points, of the bore. */
static int gear_ring(struct shape *s, double y, int bore)
{
    int status = 0;

    for (int i = 0; i < RIM; i++) {
        static const double part[4] = {-0.32, -0.16, 0.16, 0.32};
        double turn = 2 * PI * (i / 4 + part[i % 4]) / TEETH;
        double r = bore ? 0.3 : i % 4 == 1 || i % 4 == 2 ? 1 : 0.78;
        status |= shape_point(s, r * cos(turn), y, -r * sin(turn));
    }
    return status;
}

static int make_gear(struct shape *s)
{
    int status = 0;

    memset(s, 0, sizeof *s);
    for (int ring = 0; ring < 4; ring++)
        status |= gear_ring(s, ring % 2 ? 0.22 : -0.22, ring / 2);
    for (uint32_t i = 0; i < RIM; i++) {
        const uint32_t next = (i + 1) % RIM, low = i, high = RIM + i, low_next = next, high_next = RIM + next,
                       bore_low = 2 * RIM + i, bore_high = 3 * RIM + i, bore_low_next = 2 * RIM + next,
                       bore_high_next = 3 * RIM + next;
        const uint32_t side[4] = {low, low_next, high_next, high};
        const uint32_t hole[4] = {bore_low_next, bore_low, bore_high, bore_high_next};
        const uint32_t top[4] = {high, high_next, bore_high_next, bore_high};
        const uint32_t bottom[4] = {low_next, low, bore_low, bore_low_next};
        status |= shape_polygon(s, 4, side) | shape_polygon(s, 4, hole) | shape_polygon(s, 4, top) |
                  shape_polygon(s, 4, bottom);
    }
    return status;
}

/* How far the surface is from the centre in direction d: a body with a head, two ears, a tail and two paws. */
static double rabbit_radius(const double d[3])
{
    static const double lump[][5] = {/* direction, height, width */
                                     {0.35, 0.75, 0.2, 0.55, 0.30},   {0.15, 0.95, 0.35, 0.65, 0.12},
                                     {0.15, 0.95, -0.15, 0.65, 0.12}, {-0.9, -0.1, 0.1, 0.25, 0.18},
                                     {0.6, -0.6, 0.4, 0.25, 0.25},    {0.6, -0.6, -0.4, 0.25, 0.25}};
    double r = 0.6;

    for (size_t i = 0; i < sizeof lump / sizeof lump[0]; i++) {
        const double *l = lump[i], length = sqrt(l[0] * l[0] + l[1] * l[1] + l[2] * l[2]);
        double cosine = (d[0] * l[0] + d[1] * l[1] + d[2] * l[2]) / length;
        double angle = acos(fmin(fmax(cosine, -1), 1)) / l[4];
        r += l[3] * exp(-angle * angle);
    }
    return r + 0.01 * sin(23 * d[0]) * sin(19 * d[1]) * sin(21 * d[2]);
}

static int make_rabbit(struct shape *s)
{
    int status = shape_sphere(s, RINGS, AROUND);

    for (size_t i = 0; status == 0 && i < s->polygons.point_count; i++) {
        double *at = s->points[i], r = rabbit_radius(at);
        for (int k = 0; k < 3; k++)
            at[k] *= r;
    }
    return status;
}

static int find_edges(struct edge_mesh *m)
{
    uint32_t *scratch =
        malloc(SHEEN_EDGES_WORDS((size_t)m->mesh.vertices, (size_t)m->mesh.triangles) * sizeof *scratch);

    m->edges = malloc(m->mesh.triangles * sizeof *m->edges);
    if (!scratch || !m->edges) {
        free(scratch);
        return -1;
    }
    sheen_mesh_edges(&m->mesh, SHEEN_Q30(0.5), scratch, m->edges);
    m->mesh.edges = m->edges;
    free(scratch);
    return 0;
}

int edge_mesh_make(struct edge_mesh *m, enum edge_mesh_name which)
{
    static const char *const name[EDGE_ALL_MESHES] = {"teapot", "gear", "rabbit", "cube"};
    const struct ref_mesh_options options = {.fit = true, .crease = CREASE};

    memset(m, 0, sizeof *m);
    m->name = name[which];
    if (which == EDGE_TEAPOT || which == EDGE_CUBE) {
        m->reference = &m->loaded.reference;
        if (loaded_mesh_make(&m->loaded, which == EDGE_CUBE ? "builtin:cube" : "builtin:teapot") != 0)
            return -1;
        m->mesh = m->loaded.quantised.mesh;
    } else {
        int status = which == EDGE_GEAR ? make_gear(&m->shape) : make_rabbit(&m->shape);
        m->reference = &m->own_reference;
        if (status != 0 || ref_mesh_build(&m->own_reference, &m->shape.polygons, &options) != 0 ||
            core_mesh_make(&m->own, &m->own_reference) != 0)
            return -1;
        m->mesh = m->own.mesh;
    }
    return find_edges(m);
}

void edge_mesh_free(struct edge_mesh *m)
{
    loaded_mesh_free(&m->loaded);
    shape_free(&m->shape);
    ref_mesh_free(&m->own_reference);
    core_mesh_free(&m->own);
    free(m->edges);
    memset(m, 0, sizeof *m);
}
