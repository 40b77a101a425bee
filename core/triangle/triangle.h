/*
 * triangle.h - private: a triangle made ready: edges, gradients, and the rows that several shadings share.
 */
#ifndef SHEEN_TRIANGLE_H
#define SHEEN_TRIANGLE_H

#include "../math/newton.h"
#include "../vertex/vertex.h"
#include "ways.h"

struct sheen_shader;
struct fog_terms;

/* Pixels that a draw leaves out: none, every second one, half of every row's at the most, or more. */
enum stippled {
    STIPPLED_NOT,
    STIPPLED_SECOND,
    STIPPLED_HALF,
    STIPPLED_MORE
};

/* What a draw call left behind for its triangles. */
struct draw {
    uint8_t two_sided;
    uint8_t strong; /* the highlight gives more than 1/2 */
    uint8_t dither;
    uint8_t swap;        /* as in struct pixel_format */
    uint8_t is_565;      /* the target's pixels are */
    uint8_t by_ramp;     /* 0: no ramp is read at pixels; else 1 and twice its `steep` */
    uint8_t early;       /* 565 without dither: the half of the one rounding can be added in advance */
    uint8_t stippled;    /* enum stippled */
    uint8_t left_out[8]; /* of a stippled draw's rows, y & 7: a bit a column, x & 7, whose pixels are not drawn */
    uint8_t forced;      /* 1 + enum sheen_way, or 0: a test wants that way where it is good enough */
    uint8_t quads;       /* the highest warp of polygons whose triangles may be listed as quads; 0: none are */
    uint8_t widest;      /* |Ni - Nj|^2 up to which L.N is a quadric, UQ.9: sheen_reflection_begin's */
    int16_t depth_bias;  /* steps of z16, -4096..4095 */
    const struct sheen_mesh *mesh;
    const struct sheen_morph *morph; /* NULL: the mesh as it is */
    const struct sheen_shader *shader;
    struct power power;
    const struct shades *shades; /* NULL: there are none */
    const struct fog_terms *fog; /* NULL: none */
    struct colour_terms colour;
    struct lighting light;
    union {
        struct loop_terms loop;
        struct texel_terms texel; /* of shadings with a texture */
        struct tint_terms tint;   /* of those with colours */
    };
};

/*
 * For draws whose pixels take loops of any target: thresholds are as the tile has them. They count as dithered greys
 * where a set-up chooses.
 */
static inline void take_general_loops(struct draw *d)
{
    d->shades = NULL;
    d->is_565 = d->early = 0;
    d->dither = 1;
    d->colour.low = d->colour.high = NO_DIFFUSE;
}

/* shades.c: d->loop, as a shader's `begin`. */
void sheen_loop_begin(struct draw *d, const struct sheen_material *material, const struct pixel_format *format,
                      const struct sheen_object *object, const struct sheen_pose *view);
/*
 * The shades of a draw's colours, of `count` in a store some that have none of this frame's, which are the
 * first *taken; or NULL. That depends on the frame's draws alone.
 */
const struct shades *sheen_shades_of(const struct draw *d, struct shades *store, unsigned count, unsigned *taken);

/* 1 where a way is not ruled out by another that is forced. */
static inline int way_wanted(const struct draw *d, enum sheen_way way)
{
    return d->forced == 0 || d->forced == 1 + (unsigned)way;
}

/* Of the view, what a triangle's set-up needs. */
struct screen {
    struct sheen_rect viewport;
    int32_t centre_x, centre_y; /* the viewport's, 1/64 px on the target: where struct vertex counts from */
    int32_t weight_offset;      /* as in struct projection */
    uint8_t weight_shift;
    uint8_t flat_weight; /* affine or orthographic: all weights are equal */
    uint16_t again;      /* of a tile's last rows, how many the next tile has too */
};

/* What a sum of z16 and it is proportional to 1/m of: from -DEPTH_FAR on. */
static inline uint32_t weight_beyond(const struct screen *screen)
{
    return (uint32_t)asr32(screen->weight_offset, screen->weight_shift);
}

/* ---- set-up: three vertices -> edges and gradients ---- */

/* An int64_t that takes no alignment of 8 bytes. */
struct halves {
    uint32_t low;
    int32_t high;
};

static inline int64_t whole_of(struct halves x)
{
    return (int64_t)((uint64_t)(uint32_t)x.high << 32 | x.low);
}

