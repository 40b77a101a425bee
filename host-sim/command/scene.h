/*
 * scene.h - a mesh that turns, on any target: the command draws it on a simulated panel and a board's program on a real
 * one, so that both pictures are the same bits.
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
    struct sheen_material hidden; /* of faces that only hide lines (--edges wire) */
    uint8_t *own_color;           /* per mesh; 1: the material's colour is the file's */
    struct sheen_shine shine;     /* of all materials */
    struct sheen_ramp ramp;       /* of all materials, if one is made for the options */
    struct sheen_morph *morphs;   /* per mesh, if there is another frame of it */
    size_t count;
    struct sheen_texels *texels; /* the textures that materials point to */
    size_t texel_count;
    const struct sheen_texture **own_texture; /* per mesh; NULL: none */
    struct sheen_texels matcap;               /* shown instead if the shading is a matcap */
    int has_colors;                           /* 1: a mesh has vertex colours */
    int shows_inside; /* 1: a file's mesh is not closed, its inside is seen, and no --cull was given */
    int edgeless;     /* 1: the edges drawn by default are left out, as no frame has room for them */
    int is_usage;     /* 1: an error is the command line's, not the mesh's */
    struct sheen_light lights[SHEEN_MAX_LIGHTS];
    struct sheen_view view;
    struct sheen_fog fog; /* the view's, where it has one */
    /* Where it is drawn, and the frame's memory. */
    const struct sheen_target *target;
    struct sheen_config config;
    void *arena;
    struct sheen_frame *frame;
};

/* The options that say how a mesh is made from its file, except those about textures. */
struct sheen_host_options sheen_scene_host_options(const struct sheen_options *options, int by_group);

/* The options that say which textures are read, and how. */
struct sheen_texture_options sheen_scene_texture_options(const struct sheen_options *options);

/* Makes a mesh's textures in the core's format, one for each of its pictures. 0, or SHEEN_ERR_MEMORY. */
int sheen_scene_texels(struct sheen_texels **texels, const struct sheen_host_mesh *host,
                       const struct sheen_options *options);

/* 1 if the shading asked for shows colours of vertices, lights or ambient light, or point lights. */
int sheen_scene_is_colored(const struct sheen_scene *scene);

/* 1 if the scene can only be lit flat or gouraud: it shows a texture, or there are point lights. */
int sheen_scene_corners_alone(const struct sheen_scene *scene);

/* The shading: the options', but gouraud in place of phong or slerp if the scene can only be lit flat or gouraud. */
enum sheen_shading sheen_scene_shading(const struct sheen_scene *scene);

/*
 * What is drawn of edges: what the options say, or by default what shows best on the panel. With an opacity below 1 the
 * default is none, because the pixels that the pattern leaves out are not the other side of a contour.
 */
enum sheen_edging sheen_scene_edging(const struct sheen_scene *scene);

/*
 * Loads and allocates; nothing is drawn. options and target are borrowed.
 * 0, or a negative code and *problem; close in either case.
 */
int sheen_scene_open(struct sheen_scene *scene, const struct sheen_options *options, const struct sheen_target *target,
                     struct sheen_problem *problem);
void sheen_scene_close(struct sheen_scene *scene);

/* Moves the meshes to another target: the frame is made anew and sends everything once. 0, or a negative code. */
int sheen_scene_retarget(struct sheen_scene *scene, const struct sheen_target *target);

/* Takes eye, lights and dithering over from the options, which may have changed since the last frame. */
void sheen_scene_look(struct sheen_scene *scene);

/* Checks that the fog spans enough steps of depth to be drawn. 0, or SHEEN_ERR_ARGUMENT and *problem. */
int sheen_scene_check_fog(const struct sheen_scene *scene, struct sheen_problem *problem);

/* The meshes' pose in frame `number`. */
void sheen_scene_pose(const struct sheen_scene *scene, int number, struct sheen_pose *pose);

/* The object as which mesh i is drawn in frame `number`; valid once a frame has begun. */
void sheen_scene_object(const struct sheen_scene *scene, int number, size_t i, struct sheen_object *object);

/* Begins frame `number` and draws all meshes into it; sheen_end(scene->frame), or each band, is left to the caller. */
int sheen_scene_begin(struct sheen_scene *scene, int number);

/*
 * Draws frame `number` (yaw + number * yaw_step) and sends it; its last push may still be under way until
 * sheen_wait(scene->frame) or the next draw has waited for it.
 */
int sheen_scene_draw(struct sheen_scene *scene, int number);

#endif
