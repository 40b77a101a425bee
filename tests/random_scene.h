/*
 * random_scene.h - scenes of the reference by number: a few that the core once drew wrongly, then random ones.
 */
#ifndef RANDOM_SCENE_H
#define RANDOM_SCENE_H

#include "textured_scene.h"

enum random_kind {
    RANDOM_ANY,
    RANDOM_BEHIND,    /* every light from behind, shininess 1 to 8 */
    RANDOM_STRONG,    /* specular 1, shininess from 16, coarse meshes near the eye */
    RANDOM_MAGNIFIED, /* a field of view of 1 to 32 degrees: corners lie far outside the guard band */
    RANDOM_KNOWN,     /* numbers 0 .. KNOWN_SCENES - 1 */
    RANDOM_KINDS
};
#define KNOWN_SCENES 6

/* Each shape, fine and coarse, and the meshes with uv. */
struct random_meshes {
    struct accuracy_mesh fine[ACCURACY_SHAPES], coarse[ACCURACY_SHAPES], textured[TEXTURED_MESHES];
};

struct random_scene {
    struct ref_scene scene;
    struct ref_texture texture; /* the scene's, if it has one */
    const struct accuracy_mesh *mesh;
    unsigned way; /* as in sheen_frame_force() */
    enum random_kind kind;
};

/* 0 or -1. Release with random_meshes_free. */
int random_meshes_make(struct random_meshes *meshes);
void random_meshes_free(struct random_meshes *meshes);

/* The scene of a number: the same on every machine. */
void random_scene(struct random_scene *to, const struct random_meshes *meshes, uint32_t number);

/* Print all parameters of a scene. */
void random_scene_print(const struct random_scene *scene);

#endif
