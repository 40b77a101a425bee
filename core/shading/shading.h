/*
 * shading.h - private: the interface between a frame and a shading.
 *
 * A frame knows a shading only as a struct sheen_shader, which the caller names; a
 * shading that is not named is not linked. A room (flat, gouraud, phong, slerp, colored,
 * textured, matcap) gets a draw record, a triangle and a tile; it never sees the frame.
 */
#ifndef SHEEN_SHADING_H
#define SHEEN_SHADING_H

#include "../triangle/triangle.h"

/* Names an int16_t array of a mesh by its pointer's offset. */
#define OF_MESH(array) (offsetof(struct sheen_mesh, array))

/* How the normals at the corners of pieces are interpolated. */
enum piece_normals {
    LINEAR_NORMALS, /* linear in space; in an affine view on the screen, where triangles are shaded so */
    UNIT_IN_SPACE,  /* linear in space, then normalised: slerp goes from unit vector to unit vector */
    LINEAR_IN_SPACE
};

/* Which plane quads a shading may draw whole: the set-up made from three corners has to be right at the fourth too. */
enum quads_taken {
    QUADS_NONE,
    QUADS_ANY,       /* light is the same all over a polygon */
    QUADS_LIT,       /* linear intensities: see sheen_lit_linearly */
    QUADS_REFLECTED, /* quadrics of cosines: see sheen_most_bend and sheen_reflects_whole */
    QUADS_CLOSE      /* the same for normals no farther apart than CLOSE_ARCS */
};

/*
 * begin: fills in, once per draw, what the draw keeps for the room; NULL: nothing. material: the object's, changed by
 *   its ramp if it has one; view: world to eye.
 * light: computes what the shading keeps of a vertex from its normal (the mesh's, or for corners of pieces as seen),
 *   once per vertex that a listed triangle uses; NULL: nothing is kept. Pieces interpolate it linearly.
 * carry: three numbers for each corner of a triangle, for the side that is seen, which its pieces interpolate linearly
 *   and have in place of normals; NULL: pieces have normals.
 * setup: chooses the cheapest way whose error stays below what a level shows; sets way, rows and, if that way reads it,
 *   special_loop; fills in what follows *s. g: NULL if the triangle is too flat for gradients.
 * find_shades: sheen_shades_of, or NULL for a shading that uses no shades and so does not link that function.
 * takes: 0 if the shading cannot show the material's texture, which may be NULL. `takes` is NULL if it needs none.
 */
struct sheen_shader {
    void (*begin)(struct draw *d, const struct sheen_material *material, const struct pixel_format *format,
                  const struct sheen_object *object, const struct sheen_pose *view);
    void (*light)(const struct draw *d, const int16_t normal[3], uint16_t kept[2]);
    void (*carry)(const struct draw *d, uint16_t triangle, int back, int16_t out[3][3]);
    void (*setup)(struct setup *s, struct surface_corners *c, const struct gradients *g);
    int (*takes)(const struct sheen_texture *texture);
    const struct shades *(*find_shades)(const struct draw *d, struct shades *store, unsigned count, unsigned *taken);
    const struct sheen_light *axes; /* two lights that replace the object's; NULL: the object's own */
    uint8_t needs_normals;          /* 1: the mesh has to have vertex normals */
    uint8_t reads_normals;          /* 1: set-ups read normals of front faces too, not only what vertices keep */
    uint8_t unit_normals;           /* enum piece_normals */
    uint8_t needs_uvs;              /* 1: the mesh has to have uvs */
    uint8_t corners;                /* OF_MESH(...): where struct corners' `normal` points; 0: positions */
    uint8_t at_pixels;              /* 1: light is not linear between corners, so a ramp is read at pixels */
    uint8_t lights;                 /* enum lights_taken */
    uint8_t quads;                  /* enum quads_taken */
};

static inline const int16_t *corner_parts(const struct sheen_mesh *mesh, const struct sheen_shader *shader)
{
    return *(const int16_t *const *)(const void *)((const char *)mesh + shader->corners);
}

#endif
