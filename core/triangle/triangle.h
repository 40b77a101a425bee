/*
 * triangle.h - private: triangle set-up (edges, depth, gradients) and the row loops that several shadings share.
 */
#ifndef SHEEN_TRIANGLE_H
#define SHEEN_TRIANGLE_H

#include "../math/newton.h"
#include "../vertex/vertex.h"
#include "ways.h"

struct sheen_shader;
struct fog_terms;

/* The pixels that a draw leaves out: none, every second one, at most half of each row, or more. */
enum stippled {
    STIPPLED_NOT,
    STIPPLED_SECOND,
    STIPPLED_HALF,
    STIPPLED_MORE
};

/* What a call of sheen_draw() keeps for drawing its triangles. */
struct draw {
    uint8_t two_sided;
    uint8_t strong; /* the material's specular intensity is above 1/2 */
    uint8_t dither;
    uint8_t swap;        /* as in struct pixel_format */
    uint8_t is_565;      /* the target is 565, not grey */
    uint8_t pixel_ramp;  /* 0: no ramp is read per pixel; else 1 + 2 * the ramp's `steep` */
    uint8_t stippled;    /* enum stippled */
    uint8_t left_out[8]; /* stippled draws: bit x & 7 of entry y & 7 is set if pixel (x, y) is left out */
    uint8_t forced;      /* 1 + the enum sheen_way that a test forces wherever it is accurate enough, or 0 */
    uint8_t quads;       /* the highest warp of a polygon whose triangles may be listed as quads; 0: no quads */
    uint8_t most_apart;  /* largest |Ni - Nj|^2 for which L.N may be a quadric, UQ.9; see sheen_widest_diffuse */
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
        struct texel_terms texel; /* for shadings with a texture */
        struct tint_terms tint;   /* for shadings that are colored */
    };
};

/*
 * Makes a draw use the general pixel loops, which work for any target and read the tile's own thresholds. Set-ups
 * choose these loops because the draw then looks like a dithered one on grey.
 */
static inline void take_general_loops(struct draw *d)
{
    d->shades = NULL;
    d->is_565 = 0;
    d->dither = 1;
    d->colour.low = d->colour.high = NO_DIFFUSE_RANGE;
}

/* shades.c: a shader's `begin` that fills in d->loop. */
void sheen_loop_begin(struct draw *d, const struct sheen_material *material, const struct pixel_format *format,
                      const struct sheen_object *object, const struct sheen_pose *view);
/*
 * The shades for a draw's colours, or NULL if these can have none or the store is full. store: `count` entries, of
 * which the first *taken belong to colours of this frame; if none of these fits, the next entry is made to fit and
 * *taken grows. Which draws get shades depends only on the draws of the frame.
 */
const struct shades *sheen_shades_of(const struct draw *d, struct shades *store, unsigned count, unsigned *taken);

/* 1 unless a test forces another way than this one. */
static inline int way_wanted(const struct draw *d, enum sheen_way way)
{
    return d->forced == 0 || d->forced == 1 + (unsigned)way;
}

/* What a triangle's set-up needs to know about the view. */
struct screen {
    struct sheen_rect viewport;
    int32_t centre_x, centre_y; /* the viewport's centre on the target, 1/64 px: the origin of struct vertex */
    int32_t weight_offset;      /* as in struct projection */
    uint8_t weight_shift;
    uint8_t flat_weight;  /* affine or orthographic: all weights are equal */
    uint16_t shared_rows; /* how many of a tile's last rows the next tile contains too */
};

/* The offset for which z16 + offset is proportional to 1/m; at least -DEPTH_FAR. */
static inline uint32_t z16_weight_offset(const struct screen *screen)
{
    return (uint32_t)asr32(screen->weight_offset, screen->weight_shift);
}

/* ---- set-up: three vertices -> edges and gradients ---- */

/* An int64_t that needs no 8-byte alignment. */
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

/* Where an edge crosses pixel rows; see edge.c. */
struct edge {
    /* Q31.32 px in the next row; the integer part is the first column whose centre is at or right of the edge */
    struct halves at;
    struct halves step; /* px per row, Q31.32 */
    int16_t first, end; /* rows: first <= y < end */
};

