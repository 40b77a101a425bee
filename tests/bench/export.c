/*
 * export.c - prints the scenes as C, because boards have no libm to make them with.
 */
#include <math.h>
#include <stdio.h>

#include "../../firmware/meshes/teapot.h"
#include "scenes.h"

#define PI 3.14159265358979323846
#define MAX_VERTICES 2112
#define MAX_TRIANGLES 3968

static double position[MAX_VERTICES][3], normal[MAX_VERTICES][3];
static double polygon_normal[MAX_TRIANGLES][3];
static double uv[MAX_VERTICES][2]; /* for scenes that are drawn with a texture */
static int triangle[MAX_TRIANGLES][3], polygon[MAX_TRIANGLES];
static int vertices, triangles, polygons;

static void add_triangle(int a, int b, int c)
{
    int *t = triangle[triangles];

    t[0] = a;
    t[1] = b;
    t[2] = c;
    polygon[triangles++] = polygons;
}

/* Ends the polygon to which the triangles from `first` on were added; its normal is the normalised sum of theirs. */
static void end_polygon(int first)
{
    double *n = polygon_normal[polygons], length;

    n[0] = n[1] = n[2] = 0;
    for (int i = first; i < triangles; i++) {
        const double *a = position[triangle[i][0]], *b = position[triangle[i][1]], *c = position[triangle[i][2]];
        for (int k = 0; k < 3; k++) {
            int u = (k + 1) % 3, v = (k + 2) % 3;
            n[k] += (b[u] - a[u]) * (c[v] - a[v]) - (b[v] - a[v]) * (c[u] - a[u]);
        }
    }
    length = sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    for (int k = 0; k < 3; k++)
        n[k] /= length;
    polygons++;
}

static void sphere(void)
{
    for (int i = 0; i <= 32; i++) {
        for (int j = 0; j < 64; j++, vertices++) {
            double r = sin(PI * i / 32), turn = 2 * PI * j / 64;
            double p[3] = {r * cos(turn), cos(PI * i / 32), -r * sin(turn)};
            for (int k = 0; k < 3; k++)
                position[vertices][k] = normal[vertices][k] = p[k];
            uv[vertices][0] = 2 * fabs(j - 32.0) / 32; /* forwards and backwards, so that there is no seam */
            uv[vertices][1] = i / 32.0;
        }
    }
    for (int i = 0; i < 32; i++) {
        for (int j = 0; j < 64; j++) {
            int up = 64 * i, down = up + 64, next = (j + 1) % 64, first = triangles;
            if (i < 31)
                add_triangle(up + j, down + j, down + next);
            if (i > 0)
                add_triangle(up + j, down + next, up + next);
            end_polygon(first);
        }
    }
}

static void torus(void)
{
    for (int i = 0; i < 40; i++) {
        for (int j = 0; j < 25; j++, vertices++) {
            double turn = 2 * PI * i / 40, tube = 2 * PI * j / 25;
            double n[3] = {cos(tube) * cos(turn), sin(tube), -cos(tube) * sin(turn)};
            double p[3] = {(0.75 + 0.33 * cos(tube)) * cos(turn), 0.33 * sin(tube),
                           -(0.75 + 0.33 * cos(tube)) * sin(turn)};
            for (int k = 0; k < 3; k++) {
                position[vertices][k] = p[k];
                normal[vertices][k] = n[k];
            }
        }
    }
    for (int i = 0; i < 40; i++) {
        for (int j = 0; j < 25; j++) {
            int here = 25 * i, there = (i + 1) % 40 * 25, next = (j + 1) % 25, first = triangles;
            add_triangle(here + j, there + j, there + next);
            add_triangle(here + j, there + next, here + next);
            end_polygon(first);
        }
    }
}

static void screen(void)
{
    for (vertices = 0; vertices < 4; vertices++) {
        int x = vertices & 1 ? 1 : -1, y = vertices & 2 ? 1 : -1;
        double length = sqrt(0.5 * 0.5 + 0.5 * 0.5 + 1);
        double p[3] = {1.6 * x, 1.2 * y, 0}, n[3] = {0.5 * x / length, 0.5 * y / length, 1 / length};
        for (int k = 0; k < 3; k++) {
            position[vertices][k] = p[k];
            normal[vertices][k] = n[k];
        }
        uv[vertices][0] = x + 1;
        uv[vertices][1] = (1 - y) / 2;
    }
    add_triangle(0, 1, 2); /* the diagonal runs from (-,+) to (+,-) */
    add_triangle(2, 1, 3);
    end_polygon(0);
}

