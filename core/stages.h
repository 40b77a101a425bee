/*
 * stages.h - private: what each stage of a frame hands the next.
 *
 *   transform -> light -> clip -> bin -> setup -> spans -> shade_* -> target
 *
 * sheen.c calls them in this order. Everything here lives in the caller's arena.
 */
#ifndef SHEEN_STAGES_H
#define SHEEN_STAGES_H

#include "fixed.h"
#include "sheen.h"

/* Builds that count pixels pay for it; pictures are the same. */
#ifndef SHEEN_STATS
#define SHEEN_STATS 0
#endif

/*
 * Loops of their own for 565 without clamp or dither; builds for size take the
 * general ones, which give the same pixels.
 */
#ifndef FAST_LOOPS
#ifdef __OPTIMIZE_SIZE__
#define FAST_LOOPS 0
#else
#define FAST_LOOPS 1
#endif
#endif

/* Kept out of its caller, whose stack it would stay on: the limit is 1 KB. */
#ifdef __GNUC__
#define APART __attribute__((noinline))
#else
#define APART
#endif

#define SUBPIXEL_BITS 6 /* vertices are snapped to 1/64 px */
#define SUBPIXEL_ONE 64
#define SUBPIXEL_HALF 32                  /* a pixel's centre */
#define GUARD_BAND (511 << SUBPIXEL_BITS) /* 1/64 px from the viewport's centre */

/*
 * Depth in 16 bits: z16 = DEPTH_FAR + DEPTH_RANGE * (1/m - 1/far) / (1/near - 1/far).
 * The margins on both sides keep what interpolation rounds off from wrapping. The
 * buffer is cleared to DEPTH_FAR, two equal bytes, so m >= far is not drawn.
 */
#define DEPTH_RANGE 65020
#define DEPTH_FAR 0x0101

#define NONE 0xffffu /* end of a list of entries */

/* ---- transform: model -> eye -> screen ---- */

enum vertex_flag { /* sides of the view volume a vertex lies outside of, and what was done to it */
    OUTSIDE_NEAR = 1,
    OUTSIDE_FAR = 2,
    OUTSIDE_LEFT = 4,
    OUTSIDE_RIGHT = 8,
    OUTSIDE_TOP = 16,
    OUTSIDE_BOTTOM = 32,
    OUTSIDE = 63,
    LIT = 64,         /* diffuse and specular are set, for the mesh's normal */
    LIT_AS_SEEN = 128 /* for the side that is seen, front or back: corners of pieces */
};

struct vertex {
    int16_t x, y;      /* Q9.6 px from the viewport's centre, +-511 px; undefined where OUTSIDE */
    uint16_t z;        /* z16 */
    uint16_t flags;    /* enum vertex_flag */
    uint16_t diffuse;  /* UQ1.15, Gouraud, once LIT: weighted sum of max(0, L.N) */
    uint16_t specular; /* UQ1.15, likewise of (R.V)^n */
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
    struct scaled depth; /* z16 = DEPTH_FAR + depth / m - depth / far */
    int64_t depth_far;   /* depth / far, Q.8 */
    sheen_q24_t near, far;
    sheen_q24_t orthographic; /* 0, or the depth that x and y are divided by in place of m */
    struct scaled fixed;      /* its reciprocal; `depth` then is a unit's steps of z16 */
    unsigned weight_shift;    /* 1/m is proportional to (z16 << weight_shift) + weight_offset, */
    uint32_t weight_offset;   /* which lies in (0, 2^32) for every z16 from near to far */
};

/* Model to eye: e = (sum of raw position * m) / 2^(16 + shift) + t, Q7.24. |m| <= 2^30, shift -1..28. */
struct transform {
    int32_t m[9];
    int shift;
    sheen_q24_t t[3];
};

