/*
 * shapes.c - meshes for tests.
 */
#include "shapes.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define PI 3.14159265358979323846

/* Room for one more element of `size` bytes behind `count`; 0 or -1. */
static int grow(void **array, size_t *room, size_t count, size_t size)
{
    if (count < *room)
        return 0;
    size_t more = *room ? 2 * *room : 64;
    void *larger = realloc(*array, more * size);
    if (!larger)
        return -1;
    *array = larger;
    *room = more;
    return 0;
}

int shape_point(struct shape *s, double x, double y, double z)
{
    void *points = s->points;
    int status = grow(&points, &s->point_room, s->polygons.point_count, sizeof *s->points);

    s->points = points;
    s->polygons.points = points;
    if (status == 0) {
        double *at = s->points[s->polygons.point_count++];
        at[0] = x;
        at[1] = y;
        at[2] = z;
    }
    return status;
}

int shape_polygon(struct shape *s, int count, const uint32_t *points)
{
    void *first = s->first, *corners = s->corners;
    size_t end = s->polygons.polygon_count ? s->first[s->polygons.polygon_count] : 0;
    int status = grow(&first, &s->polygon_room, s->polygons.polygon_count + 1, sizeof *s->first);

    for (int k = 0; k < count && status == 0; k++) {
        status = grow(&corners, &s->corner_room, end + (size_t)k, sizeof *s->corners);
        if (status == 0)
            ((uint32_t *)corners)[end + (size_t)k] = points[k];
    }
    s->first = first;
    s->corners = corners;
    s->polygons.first = s->first;
    s->polygons.corners = s->corners;
    if (status == 0) {
        s->first[s->polygons.polygon_count++] = (uint32_t)end;
        s->first[s->polygons.polygon_count] = (uint32_t)(end + (size_t)count);
    }
    return status;
}

void shape_free(struct shape *s)
{
    free(s->points);
    free(s->normals);
    free(s->first);
    free(s->corners);
    memset(s, 0, sizeof *s);
}

static int quad(struct shape *s, int a, int b, int c, int d)
{
    return shape_polygon(s, 4, (uint32_t[]){(uint32_t)a, (uint32_t)b, (uint32_t)c, (uint32_t)d});
}

static int triangle(struct shape *s, int a, int b, int c)
{
    return shape_polygon(s, 3, (uint32_t[]){(uint32_t)a, (uint32_t)b, (uint32_t)c});
}

/* Points: rings 0 (north pole: `around` times the same position) to `rings`; no point is repeated at the seam. */
int shape_sphere(struct shape *s, int rings, int around)
{
    int status = 0;

    memset(s, 0, sizeof *s);
    for (int i = 0; i <= rings; i++) {
        double y = i == 0 ? 1 : i == rings ? -1 : cos(PI * i / rings), r = sin(PI * i / rings);
        for (int j = 0; j < around; j++) {
            double turn = 2 * PI * j / around;
            bool pole = i == 0 || i == rings;
            status |= shape_point(s, pole ? 0 : r * cos(turn), y, pole ? 0 : -r * sin(turn));
        }
    }
    for (int i = 0; i < rings; i++) {
        for (int j = 0; j < around; j++) {
            int next = (j + 1) % around, up = i * around, down = up + around;
            if (i == 0)
                status |= triangle(s, up + j, down + j, down + next);
            else if (i == rings - 1)
                status |= triangle(s, up + j, down + j, up + next);
            else
                status |= quad(s, up + j, down + j, down + next, up + next);
        }
    }
    return status;
}

int shape_torus(struct shape *s, double major, double minor, int along, int around)
{
    int status = 0;

    memset(s, 0, sizeof *s);
    for (int i = 0; i < along; i++) {
        for (int j = 0; j < around; j++) {
            double turn = 2 * PI * i / along, tube = 2 * PI * j / around, r = major + minor * cos(tube);
            status |= shape_point(s, r * cos(turn), minor * sin(tube), -r * sin(turn));
        }
    }
    for (int i = 0; i < along; i++) {
        for (int j = 0; j < around; j++) {
            int here = i * around, there = (i + 1) % along * around, next = (j + 1) % around;
            status |= quad(s, here + j, there + j, there + next, here + next);
        }
    }
    return status;
}

int shape_octahedron(struct shape *s)
{
    int status = 0;

    memset(s, 0, sizeof *s);
    for (int k = 0; k < 6; k++) {
        double end = k % 2 ? -1 : 1;
        status |= shape_point(s, k / 2 == 0 ? end : 0, k / 2 == 1 ? end : 0, k / 2 == 2 ? end : 0);
    }
    for (int octant = 0; octant < 8; octant++) {
        int x = octant & 1, y = 2 + (octant >> 1 & 1), z = 4 + (octant >> 2);
        bool mirrored = (octant & 1) ^ (octant >> 1 & 1) ^ (octant >> 2);
        status |= mirrored ? triangle(s, x, z, y) : triangle(s, x, y, z);
    }
    return status;
}