/* The vertex halfway between a and b on the unit sphere, added if it is new; the icosahedron's twelve come first. */
static int middle(int a, int b)
{
    double m[3], length = 0;
    int found;

    for (int k = 0; k < 3; k++) {
        m[k] = position[a][k] + position[b][k];
        length += m[k] * m[k];
    }
    for (int k = 0; k < 3; k++)
        m[k] /= sqrt(length);
    for (found = 12; found < vertices; found++) {
        if (fabs(position[found][0] - m[0]) + fabs(position[found][1] - m[1]) + fabs(position[found][2] - m[2]) < 1e-9)
            return found;
    }
    for (int k = 0; k < 3; k++)
        position[vertices][k] = normal[vertices][k] = m[k];
    return vertices++;
}

static void icosahedron_corners(void)
{
    const double golden = (1 + sqrt(5)) / 2, length = sqrt(1 + golden * golden);

    for (vertices = 0; vertices < 12; vertices++) {
        int axis = vertices / 4;
        double *p = position[vertices];
        p[axis] = 0;
        p[(axis + 1) % 3] = (vertices & 1 ? 1 : -1) / length;
        p[(axis + 2) % 3] = (vertices & 2 ? 1 : -1) * golden / length;
        for (int k = 0; k < 3; k++)
            normal[vertices][k] = p[k];
    }
}

static double squared_distance(int a, int b)
{
    double d = 0;

    for (int k = 0; k < 3; k++)
        d += (position[a][k] - position[b][k]) * (position[a][k] - position[b][k]);
    return d;
}

/* Whether a, b, c run counter-clockwise seen from outside. */
static int outwards(int a, int b, int c)
{
    const double *p = position[a], *q = position[b], *r = position[c];

    return p[0] * (q[1] * r[2] - q[2] * r[1]) + p[1] * (q[2] * r[0] - q[0] * r[2]) +
               p[2] * (q[0] * r[1] - q[1] * r[0]) >
           0;
}

static void add_polygon(int a, int b, int c)
{
    int first = triangles;

    add_triangle(a, b, c);
    end_polygon(first);
}

/* Three vertices an edge apart form a face; an edge is 1.051 long, the next larger distance is 1.701. */
static void icosahedron(void)
{
    icosahedron_corners();
    for (int a = 0; a < 12; a++) {
        for (int b = 0; b < 12; b++) {
            for (int c = 0; c < 12; c++) {
                if (a > b || a > c || b == c || squared_distance(a, b) > 1.2 || squared_distance(b, c) > 1.2 ||
                    squared_distance(c, a) > 1.2 || a == b || a == c || !outwards(a, b, c))
                    continue;
                int ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
                add_polygon(a, ab, ca);
                add_polygon(ab, b, bc);
                add_polygon(ca, bc, c);
                add_polygon(ab, bc, ca);
            }
        }
    }
}

static long quantised(double (*v)[3], int i, double unit)
{
    return lround(32767 * v[i / 3][i % 3] / unit);
}

static void print_vectors(const char *name, int scene, double (*v)[3], int count, double unit)
{
    printf("static const int16_t %s_%d[] = {", name, scene);
    for (int i = 0; i < 3 * count; i++)
        printf("%s%ld,", i % 12 ? " " : "\n    ", quantised(v, i, unit));
    printf("\n};\n");
}

static void print_uvs(int scene)
{
    printf("static const int16_t uvs_%d[] = {", scene);
    for (int i = 0; i < 2 * vertices; i++)
        printf("%s%ld,", i % 12 ? " " : "\n    ", lround(uv[i / 2][i % 2] * 4096));
    printf("\n};\n");
}

