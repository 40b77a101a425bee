/*
 * textured_scene.h - meshes with uv, computed textures and scenes of them, for the tests of textures.
 */
#ifndef TEXTURED_SCENE_H
#define TEXTURED_SCENE_H

#include "accuracy.h"

#define TEXTURED_MESHES 6
#define TEXTURED_PICTURES 4

/* Mesh number `index`: floor, cube, sphere, torus, screen, barrel. Their uv have seams and repeat. 0 or -1. */
int textured_mesh_make(struct accuracy_mesh *mesh, int index);

/* Picture number `index`: tiles, noise, marble, sixteen colours. Static. */
const struct ref_texture *textured_picture(int index);

/* How a scene is lit and coloured. */
enum textured_light {
    TEXTURED_SCENE_UNLIT,
    TEXTURED_SCENE_FLAT,
    TEXTURED_SCENE_GOURAUD,
    TEXTURED_SCENE_GLOSSY,
    TEXTURED_SCENE_LIGHTS,
    TEXTURED_SCENE_COLORS, /* of the vertices; all from here on are glossy */
    TEXTURED_SCENE_FLAT_COLORS,
    TEXTURED_SCENE_TINTS, /* coloured lights and ambient light; like POINTS, vertices' colours in every other view */
    TEXTURED_SCENE_POINTS,
    TEXTURED_SCENE_FLAT_POINTS,
    TEXTURED_SCENE_ALL
};

/* View 0..4 of a mesh (3: cut by the near plane; 4: magnified, so that the guard band cuts). */
#define TEXTURED_VIEWS 5
bool textured_is_flat(enum textured_light light);
void textured_view(struct ref_scene *scene, const struct ref_mesh *mesh, int view, enum textured_light light);

#endif