/* base + x dx + y dy modulo 2^32; (x, y) is a pixel of the target. */
struct plane {
    uint32_t base, dx, dy;
};

/* base + x dx + y dy + x(x-1)/2 dxx + xy dxy + y(y-1)/2 dyy modulo 2^32. */
struct quadric {
    uint32_t base, dx, dy, dxx, dxy, dyy;
};

/*
 * A triangle's set-up, ready to be stepped row by row; it is kept for the next band if the triangle goes on there. Each
 * way extends it by a struct of its own, which begins with this one and has at most SETUP_BYTES, as SETUP_FITS asserts.
 */
struct setup {
    uint16_t entry;
    uint8_t next;           /* the next slot in the worker's list */
    uint8_t way;            /* enum sheen_way */
    int16_t row, end_row;   /* the next row to draw; one past the last */
    uint8_t right;          /* one bit per edge from bit 0 on, 1 if it bounds the right; a final 1 marks the end */
    uint8_t needs_clipping; /* 1: spans may leave the tile's columns, so they are clipped */
    uint8_t special_loop;   /* 0: a loop for anything; else one for what the way has checked: 1, or its own enum */
    uint8_t detail;         /* each way defines it */
    const struct draw *draw;
    void (*rows)(const struct tile *t, const struct setup *s);
    struct plane depth; /* z16 as UQ16.16 */
    struct edge edge[4];
};

#define SETUP_BYTES (sizeof(struct setup) + 64)
#define SETUP_FITS(type) _Static_assert(sizeof(type) <= SETUP_BYTES, #type " is larger than a set-up's slot")

static inline uint32_t plane_at(const struct plane *p, int32_t x, int32_t y)
{
    return p->base + (uint32_t)x * p->dx + (uint32_t)y * p->dy;
}

/* x (x - 1) / 2, a binomial coefficient; |x| < 2^15. */
static inline uint32_t pairs(int32_t x)
{
    return (uint32_t)(x * (x - 1)) / 2;
}

/* The corners of an entry, and what shading needs to know about them. */
struct corners {
    const struct vertex *v[4]; /* v[3]: a quad's fourth corner, which lies between 1 and 2; NULL for a triangle */
    const int16_t *normal[3];  /* or what struct sheen_shader's `corners` names in its place */
    uint16_t triangle;         /* in the mesh; for a quad the first of its two */
};

/*
 * A plane quad that may be drawn as one, corners as in struct corners; its normals are linear in space over it. On the
 * screen corner 3 is corner 0 + S (corner 1 - corner 0) + T (corner 2 - corner 0), with S = area[1] / area[0] and T =
 * area[2] / area[0], each at most 2.
 */
struct quad {
    const struct vertex *const *v;
    uint32_t index[4]; /* the corners' vertices in the mesh */
    int32_t area[3];   /* twice the areas of corners 012, 032, 013, 1/4096 px^2; 0 < area < 2^30 */
};

/* quad.c, for vertices that keep intensities: 1 if any way set up from corners 0 to 2 is right at corner 3 too. */
int sheen_lit_linearly(const struct draw *d, const struct quad *q);

/* An entry's corners, clockwise as gradients need them, and what shading needs to know about them. */
struct surface_corners {
    struct corners at;
    uint32_t weight[3]; /* from sheen_weigh: UQ0.32, proportional to 1/m; largest in [1/2, 1), a quad's in [1/8, 1/4) */
    const struct screen *screen;
    struct lit_facet *facet; /* the one that was lit last in the tile */
    uint8_t back;            /* a back face: normals are negated */
    uint8_t flat;            /* too flat for gradients */
    uint8_t flat_weight;     /* from sheen_weigh: all weights are equal */
};

/*
 * gradient.c: attributes that are linear on the screen. With barycentric
 * coordinates b1, b2 of corners 1 and 2, f = f0 + b1 (f1 - f0) + b2 (f2 - f0).
 */