/* Each vertex gets its position as r, g, b; each axis runs from -1 to 1. */
static void print_colors(int scene)
{
    printf("static const uint8_t colors_%d[] = {", scene);
    for (int i = 0; i < 3 * vertices; i++)
        printf("%s%ld,", i % 12 ? " " : "\n    ", lround(127.5 + 127.5 * fmax(-1, fmin(position[i / 3][i % 3], 1))));
    printf("\n};\n");
}

static void print_texels(void)
{
    uint32_t noise = 1;

    printf("\nconst uint16_t bench_texels[] = {");
    for (int i = 0; i < 1 << 2 * BENCH_TEXELS_LOG2; i++) {
        noise = noise * 1664525u + 1013904223u;
        printf("%s%u,", i % 12 ? " " : "\n    ", (unsigned)(noise >> 16));
    }
    printf("\n};\n");
}

static void print_numbers(const char *name, int scene, const int *number, int count)
{
    printf("static const uint16_t %s_%d[] = {", name, scene);
    for (int i = 0; i < count; i++)
        printf("%s%d,", i % 12 ? " " : "\n    ", number[i]);
    printf("\n};\n");
}

static void print_pose(double degrees, double depth)
{
    double c = cos(degrees * PI / 180), s = sin(degrees * PI / 180);

    printf("{{1073741824, 0, 0, 0, %ld, %ld, 0, %ld, %ld}, 65536, {0, 0, %ld}}", lround(c * 1073741824),
           lround(-s * 1073741824), lround(s * 1073741824), lround(c * 1073741824), lround(-depth * 16777216));
}

/* unit: what raw 32767 stands for; used, listed: room for vertices and triangles that face the eye. */
static struct scene {
    int number;
    void (*make)(void);
    double unit, depth, degrees;
    int used, listed, vertices, triangles;
} scenes[] = {
    {1, sphere, 1, 2.2195, 45, 800, 1300, 0, 0},
    {2, torus, 1.08, 2.6, 45, 700, 1300, 0, 0},
    {3, screen, 1.6, 2, 0, 4, 2, 0, 0},
    {5, icosahedron, 1, 2.2195, 45, 42, 80, 0, 0},
};
#define SCENES (int)(sizeof scenes / sizeof scenes[0])

static void print_edges(int scene, const struct sheen_mesh *mesh)
{
    static struct sheen_triangle_edges edges[MAX_TRIANGLES];
    static uint32_t scratch[SHEEN_EDGES_WORDS(MAX_VERTICES, MAX_TRIANGLES)];

    sheen_mesh_edges(mesh, SHEEN_Q30(0.5), scratch, edges);
    printf("static const struct sheen_triangle_edges edges_%d[] = {", scene);
    for (int i = 0; i < triangles; i++)
        printf("%s{{%u, %u, %u}, %u, %u},", i % 6 ? " " : "\n    ", edges[i].across[0], edges[i].across[1],
               edges[i].across[2], edges[i].sharp, edges[i].inner);
    printf("\n};\n");
}

/* What `sheen bake` would add to the mesh: warp and edges. */
static void print_baked(const struct scene *s)
{
    static int16_t positions[3 * MAX_VERTICES], normals[3 * MAX_VERTICES], facing[3 * MAX_TRIANGLES];
    static uint16_t polygon_of[MAX_TRIANGLES], indices[3 * MAX_TRIANGLES];
    static uint8_t warp[MAX_TRIANGLES];
    const struct sheen_mesh mesh = {.positions = positions,
                                    .normals = normals,
                                    .polygon_normals = facing,
                                    .polygons = polygon_of,
                                    .indices = indices,
                                    .index_bytes = 2,
                                    .vertices = (uint16_t)vertices,
                                    .triangles = (uint16_t)triangles};

    for (int i = 0; i < 3 * vertices; i++)
        positions[i] = (int16_t)quantised(position, i, s->unit);
    for (int i = 0; i < 3 * vertices; i++)
        normals[i] = (int16_t)quantised(normal, i, 1);
    for (int i = 0; i < 3 * polygons; i++)
        facing[i] = (int16_t)quantised(polygon_normal, i, 1);
    for (int i = 0; i < 3 * triangles; i++) {
        polygon_of[i / 3] = (uint16_t)polygon[i / 3];
        indices[i] = (uint16_t)triangle[i / 3][i % 3];
    }
    sheen_mesh_warp(&mesh, (uint32_t)polygons, warp);
    printf("static const uint8_t warp_%d[] = {", s->number);
    for (int i = 0; i < polygons; i++)
        printf("%s%d,", i % 24 ? " " : "\n    ", warp[i]);
    printf("\n};\n");
    print_edges(s->number, &mesh);
}

