/*
 * vertex.h - private: vertices on the screen, how a mesh's vertices get there, and light at them.
 */
#ifndef SHEEN_VERTEX_H
#define SHEEN_VERTEX_H

#include "../math/products.h"
#include "../pixel/pixel.h"

#define SUBPIXEL_BITS 6 /* vertices are snapped to 1/64 px */
#define SUBPIXEL_ONE 64
#define SUBPIXEL_HALF 32                  /* a pixel's centre */
#define GUARD_BAND (511 << SUBPIXEL_BITS) /* 1/64 px from the viewport's centre */
#define INNER_VIEW (255 << SUBPIXEL_BITS) /* likewise; differences of coordinates inside it fit 16 bits */

/*
 * Depth in 16 bits: z16 = DEPTH_FAR + DEPTH_RANGE * (1/m - 1/far) / (1/near - 1/far).
 * The margins on both sides keep rounding errors of interpolation from wrapping. The
 * buffer is cleared to DEPTH_FAR, two equal bytes, so m >= far is not drawn.
 */
#define DEPTH_RANGE 65020
#define DEPTH_FAR 0x0101

enum vertex_flag { /* sides of the view volume a vertex lies outside of, and what was done to it */
    OUTSIDE_NEAR = 1,
    OUTSIDE_FAR = 2,
    OUTSIDE_LEFT = 4,
    OUTSIDE_RIGHT = 8,
    OUTSIDE_TOP = 16,
    OUTSIDE_BOTTOM = 32,
    OUTSIDE = 63,
    LIT = 64,          /* kept is set, for the mesh's normal */
    LIT_AS_SEEN = 128, /* kept is for the side that is seen, front or back: set at corners of pieces */
    OFF_VIEW = 256     /* x or y is outside the viewport, or more than INNER_VIEW from its centre */
};

struct vertex {
    int16_t x, y;     /* Q9.6 px from the viewport's centre, +-511 px; undefined where OUTSIDE */
    uint16_t z;       /* z16 */
    uint16_t flags;   /* enum vertex_flag */
    uint16_t kept[2]; /* what the shading keeps of a vertex, once LIT; Gouraud: diffuse and specular, UQ1.15 */
};

/*
 * A positive number as mantissa / 2^31 * 2^exponent, mantissa in [2^31, 2^32).
 */
struct scaled {
    uint32_t mantissa;
    int exponent;
};

/* The view's projection, valid for one frame. Made by sheen_project_begin. */
struct projection {
    struct scaled focal;     /* px */
    uint32_t depth;          /* mantissa: z16 = DEPTH_FAR + depth / m - depth / far; orthographic: see depth_factor */
    int depth_shift;         /* right shift that brings products with that mantissa to depth_fraction bits */
    unsigned depth_fraction; /* 0..15: fraction bits of depth / m, as many as 32 bits have room for */
    uint32_t depth_base;     /* with these bits: DEPTH_FAR - depth / far + 1/2; orthographic: without depth / far */
    sheen_q24_t near, far;
    int16_t view_x, view_y;   /* 1/64 px: half the viewport's width and height, at most INNER_VIEW */
    sheen_q24_t orthographic; /* 0, or the depth that x and y are divided by in place of m */
    /*
     * 1/m is proportional to (z16 << weight_shift) + weight_offset, which is in [0, 2^31) for every z16 from near to
     * far, and 0 at far if far / near is beyond 2^24.
     */
    unsigned weight_shift; /* 0..15 */
    int32_t weight_offset; /* negative if far / near is 254 or more */
};

/*
 * A point in eye space: m, Q7.24; x to the right and y down, multiplied by focal's mantissa / 2^32, with `fine` more
 * fraction bits than m. |part| < 2^31.
 */
struct point {
    int32_t x, y, m;
};

/*
 * Model to a point: floor(row times raw position / 2^14) / 2^shift + t. For x and y the shift is less by `fine`, the
 * bits that the draw's x and y leave free: small ones are kept finer because the screen shows more of them.
 */
struct transform {
    struct PRODUCT_FORM(row) row[3];
    int32_t t[3];
    unsigned shift, shift_fine; /* 0..29 */
    unsigned fine;
    int screen_shift; /* x in 1/128 px = x / u * 2^(30 - screen_shift + up), with m = u / 2^up */
};

