/*
 * reflection.c - Phong where normals nearly agree: L.N and 1 - R.V quadratic over the triangle.
 *
 * The excess on an edge, 4 (middle - mean of the ends), needs no root. Let N be linear in space and brought to unit
 * length; l = L.N, v = N.V and u = 1 - R.V at the ends 1 and 2, t the angle between N1 and N2, h = (1 - N1.N2) / 2 =
 * |N1 - N2|^2 / 4 and, with weights w, d = (w1 - w2) / (w1 + w2). Then the excess is
 *   of L.N:      2 (1 / cos(t/2) - 1) (l1 + l2) + 2 d (l1 - l2),   2 / cos(t/2) - 2 = h + 3/4 h^2 + ...
 *   of 1 - R.V:  2 (l1 - l2) (v1 - v2) - 2 (h + h^2) (l1 + l2) (v1 + v2) + 2 d (u1 - u2)
 * in 32 bits, by factors of 15 to 18 bits.
 */
#include "../math/bend.h"
#include "excess.h"
#include "normal.h"

SETUP_FITS(struct quadric_setup);

/*
 * A quadric's error grows with the cube of the angle between normals, and shows in proportion to the levels that light
 * spans. So without a highlight |Ni - Nj|^2, UQ.9, is limited: its cube >> 7, times the square of the levels, to what
 * 26 degrees and 125 levels give, the most levels that count; and itself to 34 degrees, up to which the series in h are
 * accurate enough. Range: 2^16 * 125^2.
 */
#define MOST_DIFFUSE 135828125u
#define WIDEST_DIFFUSE 175
#define MOST_LEVELS 125

COLD uint8_t sheen_widest_diffuse(const struct colour_terms *t)
{
    const uint32_t sum = ((uint32_t)t->b[0] + t->b[1] + t->b[2]) >> (t->fraction - 15),
                   levels = sum < MOST_LEVELS ? sum : MOST_LEVELS;
    uint32_t widest = WIDEST_DIFFUSE;

    while ((widest * widest * widest >> 7) * levels * levels > MOST_DIFFUSE)
        widest--;
    return (uint8_t)widest;
}

COLD void sheen_reflection_begin(struct draw *d, const struct sheen_material *material,
                                 const struct pixel_format *format, const struct sheen_object *object,
                                 const struct sheen_pose *view)
{
    sheen_loop_begin(d, material, format, object, view);
    d->most_apart = sheen_widest_diffuse(&d->colour);
}

void sheen_keep_cosines(const struct draw *d, const int16_t normal[3], uint16_t kept[2])
{
    SHEEN_TAP(COSINES, 1);
    kept[0] = (uint16_t)cosine_of(normal, d->light.to[0]);
    kept[1] = (uint16_t)cosine_of(normal, d->light.view);
}

/* |a - b|^2, UQ2.30; for unit vectors with rounded components it stays below 2^32: at most 4,294,929,004. */
static uint32_t square_apart(const int16_t *a, const int16_t *b)
{
    uint32_t x = (uint32_t)(a[0] - b[0]), y = (uint32_t)(a[1] - b[1]), z = (uint32_t)(a[2] - b[2]);

    return x * x + y * y + z * z;
}

HOT uint32_t sheen_normals_apart(const int16_t *const n[3], uint32_t h[3])
{
    h[0] = square_apart(n[0], n[1]);
    h[1] = square_apart(n[0], n[2]);
    h[2] = square_apart(n[1], n[2]);
    uint32_t most = h[0] > h[1] ? h[0] : h[1];
    return most > h[2] ? most : h[2];
}

void sheen_face(struct facing *f, const struct surface_corners *c)
{
    UNROLLED
    for (int k = 0; k < 3; k++) {
        const uint16_t *kept = c->at.v[k]->kept;
        int32_t ln = (int16_t)kept[0], nv = (int16_t)kept[1];
        f->ln[k] = c->back ? -ln : ln;
        f->nv[k] = c->back ? -nv : nv;
    }
    f->apart = sheen_normals_apart(c->at.normal, f->h);
    f->kept = NULL;
    if (c->at.v[3] != NULL) {
        f->kept = c->at.v[3]->kept;
        f->apart *= QUAD_APART;
    }
}

