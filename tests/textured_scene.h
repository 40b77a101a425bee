/*
 * textured_scene.h - meshes with uv, textures of our own making and scenes of them, for the tests of textures.
 */
#ifndef TEXTURED_SCENE_H
#define TEXTURED_SCENE_H

#include "accuracy.h"

#define TEXTURED_MESHES 6
#define TEXTURED_PICTURES 4

/* Mesh number `index`: floor, cube, sphere, torus, screen, barrel; uv with seams, and repeated. 0 or -1. */
int textured_mesh_make(struct accuracy_mesh *mesh, int index);

/* Picture number `index`: tiles, noise, marble, sixteen colours. Lives as long as the program. */
const struct ref_texture *textured_picture(int index);

/* Which of a scene's many properties: each takes one of the next in turn, so that all pairs come soon. */
enum textured_light {
    TEXTURED_SCENE_UNLIT,
    TEXTURED_SCENE_FLAT,
    TEXTURED_SCENE_GOURAUD,
    TEXTURED_SCENE_GLOSSY,
    TEXTURED_SCENE_LIGHTS,
    TEXTURED_SCENE_COLORS, /* of the vertices, glossy */
    TEXTURED_SCENE_FLAT_COLORS,
    TEXTURED_SCENE_TINTS, /* of lights and ambient light, and every other view's vertices */
    TEXTURED_SCENE_POINTS,
    TEXTURED_SCENE_FLAT_POINTS,
    TEXTURED_SCENE_ALL
};

/* Mesh's view of 0..4 (3: cut by the near plane, 4: magnified, so that the guard band cuts). */
#define TEXTURED_VIEWS 5
bool textured_is_flat(enum textured_light light);
void textured_view(struct ref_scene *scene, const struct ref_mesh *mesh, int view, enum textured_light light);

#endif
