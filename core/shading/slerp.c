/*
 * slerp.c - a triangle whose rows lie between great arcs (lecture, "Spherical Linear Interpolation"), and which way
 * they take: narrow arcs as Phong, others by the arcs' series.
 */
#include "slerp.h"
#include "../triangle/reflection.h"

SETUP_FITS(struct slerp_setup);

/* `apart` of a right angle, the widest that cosines do; of 60 degrees where n is over 16: 15 bits are few there. */
#define WIDEST_ARC (1u << 31)
#define WIDEST_SHARP (1u << 30)

const uint8_t sheen_slerp_end[3][2] = {{0, 2}, {0, 1}, {1, 2}};

void sheen_slerp_cross(const struct slerp_corners *s, unsigned edge, int32_t centre, struct crossing *at)
{
    const unsigned a = sheen_slerp_end[edge][0], b = sheen_slerp_end[edge][1];
    const int32_t across = s->x[b] - s->x[a];                                   /* below 2^16 */
    const uint32_t t = (uint32_t)(centre - s->y[a]) * s->inverse[edge];         /* UQ.31, at most 1.0 and 2^-16 of it */
    const int32_t high = (int32_t)(t >> 16), low = (int32_t)(t >> 1 & 0x7fffu); /* 65408 * 2^15 < 2^31 */

    at->x = s->x[a] * 1024 + asr32(across * high, 5) + asr32(across * low, 20);
    at->t = min32((int32_t)((t + (1u << 15)) >> 16), 32768);
    at->weight = s->weight[a];
    if (!s->even)
        at->t = in_space(at->t, s->weight[a], s->weight[b], &at->weight);
}

/* ---- set-up ---- */

/* order: the corners from the top down, corners of a row as they come. Returns 1 where they turn the other way then. */
static int from_the_top(unsigned order[3], const struct surface_corners *c)
{
    int turned = 0;

    for (unsigned i = 0; i < 3; i++)
        order[i] = i;
    for (unsigned i = 0; i < 3; i++) {
        const unsigned upper = order[i % 2], lower = order[i % 2 + 1];
        if (c->at.v[lower]->y < c->at.v[upper]->y) {
            order[i % 2] = lower;
            order[i % 2 + 1] = upper;
            turned ^= 1;
        }
    }
    return turned;
}

void sheen_slerp_corners(struct slerp_corners *s, const struct surface_corners *c)
{
    unsigned order[3];

    s->long_right = (uint8_t)from_the_top(order, c);
    s->even = 1;
    for (int k = 0; k < 3; k++) {
        const struct vertex *v = c->at.v[order[k]];
        s->x[k] = v->x;
        s->y[k] = v->y;
        s->weight[k] = slerp_weight(c, order[k]);
        s->even &= s->weight[k] == s->weight[0];
        for (int i = 0; i < 3; i++) {
            int32_t part = max32(c->at.normal[order[k]][i], -32767);
            s->normal[k][i] = (int16_t)(c->back ? -part : part);
        }
    }
    for (int k = 0; k < 3; k++) {
        const uint32_t height = (uint32_t)(s->y[sheen_slerp_end[k][1]] - s->y[sheen_slerp_end[k][0]]);
        s->inverse[k] = height > 0 ? ((1u << 31) + height / 2) / height : 0;
    }
}

static void slerp_setup(struct setup *setup, struct surface_corners *c, const struct gradients *g)
{
    const struct draw *d = setup->draw;
    const int piece = (c->at.v[0]->flags & LIT_AS_SEEN) != 0; /* these keep no cosines */
    struct facing f = {.apart = UINT32_MAX};

    if (g == NULL || d->light.count == 0) {
        sheen_setup_mean_normal(setup, c);
        return;
    }
    if (d->light.count == 1 && !piece)
        sheen_face(&f, c);
    if (f.apart <= CLOSE_ARCS && sheen_setup_reflection(setup, c, g, &f))
        return;
    int one = f.apart <= (d->power.shininess > 16 ? WIDEST_SHARP : WIDEST_ARC) && d->by_ramp < 2 &&
              way_wanted(d, SHEEN_WAY_SLERP);
    sheen_weigh(c);
    sheen_slerp_corners(&((struct slerp_setup *)setup)->at, c);
    setup->way = one ? SHEEN_WAY_SLERP : SHEEN_WAY_SLERP_NORMALS;
    setup->fast = 0;
    setup->rows = sheen_slerp_rows;
}

const struct sheen_shader sheen_slerp = {.light = sheen_keep_cosines,
                                         .setup = slerp_setup,
                                         .shades = &sheen_shades_maker,
                                         .needs_normals = 1,
                                         .corners = OF_MESH(normals),
                                         .reads_normals = 1,
                                         .unit_normals = UNIT_IN_SPACE,
                                         .at_pixels = 1};