static inline struct halves halves_of(int64_t x)
{
    return (struct halves){(uint32_t)(uint64_t)x, (int32_t)((uint64_t)x >> 32)};
}

/* Where an edge crosses pixel rows: edge.c. */
struct edge {
    struct halves at;   /* Q31.32 px in the next row; the whole part is the first column whose centre is at or right */
    struct halves step; /* a row */
    int16_t first, end; /* rows */
};

/* base + x * dx + y * dy modulo 2^32, x and y target pixels. */
struct plane {
    uint32_t base, dx, dy;
};

/* base + x dx + y dy + x(x-1)/2 dxx + xy dxy + y(y-1)/2 dyy modulo 2^32. */
struct quadric {
    uint32_t base, dx, dy, dxx, dxy, dyy;
};

/*
 * A triangle ready to be stepped; kept across bands' edges when it goes on below.
 * What a way of shading needs besides follows it: a struct that begins with this one
 * and has at most SETUP_BYTES, which SETUP_FITS asserts.
 */
struct setup {
    uint16_t entry;
    uint8_t next;         /* slot in the worker's list */
    uint8_t way;          /* enum sheen_way */
    int16_t row, end_row; /* next row to do; one past the last */
    uint8_t right;        /* a bit an edge: 1 where it bounds the right; and 1 after the last */
    uint8_t beyond;       /* columns may leave the tile */
    uint8_t fast;         /* loops may do without clamp: see the ways */
    uint8_t detail;       /* the way's own */
    const struct draw *draw;
    void (*rows)(const struct tile *t, const struct setup *s);
    struct plane depth; /* UQ16.16 of z16 */
    struct edge edge[4];
};

#define SETUP_BYTES (sizeof(struct setup) + 64)
#define SETUP_FITS(type) _Static_assert(sizeof(type) <= SETUP_BYTES, #type " is larger than a set-up's slot")

static inline uint32_t plane_at(const struct plane *p, int32_t x, int32_t y)
{
    return p->base + (uint32_t)x * p->dx + (uint32_t)y * p->dy;
}

/* x (x - 1) / 2, the binomial; |x| < 2^15. */
static inline uint32_t pairs(int32_t x)
{
    return (uint32_t)(x * (x - 1)) / 2;
}

/* The three corners of an entry, with what shading needs of them. */
struct corners {
    const struct vertex *v[4]; /* the last of a quad, else NULL: it follows corner 1, and precedes corner 2 */
    const int16_t *normal[3];  /* or what struct sheen_shader says */
    uint16_t triangle;         /* of the mesh; of a quad the first of its two */
};

/*
 * A plane quad that may be drawn whole, corners as in struct corners; normals are linear over it in space. On the
 * screen corner 3 is corner 0 + S (corner 1 - corner 0) + T (corner 2 - corner 0), S = area[1] / area[0] and T =
 * area[2] / area[0], at most 2 each.
 */
struct quad {
    const struct vertex *const *v;
    uint32_t index[4]; /* in the mesh */
    int32_t area[3];   /* twice, 1/4096 px^2, of corners 012, 032, 013; 0 < area < 2^30 */
};

/* quad.c: of vertices that keep intensities: whether any way with corners 0 to 2 holds for corner 3 too. */
int sheen_lit_linearly(const struct draw *d, const struct quad *q);

/* Corners in the order of the gradients, and what shading needs of them. */
struct surface_corners {
    struct corners at;
    uint32_t weight[3]; /* sheen_weigh: UQ0.32, proportional to 1/m, the largest in [1/2, 1); all equal where affine */
    const struct screen *screen;
    struct lit_facet *facet; /* the tile's */
    uint8_t back;            /* a back face: normals are negated */
    uint8_t flat;            /* too flat for gradients */
    uint8_t flat_weight;     /* sheen_weigh: all weights are equal */
};

/*
 * gradient.c: attributes that are linear on the screen. With barycentric
 * coordinates b1, b2 of corners 1 and 2, f = f0 + b1 (f1 - f0) + b2 (f2 - f0).
 */