HOT void sheen_face_light(struct facing *f, const int16_t *const normal[3], int back, const int32_t to[3])
{
    for (int k = 0; k < 3; k++) {
        const int32_t ln = cosine_of(normal[k], to);
        f->ln[k] = back ? -ln : ln;
    }
}

/*
 * Outside its triangle a quadric is off by up to 11 times as much as inside, at corner 3 of a square. As the error
 * grows with the cube of the angle, an angle in a quad counts as sqrt(5) times what it is (sheen_face). The diagonal
 * from corner 0 is at most twice as long as the longest edge, so if one corner has a highlight, u stays below
 * MOST_ARGUMENT everywhere.
 */
COLD uint8_t sheen_most_bend(const struct draw *d, uint32_t most)
{
    const int sharp = d->strong && d->power.shininess > 32;
    unsigned warp = BENDS;

    if (d->light.count != 1 || d->pixel_ramp || sharp)
        return 0;
    if (d->power.limit != 0 && widest_with_highlight(d) < most)
        most = widest_with_highlight(d);
    while (warp > 0 && ((uint32_t)sheen_bends[warp - 1] << 14) * QUAD_APART > most)
        warp--;
    return (uint8_t)warp;
}

/*
 * REFLECTION_LEAN is 2^18 / 8, so with weights that differ by at most 1/9 of the least one, what sheen_leans makes of
 * three corners stays below it. Their mean, as it computes it, is at most a step below the least weight.
 */
int sheen_reflects_whole(const struct screen *screen, const struct quad *q)
{
    const struct vertex *const *v = q->v, *const first = v[0];
    int32_t least = 0, most = 0;
    uint32_t extent = 0;

    UNROLLED
    for (int k = 1; k < 4; k++) {
        const int32_t z = v[k]->z - first->z;
        extent |= magnitude32(v[k]->x - first->x) | magnitude32(v[k]->y - first->y);
        least = min32(least, z);
        most = max32(most, z);
    }
    const unsigned bits = 32 - clz32(extent);
    const uint32_t weight = (uint32_t)(first->z + least) + z16_weight_offset(screen);
    return bits <= MOST_HIGHLIGHT_BITS && quadric_fits_area(bits, (uint32_t)q->area[0]) &&
           (screen->flat_weight || (weight > LEAST_MEAN && 9 * (uint32_t)(most - least) <= weight));
}

int32_t sheen_cosine_excess(int32_t first, int32_t second, int32_t h, int32_t lean)
{
    int32_t e = h + asr32(3 * h * h, 20);

    return asr32(e * (first + second) + lean * (first - second), 17);
}

HOT int sheen_setup_reflection(struct setup *s, const struct surface_corners *c, const struct gradients *g,
                               const struct facing *f)
{
    struct quadric_setup *q = (struct quadric_setup *)s;
    struct quadric_steps steps;
    struct excesses e;

    /* all dark: in the triangle L.N is a mean of the corners' times a positive factor */
    if (most3(f->ln) <= 0 && (f->kept == NULL || (int16_t)f->kept[0] <= 0) && !s->draw->pixel_ramp) {
        const struct lit dark = {0, 0};
        sheen_setup_constant(s, &dark);
        return 1;
    }
    if (f->apart > (uint32_t)s->draw->most_apart << 21 >> (s->draw->pixel_ramp >> 1) ||
        !way_wanted(s->draw, SHEEN_WAY_PHONG_QUADRATIC) || !sheen_leans(e.edges.lean, c, REFLECTION_LEAN))
        return 0;
    angle_excesses(&e, f);
    light_excesses(&e, f);
    int highlight = has_highlight(&e, f, s->draw, 0);
    if ((highlight && (g->bits > MOST_HIGHLIGHT_BITS || too_sharp(&e, f, s->draw))) || !sheen_quadric_steps(&steps, g))
        return 0;
    s->way = SHEEN_WAY_PHONG_QUADRATIC;
    sheen_take_quadric_rows(s, g, highlight ? SECOND_POWER : SECOND_NONE);
    light_quadric(&q->diffuse, &steps, f, &e);
    if (highlight)
        second_quadric(&q->second, &steps, &e, s->draw->power.up);
    return 1;
}
