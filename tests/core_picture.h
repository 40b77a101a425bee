/*
 * core_picture.h - a scene of the reference, drawn by the core.
 */
#ifndef CORE_PICTURE_H
#define CORE_PICTURE_H

#include "../host-sim/command/shadings.h"
#include "frame/ways.h"
#include "memory_target.h"
#include "reference/reference.h"
#include "sheen.h"

/* A reference mesh in the core's numbers. Corners with equal position, normal, uv and colour become one vertex. */
struct core_mesh {
    struct sheen_mesh mesh;
    int16_t *positions, *normals, *polygon_normals, *uvs;
    uint8_t *colors, *warp;
    uint16_t *polygons, *indices;
};

/* 0, or -1 if memory is short or the mesh has too many vertices. Release with core_mesh_free. */
int core_mesh_make(struct core_mesh *to, const struct ref_mesh *from);
/* Likewise two frames of one mesh: corners become one vertex if they are equal in both; the larger scale is used. */
int core_frames_make(struct core_mesh to[2], const struct ref_mesh *first, const struct ref_mesh *second);
void core_mesh_free(struct core_mesh *mesh);

/* A scene in the core's numbers. It has one base colour; the core would need a mesh per colour. */
void core_view(struct sheen_view *view, const struct ref_scene *scene);
void core_pose(struct sheen_pose *pose, const struct ref_scene *scene);
/* Including the mixer; meaningless if the scene has no fog. */
void core_fog(struct sheen_fog *fog, const struct ref_scene *scene);
void core_lights(struct sheen_light lights[SHEEN_MAX_LIGHTS], const struct ref_scene *scene);
/* Tables that a material points to. */
struct core_tables {
    struct sheen_shine shine;
    struct sheen_ramp gamma;
};
int core_material(struct sheen_material *material, struct core_tables *tables, const struct ref_scene *scene);

/* A frame with an arena of its own. */
struct core_frame {
    struct sheen_frame *frame;
    void *arena;
    size_t arena_bytes;
};

int core_frame_make(struct core_frame *f, const struct sheen_config *config);
void core_frame_free(struct core_frame *f);

/* A frame's counters, and how many set-ups took each way. */
struct core_stats {
    struct sheen_stats frame;
    uint32_t by_way[SHEEN_WAYS];
};

/* Draw the scene with `mesh` to the target, in bands of band_rows. 0, or the error of the call that failed. */
int core_draw_scene(const struct sheen_target *target, const struct ref_scene *scene, const struct sheen_mesh *mesh,
                    int band_rows);
/* The same with a way as in sheen_frame_force() (frame/ways.h); *stats: the frame's. */
int core_draw_scene_way(const struct sheen_target *target, const struct ref_scene *scene, const struct sheen_mesh *mesh,
                        int band_rows, unsigned way, struct core_stats *stats);
/* The same for a state between two frames of a mesh. */
int core_draw_between(const struct sheen_target *target, const struct ref_scene *scene, const struct sheen_mesh *mesh,
                      const struct sheen_morph *morph, int band_rows, struct core_stats *stats);

#endif