static double distance(const double a[3], const double b[3])
{
    return sqrt((a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]) + (a[2] - b[2]) * (a[2] - b[2]));
}

/* Whether a, b, c run counter-clockwise seen from outside: their triple product is positive. */
static bool outwards(const double a[3], const double b[3], const double c[3])
{
    return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
               a[2] * (b[0] * c[1] - b[1] * c[0]) >
           0;
}

/* The corners of three golden rectangles at right angles; any three of them that are 2 apart form a face. */
int shape_icosahedron(struct shape *s)
{
    const double golden = (1 + sqrt(5)) / 2;
    int status = 0;

    memset(s, 0, sizeof *s);
    for (int k = 0; k < 12; k++) {
        double at[3] = {0, k & 1 ? -1 : 1, k & 2 ? -golden : golden};
        status |= shape_point(s, at[(k / 4) % 3], at[(k / 4 + 1) % 3], at[(k / 4 + 2) % 3]);
    }
    for (int i = 0; i < 12 && status == 0; i++) {
        for (int j = 0; j < i; j++) {
            for (int k = 0; k < j; k++) {
                const double *a = s->points[i], *b = s->points[j], *c = s->points[k];
                if (distance(a, b) < 2.1 && distance(b, c) < 2.1 && distance(a, c) < 2.1)
                    status |= outwards(a, b, c) ? triangle(s, i, j, k) : triangle(s, i, k, j);
            }
        }
    }
    return status;
}

int shape_cube(struct shape *s)
{
    static const int faces[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    int status = 0;

    memset(s, 0, sizeof *s);
    for (int k = 0; k < 8; k++)
        status |= shape_point(s, k & 1 ? 1 : -1, k & 2 ? 1 : -1, k & 4 ? 1 : -1);
    for (int f = 0; f < 6; f++)
        status |= quad(s, faces[f][0], faces[f][1], faces[f][2], faces[f][3]);
    return status;
}

static int barrel_normals(struct shape *s, size_t sides)
{
    size_t corners = s->first[s->polygons.polygon_count];

    s->normals = calloc(corners, sizeof *s->normals);
    if (!s->normals)
        return -1;
    for (size_t c = 0; c < corners; c++) {
        const double *p = s->points[s->corners[c]];
        double r = hypot(p[0], p[2]);
        s->normals[c][0] = c < 4 * sides ? p[0] / r : 0;
        s->normals[c][1] = c < 4 * sides ? 0.8 * p[1] : p[1];
        s->normals[c][2] = c < 4 * sides ? p[2] / r : 0;
    }
    s->polygons.normals = (const double(*)[3])s->normals;
    return 0;
}

int shape_barrel(struct shape *s, int rings, int around)
{
    uint32_t *lid = malloc((size_t)around * sizeof *lid);
    int status = lid ? 0 : -1;

    memset(s, 0, sizeof *s);
    for (int i = 0; i <= rings && status == 0; i++) {
        for (int j = 0; j < around; j++) {
            double y = 0.8 - 1.6 * i / rings, r = 0.8 - 0.4 * y * y, turn = 2 * PI * j / around;
            status |= shape_point(s, r * cos(turn), y, -r * sin(turn));
        }
    }
    for (int i = 0; i < rings && status == 0; i++) {
        for (int j = 0; j < around; j++) {
            int next = (j + 1) % around, up = i * around, down = up + around;
            status |= quad(s, up + j, down + j, down + next, up + next);
        }
    }
    for (int end = 0; end < 2 && status == 0; end++) {
        for (int j = 0; j < around; j++)
            lid[j] = (uint32_t)(end ? rings * around + around - 1 - j : j);
        status |= shape_polygon(s, around, lid);
    }
    free(lid);
    return status == 0 ? barrel_normals(s, (size_t)rings * (size_t)around) : -1;
}

int shape_screen(struct shape *s)
{
    int status = 0;

    memset(s, 0, sizeof *s);
    for (int k = 0; k < 4; k++)
        status |= shape_point(s, k & 1 ? 1.6 : -1.6, k & 2 ? 1.2 : -1.2, 0);
    status |= triangle(s, 0, 1, 2); /* the diagonal runs from (-,+) to (+,-) */
    status |= triangle(s, 2, 1, 3);
    s->normals = calloc(6, sizeof *s->normals);
    if (!s->normals || status != 0)
        return -1;
    for (int c = 0; c < 6; c++) {
        s->normals[c][0] = s->corners[c] & 1 ? 0.5 : -0.5;
        s->normals[c][1] = s->corners[c] & 2 ? 0.5 : -0.5;
        s->normals[c][2] = 1;
    }
    s->polygons.normals = (const double(*)[3])s->normals;
    return 0;
}