int sheen_project_begin(struct projection *p, const struct sheen_view *view, unsigned height);
int sheen_transform_begin(struct transform *t, const struct sheen_mesh *mesh, const struct sheen_pose *pose);
void sheen_transform_point(const struct transform *t, const int16_t position[3], sheen_q24_t eye[3]);
void sheen_project(const struct projection *p, const sheen_q24_t eye[3], struct vertex *v);

/* ---- light ---- */

/* Lights and the eye in model space, so that dot products come straight from the mesh's normals. */
struct lighting {
    sheen_q30_t view[3];                        /* V */
    sheen_q30_t to[SHEEN_MAX_LIGHTS][3];        /* L */
    int32_t lv1[SHEEN_MAX_LIGHTS];              /* 1 + L.V, Q2.29 */
    uint16_t diffuse_weight[SHEEN_MAX_LIGHTS];  /* UQ1.15, their sum 1.0 */
    uint16_t specular_weight[SHEEN_MAX_LIGHTS]; /* likewise; 0: no highlight */
    sheen_q16_t diffuse_sum, specular_sum;      /* of the lights' intensities */
    uint8_t count;
};

/* Intensities relative to the most that the draw's lights can give. */
struct lit {
    uint32_t diffuse, specular; /* UQ1.15, 0..32768 */
};

int sheen_light_begin(struct lighting *l, const struct sheen_draw *draw);
void sheen_light_normal(const struct lighting *l, const struct sheen_material *m, const int16_t normal[3],
                        struct lit *out);

/* A material's power table, ready for a loop. */
struct power {
    const uint16_t *table;
    unsigned shift; /* 18..21: an entry is 2^shift of u in Q2.29 */
};

static inline struct power power_of(const struct sheen_material *m)
{
    struct power p = {m->power, 21u - m->power_shift};

    return p;
}

/*
 * s^n for u = 1 - s in Q2.29, u any int32: UQ1.15.
 * Range: index < 256; drop <= 32768 and the fraction < 2^16, so the product fits 32 bits unsigned.
 */
static inline uint32_t power_at(struct power p, int32_t u)
{
    uint32_t at = (uint32_t)max32(u, 0), index = at >> p.shift;

    if (index >= SHEEN_POWER_ENTRIES)
        return 0;
    uint32_t entry = p.table[index], drop = entry - p.table[index + 1];
    uint32_t fraction = (at >> (p.shift - 16u)) & 0xffffu;
    return entry - ((drop * fraction + 0x8000u) >> 16);
}

/* ---- colour: intensities -> channels of the target ---- */

/*
 * What a target's pixels are made of. On 565 the channels are red, green, blue
 * in levels; on grey they are the shares of red, green and blue in the level.
 */
struct pixel_format {
    uint32_t scale[3];  /* levels that 1.0 of red, green, blue gives, UQ8.16 */
    uint8_t level_bits; /* of the highest level: 6, 8, 4 or 1 */
    uint8_t grey;       /* a byte a pixel while drawing, packed before the push */
    uint8_t pixel_bits; /* in the target's memory */
    uint8_t swap;       /* 565 bytes change places between this machine and the target */
};

/*
 * A channel before rounding: a + b * diffuse + c * specular, unsigned with
 * `fraction` fraction bits, below 2^31 whatever the lights (see ramp.c).
 */
struct colour_terms {
    uint32_t a[3];
    uint16_t b[3], c[3];
    uint32_t top[3]; /* a channel's value at 1.0, where it is clamped */
    uint8_t fraction;
    uint8_t clamp; /* some normal may give more */
};

static inline uint32_t colour_channel(const struct colour_terms *t, int k, const struct lit *lit)
{
    return t->a[k] + t->b[k] * lit->diffuse + t->c[k] * lit->specular;
}

/* A 565 value in the target's byte order. */
static inline uint16_t pixel_order(uint32_t value, unsigned swap)
{
    return (uint16_t)(swap ? (value << 8 | value >> 8) : value);
}

/*
 * What is added before the one rounding: thresholds (B + 1/2) / 64 of PICTURE.md's
 * Bayer matrix, in 1/128, row y mod 8; the ninth row is 1/2 throughout, no dither.
 */
