/*
 * frame_sum_mesh.c - meshes computed with integers only.
 */
#include "frame_sum_mesh.h"

#define MAX_VERTICES 400
#define MAX_TRIANGLES 700

static int16_t positions[3 * MAX_VERTICES], normals[3 * MAX_VERTICES];
static uint16_t indices[3 * MAX_TRIANGLES];
static uint8_t small_indices[36];
static struct sheen_mesh mesh;

static int64_t root(int64_t x)
{
    int64_t r = 0;

    for (int64_t bit = (int64_t)1 << 30; bit > 0; bit >>= 1) {
        if ((r + bit) * (r + bit) <= x)
            r += bit;
    }
    return r;
}

/* Scale v to length 32767. Equal everywhere, because C rounds quotients towards zero on every machine. */
static void unit(const int32_t v[3], int16_t out[3])
{
    int64_t length = root(((int64_t)v[0] * v[0] + (int64_t)v[1] * v[1] + (int64_t)v[2] * v[2]) << 16); /* Q8 */

    for (int k = 0; k < 3; k++)
        out[k] = (int16_t)(v[k] * (int64_t)32767 * 256 / length);
}

static void add_triangle(unsigned a, unsigned b, unsigned c)
{
    uint16_t *out = indices + 3 * mesh.triangles++;

    out[0] = (uint16_t)a;
    out[1] = (uint16_t)b;
    out[2] = (uint16_t)c;
}

/* Eight octants of CELLS^2 triangles each: rows of a triangular grid, projected onto the sphere. */
static void make_ball(void)
{
    enum {
        CELLS = 7
    };

    for (int octant = 0; octant < 8; octant++) {
        int sx = octant & 1 ? -1 : 1, sy = octant & 2 ? -1 : 1, sz = octant & 4 ? -1 : 1;
        int mirrored = (octant ^ octant >> 1 ^ octant >> 2) & 1;
        unsigned row = mesh.vertices;
        for (int i = 0; i <= CELLS; i++) {
            for (int j = 0; j <= CELLS - i; j++, mesh.vertices++) {
                const int32_t v[3] = {sx * j, sy * i, sz * (CELLS - i - j)};
                unit(v, normals + 3 * mesh.vertices);
                unit(v, positions + 3 * mesh.vertices);
            }
        }
        for (int i = 0; i < CELLS; i++) {
            unsigned above = row + (unsigned)(CELLS - i + 1);
            for (unsigned j = 0; j < (unsigned)(CELLS - i); j++) {
                unsigned a = row + j, b = row + j + 1, c = above + j, d = above + j + 1;
                add_triangle(a, mirrored ? c : b, mirrored ? b : c);
                if (j + 1 < (unsigned)(CELLS - i))
                    add_triangle(b, mirrored ? c : d, mirrored ? d : c);
            }
            row = above;
        }
    }
}

/* Point i of 4 n on the circle of radius 32767, by ((n^2 - t^2), 2 n t) / (n^2 + t^2) and quarter turns. */
static void circle(int32_t i, int32_t n, int32_t *cosine, int32_t *sine)
{
    int32_t t = i % n, whole = n * n + t * t;
    int32_t c = 32767 * (n * n - t * t) / whole, s = 32767 * 2 * n * t / whole;

    for (int quarter = i / n % 4; quarter > 0; quarter--) {
        int32_t turned = -s;
        s = c;
        c = turned;
    }
    *cosine = c;
    *sine = s;
}

static void make_torus(void)
{
    enum {
        ALONG = 5,
        AROUND = 3
    }; /* steps of a quarter turn */

    for (int32_t i = 0; i < 4 * ALONG; i++) {
        int32_t c, s;
        circle(i, ALONG, &c, &s);
        for (int32_t j = 0; j < 4 * AROUND; j++, mesh.vertices++) {
            int32_t tube_c, tube_s;
            circle(j, AROUND, &tube_c, &tube_s);
            int32_t radius = 22000 + tube_c * 3 / 10;
            int16_t *p = positions + 3 * mesh.vertices;
            p[0] = (int16_t)(radius * c / 32767);
            p[1] = (int16_t)(tube_s * 3 / 10);
            p[2] = (int16_t)(-radius * s / 32767);
            const int32_t v[3] = {tube_c * c / 32767, tube_s, -tube_c * s / 32767};
            unit(v, normals + 3 * mesh.vertices);
        }
    }
    for (unsigned i = 0; i < 4 * ALONG; i++) {
        for (unsigned j = 0; j < 4 * AROUND; j++) {
            unsigned here = i * 4 * AROUND, there = (i + 1) % (4 * ALONG) * 4 * AROUND, next = (j + 1) % (4 * AROUND);
            add_triangle(here + j, there + j, there + next);
            add_triangle(here + j, there + next, here + next);
        }
    }
}

/* One-byte indices; a corner's normal points away from the centre. */
static void make_box(void)
{
    static const uint8_t faces[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                        {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};

    for (int i = 0; i < 8; i++, mesh.vertices++) {
        const int32_t v[3] = {i & 1 ? 3 : -3, i & 2 ? 2 : -2, i & 4 ? 2 : -2};
        unit(v, normals + 3 * i);
        for (int k = 0; k < 3; k++)
            positions[3 * i + k] = (int16_t)(7500 * v[k]);
    }
    for (int f = 0; f < 6; f++) {
        for (int k = 0; k < 6; k++) {
            static const uint8_t fan[6] = {0, 1, 2, 0, 2, 3};
            small_indices[6 * f + k] = faces[f][fan[k]];
        }
        mesh.triangles += 2;
    }
}

static void make_globe(void)
{
    enum {
        STEPS = 16, /* of a quarter turn, each at most 7 degrees */
        EAST = 20,
        NORTH = 16
    };

    for (int32_t i = 0; i <= EAST; i++)
        for (int32_t j = 0; j <= NORTH; j++, mesh.vertices++) {
            int32_t c, s, up_c, up_s;
            circle(i + 40, STEPS, &c, &s); /* towards the eye */
            circle((j + 4 * STEPS - NORTH / 2) % (4 * STEPS), STEPS, &up_c, &up_s);
            const int32_t v[3] = {up_c * c / 32767, up_s, -up_c * s / 32767};
            unit(v, normals + 3 * mesh.vertices);
            unit(v, positions + 3 * mesh.vertices);
        }
    for (unsigned i = 0; i < EAST; i++)
        for (unsigned j = 0; j < NORTH; j++) {
            const unsigned here = i * (NORTH + 1) + j, there = here + NORTH + 1;
            add_triangle(here, there, there + 1);
            add_triangle(here, there + 1, here + 1);
        }
}

const struct sheen_mesh *sum_mesh(enum sum_mesh which)
{
    mesh = (struct sheen_mesh){.positions = positions,
                               .normals = normals,
                               .indices = which == SUM_BOX ? (const void *)small_indices : (const void *)indices,
                               .index_bytes = which == SUM_BOX ? 1 : 2,
                               .scale = 1 << 24};
    if (which == SUM_BALL)
        make_ball();
    else if (which == SUM_TORUS)
        make_torus();
    else if (which == SUM_GLOBE)
        make_globe();
    else
        make_box();
    return &mesh;
}
