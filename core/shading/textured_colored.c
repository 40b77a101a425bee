/*
 * textured_colored.c - textures under coloured lights and point lights, with vertices' colours: light at a corner has
 * three channels, and a highlight, which is not multiplied by texels, has three more.
 */
#include "../triangle/colored_texels.h"
#include "shading.h"

/* Light at the corners: from the vertices' normals, or (is_flat) at all of them from the polygon's. */
static void corners_glow(const struct setup *s, uint32_t triangle, int is_flat, struct glow glow[3])
{
    const int back = s->detail & SHARES_BACK;

    if (is_flat) {
        sheen_polygon_glow(s->draw, (uint16_t)triangle, back, &glow[0]);
        glow[1] = glow[2] = glow[0];
        return;
    }
    for (uint32_t k = 0; k < 3; k++)
        sheen_vertex_glow(s->draw, 3 * (ptrdiff_t)mesh_index(s->draw->mesh, 3 * triangle + k), back, &glow[k]);
}

/* APART, so that its variables have left the stack when texels are drawn. */
static APART void corners_of(const struct setup *s, int is_flat, struct texel_corners *corners)
{
    const struct shares_setup *q = (const struct shares_setup *)s;
    const struct sheen_mesh *mesh = s->draw->mesh;
    const uint32_t triangle = shared_triangle_of(s, q->of);
    struct corners at;
    struct glow glow[3];

    for (uint32_t k = 0; k < 3; k++)
        at.normal[k] = mesh->uvs + 2 * mesh_index(mesh, 3 * triangle + k);
    for (int i = 0; i < 2; i++)
        sheen_texels_of(&corners->place[i], s->draw, s->draw->tint.texture, &at, i, 0);
    if (!s->draw->tint.texture->bilinear)
        sheen_inset_corners(corners->place, BORDER_BIAS);
    for (int i = 0; i < 2; i++)
        sheen_mix_corners(&corners->place[i], q);
    corners_glow(s, triangle, is_flat, glow);
    sheen_color_corners(corners, q, glow);
}

static void draw_texels(const struct tile *t, const struct setup *s, int is_flat)
{
    struct texel_corners corners = {.texel_of = NULL};

    corners_of(s, is_flat, &corners);
    sheen_colored_texels(t, s, &corners);
}

static void textured_colored_rows(const struct tile *t, const struct setup *s)
{
    draw_texels(t, s, 0);
}

static void textured_flat_colored_rows(const struct tile *t, const struct setup *s)
{
    draw_texels(t, s, 1);
}

static void shares_as(struct setup *s, struct surface_corners *c, const struct gradients *g,
                      void (*rows)(const struct tile *t, const struct setup *s))
{
    sheen_setup_shares((struct shares_setup *)s, c, g);
    s->way = SHEEN_WAY_TEXTURED_QUOTIENT;
    s->special_loop = 0;
    s->rows = rows;
}

static void textured_colored_setup(struct setup *s, struct surface_corners *c, const struct gradients *g)
{
    shares_as(s, c, g, textured_colored_rows);
}

static void textured_flat_colored_setup(struct setup *s, struct surface_corners *c, const struct gradients *g)
{
    shares_as(s, c, g, textured_flat_colored_rows);
}

const struct sheen_shader sheen_textured_colored = {.begin = sheen_glow_begin,
                                                    .carry = sheen_carry_shares,
                                                    .setup = textured_colored_setup,
                                                    .lights = LIGHTS_ALL,
                                                    .needs_normals = 1,
                                                    .takes = sheen_texture_valid,
                                                    .needs_uvs = 1};

const struct sheen_shader sheen_textured_flat_colored = {.begin = sheen_glow_begin,
                                                         .carry = sheen_carry_shares,
                                                         .setup = textured_flat_colored_setup,
                                                         .lights = LIGHTS_ALL,
                                                         .takes = sheen_texture_valid,
                                                         .needs_uvs = 1};