#define NO_DITHER 8
extern const uint8_t sheen_thresholds[9][8];

static inline const uint8_t *threshold_row(unsigned dither, int32_t y)
{
    return sheen_thresholds[dither ? (unsigned)y & 7u : NO_DITHER];
}

void sheen_format_begin(struct pixel_format *format, const struct sheen_target *target);
void sheen_colour_begin(struct colour_terms *t, const struct pixel_format *format, const struct sheen_material *m,
                        const struct lighting *l);
/* A colour as it stands in a tile, rounded and not dithered: 565 in the target's order, or a grey level. */
uint16_t sheen_colour_bytes(const struct pixel_format *format, const uint8_t rgb[3]);
/* Grey levels of a tile, a byte each, to the target's packing, in place. */
void sheen_pack_grey(const struct pixel_format *format, uint8_t *pixels, unsigned width, unsigned rows);

/* ---- draws and lists ---- */

/* What a draw call left behind for the bands. */
struct draw_record {
    const struct sheen_mesh *mesh;
    const struct sheen_material *material;
    struct lighting light;
    struct colour_terms colour;
    uint32_t first_vertex;              /* of the mesh in the frame's store */
    uint32_t end_entry;                 /* entries of this draw end here */
    uint8_t shading, two_sided, forced; /* forced: 1 + enum sheen_way, or 0 */
};

/* A visible triangle, in submission order; `next` links those that begin in the same band. */
struct entry {
    uint16_t triangle; /* of the draw's mesh, or a piece's index where its bit in `cut` is set */
    uint16_t next;
};

/* A piece of a triangle that was cut. */
struct piece {
    struct vertex corner[3];
    int16_t normal[3][3]; /* unit vectors no more: linear in space between the mesh's */
    uint16_t triangle;
};

struct band {
    struct sheen_rect cover; /* what this frame's triangles may touch */
    struct sheen_rect stale; /* what the last frame's touched, and marks */
    uint16_t first;          /* entry that begins here, or NONE */
    uint16_t back;           /* the oldest triangle here begins this many bands back */
};

/* ---- set-up: three vertices -> edges and gradients ---- */

/* Where an edge crosses pixel rows: the first column whose centre is at or right of it. */
struct edge {
    int32_t column; /* px */
    int32_t step;   /* px a row, rounded down */
    uint32_t carry; /* what is left of a row's step, in 1/size px */
    int32_t error;  /* in (-size, 0]: the crossing lies -error / size px before the column */
    uint32_t size;  /* 64 * the edge's height in 1/64 px; < 2^23 */
};

/* base + x * dx + y * dy modulo 2^32, x and y target pixels. */
struct plane {
    uint32_t base, dx, dy;
};

/* base + x dx + y dy + x(x-1)/2 dxx + xy dxy + y(y-1)/2 dyy modulo 2^32. */
struct quadric {
    uint32_t base, dx, dy, dxx, dxy, dyy;
};

/* A triangle ready to be stepped; kept across bands' edges when it goes on below. */
struct setup {
    uint16_t entry;
    uint8_t next;                     /* slot in the worker's list */
    uint8_t way;                      /* enum sheen_way */
    int16_t row, middle_row, end_row; /* next row to do; where the short edges meet; one past the last */
    uint8_t long_right;               /* the long edge is the right one */
    uint8_t highlight;                /* by quadrics: there is a second one */
    uint8_t block_shift;              /* blocks: the logarithm of their length, px */
    uint8_t fast;                     /* 565, no dither, no clamp: rounding is in the planes */
    struct edge left, right;
    int16_t middle_x, middle_y, bottom_x, bottom_y; /* the lower short edge, as in struct vertex */
    const struct draw_record *draw;
    struct plane depth; /* UQ16.16 of z16 */
    union {
        struct {
            uint32_t channel[3];
            uint16_t pixel; /* fast: in the target's order */
        } flat;
        struct {
            struct plane channel[3]; /* with the draw's fraction; under quotient times weight */
            struct plane weight;     /* UQ0.32, quotient */
        } gouraud;
        struct {
            struct plane light, view; /* L.N and V.N, Q1.30 */
            struct quadric square;    /* N.N, UQ1.31 */
        } phong;
        struct {
            struct quadric diffuse; /* Q1.30 */
            struct quadric second;  /* Gouraud: specular, Q1.30; Phong: 1 - R.V, Q2.29 */
        } quadratic;
        struct plane normal[3]; /* Phong under several lights: N, Q1.30 */
        struct {
            int16_t normal[3][3]; /* of the corners, as seen, Q0.15 */
            uint16_t weight[3];   /* UQ0.16, proportional to 1/m */
            int16_t x[3], y[3];   /* as in struct vertex */
            uint32_t angle[3];    /* between the normals of corners k and k + 1, turns */
        } slerp;
    } shade;
};

