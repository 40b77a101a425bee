/*
 * textured.c - set-up of textured triangles: texel coordinates and light at the corners, and whether they may be linear
 * on the screen (lecture, "Fixing Distortion").
 */
#include "textured.h"

SETUP_FITS(struct textured_setup);

/*
 * What rounding takes off a coordinate that lies on a border must not show the texel on its other side, and light is
 * cut at a pixel, so half of what is cut is there before.
 */
#define BORDER_BIAS 64 /* 1/1024 texel */
#define LIGHT_BIAS (1 << (LIGHT_PLANE_BITS - LIGHT_BITS - 1))

/* Of an attribute, in the order of the gradients. */
struct at_corners {
    int32_t f[3];
};

static void textured_begin(struct draw *d, const struct sheen_material *material, const struct pixel_format *format)
{
    sheen_texel_begin(&d->texel, format, material, d->light.diffuse_sum, d->light.specular_sum);
}

/* Texels of u (i = 0) or v, Q15.16; what repeats is brought near 0, so that quotients are fine. */
static struct at_corners texels_of(const struct draw *d, const struct surface_corners *c, int i)
{
    const struct sheen_texture *t = d->texel.texture;
    const unsigned size = i == 0 ? t->width_log2 : t->height_log2, clamp = i == 0 ? t->clamp_u : t->clamp_v;
    const unsigned up = 16 - d->mesh->uv_bits + size; /* 1..25 */
    uint32_t first = ((uint32_t)(int32_t)c->at.normal[0][i] << up) + ((uint32_t)d->mesh->uv_offset[i] << size);
    struct at_corners at;

    if (!clamp)
        first &= (1u << (16 + size)) - 1;
    for (int k = 0; k < 3; k++)
        at.f[k] = (int32_t)(first + BORDER_BIAS + ((uint32_t)(c->at.normal[k][i] - c->at.normal[0][i]) << up));
    return at;
}

/* Light at a diffuse intensity, UQ1.15, as it is stepped. */
static int32_t light_at(const struct texel_terms *t, uint32_t diffuse)
{
    if (!t->alike)
        return (int32_t)(diffuse << 15);
    return (int32_t)((t->a[0] + t->b[0] * diffuse) >> (t->fraction - LIGHT_PLANE_BITS)) + LIGHT_BIAS;
}

/* What corner k has more than corner 0, over 2^shift, shift >= 1. */
static int32_t more_at(const struct at_corners *at, int k, unsigned shift)
{
    return asr32(at->f[k] - at->f[0] + (1 << (shift - 1)), shift);
}

static uint32_t reach_of(const struct at_corners *at)
{
    return magnitude32(at->f[1] - at->f[0]) | magnitude32(at->f[2] - at->f[0]);
}

/* 1 where linear on the screen is within 1/32 texel. */
static int texels_straight(const struct surface_corners *c, const struct at_corners *at)
{
    return reach_of(at) < 1u << 26 && sheen_straight(c, more_at(at, 1, 12), more_at(at, 2, 12), 2);
}

/* Linear on the screen; coarse: 15 bits of the differences are enough. */
static struct plane screen_plane(const struct gradients *g, const struct at_corners *at, int coarse)
{
    uint32_t reach = reach_of(at);
    unsigned up = (unsigned)max32(1, 17 - (int32_t)clz32(reach));

    if (!coarse && reach >= 1u << 20) /* 16 texels */
        return sheen_gradient_plane(g, at->f, 0);
    return sheen_plane(g, (uint32_t)at->f[0], more_at(at, 1, up), more_at(at, 2, up), up);
}

/* The attribute, below 2^(30 - up), times weight: twice the product's high word. */
static struct plane numerator_plane(const struct gradients *g, const struct surface_corners *c,
                                    const struct at_corners *at, unsigned up)
{
    int32_t value[3];

    for (int k = 0; k < 3; k++)
        value[k] = (int32_t)asr64((int64_t)(int32_t)((uint32_t)at->f[k] << up) * c->weight[k], 32);
    return sheen_gradient_plane(g, value, 1);
}

static uint32_t largest_of(const struct at_corners *at)
{
    return magnitude32(at->f[0]) | magnitude32(at->f[1]) | magnitude32(at->f[2]);
}

static APART void textured_quotients(struct textured_setup *t, struct surface_corners *c, const struct gradients *g,
                                     const struct at_corners at[4])
{
    const unsigned zeros = clz32(largest_of(&at[0]) | largest_of(&at[1])), up = zeros < 2 ? 0 : zeros - 2;
    int32_t half[3];

    sheen_weigh(c);
    t->s.way = SHEEN_WAY_TEXTURED_QUOTIENT;
    t->s.detail = (uint8_t)up;
    t->u = numerator_plane(g, c, &at[0], up);
    t->v = numerator_plane(g, c, &at[1], up);
    t->light = numerator_plane(g, c, &at[2], 0);
    t->specular = numerator_plane(g, c, &at[3], 0);
    for (int k = 0; k < 3; k++)
        half[k] = (int32_t)(c->weight[k] >> 1);
    t->weight = sheen_gradient_plane(g, half, 1);
}