struct gradients {
    int32_t to1[2], to2[2]; /* from corner 0 to corners 1 and 2, 1/64 px */
    uint32_t area;          /* twice, 1/4096 px^2; > 0 */
    int32_t b1[2], b2[2];   /* d(b1), d(b2) a px in x and y: value = raw / 2^exponent, |raw| < 2^15 */
    int16_t centre[2];      /* from corner 0 to the origin pixel's centre, 1/64 px, -31..32 */
    int32_t origin[2];      /* the origin pixel: the one that holds corner 0 */
    uint16_t bits;          /* length of the longest difference, 1..16 */
    uint16_t exponent;      /* 4..24 */
    int16_t stretch;        /* logarithm of extent^2 / area, within 1 below and 2 above; a needle's is large */
    uint16_t wide;          /* planes take steps of 31 bits */
};

#define NARROW_BITS 14   /* 256 px */
#define WIDEST_STRETCH 5 /* of triangles whose planes 15 bits do for */

/* Of zeros + bits: gradients reach 2^11 a px (a triangle 1/2048 px high); what is flatter is shaded with one colour. */
#define FLATTEST 36

/* |f1 - f0| and |f2 - f0| in sheen_plane */
#define STEEPEST_DIFFERENCE 32768

/* An attribute's value at the origin pixel's centre and its steps a px, before they are cut to 32 bits. */
struct slope {
    int64_t value, dx, dy;
};

void sheen_weigh(struct surface_corners *c);
struct quadric sheen_quadric(const int32_t pixel[2], uint32_t base, uint32_t dx, uint32_t dy, uint32_t dxx,
                             uint32_t dxy, uint32_t dyy);

/* (x, y): corner 0 on the target, 1/64 px. */
int sheen_gradients(struct gradients *g, int32_t x, int32_t y);
void sheen_slope(const struct gradients *g, const int32_t value[3], unsigned up, struct slope *s);
struct plane sheen_slope_plane(const struct gradients *g, const struct slope *s);
struct plane sheen_gradient_plane(const struct gradients *g, const int32_t value[3], unsigned up);
/* base: f at corner 0, with `up` more fraction bits than the differences d1, d2, at most STEEPEST_DIFFERENCE. */
void sheen_plane(struct plane *p, const struct gradients *g, uint32_t base, int32_t d1, int32_t d2, unsigned up);

/* ---- set-up and rows ---- */

/*
 * lit.c: unit normal of the polygon that a triangle is of, as seen, zero where it has no area; the light there, 1 where
 * it is the one of the facet before; light at a normal of a back face, which vertices do not keep.
 */
void sheen_facet_normal(const struct draw *d, uint32_t triangle, int back, int16_t normal[3]);
int sheen_facet_lit(const struct setup *s, const struct surface_corners *c, struct lit *lit);
void sheen_light_back(const struct setup *s, const int16_t normal[3], struct lit *lit);

/* At the corners, as vertices keep it for Gouraud; returns the largest specular one. normal: the mesh's. */
static inline uint32_t corners_lit(const struct setup *s, const struct surface_corners *c,
                                   const int16_t *const normal[3], struct lit lit[3])
{
    const unsigned back = c->back;
    uint32_t most = 0;

    UNROLLED
    for (int k = 0; k < 3; k++) {
        const struct vertex *v = c->at.v[k];
        lit[k].diffuse = v->kept[0];
        lit[k].specular = v->kept[1];
        if (back && (v->flags & LIT_AS_SEEN) == 0)
            sheen_light_back(s, normal[k], &lit[k]);
        most = lit[k].specular > most ? lit[k].specular : most;
    }
    return most;
}

/*
 * setup.c: edges, depth and gradients of a triangle from the rectangle's rows on; its spans there are filled.
 * c->at is given, clockwise where it is a front face; without OFF_VIEW it keeps within the rectangle's columns.
 * Number of rows, 0 where there is none; s->row is the next one.
 */
unsigned sheen_triangle_begin(const struct screen *screen, struct sheen_rect rect, struct span *spans,
                              struct surface_corners *c, struct gradients *g, struct setup *s);

/* A corner on the target, 1/64 px, and the first row whose centre is at or below it. */
struct screen_corner {
    int32_t x, y, row;
};

/* Rows of a tile: spans[0] is row `row`. */
struct edge_rows {
    int32_t row, end;
    int whole; /* the triangle has no other rows, and these are not asked for again */
    int quad;  /* 1: a corner more, before the first */
};

/*
 * edge.c: the edges of clockwise corners at[0] to at[2], before them of a quad at[-1], the first from at[2]; columns in
 * `to` are written to spans[0] and on. Returns a bit an edge, 1 where it bounds the right, bit 3 the last.
 */