/* A row of a triangle inside the tile: x0 <= x < x1, empty where x0 >= x1. */
struct span {
    int16_t x0, x1;
};

/* A band's pixels while it is drawn: rows without gaps, as wide as its rectangle. */
struct tile {
    struct sheen_rect rect; /* px on the target */
    unsigned pitch;         /* px */
    void *pixels;           /* uint16_t, or uint8_t on grey */
    uint16_t *depth;
    const struct pixel_format *format;
    unsigned dither;
    int32_t centre_x, centre_y; /* the viewport's, 1/64 px on the target: where struct vertex counts from */
    const struct span *spans;
    int16_t first_row; /* of the spans */
    unsigned rows;
#if SHEEN_STATS
    uint32_t *shaded;
#endif
};

/* ---- workers and the frame ---- */

#define MAX_WORKERS 4

struct worker {
    void *pixels[2];
    uint16_t *depth;
    struct span *spans;    /* band_rows */
    uint32_t *pending;     /* a bit an entry: begun, not done */
    struct setup *carried; /* max_carried slots and a spare one */
    uint8_t first_carried, first_free;
    uint8_t buffer;    /* the one to draw into next */
    uint16_t done;     /* bands of this frame */
    uint8_t in_flight; /* a push of this worker awaits its wait */
    int32_t last_band; /* -1 before the first */
    int error;
    struct sheen_stats stats;
};

enum frame_state {
    IDLE,
    OPEN
};

struct sheen_frame {
    struct sheen_config config;
    const struct sheen_target *target;
    struct sheen_view view;
    struct sheen_rect viewport;
    struct pixel_format format;
    struct projection projection;
    uint8_t state;    /* enum frame_state */
    uint8_t send_all; /* this frame sends every band whole */
    uint8_t failed;   /* a push failed or a band was left out: the next frame sends every band whole */
    uint8_t stale;    /* sheen_invalidate was called: likewise */
    uint8_t begun;    /* a frame has begun before */
    unsigned bands, max_bands;
    uint32_t band_scale; /* UQ0.20, rounded up: row * band_scale >> 20 = row / band_rows, row <= 480 */
    uint32_t vertices, entries, pieces, draws;
    struct vertex *vertex;
    struct entry *entry;
    uint32_t *cut; /* a bit an entry: its triangle is a piece */
    struct piece *piece;
    void *scratch; /* two polygons of clip.c */
    struct draw_record *draw;
    struct band *band;
    struct worker *worker; /* config.workers */
    struct sheen_stats stats;
    size_t arena_bytes;
};

/* 1 where pixels are 565 without dither: the half of the one rounding can be added in advance. */
static inline uint8_t sheen_rounds_early(const struct sheen_frame *f)
{
    return FAST_LOOPS && !f->format.grey && !f->view.dither;
}

/* 1 where a way is not ruled out by a draw that forces another. */
static inline int sheen_way_wanted(const struct draw_record *d, enum sheen_way way)
{
    return d->forced == 0 || d->forced == 1 + (unsigned)way;
}

