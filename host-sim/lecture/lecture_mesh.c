/*
 * lecture_mesh.c - meshes of a few triangles, built corner by corner.
 */
#include <math.h>
#include <string.h>

#include "lecture_scene.h"
#include "quantise.h"

void sheen_lecture_mesh_begin(struct sheen_lecture_mesh *m, int reach)
{
    memset(m, 0, sizeof *m);
    m->mesh = (struct sheen_mesh){.positions = m->positions,
                                  .normals = m->normals,
                                  .indices = m->indices,
                                  .index_bytes = 2,
                                  .scale = (sheen_q24_t)reach << 24};
}

/* Rounding moves a position by at most reach / 65536 units, about a hundredth of a pixel in every figure. */
unsigned sheen_lecture_vertex(struct sheen_lecture_mesh *m, const double position[3], const double normal[3])
{
    unsigned number = m->mesh.vertices++;
    double scale = m->mesh.scale / 16777216.0;

    for (unsigned i = 0; i < 3; i++)
        m->positions[3 * number + i] = (int16_t)lround(position[i] / scale * 32768);
    sheen_quantise_unit(normal, m->normals + 3 * number);
    return number;
}

void sheen_lecture_triangle(struct sheen_lecture_mesh *m, unsigned a, unsigned b, unsigned c)
{
    uint16_t *index = m->indices + 3 * m->mesh.triangles++;

    index[0] = (uint16_t)a;
    index[1] = (uint16_t)b;
    index[2] = (uint16_t)c;
}

void sheen_lecture_quad(struct sheen_lecture_mesh *m, unsigned a, unsigned b, unsigned c, unsigned d)
{
    sheen_lecture_triangle(m, a, b, c);
    sheen_lecture_triangle(m, a, c, d);
}

void sheen_lecture_lean(double cosine, double x, double y, double normal[3])
{
    double sine = sqrt(1 - cosine * cosine) / hypot(x, y);

    normal[0] = sine * x;
    normal[1] = sine * y;
    normal[2] = cosine;
}

void sheen_lecture_facet(struct sheen_lecture_mesh *m, double degrees, int count, int rows)
{
    unsigned v[4];

    sheen_lecture_mesh_begin(m, 2);
    for (int k = 0; k < 4; k++) {
        int right = k == 1 || k == 2;
        double lean = (right ? degrees : -degrees) / 2 * M_PI / 180, normal[3] = {sin(lean), 0, cos(lean)};
        double position[3] = {(right ? count : -count) / 512.0, (k > 1 ? rows : -rows) / 512.0, 0};
        v[k] = sheen_lecture_vertex(m, position, normal);
    }
    sheen_lecture_quad(m, v[0], v[1], v[2], v[3]);
}
