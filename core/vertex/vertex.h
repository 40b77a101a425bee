/*
 * vertex.h - private: vertices on the screen, how a mesh's get there, and light at them.
 */
#ifndef SHEEN_VERTEX_H
#define SHEEN_VERTEX_H

#include "../math/products.h"
#include "../pixel/pixel.h"

#define SUBPIXEL_BITS 6 /* vertices are snapped to 1/64 px */
#define SUBPIXEL_ONE 64
#define SUBPIXEL_HALF 32                  /* a pixel's centre */
#define GUARD_BAND (511 << SUBPIXEL_BITS) /* 1/64 px from the viewport's centre */
#define INNER_VIEW (255 << SUBPIXEL_BITS) /* likewise: differences of what lies inside fit 16 bits */

/*
 * Depth in 16 bits: z16 = DEPTH_FAR + DEPTH_RANGE * (1/m - 1/far) / (1/near - 1/far).
 * The margins on both sides keep what interpolation rounds off from wrapping. The
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
    LIT_AS_SEEN = 128, /* for the side that is seen, front or back: corners of pieces */
    OFF_VIEW = 256     /* beyond the viewport's columns or rows, or INNER_VIEW from its centre: x or y */
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

/* Of the view, a frame long. Made by sheen_project_begin. */
struct projection {
    struct scaled focal; /* px */
    uint32_t depth;      /* mantissa of depth: z16 = DEPTH_FAR + depth / m - depth / far; orthographic: of a unit's */
    int depth_shift;     /* its exponent, less what depth_over makes of it */
    unsigned depth_fraction; /* 0..15: of depth / m, as many bits as 32 have room for */
    uint32_t depth_base;     /* with as many: DEPTH_FAR - depth / far + 1/2 */
    sheen_q24_t near, far;
    int16_t view_x, view_y;   /* 1/64 px: half the viewport's width and height, INNER_VIEW at the most */
    sheen_q24_t orthographic; /* 0, or the depth that x and y are divided by in place of m */
    unsigned weight_shift;    /* 0..15: 1/m is proportional to (z16 << weight_shift) + weight_offset, in [0, 2^31) */
    int32_t weight_offset;    /* for every z16 from near to far, 0 beyond a ratio of 2^24; from 254 on < 0 */
};

/*
 * A point before the eye: x to the right and y down times focal's mantissa / 2^32, with `fine` bits more than m; and m,
 * Q7.24. |part| < 2^31.
 */
struct point {
    int32_t x, y, m;
};

/*
 * Model to a point: floor(row times raw position / 2^14) / 2^shift + t, the shift of x and y less by `fine`, which is
 * what the draw's x and y leave room for: where they are small the screen shows more of them.
 */
struct transform {
    struct PRODUCT_FORM(row) row[3];
    int32_t t[3];
    unsigned shift, shift_fine; /* 0..29 */
    unsigned fine;
    int screen_shift; /* x in 1/128 px = x / u * 2^(30 - screen_shift + up), with m = u / 2^up */
};

/* The view's angle, or the one that 0 stands for; 0 where it is out of range. */
sheen_angle_t sheen_fov(const struct sheen_view *view);
int sheen_project_begin(struct projection *p, const struct sheen_view *view, unsigned width, unsigned height);
/* z16 at any m > 0, also beyond near and far, with 16 fraction bits; m >= near / 2^14. */
int64_t sheen_depth_beyond(const struct projection *p, sheen_q24_t m);
/* Where a posed mesh's origin lies before the eye, and the units that raw 32768 is, or an error: too far, too large. */
sheen_q24_t sheen_origin(const struct sheen_mesh *mesh, const struct sheen_pose *pose, sheen_q24_t origin[3]);
int sheen_transform_begin(struct transform *t, const struct projection *p, const struct sheen_mesh *mesh,
                          const struct sheen_pose *pose);
struct point sheen_transform_point(const struct transform *t, const int16_t position[3]);
/* screen_shift: of the point's transform. */
void sheen_project(const struct projection *p, int screen_shift, const struct point *point, struct vertex *v);

/* As sheen_twice_area, where no corner is OFF_VIEW: differences fit 16 bits, products 31. */
static inline int32_t small_twice_area(const struct vertex *a, const struct vertex *b, const struct vertex *c)
{
    return (b->x - a->x) * (c->y - a->y) - (b->y - a->y) * (c->x - a->x);
}

/* clip.c: twice the signed area, 1/4096 px^2, positive where clockwise on the screen (y down). Range: < 2^33. */
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
 * The eye from a mesh, raw units / 2^shift, and what n.(p - eye), n in Q0.15, has to be above to face away for sure: so
 * much for each 1/1024 of warp, besides what is rounded.
 */
struct viewpoint {
    int32_t eye[3];
    int32_t a_warp; /* 0: no test */
    unsigned shift;
};