struct gradients {
    int32_t to1[2], to2[2]; /* from corner 0 to corners 1 and 2, 1/64 px */
    uint32_t area;          /* twice the area, 1/4096 px^2; > 0 */
    int32_t b1[2], b2[2];   /* d(b1), d(b2) per pixel in x and y: value = raw / 2^exponent, |raw| < 2^15 */
    int16_t centre[2];      /* from corner 0 to the origin pixel's centre, 1/64 px, -31..32 */
    int32_t origin[2];      /* the origin pixel: the one that contains corner 0 */
    uint16_t bits;          /* bit length of the largest difference of coordinates, 1..16 */
    uint16_t exponent;      /* 4..24 */
    int16_t stretch;        /* log2(extent^2 / area), at most 1 too low and 2 too high; large for a needle */
    uint16_t wide;          /* 1: planes need steps of 31 bits */
};

#define NARROW_BITS 14   /* 256 px */
#define WIDEST_STRETCH 5 /* up to this stretch 15-bit steps are accurate enough for planes */

/* Most clz32(area) + bits: gradients reach 2^11 per pixel (1/2048 px high); flatter triangles get one colour. */
#define FLATTEST 36

/* The largest |f1 - f0| and |f2 - f0| that sheen_plane accepts. */
#define STEEPEST_DIFFERENCE 32768

/* An attribute's value at the origin pixel's centre and its steps per pixel, before they are cut to 32 bits. */
struct slope {
    int64_t value, dx, dy;
};

void sheen_weigh(struct surface_corners *c);

/* (x, y): corner 0 on the target, 1/64 px. */
int sheen_gradients(struct gradients *g, int32_t x, int32_t y);
void sheen_slope(const struct gradients *g, const int32_t value[3], unsigned up, struct slope *s);
struct plane sheen_slope_plane(const struct gradients *g, const struct slope *s);
struct plane sheen_gradient_plane(const struct gradients *g, const int32_t value[3], unsigned up);
/*
 * base: f at corner 0, with `up` more fraction bits than d1 and d2, which are f's differences from corner 0 to corners
 * 1 and 2, at most STEEPEST_DIFFERENCE.
 */
void sheen_plane(struct plane *p, const struct gradients *g, uint32_t base, int32_t d1, int32_t d2, unsigned up);

/* ---- set-up and rows ---- */

/*
 * lit.c. sheen_facet_normal: the unit normal of a triangle's polygon, for the side that is seen; zero if it has no
 * area. sheen_facet_lit: the light there; returns 1 if it is taken over from the facet that was lit last.
 * sheen_light_back: the light at a back face's vertex normal, because vertices keep that of front faces only.
 */
void sheen_facet_normal(const struct draw *d, uint32_t triangle, int back, int16_t normal[3]);
int sheen_facet_lit(const struct setup *s, const struct surface_corners *c, struct lit *lit);
void sheen_light_back(const struct setup *s, const int16_t normal[3], struct lit *lit);

/* The corners' intensities, as Gouraud's vertices keep them; returns the largest specular one. normal: the mesh's. */
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
 * setup.c: sets up a triangle's edges, depth and gradients from the rectangle's first row on, and fills in its spans in
 * the rectangle. c->at is given, clockwise for a front face; if no corner is OFF_VIEW the triangle lies within the
 * rectangle's columns. Returns the number of rows, 0 if there are none; s->row is the row that follows them.
 */
unsigned sheen_triangle_begin(const struct screen *screen, struct sheen_rect rect, struct span *spans,
                              struct surface_corners *c, struct gradients *g, struct setup *s);

/* A corner on the target, 1/64 px, and the first row whose centre is at or below it. */
struct screen_corner {
    int32_t x, y, row;
};

/* The rows of a tile that are set up; spans[0] is row `row`. */
struct edge_rows {
    int32_t row, end;
    int whole; /* 1: the triangle has no other rows, and these are not needed again, so edges are not stored */
    int quad;  /* 1: there is a fourth corner, at[-1] */
};

/*
 * edge.c: sets up the edges between the clockwise corners at[0] to at[2], for a quad at[-1] to at[2]; the first edge
 * starts at at[2]. Writes their columns in the rows of `to` to spans[0] and on. Returns one bit per edge, 1 if it
 * bounds the right; bit 3 is the last edge's.
 */
