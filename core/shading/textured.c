/*
 * textured.c - textures: texel coordinates and light at the corners (lecture, "Fixing Distortion").
 */
#include "../triangle/textured.h"
#include "shading.h"

static void textured_begin(struct draw *d, const struct sheen_material *material, const struct pixel_format *format,
                           const struct sheen_object *object, const struct sheen_pose *view)
{
    (void)object;
    (void)view;
    sheen_colour_reach(&d->colour, format);
    sheen_texel_begin(&d->texel, format, material, d->light.diffuse_sum, d->light.specular_sum);
}

/*
 * u, v, and how many bits finer than the mesh's they are: as many as fit. Cut corners lie between the mesh's own steps,
 * which may be as large as a picture.
 */
static void textured_carry(const struct draw *d, uint16_t triangle, int back, int16_t out[3][3])
{
    int finer = 15 - d->mesh->uv_bits;

    (void)back;
    for (uint32_t k = 0; k < 3; k++) {
        const int16_t *uv = d->mesh->uvs + 2 * mesh_index(d->mesh, 3u * triangle + k);
        for (int i = 0; i < 2; i++) {
            out[k][i] = uv[i];
            while (asr32(uv[i] * (1 << finer), 15) != asr32(uv[i], 15)) /* more than 16 bits */
                finer--;
        }
    }
    for (int k = 0; k < 3; k++) {
        out[k][0] = (int16_t)(out[k][0] * (1 << finer));
        out[k][1] = (int16_t)(out[k][1] * (1 << finer));
        out[k][2] = (int16_t)finer;
    }
}

HOT static void textured_as(struct setup *s, struct surface_corners *c, const struct gradients *g,
                            const struct lit lit[3])
{
    const struct draw *d = s->draw;
    const struct colour_terms *colour = &d->colour;
    struct at_corners at[4];
    int32_t diffuse[2], specular[2];
    const unsigned finer = (c->at.v[0]->flags & LIT_AS_SEEN) != 0 ? (unsigned)c->at.normal[0][2] : 0;

    sheen_texels_of(&at[0], d, d->texel.texture, &c->at, 0, finer);
    sheen_texels_of(&at[1], d, d->texel.texture, &c->at, 1, finer);
    for (int k = 0; k < 3; k++) {
        at[2].f[k] = texel_light(&d->texel, lit[k].diffuse);
        at[3].f[k] = (int32_t)(d->texel.white ? lit[k].specular * d->texel.gloss >> (30 - LIGHT_BITS)
                                              : lit[k].specular << (LIGHT_BITS - 15));
    }
    for (int k = 0; k < 2; k++) {
        diffuse[k] = (int32_t)(lit[k + 1].diffuse - lit[0].diffuse);
        specular[k] = (int32_t)(lit[k + 1].specular - lit[0].specular);
    }
    sheen_setup_textured(s, c, g, at,
                         sheen_straight(c, diffuse[0], diffuse[1], colour->diffuse_tolerance / 2) &&
                             sheen_straight(c, specular[0], specular[1], 4u * colour->faint_specular));
}

static void textured_setup(struct setup *s, struct surface_corners *c, const struct gradients *g)
{
    struct lit lit[3] = {{0, 0}, {0, 0}, {0, 0}};

    if (!s->draw->texel.unlit) {
        const struct sheen_mesh *mesh = s->draw->mesh;
        const int16_t *normal[3];
        for (int k = 0; k < 3; k++) /* corners of pieces have no normals and need none */
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

/* A vertex keeps its intensities; they are 0 if the draw is unlit. */
static void textured_light(const struct draw *d, const int16_t normal[3], uint16_t kept[2])
{
    struct lit lit = {0, 0};

    if (!d->texel.unlit)
        light_normal(&d->light, &d->power, normal, &lit);
    kept[0] = (uint16_t)lit.diffuse;
    kept[1] = (uint16_t)lit.specular;
}

const struct sheen_shader sheen_textured = {.begin = textured_begin,
                                            .light = textured_light,
                                            .carry = textured_carry,
                                            .setup = textured_setup,
                                            .needs_normals = 1,
                                            .takes = sheen_texture_valid,
                                            .needs_uvs = 1,
                                            .corners = OF_MESH(uvs)};

const struct sheen_shader sheen_textured_flat = {.begin = textured_begin,
                                                 .carry = textured_carry,
                                                 .setup = textured_flat_setup,
                                                 .takes = sheen_texture_valid,
                                                 .needs_uvs = 1,
                                                 .corners = OF_MESH(uvs)};
