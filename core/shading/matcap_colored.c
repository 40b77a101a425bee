/*
 * matcap_colored.c - matcaps times colours of vertices: the normal or the texel coordinates, and the colour, are
 * interpolated with the corners' shares.
 */
#include "../triangle/colored_texels.h"
#include "../triangle/normal.h"
#include "matcap.h"

/* There are no lights: ambient light of 1.0 shows the base colour as it is. */
static COLD void matcap_colored_begin(struct draw *d, const struct sheen_material *material,
                                      const struct pixel_format *format, const struct sheen_object *object,
                                      const struct sheen_pose *view)
{
    const struct sheen_material unlit = {.base = {material->base[0], material->base[1], material->base[2]},
                                         .ambient = 1 << 16};

    (void)object;
    (void)view;
    sheen_colour_begin(&d->colour, format, &unlit, 0, 0);
    d->tint.texture = material->texture;
}

static void texel_of_cosines(const struct sheen_texture *t, int32_t x, int32_t y, uint32_t at[])
{
    at[0] = (uint32_t)texel_at_cosine(x, t->width_log2, TEXEL_EDGE);
    at[1] = (uint32_t)texel_at_cosine(-y, t->height_log2, TEXEL_EDGE);
}

HOT static void texel_of_unit(const struct sheen_texture *t, const uint32_t normal[3], uint32_t at[])
{
    int32_t x, y;

    cosines_of(normal, &x, &y);
    texel_of_cosines(t, x, y, at);
}

/* by_pixel: normals are interpolated over the triangle, else texel coordinates. */
HOT static APART void matcap_corners(const struct setup *s, int by_pixel, struct texel_corners *corners)
{
    const struct lighting *l = &s->draw->light;
    const sheen_q30_t *const axis[3] = {l->to[0], l->to[1], l->view};
    const struct shares_setup *q = (const struct shares_setup *)s;
    int16_t normal[3][3];
    struct glow glow[3];

    sheen_shared_normals(s, q->of, normal);
    for (int k = 0; k < 3; k++) {
        int32_t n[3];
        uint32_t at[2];
        for (int i = 0; i < 3; i++) {
            n[i] = cosine_of(normal[k], axis[i]);
            glow[k].base[i] = s->draw->colour.a[i];
            glow[k].highlight[i] = 0;
        }
        texel_of_cosines(s->draw->tint.texture, n[0], n[1], at);
        for (int i = 0; i < 3; i++)
            corners->place[i].f[k] = by_pixel || i == 2 ? n[i] : (int32_t)at[i];
    }
    sheen_color_corners(corners, q, glow);
}

static void draw_matcap(const struct tile *t, const struct setup *s, int by_pixel)
{
    struct texel_corners corners = {.texel_of = by_pixel ? texel_of_unit : NULL};

    matcap_corners(s, by_pixel, &corners);
    sheen_colored_texels(t, s, &corners);
}

static void matcap_colored_rows(const struct tile *t, const struct setup *s)
{
    draw_matcap(t, s, 1);
}

static void matcap_vertex_colored_rows(const struct tile *t, const struct setup *s)
{
    draw_matcap(t, s, 0);
}

static void matcap_colored_setup(struct setup *s, struct surface_corners *c, const struct gradients *g)
{
    sheen_setup_shares((struct shares_setup *)s, c, g);
    s->way = SHEEN_WAY_MATCAP_NORMALS;
    s->special_loop = 0;
    s->rows = matcap_colored_rows;
}

static void matcap_vertex_colored_setup(struct setup *s, struct surface_corners *c, const struct gradients *g)
{
    sheen_setup_shares((struct shares_setup *)s, c, g);
    s->way = SHEEN_WAY_TEXTURED_QUOTIENT;
    s->special_loop = 0;
    s->rows = matcap_vertex_colored_rows;
}

const struct sheen_shader sheen_matcap_colored = {.begin = matcap_colored_begin,
                                                  .carry = sheen_carry_shares,
                                                  .setup = matcap_colored_setup,
                                                  .axes = eye_axes,
                                                  .needs_normals = 1,
                                                  .takes = sheen_sphere_valid};

const struct sheen_shader sheen_matcap_vertex_colored = {.begin = matcap_colored_begin,
                                                         .carry = sheen_carry_shares,
                                                         .setup = matcap_vertex_colored_setup,
                                                         .axes = eye_axes,
                                                         .needs_normals = 1,
                                                         .takes = sheen_sphere_valid};