/* The three corners of an entry, with what shading needs of them. */
struct corners {
    const struct vertex *v[3];
    const int16_t *normal[3]; /* NULL where the mesh has none */
    uint16_t triangle;        /* of the mesh */
};

static inline uint32_t mesh_index(const struct sheen_mesh *mesh, uint32_t i)
{
    return mesh->index_bytes == 1 ? ((const uint8_t *)mesh->indices)[i] : ((const uint16_t *)mesh->indices)[i];
}

/* Twice the signed area, 1/4096 px^2, positive where clockwise on the screen (y down). Range: < 2^33. */
static inline int64_t twice_area(const struct vertex *a, const struct vertex *b, const struct vertex *c)
{
    int32_t x1 = b->x - a->x, y1 = b->y - a->y, x2 = c->x - a->x, y2 = c->y - a->y;

    if ((((uint32_t)(x1 + 32768) | (uint32_t)(y1 + 32768) | (uint32_t)(x2 + 32768) | (uint32_t)(y2 + 32768)) >> 16) ==
        0)
        return x1 * y2 - y1 * x2; /* spans under 512 px: products < 2^30 */
    return (int64_t)x1 * y2 - (int64_t)y1 * x2;
}

/* First pixel whose centre is at or after a coordinate of 1/64 px: ceil(v - 1/2). */
static inline int32_t first_centre(int32_t v)
{
    return asr32(v + SUBPIXEL_HALF - 1, SUBPIXEL_BITS);
}

/* Screen coordinates of a vertex on the target, 1/64 px. */
static inline int32_t target_x(const struct sheen_frame *f, int32_t x)
{
    return x + SUBPIXEL_HALF * (f->viewport.x0 + f->viewport.x1);
}

static inline int32_t target_y(const struct sheen_frame *f, int32_t y)
{
    return y + SUBPIXEL_HALF * (f->viewport.y0 + f->viewport.y1);
}

static inline uint32_t plane_at(const struct plane *p, int32_t x, int32_t y)
{
    return p->base + (uint32_t)x * p->dx + (uint32_t)y * p->dy;
}

/* x (x - 1) / 2, the binomial; |x| < 2^15. */
static inline uint32_t pairs(int32_t x)
{
    return (uint32_t)(x * (x - 1) / 2);
}

static inline uint32_t quadric_at(const struct quadric *q, int32_t x, int32_t y)
{
    uint32_t ux = (uint32_t)x, uy = (uint32_t)y;

    return q->base + ux * q->dx + uy * q->dy + pairs(x) * q->dxx + ux * uy * q->dxy + pairs(y) * q->dyy;
}

/* clip.c: cut a triangle and list its pieces; 0 or SHEEN_ERR_CAPACITY. */
#define MAX_CLIP_CORNERS 9 /* a triangle cut by six planes */
size_t sheen_clip_scratch_bytes(void);
int sheen_clip(struct sheen_frame *f, const struct draw_record *d, const struct transform *t, uint16_t triangle);

/* bin.c */
void sheen_bin_clear(struct sheen_frame *f);
int sheen_bin_would_list(const struct sheen_frame *f, const struct vertex *const v[3]);
int sheen_bin_triangle(struct sheen_frame *f, const struct vertex *const v[3], uint32_t triangle, int is_piece);
void sheen_bin_rollback(struct sheen_frame *f, uint32_t entries);
void sheen_entry_corners(const struct sheen_frame *f, const struct draw_record *d, uint32_t entry, struct corners *c);
struct sheen_rect sheen_rect_union(struct sheen_rect a, struct sheen_rect b);
struct sheen_rect sheen_rect_intersection(struct sheen_rect a, struct sheen_rect b);

static inline int rect_empty(struct sheen_rect r)
{
    return r.x0 >= r.x1 || r.y0 >= r.y1;
}

/* setup.c: prepare a triangle from row `from` on; 0 where it has no row left. */
int sheen_setup(const struct sheen_frame *f, const struct draw_record *d, uint32_t entry, int32_t from,
                struct setup *s);