unsigned sheen_edges_begin(struct edge *edge, const struct screen_corner *at, const struct edge_rows *to,
                           struct span *spans);

/* struct setup's `right`, of what sheen_edges_begin returns. */
static inline uint8_t right_edges(unsigned right, int quad)
{
    return (uint8_t)(quad ? right | 16u : right >> 1 | 8u);
}

/*
 * The next rows of a triangle inside the tile; moves s->row past them. Number of rows; spans[0] was s->row.
 * Before that it may go back to `row`, no farther above where it stands than the screen's `again`.
 */
void sheen_spans_back(struct setup *s, int32_t row);
unsigned sheen_spans(struct setup *s, struct sheen_rect rect, struct span *spans);
void sheen_clip_spans(struct span *spans, unsigned rows, struct sheen_rect rect);

/* One colour: what flat shading and degenerate triangles use. */
struct constant_setup {
    struct setup s;
    uint16_t pixel; /* as it stands in a tile */
};

/* From channels, which are held to the highest level; from intensities; from the mean of the corners' normals. */
void sheen_setup_colour(struct setup *s, uint32_t channel[3]);
void sheen_setup_constant(struct setup *s, const struct lit *lit);
void sheen_setup_mean_normal(struct setup *s, const struct surface_corners *c);
void sheen_constant_rows(const struct tile *t, const struct setup *s);
void sheen_dithered_constant_rows(const struct tile *t, const struct setup *s);

/* linear.c: channels, or the diffuse intensity, that are linear on the screen. */
struct linear_setup {
    struct setup s;
    struct plane channel[3]; /* with the draw's fraction; fast: 565 whose corners do not exceed 1.0 */
};

/* Steps of 11 fraction bits are off by 2^-12 a px: good for COLUMN px. */
#define COLUMN_BITS 5
#define COLUMN (1 << COLUMN_BITS)

static inline uint32_t pack_red_blue(uint32_t red, uint32_t blue, unsigned fraction)
{
    const unsigned down = fraction - 11;
    const uint32_t half = 1u << (down - 1);

    return ((uint32_t)asr32((int32_t)(red + half), down) << 16) + (uint32_t)asr32((int32_t)(blue + half), down);
}

static inline struct packed pack_channels(const uint32_t channel[3], unsigned fraction)
{
    return (struct packed){pack_red_blue(channel[0], channel[2], fraction), channel[1] << (26 - fraction)};
}

/* Channels of a triangle within COLUMN px: struct packed as planes, 1/2 added where nothing is dithered. */
struct packed_setup {
    struct setup s;
    struct plane red_blue, green;
};

struct shades_setup {
    struct setup s;
    struct plane diffuse; /* UQ1.30, SHADES_GUARD entries added */
};

/* 1 where perspective shows by less than 1/8 of `unit`, in d1 and d2, f's differences of corners 1 and 2 to 0. */
int sheen_straight(const struct surface_corners *c, int32_t d1, int32_t d2, uint32_t unit);
int sheen_channels_leave(const struct colour_terms *terms, uint32_t channel[3][3], uint32_t margin);
void sheen_setup_linear(struct setup *s, const struct gradients *g, uint32_t channel[3][3]);
/* diffuse: at corner 0, UQ1.15; d1, d2: what corners 1 and 2 have more. */
void sheen_setup_shades(struct setup *s, const struct gradients *g, uint32_t diffuse, int32_t d1, int32_t d2);
/* The same for draws without shades, in channels; 0 where that is not good enough. */
int sheen_setup_diffuse(struct setup *s, const struct gradients *g, uint32_t diffuse, int32_t d1, int32_t d2);
void sheen_linear_rows(const struct tile *t, const struct setup *s);
void sheen_packed_rows(const struct tile *t, const struct setup *s);
void sheen_shades_rows(const struct tile *t, const struct setup *s);
void sheen_wide_shades_rows(const struct tile *t, const struct setup *s); /* where there are THUMB_LOOPS */

/* Of channels below 2^31, in 2^16 steps: STEEPEST_DIFFERENCE at the most. */
static inline int32_t cut_difference(uint32_t f, uint32_t f0)
{
    return asr32((int32_t)(f - f0) + (1 << 15), 16);
}

#endif
