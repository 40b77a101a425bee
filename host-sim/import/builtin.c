/*
 * builtin.c - meshes that need no file.
 *
 * Points are rounded to 32-bit floats, as a file would hold them.
 */
#include "builtin.h"

#include <string.h>

#include "host_vector.h"
#include "sheen.h"

void sheen_builtin_grid(struct sheen_polygons *polygons, size_t base, unsigned rows, unsigned columns, int reverse)
{
    for (unsigned i = 0; i < rows * columns; i++) {
        size_t at = base + (size_t)(i / columns) * (columns + 1) + i % columns;
        size_t quad[4] = {at, at + columns + 1, at + columns + 2, at + 1};
        uint32_t *corner = polygons->corners + polygons->corner_count;
        unsigned count = 0;

        for (int k = 0; k < 4; k++) {
            size_t here = quad[reverse ? 3 - k : k], next = quad[reverse ? (6 - k) % 4 : (k + 1) % 4];
            if (memcmp(polygons->points[here], polygons->points[next], sizeof polygons->points[here]) != 0)
                corner[count++] = (uint32_t)here;
        }
        polygons->corner_count += count;
        polygons->first[++polygons->polygon_count] = (uint32_t)polygons->corner_count;
    }
}

/* Allocates rows x columns quads and their points; polygon_count and corner_count stay 0 for sheen_builtin_grid. */
static int grid_alloc(struct sheen_polygons *polygons, unsigned rows, unsigned columns)
{
    size_t quads = (size_t)rows * columns;
    int error = sheen_polygons_alloc(polygons, (size_t)(rows + 1) * (columns + 1), quads, 4 * quads, 1, 0);

    polygons->polygon_count = polygons->corner_count = 0;
    return error;
}

/*
 * Cosine and sine of part / parts of a turn. The core computes them in integers, so they
 * are the same on every machine; the error is at most 3e-9, a twentieth of a float's step.
 * Quarters of a turn are exact, so that seams and poles close.
 */
static void on_circle(unsigned part, unsigned parts, double *cosine, double *sine)
{
    sheen_angle_t angle = (sheen_angle_t)(((uint64_t)(part % parts) << 32) / parts);

    *cosine = sheen_cos(angle) / 1073741824.0;
    *sine = sheen_sin(angle) / 1073741824.0;
}

static void set_point(double point[3], double x, double y, double z)
{
    point[0] = as_float(x);
    point[1] = as_float(y);
    point[2] = as_float(z);
}

/* Unit sphere, 32 rings of 64 quads, y = cos(pi ring / 32); triangles at the poles. */
static int make_sphere(struct sheen_polygons *polygons)
{
    enum {
        RINGS = 32,
        COLUMNS = 64
    };
    int error = grid_alloc(polygons, RINGS, COLUMNS);

    for (unsigned i = 0; !error && i < (RINGS + 1) * (COLUMNS + 1); i++) {
        double y, r, c, s;
        on_circle(i / (COLUMNS + 1), 2 * RINGS, &y, &r);
        on_circle(i % (COLUMNS + 1), COLUMNS, &c, &s);
        set_point(polygons->points[i], r * s, y, r * c);
    }
    if (!error)
        sheen_builtin_grid(polygons, 0, RINGS, COLUMNS, 0);
    return error;
}

/* Torus around y, radii 0.75 and 0.33, 40 x 25 quads. */
static int make_torus(struct sheen_polygons *polygons)
{
    enum {
        AROUND = 40,
        TUBE = 25
    };
    int error = grid_alloc(polygons, TUBE, AROUND);

    for (unsigned i = 0; !error && i < (TUBE + 1) * (AROUND + 1); i++) {
        double tube_c, tube_s, c, s;
        on_circle(i / (AROUND + 1), TUBE, &tube_c, &tube_s);
        on_circle(i % (AROUND + 1), AROUND, &c, &s);
        double r = 0.75 + 0.33 * tube_c;
        set_point(polygons->points[i], r * s, 0.33 * tube_s, r * c);
    }
    if (!error)
        sheen_builtin_grid(polygons, 0, TUBE, AROUND, 1);
    return error;
}

/* Corners at +-1: bit 0 of a corner's number is x, 1 is y, 2 is z. */
static int make_cube(struct sheen_polygons *polygons)
{
    static const uint8_t sides[6][4] = {{4, 5, 7, 6}, {1, 0, 2, 3}, {5, 1, 3, 7},
                                        {0, 4, 6, 2}, {6, 7, 3, 2}, {0, 1, 5, 4}};
    int error = sheen_polygons_alloc(polygons, 8, 6, 24, 1, 0);

    for (unsigned i = 0; !error && i < 8; i++)
        set_point(polygons->points[i], i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
    for (unsigned c = 0; !error && c < 24; c++) {
        polygons->corners[c] = sides[c / 4][c % 4];
        polygons->first[c / 4 + 1] = 4 * (c / 4 + 1);
    }
    return error;
}

static const struct {
    const char *name;
    int (*make)(struct sheen_polygons *polygons);
} builtins[] = {{"teapot", sheen_builtin_teapot},
                {"teapot-fine", sheen_builtin_fine_teapot},
                {"sphere", make_sphere},
                {"torus", make_torus},
                {"cube", make_cube}};

enum {
    BUILTINS = sizeof builtins / sizeof builtins[0]
};

/* The index into builtins, or BUILTINS if there is no mesh of that name. */
static int find(const char *name)
{
    int i = 0;

    while (i < BUILTINS && strcmp(name + strlen(SHEEN_BUILTIN), builtins[i].name) != 0)
        i++;
    return i;
}

int sheen_builtin_check(const char *name, struct sheen_problem *problem)
{
    if (strncmp(name, SHEEN_BUILTIN, strlen(SHEEN_BUILTIN)) != 0 || find(name) < BUILTINS)
        return SHEEN_OK;
    return sheen_problem(
        problem, SHEEN_ERR_ARGUMENT,
        "%s: no such mesh; there are builtin:teapot, builtin:teapot-fine, builtin:sphere, builtin:torus, "
        "builtin:cube",
        name);
}

int sheen_builtin(struct sheen_polygons *polygons, const char *name, struct sheen_problem *problem)
{
    int error = sheen_builtin_check(name, problem);

    memset(polygons, 0, sizeof *polygons);
    if (error)
        return error;
    error = builtins[find(name)].make(polygons);
    return error ? sheen_problem(problem, error, "%s: not enough memory", name) : SHEEN_OK;
}