/* The view's field of view, or the default that 0 stands for; 0 if it is out of range. */
sheen_angle_t sheen_fov(const struct sheen_view *view);
int sheen_project_begin(struct projection *p, const struct sheen_view *view, unsigned width, unsigned height);
/* z16 with 16 fraction bits at any m > 0, also outside near to far; with perspective m MUST be at least near / 2^15. */
int64_t sheen_depth_beyond(const struct projection *p, sheen_q24_t m);
/* origin: a posed mesh's, in eye space. Returns the units that raw 32768 is, or an error: too far or too large. */
sheen_q24_t sheen_origin(const struct sheen_mesh *mesh, const struct sheen_pose *pose, sheen_q24_t origin[3]);
int sheen_transform_begin(struct transform *t, const struct projection *p, const struct sheen_mesh *mesh,
                          const struct sheen_pose *pose);
struct point sheen_transform_point(const struct transform *t, const int16_t position[3]);
/* screen_shift: of the point's transform. */
void sheen_project(const struct projection *p, int screen_shift, const struct point *point, struct vertex *v);

/* As sheen_twice_area, if no corner is OFF_VIEW: differences fit 16 bits, products 31. */
static inline int32_t small_twice_area(const struct vertex *a, const struct vertex *b, const struct vertex *c)
{
    return (b->x - a->x) * (c->y - a->y) - (b->y - a->y) * (c->x - a->x);
}

/* clip.c: twice the signed area, 1/4096 px^2, positive if clockwise on the screen (y down). Range: < 2^33. */
int64_t sheen_twice_area(const struct vertex *a, const struct vertex *b, const struct vertex *c);

/* First pixel whose centre is at or after a coordinate of 1/64 px: ceil(v - 1/2). */
static inline int32_t first_centre(int32_t v)
{
    return asr32(v + SUBPIXEL_HALF - 1, SUBPIXEL_BITS);
}

static inline uint32_t mesh_index(const struct sheen_mesh *mesh, uint32_t i)
{
    return mesh->index_bytes == 1 ? ((const uint8_t *)mesh->indices)[i] : ((const uint16_t *)mesh->indices)[i];
}

/* ---- polygons that face away ---- */

/*
 * The eye in a mesh's space, raw units / 2^shift. A polygon faces away for certain if n.(p - eye), n in Q0.15, exceeds
 * a margin: margin_per_warp for each 1/1024 of its warp, plus the rounding errors.
 */
struct viewpoint {
    int32_t eye[3];
    int32_t margin_per_warp; /* 0: no test */
    unsigned shift;
};

void sheen_viewpoint_begin(struct viewpoint *viewpoint, const struct projection *p, const struct sheen_mesh *mesh,
                           const struct sheen_pose *pose);
/*
 * The first triangle from i on (i < triangles) that may face the eye; mesh->triangles: none. *faces: the polygon of the
 * triangle found last, at first UINT32_MAX.
 */
uint32_t sheen_next_facing(const struct viewpoint *viewpoint, const struct sheen_mesh *mesh, uint32_t i,
                           uint32_t *faces);

/* ---- light ---- */

/* Lights and the eye in model space, so that dot products come straight from the mesh's normals. */
struct lighting {
    uint8_t count;
    const struct sheen_ramp *ramp;              /* of the material; NULL: none */
    sheen_q16_t diffuse_sum, specular_sum;      /* of the lights' intensities */
    uint16_t diffuse_weight[SHEEN_MAX_LIGHTS];  /* UQ1.15, their sum at most 1.0 */
    uint16_t specular_weight[SHEEN_MAX_LIGHTS]; /* likewise; 0: no highlight */
    sheen_q30_t view[3];                        /* V */
    sheen_q30_t to[SHEEN_MAX_LIGHTS][3];        /* L; for a point light its place, see sheen_light_tinted */
    int32_t lv1[SHEEN_MAX_LIGHTS];              /* 1 + L.V, Q2.29; for a point light its radius, Q11.20 */
};

/* Which lights a shading accepts. */
enum lights_taken {
    LIGHTS_FAR, /* lights at infinity */
    LIGHTS_ALL  /* point lights too, whose places the shading then finds */
};

