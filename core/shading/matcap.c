/*
 * matcap.c - a picture of a lit sphere in place of light: a pixel takes the texel where the sphere has its normal.
 *
 * Texel coordinates are (1 + x) / 2 and (1 - y) / 2 of the unit normal in eye space; x and y are L.N of two lights
 * along the eye's axes. Like Phong's cosines they are quadratic over a triangle whose corner normals nearly agree, and
 * linear if the normals are closer still; otherwise the normal itself is linear, and a root is taken at the ends of
 * blocks. In sheen_matcap_vertex the coordinates are linear in space.
 */
#include "matcap.h"
#include "../triangle/normal.h"
#include "../triangle/reflection.h"

SETUP_FITS(struct matcap_setup);

#define MATCAP_LEAN 32768   /* 1/m changes along an edge by at most 1/8 of its mean */
#define MAGNIFIED_MATCAP 12 /* gradients' bits: from 64 px on too many pixels would share a quadric's error */

/* |Ni - Nj|^2, UQ2.30, up to which a quadric is within 1/24 step: for up to 64 steps a side, 128, 256, 512 and 1024. */
static const uint32_t widest_quadratic[5] = {189000000u, 119000000u, 75000000u, 47000000u, 29000000u};

/* There are no lights: ambient light of 1.0 shows the base colour as it is. */
static void matcap_begin(struct draw *d, const struct sheen_material *material, const struct pixel_format *format,
                         const struct sheen_object *object, const struct sheen_pose *view)
{
    struct sheen_material unlit = {.base = {material->base[0], material->base[1], material->base[2]},
                                   .ambient = 1 << 16};

    (void)object;
    (void)view;
    unlit.texture = material->texture;
    sheen_texel_begin(&d->texel, format, &unlit, 0, 0);
}

/* A vertex keeps x and y of its normal, UQ1.15: 1.0 is added because pieces interpolate unsigned numbers. */
static void matcap_light(const struct draw *d, const int16_t normal[3], uint16_t kept[2])
{
    SHEEN_TAP(COSINES, 1);
    for (int i = 0; i < 2; i++)
        kept[i] = (uint16_t)(32768 + cosine_of(normal, d->light.to[i]));
}

/* x and -y of the normals at the corners, as seen: Q0.15. */
HOT static void corner_cosines(int32_t cosine[2][3], const struct surface_corners *c)
{
    for (int k = 0; k < 3; k++) {
        const struct vertex *v = c->at.v[k];
        const int turned = c->back && (v->flags & LIT_AS_SEEN) == 0;
        const int32_t x = v->kept[0] - 32768, y = v->kept[1] - 32768;
        cosine[0][k] = turned ? -x : x;
        cosine[1][k] = turned ? y : -y;
    }
}

static unsigned size_of(const struct draw *d, int i)
{
    const struct sheen_texture *t = d->texel.texture;

    return i == 0 ? t->width_log2 : t->height_log2;
}

/* The logarithm of the steps a side to which coordinates have to be exact: texels, or half texels if bilinear. */
static unsigned steps_of(const struct draw *d)
{
    const unsigned width = size_of(d, 0), height = size_of(d, 1);

    return (width > height ? width : height) + (d->texel.texture->bilinear ? 1 : 0);
}

/* Texel coordinates from x and -y, at least `edge` from the picture's edges, and light. */
HOT static void corner_texels(const struct draw *d, int32_t cosine[2][3], int32_t edge, struct at_corners at[4])
{
    for (int i = 0; i < 2; i++)
        for (int k = 0; k < 3; k++)
            at[i].f[k] = texel_at_cosine(cosine[i][k], size_of(d, i), edge);
    for (int k = 0; k < 3; k++) {
        at[2].f[k] = texel_light(&d->texel, 0);
        at[3].f[k] = 0;
    }
}

/* ---- quadratic ---- */

/*
 * 1 if the quadric might come near the picture's edges. Inside it rises above the corners by at most a third of the
 * largest excess, b0 b1 + b0 b2 + b1 b2 being at most 1/3: that is k / 6, as k has a bit more than f. k / 2 needs no
 * division.
 */
