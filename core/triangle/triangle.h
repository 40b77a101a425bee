/*
 * triangle.h - private: a triangle made ready, its rows, and the ways to shade them.
 */
#ifndef SHEEN_TRIANGLE_H
#define SHEEN_TRIANGLE_H

#include "../pixel/colour.h"
#include "../vertex/vertex.h"

struct sheen_frame;

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
    uint8_t highlight;                /* by quadrics: there is a second one, */
    uint8_t faded;                    /* and L.N may lie below 1/8 (Phong) */
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

static inline uint32_t plane_at(const struct plane *p, int32_t x, int32_t y)
{
    return p->base + (uint32_t)x * p->dx + (uint32_t)y * p->dy;
}

/* x (x - 1) / 2, the binomial; |x| < 2^15. */
static inline uint32_t pairs(int32_t x)
{
    return (uint32_t)(x * (x - 1) / 2);
}

/* setup.c: prepare a triangle from row `from` on; 0 where it has no row left. */
int sheen_setup(const struct sheen_frame *f, const struct draw_record *d, uint32_t entry, int32_t from,
                struct setup *s);
void sheen_setup_lower_edge(const struct sheen_frame *f, struct setup *s);

/* The three corners of an entry, with what shading needs of them. */
struct corners {
    const struct vertex *v[3];
    const int16_t *normal[3]; /* NULL where the mesh has none */
    uint16_t triangle;        /* of the mesh */
};

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
    int32_t b1[2], b2[2]; /* d(b1), d(b2) a px in x and y: value = raw / 2^exponent, |raw| <= 2^31 - 2^15 */
    unsigned exponent;    /* MIN_EXPONENT..40 */
    int stretch;          /* logarithm of extent^2 / area, within 1 below and 2 above; a needle's is large */
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
 * products of steps and six of first order, for one triangle and any f on it; quadric.c.
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

/* shading/: set-up and rows. g is NULL where the triangle is too flat for gradients. */
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
