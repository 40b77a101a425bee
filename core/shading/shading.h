/*
 * shading.h - private: what a shading is to a frame.
 *
 * A frame knows a shading as a struct sheen_shader, which the caller names: what is
 * not named is not linked. A room (flat, gouraud, phong, slerp, colored, textured,
 * matcap) gets a draw record, a triangle and a tile; it never sees the frame.
 */
#ifndef SHEEN_SHADING_H
#define SHEEN_SHADING_H

#include "../triangle/triangle.h"

/* An array of a mesh, of int16_t. */
#define OF_MESH(array) (offsetof(struct sheen_mesh, array))

/* What corners of pieces are given in place of normals. */
enum piece_normals {
    LINEAR_NORMALS, /* as cuts are: in space, or where that is how a triangle is shaded on the screen */
    UNIT_IN_SPACE,  /* linear in space, brought to length 1: slerp goes from unit vector to unit vector */
    LINEAR_IN_SPACE
};

/* Which plane quads a shading may draw whole: what it makes of three corners has to hold for the fourth too. */
enum quads_taken {
    QUADS_NONE,
    QUADS_ANY,       /* light is one a polygon */
    QUADS_LIT,       /* linear intensities: sheen_lit_linearly */
    QUADS_REFLECTED, /* quadrics of cosines: sheen_most_bend, sheen_reflects_whole; */
    QUADS_CLOSE      /* up to CLOSE_ARCS */
};

/*
 * begin: fills in what the draw keeps for the room, once a draw; NULL: nothing. material: the object's, as its ramp has
 *   it; view: world to eye.
 * light: what the shading keeps of a vertex, from its normal (as the mesh has it, or as
 *   seen), once for each that a listed triangle uses; NULL: nothing. Between corners it is linear.
 * carry: of a triangle's corners three numbers each, for the side that is seen, which are linear in between: what its
 *   pieces have in place of normals; NULL: normals.
 * setup: chooses the cheapest way that is off by less than a level shows and fills in what follows *s; g: NULL
 *   where the triangle is too flat for gradients. Sets way, fast and rows.
 * shades: sheen_shades_of, so that what takes none does not link it; NULL: it takes none.
 * takes: 0 where the material's texture, or NULL, is none that the shading can show; NULL: it needs none.
 */
struct sheen_shader {
    void (*begin)(struct draw *d, const struct sheen_material *material, const struct pixel_format *format,
                  const struct sheen_object *object, const struct sheen_pose *view);
    void (*light)(const struct draw *d, const int16_t normal[3], uint16_t kept[2]);
    void (*carry)(const struct draw *d, uint16_t triangle, int back, int16_t out[3][3]);
    void (*setup)(struct setup *s, struct surface_corners *c, const struct gradients *g);
    int (*takes)(const struct sheen_texture *texture);
    const struct shades *(*shades)(const struct draw *d, struct shades *store, unsigned count, unsigned *taken);
    const struct sheen_light *axes; /* two lights in place of the object's; NULL: those */
    uint8_t needs_normals;          /* 1: the mesh has to have vertex normals */
    uint8_t reads_normals;          /* 1: set-ups read those of front faces too, not what vertices keep alone */
    uint8_t unit_normals;           /* enum piece_normals */
    uint8_t needs_uvs;              /* 1: the mesh has to have uvs */
    uint8_t corners;                /* OF_MESH(...): what they have as their `normal`; 0: positions */
    uint8_t at_pixels;              /* 1: light is not linear between corners: a ramp is read at pixels */
    uint8_t lights;                 /* enum lights_taken */
    uint8_t quads;                  /* enum quads_taken */
};

static inline const int16_t *corner_parts(const struct sheen_mesh *mesh, const struct sheen_shader *shader)
{
    return *(const int16_t *const *)(const void *)((const char *)mesh + shader->corners);
}

#endif
