/*
 * warp.c - how far the triangles of a mesh deviate from their polygons' normals and planes.
 */
#include "../math/bend.h"
#include "../math/fixed.h"
#include "../math/vector.h"

/* floor(sqrt(x)), x < 2^60. */
static uint32_t whole_root(uint64_t x)
{
    uint32_t root = 0;

    for (uint32_t bit = 1u << 29; bit != 0; bit >>= 1)
        if ((uint64_t)(root | bit) * (root | bit) <= x)
            root |= bit;
    return root;
}

static uint32_t corner_index(const struct sheen_mesh *mesh, uint32_t i)
{
    return mesh->index_bytes == 1 ? ((const uint8_t *)mesh->indices)[i] : ((const uint16_t *)mesh->indices)[i];
}

/* A triangle's unit normal, Q1.30; 0 where it has no area. Range: differences < 2^16.01, their products < 2^33.1. */
static int unit_normal(const int16_t *const corner[3], sheen_q30_t normal[3])
{
    int64_t cross[3];

    for (int k = 0; k < 3; k++) {
        int u = k == 2 ? 0 : k + 1, v = k == 0 ? 2 : k - 1;
        cross[k] = (int64_t)(corner[1][u] - corner[0][u]) * (corner[2][v] - corner[0][v]) -
                   (int64_t)(corner[1][v] - corner[0][v]) * (corner[2][u] - corner[0][u]);
    }
    return sheen_normalize_wide(cross, normal) == SHEEN_OK;
}

#define FLAT 2 /* the largest warp_of of a plane polygon's triangles; 1: nothing but rounding */

/*
 * The warp of one triangle, rounded up: how far its normal is off, plus the distance of its plane from `at`, the first
 * corner of its polygon; 56,756 raw units count as 1.0.
 */
static uint8_t warp_of(const int16_t *const corner[3], const int16_t polygon_normal[3], const int16_t at[3])
{
    sheen_q30_t normal[3];
    uint64_t square = 0;
    int64_t distance = 0; /* Q.30, < 2^17 raw units */

    if (!unit_normal(corner, normal))
        return 0;
    for (int k = 0; k < 3; k++) {
        int64_t off = (int64_t)normal[k] - polygon_normal[k] * 32769; /* 2^30 / 32767, less 2^-15 of it */
        if (off >= 1 << 29 || off <= -(1 << 29))
            return SHEEN_WARP_UNKNOWN;
        square += (uint64_t)(off * off);
        distance += (int64_t)normal[k] * (corner[0][k] - at[k]);
    }
    uint32_t away = (uint32_t)asr64(distance < 0 ? -distance : distance, 30) + 1;
    uint32_t warp = whole_root(square) + 8 + away * 18919; /* Q.30: 2^30 / 56756 = 18918.6; 8 for rounded parts */
    return (uint8_t)(warp >> 20 < SHEEN_WARP_UNKNOWN - 1 ? (warp >> 20) + 1 : SHEEN_WARP_UNKNOWN);
}

/*
 * 1 if triangles t and t + 1 are a fan of corners 0 to 3 over which vertex normals are linear: corner 3's normal is
 * the one that corners 0, 1, 2 extrapolate to, within LINEAR steps. Range: differences < 2^16.01, areas < 2^33.1,
 * products < 2^51.
 */
#define LINEAR 6

