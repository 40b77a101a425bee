/*
 * tinted_quadrics.c - pixels that have a colour each, lit by lights that may have colours, on triangles whose corner
 * normals nearly agree: L.N and 1 - R.V of each light are quadratic, and so are the channels of the vertices' colours.
 * There is no root and no reciprocal per pixel.
 *
 * A set-up has no room for that many quadrics. It keeps what they are made from, and rows make them, once per band.
 */
#include "excess.h"
#include "tinted.h"

#define MOST_QUADRICS 7 /* two lights that both have a highlight, over coloured vertices */

/* What quadrics are made from, of struct gradients. */
struct kept_gradients {
    int16_t b1[2], b2[2], centre[2], origin[2];
    uint8_t exponent; /* LOWEST_SCALE..24 */
    int8_t stretch;   /* -32..QUADRIC_STRETCH */
};

struct tinted_quadrics_setup {
    struct setup s; /* detail: SHARES_BACK */
    union shared_triangle of;
    struct edge_terms edges;
    int16_t ln[3], nv[3]; /* the first light's, as in struct facing */
    struct kept_gradients g;
    uint8_t lit, shines; /* one bit per light: it lights some of the triangle; it may have a highlight there */
};
SETUP_FITS(struct tinted_quadrics_setup);

static void keep_gradients(struct kept_gradients *kept, const struct gradients *g)
{
    for (int i = 0; i < 2; i++) {
        kept->b1[i] = (int16_t)g->b1[i];
        kept->b2[i] = (int16_t)g->b2[i];
        kept->centre[i] = g->centre[i];
        kept->origin[i] = (int16_t)g->origin[i];
    }
    kept->exponent = (uint8_t)g->exponent;
    kept->stretch = (int8_t)g->stretch;
}

static void gradients_of(struct gradients *g, const struct kept_gradients *kept)
{
    for (int i = 0; i < 2; i++) {
        g->b1[i] = kept->b1[i];
        g->b2[i] = kept->b2[i];
        g->centre[i] = kept->centre[i];
        g->origin[i] = kept->origin[i];
    }
    g->exponent = kept->exponent;
    g->stretch = kept->stretch;
}

static inline unsigned bits_of(unsigned lights)
{
    unsigned bits = 0;

    for (; lights != 0; lights &= lights - 1)
        bits++;
    return bits;
}

/* ---- set-up ---- */

/* Adds to ambient light what a ramp's low gives by lights of these colours, because it is the same all over a draw. */
static COLD void add_low(struct draw *d)
{
    for (int k = 0; k < 3; k++) {
        uint32_t all = 0; /* UQ1.15: weights sum to 1.0 */
        for (unsigned i = 0; i < d->light.count; i++)
            all += by_colour(d->light.diffuse_weight[i], d->tint.color[i][k]);
        d->colour.a[k] += mul_high(d->tint.low[k], all << 16) * 2;
    }
}

COLD void sheen_tinted_quadrics_begin(struct draw *d, const struct sheen_material *material,
                                      const struct pixel_format *format, const struct sheen_object *object,
                                      const struct sheen_pose *view)
{
    sheen_glow_begin(d, material, format, object, view);
    add_low(d);
    d->most_apart = sheen_widest_diffuse(&d->colour);
}

/* Finds the lights that need quadrics; returns 0 if a highlight is too much for quadrics, or too many are needed. */
static int choose_lights(struct tinted_quadrics_setup *q, const struct surface_corners *c, const struct gradients *g,
                         struct facing *f, struct excesses *e)
{
    const struct draw *d = q->s.draw;
    unsigned lit = 0, shines = 0;

    for (unsigned i = 0; i < d->light.count; i++) {
        if (i > 0)
            sheen_face_light(f, c->at.normal, c->back, d->light.to[i]);
        const int dark = most3(f->ln) <= 0;
        lit |= (unsigned)(!dark || d->pixel_ramp) << i;
        if (dark || !has_highlight(e, f, d, i))
            continue;
        shines |= 1u << i;
        if (g->bits > MOST_HIGHLIGHT_BITS || too_sharp(e, f, d))
            return 0;
    }
    q->lit = (uint8_t)lit;
    q->shines = (uint8_t)shines;
    return bits_of(lit) + bits_of(shines) + (d->mesh->colors != NULL ? 3 : 0) <= MOST_QUADRICS;
}

