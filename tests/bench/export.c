/*
 * export.c - prints the scenes as C, for boards that have no libm to make them with.
 */
#include <math.h>
#include <stdio.h>

#define PI 3.14159265358979323846
#define MAX_VERTICES 2112
#define MAX_TRIANGLES 3968

static double position[MAX_VERTICES][3], normal[MAX_VERTICES][3];
static double polygon_normal[MAX_TRIANGLES][3];
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

/* Ends the polygon that the triangles from `first` on were added to; its normal is the unit sum of theirs. */
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
    }
    add_triangle(0, 1, 2); /* the diagonal runs from (-,+) to (+,-) */
    add_triangle(2, 1, 3);
    end_polygon(0);
}

static void print_vectors(const char *name, int scene, double (*v)[3], int count, double unit)
{
    printf("static const int16_t %s_%d[] = {", name, scene);
    for (int i = 0; i < 3 * count; i++)
        printf("%s%ld,", i % 12 ? " " : "\n    ", lround(32767 * v[i / 3][i % 3] / unit));
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

/* unit: what raw 32767 stands for; listed: room for triangles that face the eye. */
static struct scene {
    void (*make)(void);
    double unit, depth, degrees;
    int listed, vertices, triangles;
} scenes[3] = {
    {sphere, 1, 2.2195, 45, 1300, 0, 0},
    {torus, 1.08, 2.6, 45, 1300, 0, 0},
    {screen, 1.6, 2, 0, 2, 0, 0},
};

static void print_scene(int number, const struct scene *s)
{
    printf("    {\"S%d\",\n"
           "     {.positions = positions_%d, .normals = normals_%d, .polygon_normals = polygon_normals_%d,\n"
           "      .polygons = polygons_%d, .indices = indices_%d, .index_bytes = 2,\n"
           "      .vertices = %d, .triangles = %d, .scale = %ld},\n     {",
           number, number, number, number, number, number, s->vertices, s->triangles,
           lround(s->unit * 32768 / 32767 * 16777216));
    print_pose(s->degrees - 1, s->depth);
    printf(",\n      ");
    print_pose(s->degrees, s->depth);
    printf("},\n     %ld, %ld, %d},\n", lround((s->depth - 1.1) * 16777216), lround((s->depth + 1.1) * 16777216),
           s->listed);
}

int main(void)
{
    printf("/* Made by export.c. */\n#include \"scenes.h\"\n\n");
    for (int i = 0; i < 3; i++) {
        vertices = triangles = polygons = 0;
        scenes[i].make();
        scenes[i].vertices = vertices;
        scenes[i].triangles = triangles;
        print_vectors("positions", i + 1, position, vertices, scenes[i].unit);
        print_vectors("normals", i + 1, normal, vertices, 1);
        print_vectors("polygon_normals", i + 1, polygon_normal, polygons, 1);
        print_numbers("polygons", i + 1, polygon, triangles);
        print_numbers("indices", i + 1, triangle[0], 3 * triangles);
    }
    printf("\nconst struct bench_scene bench_scenes[BENCH_SCENES] = {\n");
    for (int i = 0; i < 3; i++)
        print_scene(i + 1, &scenes[i]);
    printf("};\n");
    return ferror(stdout) || fflush(stdout) != 0;
}
