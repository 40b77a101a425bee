/*
 * slerp.c - set-up of triangles whose rows lie between great arcs (lecture, "Spherical Linear Interpolation"), and the
 * choice of their way: narrow arcs as Phong, others by the arcs' series.
 */
#include "slerp.h"

SETUP_FITS(struct slerp_setup);

/* `apart` of a right angle, the widest arc for cosines; of 60 degrees if n is over 16, as 15 bits are too few then. */
#define WIDEST_ARC (1u << 31)
#define WIDEST_SHARP (1u << 30)

COLD void sheen_slerp_corners(struct slerp_corners *s, const struct surface_corners *c, const struct facing *f)
{
    struct slerp_corner *at = s->corner;
    unsigned from[3] = {0, 1, 2};

    s->long_right = 0;
    for (unsigned i = 0; i < 3; i++) { /* sorts by y; each exchange turns the corners' winding around */
        unsigned *upper = &from[i % 2], held = *upper;
        if (c->at.v[upper[1]]->y < c->at.v[held]->y) {
            upper[0] = upper[1];
            upper[1] = held;
            s->long_right ^= 1;
        }
    }
    for (unsigned k = 0; k < 3; k++, at++) {
        const unsigned own = from[k];
        at->x = c->at.v[own]->x;
        at->y = c->at.v[own]->y;
        at->weight = slerp_weight(c, own);
        for (int i = 0; f == NULL && i < 3; i++) {
            const int32_t part = max32(c->at.normal[own][i], -32767);
            at->normal[i] = (int16_t)(c->back ? -part : part);
        }
        if (f != NULL) {
            at->lit[0] = (int16_t)f->ln[own];
            at->lit[1] = (int16_t)f->nv[own];
        }
    }
    at = s->corner;
    s->even = at[1].weight == at[0].weight && at[2].weight == at[0].weight;
    for (unsigned edge = 0; edge < 3; edge++) {
        const unsigned upper = edge >> 1, lower = 2 - (edge & 1u);
        const uint32_t height = (uint32_t)(at[lower].y - at[upper].y);
        s->inverse[edge] = height > 0 ? QUOTIENT((1u << 31) + height / 2, height) : 0;
        if (f != NULL) /* f->h holds edges 01, 02, 12: the place is the sum of both corners less 1 */
            s->h[edge] = (uint16_t)((f->h[from[upper] + from[lower] - 1] + (1u << 16)) >> 17);
    }
}

HOT static void slerp_setup(struct setup *setup, struct surface_corners *c, const struct gradients *g)
{
    const struct draw *d = setup->draw;
    const int piece = (c->at.v[0]->flags & LIT_AS_SEEN) != 0; /* pieces keep no cosines */
    struct facing f = {.apart = UINT32_MAX};

    if (g == NULL || d->light.count == 0) {
        sheen_setup_mean_normal(setup, c);
        return;
    }
    if (d->light.count == 1 && !piece)
        sheen_face(&f, c);
    if (f.apart <= CLOSE_ARCS && sheen_setup_reflection(setup, c, g, &f))
        return;
    int one = f.apart <= (d->power.shininess > 16 ? WIDEST_SHARP : WIDEST_ARC) && d->pixel_ramp < 2 &&
              way_wanted(d, SHEEN_WAY_SLERP);
    sheen_weigh(c);
    sheen_slerp_corners(&((struct slerp_setup *)setup)->at, c, one ? &f : NULL);
    setup->way = one ? SHEEN_WAY_SLERP : SHEEN_WAY_SLERP_NORMALS;
    setup->rows = sheen_slerp_rows;
}

const struct sheen_shader sheen_slerp = {.begin = sheen_reflection_begin,
                                         .light = sheen_keep_cosines,
                                         .setup = slerp_setup,
                                         .quads = QUADS_CLOSE,
                                         .find_shades = sheen_shades_of,
                                         .needs_normals = 1,
                                         .corners = OF_MESH(normals),
                                         .reads_normals = 1,
                                         .unit_normals = UNIT_IN_SPACE,
                                         .at_pixels = 1};