static int may_leave(const int32_t f[3], const int32_t k[3], int32_t most_cosine)
{
    const int32_t most = max32(max32(f[0], f[1]), f[2]), least = min32(min32(f[0], f[1]), f[2]);
    const uint32_t bend = magnitude32(k[0]) | magnitude32(k[1]) | magnitude32(k[2]);

    return max32(most, -least) + (int32_t)(bend >> 1) > most_cosine;
}

/* About the longest block whose length squared times `rate` stays below 2^bits, bits <= 29. */
static uint8_t block_of(uint32_t rate, unsigned bits)
{
    const unsigned drop = bits > 21 ? bits - 21 : 0; /* LARGEST_BLOCK squared is 2^10 */
    uint32_t count = LARGEST_BLOCK;

    if (rate >> bits != 0)
        return 1;
    rate = (rate >> drop) + 1;
    while (count > 1 && rate * count * count > 1u << (bits - drop))
        count -= (count >> 3) + 1;
    return (uint8_t)count;
}

/* A block's middle is off by its length squared times 1/8 of the second difference: at most 1/32 step. */
static uint8_t quadric_block(const struct quadric quadric[2], unsigned steps)
{
    const uint32_t u = magnitude32((int32_t)quadric[0].dxx), v = magnitude32((int32_t)quadric[1].dxx);

    return block_of(u > v ? u : v, 29 - steps);
}

/* 0: the triangle is too large, too small or a needle, weights are too far apart, or it might leave the picture. */
HOT static int quadratic_matcap(struct matcap_setup *m, const struct surface_corners *c, const struct gradients *g,
                                const uint32_t h[3])
{
    struct quadric_steps steps;
    int32_t cosine[2][3], lean[3];

    if (g->bits > MAGNIFIED_MATCAP || !sheen_leans(lean, c, MATCAP_LEAN) || !sheen_quadric_steps(&steps, g))
        return 0;
    corner_cosines(cosine, c);
    for (int i = 0; i < 2; i++) {
        const int32_t *f = cosine[i];
        const int32_t k[3] = {sheen_cosine_excess(f[0], f[1], (int32_t)(h[0] >> 14), lean[0]),
                              sheen_cosine_excess(f[0], f[2], (int32_t)(h[1] >> 14), lean[1]),
                              sheen_cosine_excess(f[1], f[2], (int32_t)(h[2] >> 14), lean[2])};
        const uint32_t bias = (uint32_t)BORDER_BIAS << (15 - size_of(m->s.draw, i));
        if (may_leave(f, k, 32768 - (texel_edge(m->s.draw->texel.texture) >> size_of(m->s.draw, i)) - 64))
            return 0;
        sheen_corner_quadric(&m->quadric[i], &steps, ((uint32_t)(f[0] + 32768) << 15) + bias, (f[1] - f[0]) * 2,
                             (f[2] - f[0]) * 2, k);
    }
    m->x = (int16_t)g->origin[0];
    m->y = (int16_t)g->origin[1];
    m->s.detail = quadric_block(m->quadric, steps_of(m->s.draw));
    m->s.way = SHEEN_WAY_MATCAP_QUADRATIC;
    m->s.rows = sheen_matcap_quadric_rows;
    return 1;
}

/* ---- normals ---- */

/* |x| <= 2^15. */
static uint32_t part_square(int32_t x)
{
    return (uint32_t)(x * x);
}

/*
 * The block length by normals. Over the triangle N.N is at least the smallest N.N of a corner less a quarter of the
 * largest |Ni - Nj|^2, if that edge lies across an obtuse angle, else less a third. At that length the normal turns by
 * |Nx| / |N| per pixel, and the square of that bounds the second difference of the coordinates.
 */
static uint8_t normal_block(const struct plane normal[3], int32_t n[3][3], unsigned steps)
{
    uint32_t least = UINT32_MAX, apart = 0, sum = 0, step = 0;

    for (int k = 0; k < 3; k++) { /* UQ2.30 */
        const int j = k == 2 ? 0 : k + 1;
        uint32_t square = part_square(n[0][k]) + part_square(n[1][k]) + part_square(n[2][k]);
        uint32_t edge = (part_square(asr32(n[0][k] - n[0][j], 1)) + part_square(asr32(n[1][k] - n[1][j], 1)) +
                         part_square(asr32(n[2][k] - n[2][j], 1))) >>
                        1; /* |Ni - Nj|^2 / 8 */
        least = square < least ? square : least;
        apart = edge > apart ? edge : apart;
        sum += edge;
        if (magnitude32((int32_t)normal[k].dx) >= 1u << 25)
            return 1;
        step += part_square(asr32((int32_t)normal[k].dx, 10)); /* UQ.40 */
    }
    apart = 2 * apart >= sum ? 2 * apart : QUOTIENT(apart, 3u) * 8;
    least = least > apart ? least - apart : 0;
    if (least >> 15 == 0)
        return 1;
    return block_of(QUOTIENT(step, least >> 15), 24 - steps); /* of UQ.25 */
}