/* Too flat for gradients: the mean. */
static struct plane mean_plane(const struct at_corners *at)
{
    struct plane p = {(uint32_t)(at->f[0] + (at->f[1] - at->f[0]) / 3 + (at->f[2] - at->f[0]) / 3), 0, 0};

    return p;
}

static void textured_planes(struct textured_setup *t, struct surface_corners *c, const struct gradients *g,
                            const struct at_corners at[4], int straight)
{
    struct plane *plane[4] = {&t->u, &t->v, &t->light, &t->specular};

    t->s.rows = sheen_textured_blocks;
    t->s.way = SHEEN_WAY_TEXTURED_LINEAR;
    if (g != NULL && !straight) {
        textured_quotients(t, c, g, at);
        return;
    }
    for (int i = 0; i < 4; i++)
        *plane[i] = g == NULL ? mean_plane(&at[i]) : screen_plane(g, &at[i], i > 1);
}

/* The cheapest pixels that give what any would. */
static enum textured_pixels pixels_of(const struct draw *d, const struct at_corners at[4])
{
    const struct texel_terms *terms = &d->texel;
    const struct sheen_texture *t = terms->texture;
    uint32_t light = 0;

    if (!d->is_565 || (t->bits & 15) != 0 || t->keyed || t->clamp_u || t->clamp_v || t->bilinear ||
        t->width_log2 + t->height_log2 > 16 || !terms->alike)
        return TEXTURED_ANY;
    for (int k = 0; k < 3; k++)
        light = (uint32_t)at[2].f[k] > light ? (uint32_t)at[2].f[k] : light;
    if (terms->unlit)
        return TEXTURED_UNLIT;
    return light > (1u << LIGHT_PLANE_BITS) + LIGHT_BIAS || largest_of(&at[3]) != 0 ? TEXTURED_ANY : TEXTURED_LIT;
}

static void textured_as(struct setup *s, struct surface_corners *c, const struct gradients *g, const struct lit lit[3])
{
    const struct draw *d = s->draw;
    const struct colour_terms *colour = &d->colour;
    struct at_corners at[4] = {texels_of(d, c, 0), texels_of(d, c, 1), {{0, 0, 0}}, {{0, 0, 0}}};
    int32_t diffuse[2], specular[2];

    for (int k = 0; k < 3; k++) {
        at[2].f[k] = light_at(&d->texel, lit[k].diffuse);
        at[3].f[k] = (int32_t)(lit[k].specular << 15);
    }
    for (int k = 0; k < 2; k++) {
        diffuse[k] = (int32_t)(lit[k + 1].diffuse - lit[0].diffuse);
        specular[k] = (int32_t)(lit[k + 1].specular - lit[0].specular);
    }
    s->fast = (uint8_t)pixels_of(d, at);
    textured_planes((struct textured_setup *)s, c, g, at,
                    texels_straight(c, &at[0]) && texels_straight(c, &at[1]) &&
                        sheen_straight(c, diffuse[0], diffuse[1], colour->eighth / 2) &&
                        sheen_straight(c, specular[0], specular[1], 4u * colour->dim));
}

static void textured_setup(struct setup *s, struct surface_corners *c, const struct gradients *g)
{
    struct lit lit[3] = {{0, 0}, {0, 0}, {0, 0}};

    if (!s->draw->texel.unlit) {
        const struct sheen_mesh *mesh = s->draw->mesh;
        const int16_t *normal[3];
        for (int k = 0; k < 3; k++) /* corners of pieces have none and need none */
            normal[k] =
                (c->at.v[k]->flags & LIT_AS_SEEN) != 0 ? NULL : mesh->normals + (c->at.normal[k] - mesh->uvs) / 2 * 3;
        (void)corners_lit(s, c, normal, lit);
    }
    textured_as(s, c, g, lit);
}

static void textured_flat_setup(struct setup *s, struct surface_corners *c, const struct gradients *g)
{
    struct lit lit[3] = {{0, 0}, {0, 0}, {0, 0}};

    if (!s->draw->texel.unlit)
        sheen_facet_lit(s, c, &lit[0]);
    lit[1] = lit[2] = lit[0];
    textured_as(s, c, g, lit);
}

/* A vertex keeps its intensities, where there are any. */
static void textured_light(const struct draw *d, const int16_t normal[3], uint16_t kept[2])
{
    struct lit lit = {0, 0};

    if (!d->texel.unlit)
        sheen_light_normal(&d->light, d->power, normal, &lit);
    kept[0] = (uint16_t)lit.diffuse;
    kept[1] = (uint16_t)lit.specular;
}

const struct sheen_shader sheen_textured = {.begin = textured_begin,
                                            .light = textured_light,
                                            .setup = textured_setup,
                                            .needs_normals = 1,
                                            .needs_texture = 1,
                                            .needs_uvs = 1};

const struct sheen_shader sheen_textured_flat = {
    .begin = textured_begin, .setup = textured_flat_setup, .needs_texture = 1, .needs_uvs = 1};
