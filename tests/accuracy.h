/*
 * accuracy.h - the core against the picture in double precision: scenes, limits, scores.
 */
#ifndef ACCURACY_H
#define ACCURACY_H

#include "core_picture.h"
#include "shapes.h"

#define ACCURACY_SHAPES 8
#define ACCURACY_VIEWS 3

/*
 * How close the core has to come; README, "Numbers", has how close it comes. Shares are of the compared pixels. Nearest
 * texels and matcaps keep Gouraud's limits. Bilinear ones are off by no more than 1 step and what 1/16 texel and 1/16
 * px change (struct ref_score's `beyond`), and equal as below where that is little (REF_CALM). In fog a step more is
 * allowed.
 */
struct accuracy_limit {
    double equal, within_one;
    int worst; /* steps of a channel */
};
extern const struct accuracy_limit accuracy_limits[4]; /* by enum ref_shading */

#define ACCURACY_BILINEAR 0.88 /* equal, of calm pixels */
#define ACCURACY_FOGGED 0.95   /* equal, at least, where the limit is not lower */
#define ACCURACY_COMPARED 0.60 /* of the covered pixels, at least */

struct accuracy_mesh {
    const char *name;
    struct ref_mesh reference;
    const struct sheen_mesh *mesh; /* the same for the core */
    struct core_mesh own;          /* of a shape: what mesh points to */
};

/* Of each corner; its point's own, and whole bytes. NULL where memory is short; to be freed. */
double (*accuracy_corner_colors(const struct ref_polygons *polygons))[3];
/* Shape number `index`; coarse: with polygons large enough to judge flat shading by. 0 or -1. */
int accuracy_mesh_make(struct accuracy_mesh *mesh, int index, bool coarse);
void accuracy_mesh_free(struct accuracy_mesh *mesh);

/* View number `index` of 0..2: pose, distance, field of view, light, colours. */
void accuracy_view(struct ref_scene *scene, const struct ref_mesh *mesh, int index);
/* The same with four lights; these and ambient light with colours; three of them points; without perspective. */
void accuracy_more_lights(struct ref_scene *scene);
void accuracy_tints(struct ref_scene *scene);
void accuracy_points(struct ref_scene *scene);
void accuracy_ortho(struct ref_scene *scene);

#define ACCURACY_PIXELS (320 * 320) /* of the largest picture */

/* A picture of the core's, and how it does against the reference's. */
struct accuracy_shot {
    struct ref_score score;
    struct core_stats stats;
    uint16_t values[ACCURACY_PIXELS]; /* 565 or the scene's grey levels, row by row */
};

/* Draw the scene, of which `picture` is the reference's, by the core; way as in struct sheen_object. 0 or negative. */
int accuracy_shoot(struct accuracy_shot *shot, const struct ref_scene *scene, const struct ref_picture *picture,
                   const struct sheen_mesh *mesh, unsigned way);
/* The same between two frames of a mesh. */
int accuracy_shoot_between(struct accuracy_shot *shot, const struct ref_scene *scene, const struct ref_picture *picture,
                           const struct sheen_mesh *mesh, const struct sheen_morph *morph);

/* True where the score keeps the limits of its shading, and so much of what is covered was compared. */
bool accuracy_kept(const struct ref_score *score, enum ref_shading shading, double least_compared);

#endif