static void print_scene(const struct scene *s)
{
    int number = s->number;

    printf("    {\"S%d\",\n"
           "     {.positions = positions_%d, .normals = normals_%d, .polygon_normals = polygon_normals_%d,\n"
           "      .polygons = polygons_%d, .indices = indices_%d, .warp = warp_%d, .index_bytes = 2,\n"
           "      .vertices = %d, .triangles = %d, .scale = %ld, .uvs = uvs_%d, .uv_bits = 12,\n      "
           ".colors = colors_%d, .edges = edges_%d},\n     {",
           number, number, number, number, number, number, number, s->vertices, s->triangles,
           lround(s->unit * 32768 / 32767 * 16777216), number, number, number);
    print_pose(s->degrees - 1, s->depth);
    printf(",\n      ");
    print_pose(s->degrees, s->depth);
    printf("},\n     %ld, %ld, %d, %d, BENCH_WIDTH},\n", lround((s->depth - 1.1) * 16777216),
           lround((s->depth + 1.1) * 16777216), s->used, s->listed);
}

/* The teapot as in the firmware, with edges; at the distance of `sheen render`, in the other scenes' field of view. */
static void print_teapot(void)
{
    const sheen_q24_t distance = SHEEN_Q24(2.2195);

    triangles = teapot.triangles;
    printf("\n#include \"../../firmware/meshes/teapot.h\"\n\n");
    print_edges(0, &teapot);
    printf("\nconst struct bench_scene bench_teapot = {\n"
           "    \"teapot\",\n    {.positions = teapot_positions, .normals = teapot_normals, .polygon_normals = "
           "teapot_polygon_normals,\n     .polygons = teapot_polygons, .indices = teapot_indices, .warp = "
           "teapot_warp, .index_bytes = 2,\n     .vertices = %u, .triangles = %u, .scale = %ld, .edges = edges_0},\n"
           "    {",
           teapot.vertices, teapot.triangles, (long)teapot.scale);
    for (int frame = 0; frame < 2; frame++) {
        struct sheen_pose pose;
        sheen_pose_orbit(&pose, SHEEN_DEGREES(29) + (sheen_angle_t)frame * SHEEN_DEGREES(1), SHEEN_DEGREES(20), 0,
                         distance);
        printf("%s{{", frame ? ",\n     " : "");
        for (int i = 0; i < 9; i++)
            printf("%ld, ", (long)pose.rotation[i]);
        printf("}, %ld, {0, 0, %ld}}", (long)pose.scale, (long)pose.translation[2]);
    }
    printf("},\n    %ld, %ld, %u, %u, 240};\n", (long)(distance - SHEEN_Q24(1.05)), (long)(distance + SHEEN_Q24(1.05)),
           teapot.vertices, teapot.triangles);
}

int main(void)
{
    printf("/* Made by export.c. */\n#include \"scenes.h\"\n\n");
    for (struct scene *s = scenes; s < scenes + SCENES; s++) {
        vertices = triangles = polygons = 0;
        s->make();
        s->vertices = vertices;
        s->triangles = triangles;
        print_vectors("positions", s->number, position, vertices, s->unit);
        print_vectors("normals", s->number, normal, vertices, 1);
        print_vectors("polygon_normals", s->number, polygon_normal, polygons, 1);
        print_numbers("polygons", s->number, polygon, triangles);
        print_numbers("indices", s->number, triangle[0], 3 * triangles);
        print_baked(s);
        print_uvs(s->number);
        print_colors(s->number);
    }
    print_texels();
    print_teapot();
    printf("\nconst struct bench_scene bench_scenes[BENCH_SCENES] = {\n");
    for (int i = 0; i < SCENES; i++)
        print_scene(&scenes[i]);
    printf("};\n");
    return ferror(stdout) || fflush(stdout) != 0;
}
