/*
 * shapes.h - meshes for tests, as polygons in double precision.
 */
#ifndef SHAPES_H
#define SHAPES_H

#include "reference/reference.h"

/* Owns what it points to, except polygons.uv, base and color. `polygons` is what ref_mesh_build gets. */
struct shape {
    struct ref_polygons polygons;
    double (*points)[3];
    double (*normals)[3]; /* per corner, or NULL */
    uint32_t *first, *corners;
    size_t point_room, polygon_room, corner_room;
};

/* Each returns 0, or -1 if memory is short. Release with shape_free. */

/* Unit sphere: rings of `around` quads from pole to pole (y = cos(pi i / rings)), of triangles at the poles. */
int shape_sphere(struct shape *shape, int rings, int around);
/* Torus of quads around the y axis; major: from the axis to the tube's centre; minor: the tube's radius. */
int shape_torus(struct shape *shape, double major, double minor, int along, int around);
/* Octahedron with corners at distance 1; cube with corners at (+-1, +-1, +-1), quads. */
int shape_octahedron(struct shape *shape);
int shape_icosahedron(struct shape *shape); /* with edges of length 2 */
int shape_cube(struct shape *shape);
/*
 * Barrel around the y axis, |y| <= 0.8, radius 0.8 - 0.4 y^2. The side consists of quads and has exact normals, as a
 * file's `vn` would give them; each lid is one polygon with its own normal, so the rims are creases.
 */
int shape_barrel(struct shape *shape, int rings, int around);
/* Two triangles with corners (+-1.6, +-1.2, 0), normals (+-.5, +-.5, 1): fill a 4:3 picture at distance 2, fov 60. */
int shape_screen(struct shape *shape);

/* Build a shape by hand; points: indices of points that have been added. */
int shape_point(struct shape *shape, double x, double y, double z);
int shape_polygon(struct shape *shape, int count, const uint32_t *points);
void shape_free(struct shape *shape);

#endif
