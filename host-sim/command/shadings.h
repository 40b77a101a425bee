/*
 * shadings.h - shadings, and ways to draw edges, by number: for options, tables and loops of the host and the tests.
 */
#ifndef SHEEN_SHADINGS_H
#define SHEEN_SHADINGS_H

#include "sheen.h"

enum sheen_shading {
    SHEEN_FLAT = 0,
    SHEEN_GOURAUD,
    SHEEN_PHONG,
    SHEEN_SLERP,
    SHEEN_SHADINGS, /* how many the lecture has, which are lit; those from here on show a picture of a lit sphere */
    SHEEN_MATCAP = SHEEN_SHADINGS,
    SHEEN_MATCAP_VERTEX,
    SHEEN_ALL_SHADINGS
};

/* The shading's name in --shade. */
static inline const char *sheen_shading_word(unsigned shading)
{
    static const char *const word[SHEEN_ALL_SHADINGS] = {"flat",  "gouraud", "phong",
                                                         "slerp", "matcap",  "matcap-vertex"};

    return word[shading];
}

/* The shading's shader that reads colours of vertices and lights. */
static inline const struct sheen_shader *sheen_colored_shader_of(unsigned shading)
{
    static const struct sheen_shader *const shader[SHEEN_ALL_SHADINGS] = {
        &sheen_flat_colored,  &sheen_gouraud_colored, &sheen_phong_colored,
        &sheen_slerp_colored, &sheen_matcap_colored,  &sheen_matcap_vertex_colored};

    return shader[shading];
}

/* The shader of textures: flat, or gouraud for any other shading. */
static inline const struct sheen_shader *sheen_textured_shader_of(unsigned shading, int colored)
{
    static const struct sheen_shader *const shader[2][2] = {{&sheen_textured_flat, &sheen_textured},
                                                            {&sheen_textured_flat_colored, &sheen_textured_colored}};

    return shader[colored != 0][shading != SHEEN_FLAT];
}

static inline const struct sheen_shader *sheen_shader_of(unsigned shading)
{
    static const struct sheen_shader *const shader[SHEEN_ALL_SHADINGS] = {
        &sheen_flat, &sheen_gouraud, &sheen_phong, &sheen_slerp, &sheen_matcap, &sheen_matcap_vertex};

    return shader[shading];
}

enum sheen_edging {
    SHEEN_NO_EDGES = 0,
    SHEEN_SMOOTH,
    SHEEN_OUTLINE,
    SHEEN_WIRE,
    SHEEN_EDGINGS
};

static inline const struct sheen_edges *sheen_edges_of(unsigned edging)
{
    static const struct sheen_edges *const edges[SHEEN_EDGINGS] = {NULL, &sheen_edges_smooth, &sheen_edges_outline,
                                                                   &sheen_edges_wire};

    return edges[edging];
}

#endif
