/*
 * random_scene.h - scenes of the reference by number: a few that once were wrong, then random ones.
 */
#ifndef RANDOM_SCENE_H
#define RANDOM_SCENE_H

#include "textured_scene.h"

enum random_kind {
    RANDOM_ANY,
    RANDOM_BEHIND,    /* every light from behind, shininess 1 to 8 */
    RANDOM_STRONG,    /* specular 1, shininess from 16, coarse meshes near to the eye */
    RANDOM_MAGNIFIED, /* a field of view of 1 to 32 degrees: corners lie far outside the guard band */
    RANDOM_KNOWN,     /* numbers 0 .. KNOWN_SCENES - 1 */
    RANDOM_KINDS
};
#define KNOWN_SCENES 6

/* Each shape, fine and coarse; those with uv. */
struct random_meshes {
    struct accuracy_mesh fine[ACCURACY_SHAPES], coarse[ACCURACY_SHAPES], textured[TEXTURED_MESHES];
};

struct random_scene {
    struct ref_scene scene;
    struct ref_texture texture; /* the scene's, where it has one */
    const struct accuracy_mesh *mesh;
    unsigned way; /* as in struct sheen_object */
    enum random_kind kind;
};

/* 0 or -1. Release with random_meshes_free. */
int random_meshes_make(struct random_meshes *meshes);
void random_meshes_free(struct random_meshes *meshes);

/* The scene of a number: the same on every machine. */
void random_scene(struct random_scene *to, const struct random_meshes *meshes, uint32_t number);

/* A line with all that is in it. */
void random_scene_print(const struct random_scene *scene);

#endif