unsigned sheen_edges_begin(struct edge *edge, const struct screen_corner *at, const struct edge_rows *to,
                           struct span *spans);

/* struct setup's `right`, made from what sheen_edges_begin returns. */
static inline uint8_t right_edges(unsigned right, int quad)
{
    return (uint8_t)(quad ? right | 16u : right >> 1 | 8u);
}

/*
 * sheen_spans fills in the spans of a triangle's next rows inside the tile and moves s->row past them; spans[0] is the
 * old s->row. Returns the number of rows. sheen_spans_back moves s->row back up to `row`, by at most the screen's
 * shared_rows, so that the next tile can draw these once more.
 */
void sheen_spans_back(struct setup *s, int32_t row);
unsigned sheen_spans(struct setup *s, struct sheen_rect rect, struct span *spans);
void sheen_clip_spans(struct span *spans, unsigned rows, struct sheen_rect rect);

/* A triangle of one colour: flat shading, and triangles too flat for gradients. */
struct constant_setup {
    struct setup s;
    uint16_t pixel; /* as a tile stores it */
};

/* One colour: from channels, clamped to the highest level; from intensities; from the mean of the corners' normals. */
void sheen_setup_colour(struct setup *s, uint32_t channel[3]);
void sheen_setup_constant(struct setup *s, const struct lit *lit);
void sheen_setup_mean_normal(struct setup *s, const struct surface_corners *c);
void sheen_constant_rows(const struct tile *t, const struct setup *s);
void sheen_dithered_constant_rows(const struct tile *t, const struct setup *s);

/* linear.c: channels, or the diffuse intensity, that are linear on the screen. */
struct linear_setup {
    struct setup s;
    struct plane channel[3]; /* with the draw's fraction bits; s.special_loop: 565, and no corner exceeds 1.0 */
};

/* Steps with 11 fraction bits are off by 2^-12 per pixel, which is accurate enough for PACKED_RUN px. */
#define PACKED_RUN_BITS 5
#define PACKED_RUN (1 << PACKED_RUN_BITS)

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

/* Channels of a triangle within PACKED_RUN px of corner 0: struct packed as planes; includes 1/2 unless dithered. */
struct packed_setup {
    struct setup s;
    struct plane red_blue, green;
};

struct shades_setup {
    struct setup s;
    struct plane diffuse; /* UQ1.30, with SHADES_GUARD entries added */
};

/* 1 if perspective changes f by at most 1/4 of `unit`. d1, d2: f's differences from corner 0 to corners 1 and 2. */
int sheen_straight(const struct surface_corners *c, int32_t d1, int32_t d2, uint32_t unit);
int sheen_channels_leave(const struct colour_terms *terms, uint32_t channel[3][3], uint32_t margin);
void sheen_setup_linear(struct setup *s, const struct gradients *g, uint32_t channel[3][3]);
/* diffuse: the intensity at corner 0, UQ1.15; d1, d2: its differences from there to corners 1 and 2. */
void sheen_setup_shades(struct setup *s, const struct gradients *g, uint32_t diffuse, int32_t d1, int32_t d2);
/* The same in planes of channels, for dithered draws and those without shades; 0 if it is not accurate enough. */
int sheen_setup_diffuse(struct setup *s, const struct gradients *g, uint32_t diffuse, int32_t d1, int32_t d2);
void sheen_linear_rows(const struct tile *t, const struct setup *s);
void sheen_packed_rows(const struct tile *t, const struct setup *s);
void sheen_shades_rows(const struct tile *t, const struct setup *s);
void sheen_wide_shades_rows(const struct tile *t, const struct setup *s); /* only with THUMB_LOOPS */

/* The difference of two channels below 2^31, in steps of 2^16: at most STEEPEST_DIFFERENCE. */
static inline int32_t cut_difference(uint32_t f, uint32_t f0)
{
    return asr32((int32_t)(f - f0) + (1 << 15), 16);
}

#endif