HOT int sheen_setup_tinted_quadrics(struct setup *s, const struct surface_corners *c, const struct gradients *g,
                                    uint32_t widest)
{
    struct tinted_quadrics_setup *q = (struct tinted_quadrics_setup *)s;
    const struct draw *d = s->draw;
    struct facing f;
    struct excesses e;

    if (!way_wanted(d, SHEEN_WAY_PHONG_QUADRATIC) || !quadric_fits(g->exponent, g->stretch))
        return 0;
    sheen_face(&f, c);
    if (f.apart > widest >> (d->pixel_ramp >> 1) || !sheen_leans(e.edges.lean, c, REFLECTION_LEAN))
        return 0;
    angle_excesses(&e, &f);
    q->edges = e.edges;
    for (int k = 0; k < 3; k++) {
        q->ln[k] = (int16_t)f.ln[k];
        q->nv[k] = (int16_t)f.nv[k];
    }
    if (!choose_lights(q, c, g, &f, &e))
        return 0;
    keep_gradients(&q->g, g);
    q->of.own = c->at.triangle;
    s->detail = (uint8_t)(c->back ? SHARES_BACK : 0);
    s->way = SHEEN_WAY_PHONG_QUADRATIC;
    s->rows = sheen_tinted_quadric_rows;
    return 1;
}

/* ---- rows ---- */

/* A quadric stepped along a row: its value at a pixel, and its first and second difference. */
struct walk {
    uint32_t at, step, bend;
};

/* A triangle's quadrics as a pixel reads them: L.N of the lights, colours, 1 - R.V of the lights that shine. */
struct tinted_quadrics {
    struct tinted_beam beam[SHEEN_MAX_LIGHTS]; /* of the lights that reach the triangle */
    uint8_t shine[SHEEN_MAX_LIGHTS];           /* which entries of beam shine: have a highlight */
    uint8_t lights, shines, colored, count;
    uint32_t power_end; /* as in struct loop_terms */
    struct quadric of[MOST_QUADRICS];
};

/* Fills in which lights there are, and so how many quadrics. */
static void begin_quadrics(struct tinted_quadrics *to, const struct tinted_quadrics_setup *q)
{
    const struct draw *d = q->s.draw;

    to->lights = to->shines = 0;
    for (unsigned i = 0; q->lit >> i != 0; i++) {
        if ((q->shines >> i & 1) != 0)
            to->shine[to->shines++] = to->lights;
        if ((q->lit >> i & 1) != 0)
            sheen_tinted_beam(&to->beam[to->lights++], d, i);
    }
    to->colored = d->mesh->colors != NULL;
    to->count = (uint8_t)(to->lights + (to->colored ? 3 : 0) + to->shines);
    SHEEN_TAP(TINTED_QUADRIC, to->count);
    to->power_end = d->power.limit > 0 ? (d->power.limit << d->power.up) + POWER_GUARD : 0;
}

/* normal: for the side that is seen, in the gradients' order of corners. */
static void make_lights(struct tinted_quadrics *to, const struct tinted_quadrics_setup *q,
                        const struct quadric_steps *steps, const int16_t *const normal[3])
{
    const struct draw *d = q->s.draw;
    struct quadric *light = to->of, *shine = light + to->count - to->shines;
    struct facing f;
    struct excesses e;

    e.edges = q->edges;
    for (int k = 0; k < 3; k++) {
        f.ln[k] = q->ln[k];
        f.nv[k] = q->nv[k];
    }
    for (unsigned i = 0; q->lit >> i != 0; i++) {
        if ((q->lit >> i & 1) == 0)
            continue;
        if (i > 0)
            sheen_face_light(&f, normal, 0, d->light.to[i]);
        light_excesses(&e, &f);
        light_quadric(light++, steps, &f, &e);
        if ((q->shines >> i & 1) == 0)
            continue;
        reflected_corners(&e, &f, d->light.lv1[i]);
        reflected_excesses(&e, &f);
        second_quadric(shine++, steps, &e, d->power.up);
    }
}

static void make_colors(struct tinted_quadrics *to, const struct tinted_quadrics_setup *q,
                        const struct quadric_steps *steps, const unsigned order[3])
{
    int16_t color[3][3];

    sheen_shared_colors(&q->s, q->of, color);
    for (int k = 0; k < 3; k++) {
        const int32_t f[3] = {color[order[0]][k], color[order[1]][k], color[order[2]][k]};
        sheen_space_quadric(&to->of[to->lights + k], steps, q->edges.lean, f);
    }
}

