/*
 * builtin_teapot.c - the teapot of Martin Newell (University of Utah, 1975).
 *
 * The data set is public as 306 control points in 32 bicubic Bezier patches, z up
 * (F. Crow, "The Origins of the Teapot", IEEE CG&A 7(1), 1987). Its points repeat:
 * rim, body, lid and bottom are six profiles, each turned about the axis as four
 * patches; handle and spout are two tubes of two patches along and two across.
 * So 24 pairs and 14 rows describe the whole teapot. Here y is up and the spout points to +x.
 */
#include <string.h>

#include "builtin.h"
#include "host_vector.h"

enum {
    PATCHES = 32,
    STEPS = 4, /* quads along a patch's side */
    FINE_STEPS = 10
};

/* Control points of a patch: rows run along the profile or tube, columns across. */
typedef double patch_t[4][4][3];

/* Radius and height, from the top down. */
static const double profiles[6][4][2] = {
    {{1.4, 2.4}, {1.3375, 2.53125}, {1.4375, 2.53125}, {1.5, 2.4}}, /* rim */
    {{1.5, 2.4}, {1.75, 1.875}, {2.0, 1.35}, {2.0, 0.9}},           /* body */
    {{2.0, 0.9}, {2.0, 0.45}, {1.5, 0.225}, {1.5, 0.15}},
    {{1.5, 0.15}, {1.5, 0.075}, {1.425, 0.0}, {0.0, 0.0}}, /* bottom */
    {{0.0, 3.15}, {0.8, 3.15}, {0.0, 2.85}, {0.2, 2.7}},   /* knob */
    {{0.2, 2.7}, {0.4, 2.55}, {1.3, 2.55}, {1.3, 2.4}},    /* lid */
};

/* Half a tube's cross-section is a box from (x, y) to (x, y) in the plane z = 0, bulging to z = width. */
struct section {
    double x0, y0, x1, y1, width;
};

static const struct section tubes[4][4] = {
    {{-1.6, 2.025, -1.5, 2.25, 0.3}, /* handle, from the rim */
     {-2.3, 2.025, -2.5, 2.25, 0.3},
     {-2.7, 2.025, -3.0, 2.25, 0.3},
     {-2.7, 1.8, -3.0, 1.8, 0.3}},
    {{-2.7, 1.8, -3.0, 1.8, 0.3},
     {-2.7, 1.575, -3.0, 1.35, 0.3},
     {-2.5, 1.125, -2.65, 0.9375, 0.3},
     {-2.0, 0.9, -1.9, 0.6, 0.3}},
    {{1.7, 1.425, 1.7, 0.6, 0.66}, /* spout, from the body */
     {2.6, 1.425, 3.1, 0.825, 0.66},
     {2.3, 2.1, 2.4, 2.025, 0.25},
     {2.7, 2.4, 3.3, 2.4, 0.25}},
    {{2.7, 2.4, 3.3, 2.4, 0.25},
     {2.8, 2.475, 3.525, 2.49375, 0.25},
     {2.9, 2.475, 3.45, 2.5125, 0.15},
     {2.8, 2.4, 3.2, 2.4, 0.15}},
};

/*
 * Turns a profile by a quarter, for quarter 0 from +z to +x, so that down the profile and then on around it is
 * counter-clockwise seen from outside.
 */
static void turn_profile(const double profile[4][2], unsigned quarter, patch_t patch)
{
    static const double turns[4][2] = {{0, 1}, {1, 0}, {0, -1}, {-1, 0}}; /* x, z */
    const double *from = turns[quarter], *to = turns[(quarter + 1) % 4];

    for (int i = 0; i < 4; i++) {
        double r = profile[i][0];
        /* Newell's circle: the inner control points are 0.56 r from the ends; in the knob, where r = 0.8, 0.45. */
        double k = r == 0.8 ? 0.45 : 0.56 * r;
        const double along[4][2] = {{r, 0}, {r, k}, {k, r}, {0, r}};
        for (int j = 0; j < 4; j++) {
            patch[i][j][0] = along[j][0] * from[0] + along[j][1] * to[0];
            patch[i][j][1] = profile[i][1];
            patch[i][j][2] = along[j][0] * from[1] + along[j][1] * to[1];
        }
    }
}

/* side: +1 for the half with z >= 0, -1 for its mirror image. */
static void half_tube(const struct section tube[4], int side, patch_t patch)
{
    for (int i = 0; i < 4; i++) {
        const struct section *s = &tube[i];
        const double row[4][3] = {
            {s->x0, s->y0, 0}, {s->x0, s->y0, side * s->width}, {s->x1, s->y1, side * s->width}, {s->x1, s->y1, 0}};
        memcpy(patch[i], row, sizeof row);
    }
}

/* Bernstein's weights of a cubic at t. */
static void bernstein(double t, double weights[4])
{
    double s = 1 - t;

    weights[0] = s * s * s;
    weights[1] = 3 * s * s * t;
    weights[2] = 3 * s * t * t;
    weights[3] = t * t * t;
}

/* The point at (u, v) of a patch, both 0..1. */
static void evaluate(const patch_t patch, double along, double across, double point[3])
{
    double u[4], v[4];

    bernstein(along, u);
    bernstein(across, v);
    for (int k = 0; k < 3; k++) {
        double sum = 0;
        for (int i = 0; i < 4; i++) {
            for (int j = 0; j < 4; j++)
                sum += u[i] * v[j] * patch[i][j][k];
        }
        point[k] = as_float(sum); /* as a file would hold it */
    }
}

static void add_patch(struct sheen_polygons *polygons, const patch_t patch, unsigned steps, int reverse)
{
    size_t base = polygons->point_count;

    for (unsigned row = 0; row <= steps; row++)
        for (unsigned column = 0; column <= steps; column++)
            evaluate(patch, (double)row / steps, (double)column / steps, polygons->points[polygons->point_count++]);
    sheen_builtin_grid(polygons, base, steps, steps, reverse);
}

/* Each patch as steps x steps quads. */
static int make_teapot(struct sheen_polygons *polygons, unsigned steps)
{
    const size_t points = (size_t)PATCHES * (steps + 1) * (steps + 1), quads = (size_t)PATCHES * steps * steps;
    int error = sheen_polygons_alloc(polygons, points, quads, 4 * quads, 1, 0);
    if (error)
        return error;
    polygons->point_count = polygons->polygon_count = polygons->corner_count = 0;

    patch_t patch;
    for (int p = 0; p < 6; p++) {
        for (unsigned quarter = 0; quarter < 4; quarter++) {
            turn_profile(profiles[p], quarter, patch);
            add_patch(polygons, (const double(*)[4][3])patch, steps, 0);
        }
    }
    for (int t = 0; t < 4; t++) {
        for (int side = -1; side <= 1; side += 2) {
            half_tube(tubes[t], side, patch);
            add_patch(polygons, (const double(*)[4][3])patch, steps, side > 0);
        }
    }
    return SHEEN_OK;
}

int sheen_builtin_teapot(struct sheen_polygons *polygons)
{
    return make_teapot(polygons, STEPS);
}

int sheen_builtin_fine_teapot(struct sheen_polygons *polygons)
{
    return make_teapot(polygons, FINE_STEPS);
}
