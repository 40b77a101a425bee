/*
 * textured_planes.c - makes planes of texel coordinates and light at the corners: linear on the screen if that is good
 * enough, else for quotients (lecture, "Fixing Distortion").
 */
#include "fog.h"
#include "textured.h"

SETUP_FITS(struct textured_setup);

/* Corner k's value minus corner 0's, over 2^shift, shift >= 1. */
static int32_t more_at(const struct at_corners *at, int k, unsigned shift)
{
    return asr32(at->f[k] - at->f[0] + (1 << (shift - 1)), shift);
}

static uint32_t reach_of(const struct at_corners *at)
{
    return magnitude32(at->f[1] - at->f[0]) | magnitude32(at->f[2] - at->f[0]);
}

/* 1 if coordinates that are linear on the screen are off by at most 1/32 texel. */
static int texels_straight(const struct surface_corners *c, const struct at_corners *at)
{
    return reach_of(at) < 1u << 26 && sheen_straight(c, more_at(at, 1, 12), more_at(at, 2, 12), 2);
}

/* The plane of what is linear on the screen. coarse: 15 bits of the differences are enough. */
static struct plane screen_plane(const struct gradients *g, const struct at_corners *at, int coarse)
{
    uint32_t reach = reach_of(at);
    unsigned up = (unsigned)max32(1, 17 - (int32_t)clz32(reach));
    struct plane p;

    if (!coarse && reach >= 1u << 20) /* 16 texels */
        return sheen_gradient_plane(g, at->f, 0);
    sheen_plane(&p, g, (uint32_t)at->f[0], more_at(at, 1, up), more_at(at, 2, up), up);
    return p;
}

/* The plane of an attribute, below 2^(30 - up), times weight: it holds twice the product's high word. */
static struct plane numerator_plane(const struct gradients *g, const struct surface_corners *c,
                                    const struct at_corners *at, unsigned up)
{
    int32_t value[3];

    for (int k = 0; k < 3; k++)
        value[k] = (int32_t)asr64((int64_t)(int32_t)((uint32_t)at->f[k] << up) * c->weight[k], 32);
    return sheen_gradient_plane(g, value, 1);
}

static APART uint32_t largest_of(const struct at_corners *at)
{
    return magnitude32(at->f[0]) | magnitude32(at->f[1]) | magnitude32(at->f[2]);
}

HOT static APART void textured_quotients(struct textured_setup *t, struct surface_corners *c, const struct gradients *g,
                                         const struct at_corners at[4])
{
    const unsigned zeros = clz32(largest_of(&at[0]) | largest_of(&at[1])), up = zeros < 2 ? 0 : zeros - 2;
    int32_t half[3];

    sheen_weigh(c);
    t->s.way = SHEEN_WAY_TEXTURED_QUOTIENT;
    t->s.detail = (uint8_t)up;
    t->u = numerator_plane(g, c, &at[0], up);
    t->v = numerator_plane(g, c, &at[1], up);
    if (!t->s.draw->texel.unlit) {
        t->light = numerator_plane(g, c, &at[2], 0);
        t->specular = numerator_plane(g, c, &at[3], 0);
    }
    for (int k = 0; k < 3; k++)
        half[k] = (int32_t)(c->weight[k] >> 1);
    t->weight = sheen_gradient_plane(g, half, 1);
}

/* For triangles too flat for gradients: the corners' mean. */
static struct plane mean_plane(const struct at_corners *at)
{
    struct plane p = {(uint32_t)(at->f[0] + (at->f[1] - at->f[0]) / 3 + (at->f[2] - at->f[0]) / 3), 0, 0};

    return p;
}

/* 1 if a coordinate may come so near to the picture's edges that clamping and repeating differ. */
static int nears_edges(const struct at_corners *at, unsigned size, int32_t edge)
{
    unsigned near = 0;

    for (int k = 0; k < 3; k++)
        near |= (uint32_t)(at->f[k] - edge) > (1u << (16 + size)) - 2u * (uint32_t)edge;
    return near != 0;
}

/* 1 if loops for 565 may draw the texels. Under fog d->is_565 is 0 (take_general_loops), so the fog's is asked. */
static int shows_565(const struct draw *d)
{
    return d->is_565 || (d->fog != NULL && d->fog->is_565 && !d->stippled);
}

HOT enum textured_loop sheen_textured_loop(const struct draw *d, const struct at_corners at[4])
{
    const struct texel_terms *terms = &d->texel;
    const struct sheen_texture *t = terms->texture;
    const int is_other = (t->bits & 15) != 0 || t->keyed;
    const uint32_t highlight = largest_of(&at[3]);
    int32_t light = 0;

    for (int k = 0; k < 3; k++)
        light = max32(light, at[2].f[k]);
    if ((t->clamp_u && nears_edges(&at[0], t->width_log2, texel_edge(t))) ||
        (t->clamp_v && nears_edges(&at[1], t->height_log2, texel_edge(t))))
        return TEXTURED_ANY;
    if (!shows_565(d) || t->width_log2 + t->height_log2 > 16 || !terms->alike || light > 1 << LIGHT_BITS ||
        (highlight != 0 && !terms->white) || (t->bilinear && t->keyed))
        return TEXTURED_ANY;
    if (t->bilinear)
        return terms->unlit && !is_other ? TEXTURED_BILINEAR : TEXTURED_BILINEAR_OTHER;
    if (is_other)
        return TEXTURED_OTHER;
    return terms->unlit ? TEXTURED_UNLIT : highlight != 0 ? TEXTURED_GLOSSY : TEXTURED_LIT;
}

/* How far packed coordinates of nearest texels may be off along 8 px and along 32 px, in 2^-16 texel. */
#define BLOCK_BIAS 320
#define RUN_BIAS 1088

HOT void sheen_setup_textured(struct setup *s, struct surface_corners *c, const struct gradients *g,
                              struct at_corners at[4], int straight)
{
    struct textured_setup *t = (struct textured_setup *)s;
    struct plane *plane[4] = {&t->u, &t->v, &t->light, &t->specular};

    t->light = (struct plane){(uint32_t)at[2].f[0], 0, 0}; /* if unlit, it is the same everywhere */
    t->specular = (struct plane){0, 0, 0};
    s->special_loop = (uint8_t)sheen_textured_loop(s->draw, at);
    s->rows = sheen_textured_blocks;
    s->way = SHEEN_WAY_TEXTURED_LINEAR;
    const int linear = g == NULL || (straight && texels_straight(c, &at[0]) && texels_straight(c, &at[1]));
    if (!s->draw->texel.texture->bilinear)
        sheen_inset_corners(at, !s->draw->texel.uv_packed ? BORDER_BIAS : linear ? RUN_BIAS : BLOCK_BIAS);
    if (!linear) {
        textured_quotients(t, c, g, at);
        return;
    }
    for (int i = 0; i < (s->draw->texel.unlit ? 2 : 4); i++) {
        struct plane p;
        if (g == NULL)
            p = mean_plane(&at[i]);
        else
            p = screen_plane(g, &at[i], i > 1);
        *plane[i] = p;
    }
}