static int normals_are_linear(const struct sheen_mesh *mesh, uint32_t t)
{
    uint32_t corner[4];
    int64_t d[3][3], n[3][3], area[3] = {0, 0, 0};

    for (uint32_t k = 0; k < 3; k++)
        corner[k] = corner_index(mesh, 3 * t + k);
    corner[3] = corner_index(mesh, 3 * t + 5);
    if (corner_index(mesh, 3 * t + 3) != corner[0] || corner_index(mesh, 3 * t + 4) != corner[2])
        return 0;
    for (uint32_t k = 0; k < 3; k++)
        for (uint32_t i = 0; i < 3; i++) {
            d[k][i] = mesh->positions[3 * corner[k + 1] + i] - mesh->positions[3 * corner[0] + i];
            n[k][i] = mesh->normals[3 * corner[k + 1] + i] - mesh->normals[3 * corner[0] + i];
        }
    for (int k = 0; k < 3; k++) { /* twice the areas of 012, 013, 032 along the axis where 012 is largest */
        const int u = k == 2 ? 0 : k + 1, v = k == 0 ? 2 : k - 1;
        const int64_t base = d[0][u] * d[1][v] - d[0][v] * d[1][u];
        if ((base < 0 ? -base : base) <= (area[0] < 0 ? -area[0] : area[0]))
            continue;
        area[0] = base;
        area[1] = d[0][u] * d[2][v] - d[0][v] * d[2][u];
        area[2] = d[2][u] * d[1][v] - d[2][v] * d[1][u];
    }
    if (area[0] == 0) /* corners 0, 1, 2, which quadrics are made from, say nothing of what is off their line */
        return 0;
    for (int i = 0; i < 3; i++) { /* from corner 0, corner 3 is (area[2] * corner 1 + area[1] * corner 2) / area[0] */
        const int64_t off = n[2][i] * area[0] - n[0][i] * area[2] - n[1][i] * area[1];
        if ((off < 0 ? -off : off) > LINEAR * (area[0] < 0 ? -area[0] : area[0]))
            return 0;
    }
    return 1;
}

/* The least warp that triangles t and t + 1 leave a plane polygon: how far apart their corners' normals are. */
static uint8_t plane_warp(const struct sheen_mesh *mesh, uint32_t t)
{
    const uint32_t order[4] = {0, 1, 2, 5};
    uint64_t most = 0;
    uint8_t warp = 1;

    if (!normals_are_linear(mesh, t))
        return SHEEN_WARP_PLANE;
    for (uint32_t k = 1; k < 4; k++)
        for (uint32_t i = 0; i < k; i++) {
            const int16_t *a = mesh->normals + 3 * corner_index(mesh, 3 * t + order[k]),
                          *b = mesh->normals + 3 * corner_index(mesh, 3 * t + order[i]);
            const int64_t x = a[0] - b[0], y = a[1] - b[1], z = a[2] - b[2], square = x * x + y * y + z * z;
            most = (uint64_t)square > most ? (uint64_t)square : most;
        }
    while (warp <= BENDS && most > (uint64_t)sheen_bends[warp - 1] << 14)
        warp++;
    return warp;
}

void sheen_mesh_warp(const struct sheen_mesh *mesh, uint32_t polygon_count, uint8_t *warp)
{
    uint32_t polygon = UINT32_MAX;
    const int16_t *at = mesh->positions;

    for (uint32_t p = 0; p < polygon_count; p++)
        warp[p] = 0;
    for (uint32_t t = 0; t < mesh->triangles; t++) {
        const int16_t *corner[3];
        for (uint32_t k = 0; k < 3; k++)
            corner[k] = mesh->positions + 3 * corner_index(mesh, 3 * t + k);
        uint32_t own = mesh->polygons != NULL ? mesh->polygons[t] : t;
        if (own != polygon)
            at = corner[0];
        polygon = own;
        uint8_t here = warp_of(corner, mesh->polygon_normals + 3 * polygon, at);
        if (here > FLAT)
            here = here > SHEEN_WARP_PLANE ? here : SHEEN_WARP_PLANE + 1;
        else if (here == FLAT)
            here = SHEEN_WARP_PLANE;
        else if (mesh->normals != NULL && mesh->polygons != NULL && t + 1 < mesh->triangles &&
                 mesh->polygons[t + 1] == own)
            here = plane_warp(mesh, t);
        warp[polygon] = here > warp[polygon] ? here : warp[polygon];
    }
}
