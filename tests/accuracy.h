/*
 * accuracy.h - compares the core's picture with the reference's in double precision: scenes, limits, scores.
 */
#ifndef ACCURACY_H
#define ACCURACY_H

#include "core_picture.h"
#include "shapes.h"

#define ACCURACY_SHAPES 8
#define ACCURACY_VIEWS 3

/*
 * How close to the reference the core has to come; README.md, "Numbers", says how close it does. Shares are of the
 * compared pixels. Nearest texels and matcaps have to keep Gouraud's limits. Bilinear texels may be off by 1 step plus
 * what 1/16 texel and 1/16 px change (struct ref_score's `beyond`); only where that is little (REF_CALM) a share of
 * equal pixels is demanded, ACCURACY_BILINEAR. In fog one step more is allowed.
 */
struct accuracy_limit {
    double equal, within_one;
    int worst; /* steps of a channel */
};
extern const struct accuracy_limit accuracy_limits[4]; /* by enum ref_shading */

#define ACCURACY_BILINEAR 0.88 /* least share of calm pixels that are equal */
#define ACCURACY_FOGGED 0.95   /* least share of equal pixels in fog, unless the shading's limit is lower */
#define ACCURACY_COMPARED 0.60 /* least share of the covered pixels that are compared */

struct accuracy_mesh {
    const char *name;
    struct ref_mesh reference;
    const struct sheen_mesh *mesh; /* the same mesh for the core */
    struct core_mesh own;          /* what `mesh` points to if it is a shape */
};

/* A colour per corner, the same for all corners at one point, in whole 1/255. NULL if memory is short. Free it. */
double (*accuracy_corner_colors(const struct ref_polygons *polygons))[3];
/* Shape number `index`; coarse: with polygons large enough to compare flat shading. 0 or -1. */
int accuracy_mesh_make(struct accuracy_mesh *mesh, int index, bool coarse);
void accuracy_mesh_free(struct accuracy_mesh *mesh);

/* View number `index` of 0..2: pose, distance, field of view, light, colours. */
void accuracy_view(struct ref_scene *scene, const struct ref_mesh *mesh, int index);
/* Change a scene: four lights; colours for lights and ambient light; three point lights; no perspective. */
void accuracy_more_lights(struct ref_scene *scene);
void accuracy_tints(struct ref_scene *scene);
void accuracy_points(struct ref_scene *scene);
void accuracy_ortho(struct ref_scene *scene);

#define ACCURACY_PIXELS (320 * 320) /* of the largest picture */

/* A picture by the core, and its score against the reference's. */
struct accuracy_shot {
    struct ref_score score;
    struct core_stats stats;
    uint16_t values[ACCURACY_PIXELS]; /* 565 or the scene's grey levels, row by row */
};

/* Draw a scene by the core and compare it with `picture`, the reference's; way: sheen_frame_force(). 0 or negative. */
int accuracy_shoot(struct accuracy_shot *shot, const struct ref_scene *scene, const struct ref_picture *picture,
                   const struct sheen_mesh *mesh, unsigned way);
/* The same for a state between two frames of a mesh. */
int accuracy_shoot_between(struct accuracy_shot *shot, const struct ref_scene *scene, const struct ref_picture *picture,
                           const struct sheen_mesh *mesh, const struct sheen_morph *morph);

/* Whether a score keeps its shading's limits, and at least this share of the covered pixels was compared. */
bool accuracy_kept(const struct ref_score *score, enum ref_shading shading, double least_compared);

#endif
