/*
 * shares.c - shares of a triangle's corners: their set-up, what pieces carry of them, and the normals and colours at
 * the corners that rows weight by them.
 */
#include "shares.h"
#include "morph.h"

SETUP_FITS(struct shares_setup);

#define WHOLE_SHARE 32767

void sheen_carry_shares(const struct draw *d, uint16_t triangle, int back, int16_t out[3][3])
{
    (void)d;
    (void)back;
    for (int k = 0; k < 3; k++) {
        out[k][0] = k == 1 ? WHOLE_SHARE : 0;
        out[k][1] = k == 2 ? WHOLE_SHARE : 0;
        out[k][2] = (int16_t)triangle; /* the same at any corner of a piece, where shares sum to 1.0 within 2^-26 */
    }
}

/* The plane of values at the corners, |value| < 2^30; g NULL: their mean. */
static APART struct plane share_plane(const struct gradients *g, const int32_t value[3])
{
    if (g != NULL)
        return sheen_gradient_plane(g, value, 0);
    return (struct plane){QUOTIENT((uint32_t)value[0] + (uint32_t)value[1] + (uint32_t)value[2], 3u), 0, 0};
}

/*
 * The most that a weight may be, UQ2.30, unless all are equal: above 1.0 there is no room, and the plane's rounding
 * adds up to half a step per pixel, more only on needles.
 */
#define MOST_SHARED ((1 << 30) - (1 << 10))

void sheen_setup_shares(struct shares_setup *s, struct surface_corners *c, const struct gradients *g)
{
    const int piece = (c->at.v[0]->flags & LIT_AS_SEEN) != 0;

    s->s.detail = (uint8_t)((c->back ? SHARES_BACK : 0) | (piece ? SHARES_PIECE : 0));
    if (piece)
        s->of.piece = (const int16_t(*)[3])c->at.normal[0];
    else
        s->of.own = c->at.triangle;
    sheen_weigh(c);
    const int32_t most = c->flat_weight ? INT32_MAX : MOST_SHARED;
    const int32_t weight[3] = {min32((int32_t)(c->weight[0] >> 2), most), min32((int32_t)(c->weight[1] >> 2), most),
                               min32((int32_t)(c->weight[2] >> 2), most)};
    s->shares.weight = share_plane(g, weight);
    for (int k = 1; k < 3; k++) { /* k: in the mesh's order, which back faces have; others are turned over */
        int32_t part[3] = {0, 0, 0};
        const int at = c->back ? k : 3 - k;
        part[at] = weight[at];
        s->shares.part[k - 1] = share_plane(g, part);
    }
}

/*
 * Turns numbers at the mesh triangle's corners into those at a piece's. Range: shares sum to 1.0, so the sum of
 * |difference| * share is below 2^31, within rounding.
 */
static APART void of_piece(const int16_t (*piece)[3], int16_t number[3][3])
{
    for (int i = 0; i < 3; i++) {
        const int32_t first = number[0][i], d1 = number[1][i] - first, d2 = number[2][i] - first;
        for (int k = 0; k < 3; k++) {
            const int32_t more = d1 * piece[k][0] + d2 * piece[k][1]; /* in units of 1/32767 */
            number[k][i] = (int16_t)(first + asr32(asr32(more, 14) + asr32(more, 29) + 1, 1));
        }
    }
}

static const struct sheen_mesh *mesh_of(const struct setup *s, union shared_triangle of, uint32_t index[3])
{
    const struct sheen_mesh *mesh = s->draw->mesh;
    const uint32_t triangle = shared_triangle_of(s, of);

    for (uint32_t k = 0; k < 3; k++)
        index[k] = 3 * mesh_index(mesh, 3 * triangle + k);
    return mesh;
}

HOT void sheen_shared_normals(const struct setup *s, union shared_triangle of, int16_t normal[3][3])
{
    uint32_t index[3];
    const struct sheen_mesh *mesh = mesh_of(s, of, index);

    for (int k = 0; k < 3; k++) {
        int16_t store[3];
        const int16_t *n = normal_of(s->draw, mesh->normals + index[k], store);
        for (int i = 0; i < 3; i++) {
            const int32_t part = max32(n[i], -32767);
            normal[k][i] = (int16_t)((s->detail & SHARES_BACK) != 0 ? -part : part);
        }
    }
    if ((s->detail & SHARES_PIECE) != 0)
        of_piece(of.piece, normal);
}

HOT void sheen_shared_colors(const struct setup *s, union shared_triangle of, int16_t color[3][3])
{
    uint32_t index[3];
    const struct sheen_mesh *mesh = mesh_of(s, of, index);

    for (int k = 0; k < 3; k++)
        for (int i = 0; i < 3; i++)
            color[k][i] = (int16_t)(mesh->colors != NULL ? mesh->colors[index[k] + (uint32_t)i] * 257 >> 1 : 32767);
    if ((s->detail & SHARES_PIECE) != 0)
        of_piece(of.piece, color);
}