void sheen_setup_lower_edge(const struct sheen_frame *f, struct setup *s);

/* Corners in the order of the gradients, and what shading needs of them. */
struct surface_corners {
    struct corners at;
    uint32_t weight[3];  /* UQ0.32, proportional to 1/m, the largest in [1/2, 1); all equal where affine */
    uint8_t back;        /* a back face: normals are negated */
    uint8_t flat_weight; /* all weights are equal */
};

/*
 * gradient.c: attributes that are linear on the screen. With barycentric
 * coordinates b1, b2 of corners 1 and 2, f = f0 + b1 (f1 - f0) + b2 (f2 - f0).
 */
struct gradients {
    int32_t b1[2], b2[2]; /* d(b1), d(b2) a px in x and y: value = raw / 2^exponent, |raw| < 2^31 */
    unsigned exponent;    /* MIN_EXPONENT..39 */
    int32_t centre[2];    /* from corner 0 to the origin pixel's centre, 1/64 px, -31..32 */
    int32_t origin[2];    /* the origin pixel: the one that holds corner 0 */
};

/* Gradients reach 2^11 a px (a triangle 1/2048 px high); what is flatter is shaded with one colour. */
#define MIN_EXPONENT 20

/* An attribute's value at the origin pixel's centre and its steps a px, before they are cut to 32 bits. */
struct slope {
    int64_t value, dx, dy;
};

/*
 * What six nodes add to the plane through the corners: with f's excess k = 4 middle -
 * 2 (end + end) on an edge, f = plane + k01 b0 b1 + k02 b0 b2 + k12 b1 b2. The nine
 * products of steps and six of first order, for one triangle and any f on it; setup_quadratic.c.
 */
struct node_products {
    int32_t xx[3], xy[3], yy[3]; /* by edge 01, 02, 12: value = raw / 2^(2 scale - 14) */
    int32_t x[3], y[3];          /* value = raw / 2^(scale - 2) */
    int32_t constant[3];         /* Q18.13 */
    int scale;
};

/* A function's values at corners 0, 1, 2 and its excess on edges 01, 02, 12; same format, excess below 1/4 in Q1.30. */
struct nodes {
    int32_t corner[3], excess[3];
};

/* Ratios that the three edges' middles on the screen have in space: share of the first end, UQ1.15. */
struct middles {
    int32_t share[3];
};

int sheen_node_products(struct node_products *p, const struct gradients *g);
void sheen_node_quadric(const struct gradients *g, const struct node_products *p, const struct nodes *n,
                        struct quadric *q);
void sheen_middles(const struct surface_corners *c, struct middles *m);
struct quadric sheen_quadric(const struct gradients *g, uint32_t base, uint32_t dx, uint32_t dy, uint32_t dxx,
                             uint32_t dxy, uint32_t dyy);
/* Largest of the weights over the smallest, less 1: UQ16.16, 65535 at the most. */
uint32_t sheen_weight_spread(const struct surface_corners *c);

int sheen_gradients(struct gradients *g, const int32_t x[3], const int32_t y[3], uint32_t area);
void sheen_slope(const struct gradients *g, const int32_t value[3], unsigned up, struct slope *s);
struct plane sheen_slope_plane(const struct gradients *g, const struct slope *s);
struct plane sheen_gradient_plane(const struct gradients *g, const int32_t value[3], unsigned up);

/* spans.c: the rows of a triangle inside the tile; moves s->row past them. Number of rows; spans[0] is *first_row. */
unsigned sheen_spans(const struct sheen_frame *f, struct setup *s, struct sheen_rect rect, struct span *spans,
                     int16_t *first_row);

/* band.c: collect the push of a worker that may still be under way; its result. */
int sheen_worker_wait(struct sheen_frame *f, struct worker *w);