/* Makes the quadrics, at column 0 of row y. normal: in the mesh's order of corners. */
HOT static APART void make_quadrics(struct tinted_quadrics *to, const struct tinted_quadrics_setup *q,
                                    int16_t normal[3][3], int32_t y)
{
    const int back = (q->s.detail & SHARES_BACK) != 0;
    const unsigned order[3] = {0, back ? 1 : 2, back ? 2 : 1}; /* the mesh's corners in the gradients' order */
    struct gradients g;
    struct quadric_steps steps;

    gradients_of(&g, &q->g);
    (void)sheen_quadric_steps(&steps, &g); /* returns 1, because the set-up has made sure of that */
    make_lights(to, q, &steps, (const int16_t *const[3]){normal[order[0]], normal[order[1]], normal[order[2]]});
    if (to->colored)
        make_colors(to, q, &steps, order);
    for (struct quadric *own = to->of, *end = own + to->count; own < end; own++)
        sheen_quadric_from(own, own, -q->g.origin[0], y - q->g.origin[1]);
}

SPECIALISED uint32_t walk_on(struct walk *w)
{
    const uint32_t at = w->at, step = w->step;

    w->at = at + step;
    w->step = step + w->bend;
    return at;
}

/* From Q1.30 plus half a step to UQ1.15; clamped at 0, because rounding may go below it. */
SPECIALISED uint32_t walk_colour(struct walk *w)
{
    return not_negative(walk_on(w)) >> 15;
}

/* The channels at a pixel; all quadrics are stepped to the next one. */
SPECIALISED struct channels pixel_channels(const struct draw *d, const struct tinted_quadrics *q, struct walk *w)
{
    struct channels c = ambient_channels(d);
    uint32_t front[SHEEN_MAX_LIGHTS], *to = front;

    for (const struct tinted_beam *beam = q->beam, *end = beam + q->lights; beam < end; beam++) {
        const int32_t ln = asr32((int32_t)walk_on(w++), 15);
        *to = (uint32_t)max32(ln, 0);
        add_light(&c, beam->base, d->pixel_ramp ? response_at(d->light.ramp, ln) : *to);
        to++;
    }
    if (q->colored) {
        c.r = times_colour(c.r, walk_colour(w++));
        c.g = times_colour(c.g, walk_colour(w++));
        c.b = times_colour(c.b, walk_colour(w++));
    }
    for (const uint8_t *n = q->shine, *end = n + q->shines; n < end; n++) {
        const uint32_t u = walk_on(w++);
        SHEEN_TAP(HIGHLIGHT, u < q->power_end);
        if (u < q->power_end)
            add_light(&c, q->beam[*n].gloss, faded(power_entry(d->power.table, u), front[*n]));
    }
    return c;
}

static void quadric_pixels(const struct tile *t, const struct setup *s, const struct tinted_quadrics *q, int32_t x,
                           int32_t x1, int32_t y)
{
    const struct draw *d = s->draw;
    const struct rounding rounding = rounding_of(t, &d->colour, y);
    struct walk walk[MOST_QUADRICS];
    uint32_t at = tile_offset(t, x, y), z = plane_at(&s->depth, x, y);

    SHEEN_TAP(TINTED_STEP, (x1 - x) * q->count);
    for (unsigned i = 0; i < q->count; i++)
        quadric_run(&q->of[i], x, &walk[i].at, &walk[i].step, &walk[i].bend);
    for (; x < x1; x++, at++, z += s->depth.dx) {
        if (nearer(t, t->depth + at, z)) {
            put_tinted(t, d, rounding, at, x, z, pixel_channels(d, q, walk));
            continue;
        }
        for (struct walk *w = walk, *end = w + q->count; w < end; w++)
            (void)walk_on(w);
    }
}

/* APART from make_quadrics, so that the stack never holds the locals of both. */
HOT static APART void draw_quadrics(const struct tile *t, const struct setup *s, struct tinted_quadrics *q)
{
    for (unsigned row = 0; row < t->rows; row++) {
        const int32_t x = t->spans[row].x0, x1 = t->spans[row].x1, y = t->first_row + (int32_t)row;
        if (x < x1)
            quadric_pixels(t, s, q, x, x1, y);
        for (struct quadric *of = q->of, *end = of + q->count; of < end; of++)
            quadric_down(of);
    }
}

void sheen_tinted_quadric_rows(const struct tile *t, const struct setup *s)
{
    const struct tinted_quadrics_setup *own = (const struct tinted_quadrics_setup *)s;
    struct tinted_quadrics q;
    int16_t normal[3][3];

    if (own->lit > 1) /* lights other than the first need normals */
        sheen_shared_normals(s, own->of, normal);
    begin_quadrics(&q, own);
    make_quadrics(&q, own, normal, t->first_row);
    draw_quadrics(t, s, &q);
}
