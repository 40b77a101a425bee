/*
 * ways.h - private: the ways in which the shadings bring light over a triangle.
 */
#ifndef SHEEN_WAYS_H
#define SHEEN_WAYS_H

/* How a triangle was shaded: the cheapest way whose error is too small to show in a level. */
enum sheen_way {
    SHEEN_WAY_FLAT = 0,          /* one colour; also triangles too flat for gradients, or out of the light */
    SHEEN_WAY_GOURAUD_LINEAR,    /* linear on the screen */
    SHEEN_WAY_GOURAUD_QUADRATIC, /* quadratic on the screen, through the middles of the edges */
    SHEEN_WAY_GOURAUD_QUOTIENT,  /* Blinn's I/m over 1/m, a reciprocal per pixel */
    SHEEN_WAY_PHONG_QUADRATIC,   /* diffuse part and R.V quadratic over the triangle, power by table */
    SHEEN_WAY_PHONG_CELLS,       /* quadratic over cells of 8 to 32 px with exact nodes */
    SHEEN_WAY_PHONG_ROOT,        /* L.N, N.V linear, N.N by second differences, 1/sqrt per pixel */
    SHEEN_WAY_PHONG_LIGHTS,      /* several lights: N linear, 1/sqrt per pixel, a dot product per light */
    SHEEN_WAY_SLERP,             /* arcs by series, L.N and R.V quadratic over parts of a row */
    SHEEN_WAY_SLERP_NORMALS,     /* several lights, arcs beyond a right angle: the normal, 1/sqrt per pixel */
    SHEEN_WAY_TEXTURED_LINEAR,   /* texel coordinates and light linear on the screen */
    SHEEN_WAY_TEXTURED_QUOTIENT, /* Blinn's quotient at the ends of blocks of 8 px or less */
    SHEEN_WAY_MATCAP_QUADRATIC,  /* x and y of the normal quadratic over the triangle */
    SHEEN_WAY_MATCAP_NORMALS,    /* the normal linear, 1/sqrt at the ends of blocks of 32 px or less */
    SHEEN_WAYS
};

#endif
