/*
 * scenes.h - the scenes that sheen is measured on; other renderers can be given the same work.
 *
 *   S1  unit sphere, 32 rings of 64 quads, 2,112 vertices, 3,968 triangles, turned by 45 degrees about x
 *   S2  torus, radii .75 and .33, 40 x 25 quads, 1,000 vertices, 2,000 triangles, turned by 45 degrees
 *   S3  two triangles that fill the picture, corner normals spread over 71 degrees
 *   S5  an icosahedron subdivided once, 80 triangles on the unit sphere, as S1: normals up to 36 degrees apart
 *   teapot, 992 triangles, on 240x240: for the cost of its edges
 *
 * S1 and S3 have uvs, a texture of 64 x 64 texels of 565, repeated 2 by 1 times, nearest or bilinear; and vertex
 * colours, which are the vertices' positions.
 *
 * 320x240 except for the teapot, vertical field of view 60 degrees, one light, ambient .15, diffuse .70, specular .50,
 * n = 16. The second of two frames is measured, the first is one degree before it; material tables are built before
 * both.
 */
#ifndef BENCH_SCENES_H
#define BENCH_SCENES_H

#include "../../host-sim/command/shadings.h"
#include "sheen.h"

#define BENCH_WIDTH 320
#define BENCH_HEIGHT 240
#define BENCH_SCENES 4
#define BENCH_TEXELS_LOG2 6

struct bench_scene {
    const char *name;
    struct sheen_mesh mesh;
    struct sheen_pose pose[2]; /* of both frames */
    sheen_q24_t near, far;
    uint16_t max_used, max_triangles; /* used and listed, with some room to spare */
    uint16_t width;
};

/* Made by export.c at build time, because boards have no libm to make them with. */
extern const struct bench_scene bench_scenes[BENCH_SCENES], bench_teapot;

extern const uint16_t bench_texels[1 << 2 * BENCH_TEXELS_LOG2];

/* What is drawn: texels nearest unless stated otherwise; a highlight as the scenes have it. */
enum bench_texture {
    BENCH_PLAIN,
    BENCH_UNLIT,
    BENCH_LIT,
    BENCH_GLOSSY,
    BENCH_BILINEAR, /* unlit */
    BENCH_MATCAP,   /* by the normal instead of uvs and light */
    BENCH_MATCAP_VERTEX,
    BENCH_MATCAP_BILINEAR,
    BENCH_TEXTURED_COLORED, /* like BENCH_LIT, with vertices' colours */
    BENCH_MATCAP_COLORED,   /* like BENCH_MATCAP, with vertices' colours */
    BENCH_COLORED,          /* no texture, but vertices' colours; flat or Gouraud */
    /* no texture, but a highlight everywhere: as many independent channels as with vertices' colours; Gouraud */
    BENCH_HIGHLIGHTED,
    BENCH_TRIANGLES, /* like BENCH_PLAIN, without quads */
    BENCH_LIGHTS     /* with two lights; vertices have no colours */
};

/* A frame in progress: bench_begin() sets it up, then bench_first() and bench_measured() are called once each. */
struct bench {
    const struct bench_scene *scene;
    struct sheen_target target; /* throws the pixels away */
    struct sheen_config config;
    struct sheen_material material;
    struct sheen_frame *frame;
    uint8_t shading;
    uint8_t dither;                  /* 0 after bench_config */
    uint8_t texture;                 /* enum bench_texture, likewise */
    uint8_t fogged;                  /* likewise; fog from near to far */
    uint8_t transparency;            /* likewise */
    uint8_t morphed;                 /* likewise; halfway from the mesh to itself, so max_used must be all vertices */
    const struct sheen_edges *edges; /* likewise NULL; set before bench_begin() */
};

/* Only the configuration, for the size of its arena. */
void bench_config(struct bench *bench, const struct bench_scene *scene, enum sheen_shading shading, int band_rows);
int bench_begin(struct bench *bench, void *arena, size_t size);
int bench_first(struct bench *bench);
int bench_measured(struct bench *bench); /* never inlined, because what runs inside it is counted */

#endif