static void normal_matcap(struct matcap_setup *m, struct surface_corners *c, const struct gradients *g)
{
    const struct lighting *l = &m->s.draw->light;
    const sheen_q30_t *const axis[3] = {l->to[0], l->to[1], l->view};
    int32_t w[3], n[3][3];

    sheen_corner_weights(c, w);
    for (int i = 0; i < 3; i++) {
        for (int k = 0; k < 3; k++) {
            int32_t x = cosine_of(c->at.normal[k], axis[i]);
            n[i][k] = c->back ? -x : x;
        }
        m->normal[i] = sheen_weighted_plane(g, w, n[i]);
        for (int k = 0; k < 3; k++)
            n[i][k] = asr32(w[k] * n[i][k], 15);
    }
    m->s.detail = normal_block(m->normal, n, steps_of(m->s.draw));
    m->s.way = SHEEN_WAY_MATCAP_NORMALS;
    m->s.rows = sheen_matcap_normal_rows;
}

/* ---- the choice ---- */

static void matcap_vertex_setup(struct setup *s, struct surface_corners *c, const struct gradients *g)
{
    struct at_corners at[4];
    int32_t cosine[2][3];

    corner_cosines(cosine, c);
    corner_texels(s->draw, cosine, TEXEL_EDGE, at);
    sheen_setup_textured(s, c, g, at, 1);
}

/* The largest |Ni - Nj|^2, UQ2.30, for linear: the middle of an arc t lies t^2 / 8 above its chord, here 1/32 step. */
static uint32_t widest_linear(unsigned steps)
{
    return 1u << (29 - steps);
}

/* Chooses how texels are drawn for quadrics or normals, both of which keep coordinates off the picture's edges. */
static APART void choose_loop(struct setup *s, const struct surface_corners *c)
{
    struct at_corners at[4];
    int32_t cosine[2][3];

    corner_cosines(cosine, c);
    corner_texels(s->draw, cosine, texel_edge(s->draw->texel.texture), at);
    s->special_loop = (uint8_t)sheen_textured_loop(s->draw, at);
}

/* 0: linear is good enough. APART, like the functions that it calls, because there is no stack to spare. */
static APART int curved_matcap(struct setup *s, struct surface_corners *c, const struct gradients *g)
{
    const unsigned steps = steps_of(s->draw);
    /* cosines at a piece's corners are interpolated, so that only its normals are exact */
    const int piece = (c->at.v[0]->flags & LIT_AS_SEEN) != 0;
    uint32_t h[3], apart = sheen_normals_apart(c->at.normal, h);

    if (apart <= widest_linear(steps) && !piece)
        return 0;
    choose_loop(s, c);
    if (piece || apart > widest_quadratic[steps > 6 ? steps - 6 : 0] ||
        !quadratic_matcap((struct matcap_setup *)s, c, g, h))
        normal_matcap((struct matcap_setup *)s, c, g);
    return 1;
}

static void matcap_setup(struct setup *s, struct surface_corners *c, const struct gradients *g)
{
    if (g == NULL || !curved_matcap(s, c, g))
        matcap_vertex_setup(s, c, g);
}

const struct sheen_shader sheen_matcap = {.begin = matcap_begin,
                                          .light = matcap_light,
                                          .setup = matcap_setup,
                                          .axes = eye_axes,
                                          .needs_normals = 1,
                                          .corners = OF_MESH(normals),
                                          .reads_normals = 1,
                                          .takes = sheen_sphere_valid};

const struct sheen_shader sheen_matcap_vertex = {.begin = matcap_begin,
                                                 .light = matcap_light,
                                                 .setup = matcap_vertex_setup,
                                                 .axes = eye_axes,
                                                 .needs_normals = 1,
                                                 .corners = OF_MESH(normals),
                                                 .takes = sheen_sphere_valid};