/* rotation: model to eye; view: world to eye, NULL if world and eye space are one. l->ramp becomes NULL. */
int sheen_light_begin(struct lighting *l, const struct sheen_light *lights, unsigned count,
                      const sheen_q30_t rotation[9], const sheen_q30_t *view, enum lights_taken taken);
/* v in model space, in any fixed-point format: transpose(rotation) * v. */
void sheen_to_model(const sheen_q30_t rotation[9], const int32_t v[3], int32_t out[3]);
/* L.N or N.V of a unit normal, Q1.30, held at +-1.0; lacks: lacking(normal). */
int32_t sheen_unit_cosine(const int16_t normal[3], int32_t lacks, const sheen_q30_t v[3]);
/* The lights' intensities at a normal: without a ramp, and with one (for struct sheen_ramp_reader). */
void sheen_light_plainly(const struct lighting *l, const struct power *power, const int16_t normal[3], struct lit *out);
void sheen_light_by_ramp(const struct lighting *l, const struct power *power, const int16_t normal[3], struct lit *out);

/* A light at the point that it lights: L, 1 + L.V (Q2.29), and the part of it left there, UQ0.32, 1.0 as UINT32_MAX. */
struct beam {
    const sheen_q30_t *to;
    int32_t lv1;
    uint32_t left;
    sheen_q30_t own[3]; /* a point light's L, to which `to` then points */
};

struct draw;

/* The functions for point lights. Lights point to them, so that they are linked only if there are point lights. */
struct sheen_points {
    /* Puts the object's point lights into d->light and d->tint, whose is_tinted is set by then; view: world to eye. */
    void (*place)(struct draw *d, const struct sheen_object *object, const struct sheen_pose *view);
    /* The mean of the vertices of a triangle's polygon. */
    void (*middle)(const struct draw *d, uint32_t triangle, int16_t middle[3]);
    /* Light i at a normal and at `at`, see sheen_light_tinted. */
    void (*beam)(const struct lighting *l, unsigned i, const int32_t at[3], const int16_t normal[3], struct beam *beam);
};

/* Intensities of coloured lights by channel, relative to what white lights can give, UQ1.15. */
struct tinted {
    uint32_t low[3]; /* independent of the normal: what a ramp's low is multiplied by */
    uint32_t diffuse[3], specular[3];
};

/*
 * tinted_light.c; at: the lit point from the mesh's origin, along the model's axes, in units, Q11.20, as the places of
 * point lights are stored, |part| < 2^27 (a posed mesh's scale is below 64 units); not read if there are none.
 */
void sheen_light_tinted(const struct lighting *l, const struct power *power, const struct tint_terms *tint,
                        const int32_t at[3], const int16_t normal[3], struct tinted *out);

static inline void light_normal(const struct lighting *l, const struct power *power, const int16_t normal[3],
                                struct lit *out)
{
    (l->ramp != NULL ? l->ramp->reader->light : sheen_light_plainly)(l, power, normal, out);
}

/* ---- clipping ---- */

#define CLIP_PLANES 6                      /* near, far, and the guard band's sides: the order of enum vertex_flag */
#define MAX_CLIP_CORNERS (3 + CLIP_PLANES) /* of a triangle: each plane adds at most one */

/* A corner of the polygon that is left of a triangle. */
struct clip_corner {
    struct point point;
    int32_t share[3]; /* the shares of the triangle's corners in this corner's attributes, Q1.30 */
    struct vertex v;
};

/* The polygon that is left of a triangle, and how it is cut. */
struct clip_job {
    const struct projection *projection;
    const struct transform *transform; /* of the points */
    int on_screen;                     /* shares are linear on the screen, not in space */
    struct clip_corner *polygon, *next;
    unsigned count; /* of corners; below 3 nothing is left */
};

/* Cuts by the planes from `first` to before `end`. polygon and next have room for MAX_CLIP_CORNERS each. */
void sheen_clip(struct clip_job *job, unsigned first, unsigned end);
/* Cuts a line by all planes and moves its ends; 0 if nothing is left. The job needs no polygon. */
int sheen_clip_line(const struct clip_job *job, struct clip_corner end[2]);

#endif
