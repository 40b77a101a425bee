/*
 * shading.h - private: what a shading is to a frame.
 *
 * A frame knows a shading as a struct sheen_shader, which the caller names: what is
 * not named is not linked. A room (flat, gouraud, phong, slerp) gets a draw record,
 * a triangle and a tile; it never sees the frame.
 */
#ifndef SHEEN_SHADING_H
#define SHEEN_SHADING_H

#include "../triangle/triangle.h"

/*
 * begin: fills in what the draw keeps for the room, once a draw; NULL: nothing.
 * light: what the shading keeps of a vertex, from its normal (as the mesh has it, or as
 *   seen), once for each that a listed triangle uses; NULL: nothing. Between corners it is linear.
 * setup: chooses the cheapest way within PICTURE's table and fills in what follows *s; g: NULL
 *   where the triangle is too flat for gradients. Sets way, fast and rows.
 */
struct sheen_shader {
    void (*begin)(struct draw *d, const struct sheen_material *material, const struct pixel_format *format);
    void (*light)(const struct draw *d, const int16_t normal[3], uint16_t kept[2]);
    void (*setup)(struct setup *s, struct surface_corners *c, const struct gradients *g);
    const struct shades_maker *shades; /* NULL: takes no shades */
    const struct sheen_light *axes;    /* two lights in place of the object's; NULL: those */
    uint8_t needs_normals;             /* 1: the mesh has to have vertex normals */
    uint8_t unit_normals;              /* 1: corners of pieces need unit normals */
    uint8_t needs_texture;             /* 1: the material has to have a texture; there is no ramp then */
    uint8_t needs_uvs; /* 1: the mesh has to have uvs; corners and pieces have them in place of normals */
    uint8_t at_pixels; /* 1: light is not linear between corners: a ramp is read at pixels */
};

#endif
