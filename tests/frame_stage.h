/*
 * frame_stage.h - a few objects on a stage, for tests of whole frames.
 */
#ifndef FRAME_STAGE_H
#define FRAME_STAGE_H

#include "../host-sim/command/shadings.h"
#include "core_picture.h"
#include "memory_target.h"

enum stage_mesh {
    STAGE_BALL,
    STAGE_TORUS,
    STAGE_CUBE,
    STAGE_MESHES
};

struct stage {
    struct core_mesh mesh[STAGE_MESHES]; /* of radius 1 */
    struct sheen_material material[3];
    struct sheen_shine shine[3];
    struct sheen_light light[1];
};

/* 0 or a negative code. Release with stage_free. */
int stage_make(struct stage *stage);
void stage_free(struct stage *stage);

/* Where an object is and how it looks. Lengths in units; the eye is at the origin and looks along -z. */
struct actor {
    enum stage_mesh mesh;
    int material;
    enum sheen_shading shading;
    double x, y, depth, size; /* depth: m of its centre */
    double yaw, pitch;        /* degrees */
};

void stage_draw(const struct stage *stage, const struct actor *actor, struct sheen_object *draw);

/* near 1, far 12, fov 50 degrees, all of the target, a dark blue background. */
void stage_view(struct sheen_view *view);

/* A frame of these actors: begin, draw each, end, wait. 0 or the first negative code. */
int stage_frame(struct sheen_frame *frame, const struct sheen_view *view, const struct stage *stage,
                const struct actor *actors, int count);

/* A configuration with room for `actors` actors with any of the stage's meshes. */
void stage_config(struct sheen_config *config, const struct memory_target *target, int actors);

/* A random generator for tests: the same numbers on every machine. */
uint32_t stage_random(uint32_t *state);
/* Uniform in [low, high). */
double stage_uniform(uint32_t *state, double low, double high);

#endif
