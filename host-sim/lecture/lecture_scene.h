/*
 * lecture_scene.h - small scenes that the core draws, and the resulting pixels. Private to lecture*.c.
 */
#ifndef SHEEN_LECTURE_SCENE_H
#define SHEEN_LECTURE_SCENE_H

#include "shadings.h"
#include "sheen.h"

/* ---- meshes by hand ---- */

#define SHEEN_LECTURE_VERTICES 256
#define SHEEN_LECTURE_TRIANGLES 512

/* MUST not be copied: mesh points to the arrays below it. */
struct sheen_lecture_mesh {
    struct sheen_mesh mesh;
    int16_t positions[3 * SHEEN_LECTURE_VERTICES], normals[3 * SHEEN_LECTURE_VERTICES];
    uint16_t indices[3 * SHEEN_LECTURE_TRIANGLES];
};

/* Starts an empty mesh for coordinates of |x| < reach units; reach: a power of two, at most 64. */
void sheen_lecture_mesh_begin(struct sheen_lecture_mesh *m, int reach);
/* Adds a vertex and returns its number. normal: unit length. The caller MUST not exceed SHEEN_LECTURE_VERTICES. */
unsigned sheen_lecture_vertex(struct sheen_lecture_mesh *m, const double position[3], const double normal[3]);
/* Corners are counter-clockwise as seen from outside. A quad is cut from corner a to corner c. */
void sheen_lecture_triangle(struct sheen_lecture_mesh *m, unsigned a, unsigned b, unsigned c);
void sheen_lecture_quad(struct sheen_lecture_mesh *m, unsigned a, unsigned b, unsigned c, unsigned d);
/*
 * A rectangle that fills a picture of count * rows px; one pixel is 1/256 unit, so its corners lie on pixel corners.
 * The normals at its left and right ends are turned -degrees/2 and +degrees/2 from the eye's direction.
 */
void sheen_lecture_facet(struct sheen_lecture_mesh *m, double degrees, int count, int rows);
/* The unit normal that leans towards (x, y) and has L.N = cosine for a light along z. */
void sheen_lecture_lean(double cosine, double x, double y, double normal[3]);

/* ---- scenes ---- */

struct sheen_lecture_scene {
    const struct sheen_mesh *mesh;
    int width, height; /* px */
    int shading;       /* enum sheen_shading */
    int affine, ortho;
    double distance;         /* from the eye to the model's origin, units */
    double reach;            /* half the picture's height at that distance, units */
    double yaw, pitch, roll; /* degrees */
    int two_sided;
    double light[3];
    double ambient, diffuse, specular;
    int shininess;
    uint8_t base[3];
    uint8_t background[3]; /* only for sheen_lecture_picture(); sheen_lecture_measure() has a black one */
};

/* A white surface on a white background, seen from distance 4: no highlight, light along z, no perspective. */
void sheen_lecture_scene_default(struct sheen_lecture_scene *scene, const struct sheen_mesh *mesh);

/* Turns the light about z. With the scene's roll as `degrees`, mesh and light turn together. */
void sheen_lecture_roll_light(struct sheen_lecture_scene *scene, double degrees);

/*
 * The intensity of each pixel, 0..1, finer than any panel shows it. The picture is drawn in
 * 256 grey levels once for each of the 64 thresholds of the 8x8 dither, so that the mean is
 * within 1/128 of a level of the core's unrounded value. intensity: width * height values.
 * The base colour is taken as white. Returns 0 or a negative error code.
 */
int sheen_lecture_measure(const struct sheen_lecture_scene *scene, double *intensity);

/*
 * A scene that looks straight at the rectangle of sheen_lecture_facet(), without perspective. The light comes from
 * `from` degrees left of the eye's direction (negative: right).
 */
void sheen_lecture_facet_scene(struct sheen_lecture_scene *scene, const struct sheen_lecture_mesh *facet, int count,
                               int rows, double from);

/* The picture as a 565 panel shows it, dithered. rgb: width * height * 3 bytes. Returns 0 or a negative error code. */
int sheen_lecture_picture(const struct sheen_lecture_scene *scene, uint8_t *rgb);

#endif