/* setup_*.c and shade_*.c: set-up and rows. g is NULL where the triangle is too flat for gradients. */
void sheen_setup_flat(const struct sheen_frame *f, struct setup *s, const struct surface_corners *c);
void sheen_setup_gouraud(const struct sheen_frame *f, struct setup *s, const struct surface_corners *c,
                         const struct gradients *g);
int sheen_setup_phong_nodes(const struct sheen_frame *f, struct setup *s, const struct surface_corners *c,
                            const struct gradients *g);
int sheen_setup_phong(const struct sheen_frame *f, struct setup *s, const struct surface_corners *c,
                      const struct gradients *g);
void sheen_setup_mean_normal(const struct sheen_frame *f, struct setup *s, const struct surface_corners *c);
/* One colour from intensities: what flat shading and degenerate triangles use. */
void sheen_setup_constant(const struct sheen_frame *f, struct setup *s, const struct lit *lit);
void sheen_shade_flat(const struct tile *t, const struct setup *s);
void sheen_shade_gouraud_linear(const struct tile *t, const struct setup *s);
void sheen_shade_gouraud_quotient(const struct tile *t, const struct setup *s);
void sheen_shade_phong_root(const struct tile *t, const struct setup *s);
/* L.N, V.N and N.N at a pixel of a row, and the last one's step. */
struct normal_run {
    uint32_t ln, nv, d, d_step;
};

/* A quadratic along a row, a step a pixel. */
struct parabola {
    int32_t value, step, bend;
};

int sheen_rescale(uint32_t *d, int32_t *ln, int32_t *nv);
void sheen_shade_root_run(const struct tile *t, const struct setup *s, int32_t x, int32_t x1, int32_t y,
                          struct normal_run run);
void sheen_shade_block(const struct tile *t, const struct setup *s, int32_t x, int32_t y, struct parabola diffuse,
                       struct parabola reflected);
void sheen_shade_quadratic_diffuse(const struct tile *t, const struct setup *s);
void sheen_shade_quadratic_specular(const struct tile *t, const struct setup *s);
void sheen_shade_quadratic_power(const struct tile *t, const struct setup *s);
void sheen_shade_phong_lights(const struct tile *t, const struct setup *s);

/* slerp.c: normals that follow great arcs (lecture, "Spherical Linear Interpolation"). */

/* A unit vector at each end of a row of the triangle, and the arc between. */
struct slerp_row {
    int32_t x0, width;      /* the left crossing and the distance to the right one, px, Q15.16 */
    uint32_t weight[2];     /* at both, UQ0.32 */
    uint32_t angle;         /* between the normals, turns, at most 1/2 */
    uint8_t even;           /* t* is t: no perspective, or none that would be seen */
    uint8_t opposite;       /* the ends are opposite: the left one holds while t < 1/2 */
    struct arc_light {      /* a light along the arc, w the angle from the left end: */
        int32_t a, b;       /* L.N = a cos w + b sin w, Q1.30 */
        int32_t mean, p, q; /* R.V = mean + p cos 2w + q sin 2w, Q2.29 */
    } light[SHEEN_MAX_LIGHTS];
};

/* x + x's law x'' = -e x, one light's two sinusoids at a pixel and their next steps. */
struct arc_state {
    int32_t light, light_step;         /* L.N, Q1.30 */
    int32_t reflected, reflected_step; /* R.V less its mean, Q2.29 */
};

/* A run of pixels over which the angle grows evenly. */
struct arc_block {
    struct arc_state state[SHEEN_MAX_LIGHTS];
    uint32_t light_law, reflected_law;             /* e = 4 sin^2(step / 2) and 4 sin^2(step): 15 bits, */
    unsigned light_law_shift, reflected_law_shift; /* over 2^(15 + shift) */
};

void sheen_shade_arc(const struct tile *t, const struct setup *s, const struct slerp_row *row, struct arc_block *block,
                     int32_t x, int32_t y, unsigned length);
void sheen_setup_slerp(struct setup *s, const struct surface_corners *c);
void sheen_shade_slerp(const struct tile *t, const struct setup *s);

#endif
