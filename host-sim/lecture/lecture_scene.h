/*
 * lecture_scene.h - small scenes drawn by the core, and what it made of them. Private to lecture*.c.
 */
#ifndef SHEEN_LECTURE_SCENE_H
#define SHEEN_LECTURE_SCENE_H

#include "shadings.h"
#include "sheen.h"

/* ---- meshes by hand ---- */

#define SHEEN_LECTURE_VERTICES 256
#define SHEEN_LECTURE_TRIANGLES 512

/* Points into itself: not to be copied. */
struct sheen_lecture_mesh {
    struct sheen_mesh mesh;
    int16_t positions[3 * SHEEN_LECTURE_VERTICES], normals[3 * SHEEN_LECTURE_VERTICES];
    uint16_t indices[3 * SHEEN_LECTURE_TRIANGLES];
};

/* An empty mesh for coordinates of |x| < reach units; reach: a power of two, at most 64. */
void sheen_lecture_mesh_begin(struct sheen_lecture_mesh *m, int reach);
/* The number of a new vertex. normal: unit. The caller keeps to the room there is. */
unsigned sheen_lecture_vertex(struct sheen_lecture_mesh *m, const double position[3], const double normal[3]);
/* Corners counter-clockwise seen from outside; a quad is cut from corner a to corner c. */
void sheen_lecture_triangle(struct sheen_lecture_mesh *m, unsigned a, unsigned b, unsigned c);
void sheen_lecture_quad(struct sheen_lecture_mesh *m, unsigned a, unsigned b, unsigned c, unsigned d);
/*
 * A rectangle across the whole picture of width count px and height rows px, a pixel being 1/256 unit, its normals
 * +-degrees/2 from the eye's direction at its left and right ends: corners lie on pixel corners.
 */
void sheen_lecture_facet(struct sheen_lecture_mesh *m, double degrees, int count, int rows);
/* Unit normal that a light along z meets with L.N = cosine, leaning towards (x, y). */
void sheen_lecture_lean(double cosine, double x, double y, double normal[3]);

/* ---- scenes ---- */

struct sheen_lecture_scene {
    const struct sheen_mesh *mesh;
    int width, height; /* px */
    int shading;       /* enum sheen_shading */
    int affine, ortho;
    double distance;         /* of the eye from the model's origin, units */
    double reach;            /* half the picture's height, units at that distance */
    double yaw, pitch, roll; /* degrees */
    int two_sided;
    double light[3];
    double ambient, diffuse, specular;
    int shininess;
    uint8_t base[3];
    uint8_t background[3]; /* of sheen_lecture_picture; measured scenes are black outside */
};

/* A white surface before a white page, seen from distance 4: no highlight, light along z, no perspective. */
void sheen_lecture_scene_default(struct sheen_lecture_scene *scene, const struct sheen_mesh *mesh);

/* The light turned about z by the scene's roll, so that mesh and light turn together. */
void sheen_lecture_roll_light(struct sheen_lecture_scene *scene, double degrees);

/*
 * Intensities of every pixel, 0..1, finer than any panel shows: the picture is drawn with
 * 256 grey levels under each of the 64 thresholds of the 8x8 dither, the mean lies within
 * 1/128 of a level of the core's unrounded value. intensity: width * height. The base
 * colour counts as white. 0, or a negative code.
 */
int sheen_lecture_measure(const struct sheen_lecture_scene *scene, double *intensity);

/*
 * A scene that looks straight at sheen_lecture_facet's rectangle, lit from `from` degrees left of the eye's direction
 * (negative: right), without perspective.
 */
void sheen_lecture_facet_scene(struct sheen_lecture_scene *scene, const struct sheen_lecture_mesh *facet, int count,
                               int rows, double from);

/* As a 565 panel shows it, dithered: width * height * 3 bytes. 0, or a negative code. */
int sheen_lecture_picture(const struct sheen_lecture_scene *scene, uint8_t *rgb);

#endif