void sheen_viewpoint_begin(struct viewpoint *viewpoint, const struct projection *p, const struct sheen_mesh *mesh,
                           const struct sheen_pose *pose);
/* The first triangle from i on (i < triangles) that may face the eye; *faces: its polygon, at first UINT32_MAX. */
uint32_t sheen_next_facing(const struct viewpoint *viewpoint, const struct sheen_mesh *mesh, uint32_t i,
                           uint32_t *faces);

/* ---- light ---- */

/* Lights and the eye in model space, so that dot products come straight from the mesh's normals. */
struct lighting {
    uint8_t count;
    const struct sheen_ramp *ramp;              /* of the material; NULL: none */
    sheen_q16_t diffuse_sum, specular_sum;      /* of the lights' intensities */
    uint16_t diffuse_weight[SHEEN_MAX_LIGHTS];  /* UQ1.15, their sum 1.0 */
    uint16_t specular_weight[SHEEN_MAX_LIGHTS]; /* likewise; 0: no highlight */
    sheen_q30_t view[3];                        /* V */
    sheen_q30_t to[SHEEN_MAX_LIGHTS][3];        /* L; of a point light where it is, see sheen_light_tinted */
    int32_t lv1[SHEEN_MAX_LIGHTS];              /* 1 + L.V, Q2.29; of a point light its radius, Q11.20 */
};

/* Which lights a shading takes. */
enum lights_taken {
    LIGHTS_FAR, /* those at infinity */
    LIGHTS_ALL  /* points too, which the shading then places */
};

/* rotation: model to eye; view: world to eye, NULL where they are one. There is no ramp then. */
int sheen_light_begin(struct lighting *l, const struct sheen_light *lights, unsigned count,
                      const sheen_q30_t rotation[9], const sheen_q30_t *view, enum lights_taken taken);
/* v in model space, Q1.30 or any other: transpose(rotation) * v. */
void sheen_to_model(const sheen_q30_t rotation[9], const int32_t v[3], int32_t out[3]);
/* L.N or N.V of a unit normal, Q1.30, held at +-1.0; lacks: lacking(normal). */
int32_t sheen_unit_cosine(const int16_t normal[3], int32_t lacks, const sheen_q30_t v[3]);
/* What the lights give at a normal: without a ramp, and by one, of a struct sheen_ramp_reader. */
void sheen_light_plainly(const struct lighting *l, const struct power *power, const int16_t normal[3], struct lit *out);
void sheen_light_by_ramp(const struct lighting *l, const struct power *power, const int16_t normal[3], struct lit *out);

/* A light where it falls: L, 1 + L.V (Q2.29), and what is left of it, UQ0.32, 1.0 as UINT32_MAX. */
struct beam {
    const sheen_q30_t *to;
    int32_t lv1;
    uint32_t left;
    sheen_q30_t own[3]; /* where `to` may point */
};

struct draw;

/* What point lights point to, so that it is linked where there is one. */
struct sheen_points {
    /* They are put into d->light and d->tint, where `lights` is set; view: world to eye. */
    void (*place)(struct draw *d, const struct sheen_object *object, const struct sheen_pose *view);
    /* Mean of the vertices of a triangle's polygon. */
    void (*middle)(const struct draw *d, uint32_t triangle, int16_t middle[3]);
    /* Light i at `at`, see sheen_light_tinted, and a normal. */
    void (*beam)(const struct lighting *l, unsigned i, const int32_t at[3], const int16_t normal[3], struct beam *beam);
};

/* What lights that have colours give, by channel: relative to white lights', UQ1.15. */
struct tinted {
    uint32_t low[3]; /* whatever the normal */
    uint32_t diffuse[3], specular[3];
};

/*
 * tinted_light.c; at: what is lit, from the mesh's origin along the model's axes, in units, Q11.20, as the point lights
 * have it, |part| <= 2^30; not read where there are none.
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
#define MAX_CLIP_CORNERS (3 + CLIP_PLANES) /* of a triangle: each plane adds one at most */

/* A corner of the polygon that is left of a triangle. */
struct clip_corner {
    struct point point;
    int32_t share[3]; /* of the triangle's corners in its attributes, Q1.30 */
    struct vertex v;
};

/* What is left of a triangle, and how it is cut. */
struct clip_job {
    const struct projection *projection;
    const struct transform *transform; /* of the points */
    int on_screen;                     /* shares are linear on the screen, not in space */
    struct clip_corner *polygon, *next;
    unsigned count; /* of corners; below 3 nothing is left */
};

/* Cuts by the planes from `first` to before `end`. polygon and next have room for MAX_CLIP_CORNERS each. */
void sheen_clip(struct clip_job *job, unsigned first, unsigned end);
/* The part of a line inside all of them: its ends move there; 0 where nothing is left. job: no polygon. */
int sheen_clip_line(const struct clip_job *job, struct clip_corner end[2]);

#endif
