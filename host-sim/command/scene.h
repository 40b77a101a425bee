/*
 * scene.h - a mesh that turns, on any target: what the command draws on a simulated panel
 * and a board's program on a real one, so that both are the same bits.
 *
 *   mesh file -> quantised meshes -> core -> target
 */
#ifndef SHEEN_SCENE_H
#define SHEEN_SCENE_H

#include "options.h"
#include "quantise.h"
#include "texels.h"

struct sheen_scene {
    const struct sheen_options *options;
    /* What is drawn: one mesh, or one for each texture, and with --color file for each material. */
    struct sheen_quantised *meshes;
    struct sheen_material *materials;
    struct sheen_material hidden; /* faces whose edges alone are shown */
    uint8_t *own_color;           /* 1: the material's is of the file's */
    struct sheen_shine shine;     /* of all of them */
    struct sheen_ramp ramp;       /* likewise, where one is made */
    struct sheen_morph *morphs;   /* of each mesh, where there is another frame */
    size_t count;
    struct sheen_texels *texels; /* the textures that materials point to */
    size_t texel_count;
    const struct sheen_texture **own_texture; /* of each mesh; NULL: none */
    struct sheen_texels matcap;               /* in its place where the shading is a matcap */
    int has_colors;                           /* 1: a mesh has colours of vertices */
    int edgeless;                             /* 1: more edges than a frame takes, of which none were asked for */
    int is_usage;                             /* 1: the command line is what is wrong, not the mesh */
    struct sheen_light lights[SHEEN_MAX_LIGHTS];
    struct sheen_view view;
    struct sheen_fog fog; /* the view's, where it has one */
    /* Where, and the frame's memory. */
    const struct sheen_target *target;
    struct sheen_config config;
    void *arena;
    struct sheen_frame *frame;
};

/* What of the options says how a mesh is made of its file, its textures aside. */
struct sheen_host_options sheen_scene_host_options(const struct sheen_options *options, int by_group);

/* What of them says which textures are read. */
struct sheen_texture_options sheen_scene_texture_options(const struct sheen_options *options);

/* A mesh's textures as the core takes them, as many as it has pictures. 0, or SHEEN_ERR_MEMORY. */
int sheen_scene_texels(struct sheen_texels **texels, const struct sheen_host_mesh *host,
                       const struct sheen_options *options);

/* 1 where there are colours of vertices, lights or ambient light that the shading asked for shows. */
int sheen_scene_is_colored(const struct sheen_scene *scene);

/* 1 where it can be lit flat or gouraud alone: it shows a texture, or there are point lights. */
int sheen_scene_corners_alone(const struct sheen_scene *scene);

/* How it is shaded: as the options say, or where these do not and it is lit so alone, gouraud. */
enum sheen_shading sheen_scene_shading(const struct sheen_scene *scene);

/*
 * What is drawn of edges: as the options say, or by default what shows best on the panel; nothing with an opacity
 * below 1, as what is left out there is no contour's other side.
 */
enum sheen_edging sheen_scene_edging(const struct sheen_scene *scene);

/*
 * Loads and allocates; nothing is drawn. options and target are borrowed.
 * 0, or a negative code and *problem; close in either case.
 */
int sheen_scene_open(struct sheen_scene *scene, const struct sheen_options *options, const struct sheen_target *target,
                     struct sheen_problem *problem);
void sheen_scene_close(struct sheen_scene *scene);

/* Another target for the same meshes: the frame is made anew, the next one is sent whole. 0, or a negative code. */
int sheen_scene_retarget(struct sheen_scene *scene, const struct sheen_target *target);

/* Takes eye, lights and dithering over from the options, which may have changed since the last frame. */
void sheen_scene_look(struct sheen_scene *scene);

/* Whether the view's fog reaches deep enough to be drawn. 0, or SHEEN_ERR_ARGUMENT and *problem. */
int sheen_scene_check_fog(const struct sheen_scene *scene, struct sheen_problem *problem);

/* How the meshes stand in frame `number`. */
void sheen_scene_pose(const struct sheen_scene *scene, int number, struct sheen_pose *pose);

/* What mesh i is drawn as in frame `number`, once a frame has begun. */
void sheen_scene_object(const struct sheen_scene *scene, int number, size_t i, struct sheen_object *object);

/* Begins frame `number` and draws all meshes into it; sheen_end(scene->frame), or band by band, is left to do. */
int sheen_scene_begin(struct sheen_scene *scene, int number);

/*
 * Draws frame `number` (yaw + number * yaw_step) and sends it; its last push may
 * still be under way (sheen_wait(scene->frame), or the next draw, collects it).
 */
int sheen_scene_draw(struct sheen_scene *scene, int number);

#endif
