/*
 * averages.c - the normals of vertices: averages over the polygons around them (at load or when a mesh moves).
 */
#include "../math/fixed.h"
#include "../sheen.h"
#include "normals.h"

int sheen_polygons_around(const struct sheen_polygon_list *list, uint32_t *around)
{
    uint32_t *begin = around, *polygons = around + list->point_count + 1, all = 0;

    for (uint32_t p = 0; p < list->polygon_count; p++) {
        if (list->sizes[p] < 3 || list->sizes[p] > list->corner_count - all)
            return SHEEN_ERR_ARGUMENT;
        all += list->sizes[p];
    }
    if (all != list->corner_count)
        return SHEEN_ERR_ARGUMENT;
    for (uint32_t v = 0; v <= list->point_count; v++)
        begin[v] = 0;
    for (uint32_t c = 0; c < all; c++) {
        if (list->corners[c] >= list->point_count)
            return SHEEN_ERR_ARGUMENT;
        begin[list->corners[c]]++;
    }
    /* Counts become ends; filled from the last corner back, ends become beginnings, lists in the corners' order. */
    for (uint32_t v = 1; v <= list->point_count; v++)
        begin[v] += begin[v - 1];
    for (uint32_t p = list->polygon_count, c = all; p-- > 0;)
        for (uint32_t first = c - list->sizes[p]; c > first;)
            polygons[--begin[list->corners[--c]]] = p;
    return SHEEN_OK;
}

void sheen_polygon_normals(const struct sheen_polygon_list *list, sheen_q30_t *normals)
{
    const uint32_t *corners = list->corners;

    for (uint32_t p = 0; p < list->polygon_count; corners += list->sizes[p++], normals += 3)
        if (sheen_polygon_normal(list->points, corners, list->sizes[p], normals) != SHEEN_OK)
            normals[0] = normals[1] = normals[2] = 0;
}

/*
 * Cosines are compared with this slack, raw steps of Q1.30: two unit normals are off by at most 7 each (4 in each
 * part), the limit by 3, so that "within 60 degrees" keeps 60.
 */
#define CREASE_SLACK 18

/*
 * Range: unit normals, so |a.b| * 2^60 < 2^61 and its rounding to Q1.30 fits; the sum of fewer than 2^32 parts of
 * 2^30 + 4 stays below 2^63.
 */
static int is_within(const sheen_q30_t a[3], const sheen_q30_t b[3], int64_t least)
{
    int64_t dot = (int64_t)a[0] * b[0] + (int64_t)a[1] * b[1] + (int64_t)a[2] * b[2];

    return round_shift64(dot, 30) >= least;
}

/*
 * The average around point v, of those within the crease of the normal `own`, or of all where own is NULL. Zero
 * where the sum is not above its own rounding, 4 raw steps a normal.
 */
static void average(const struct sheen_polygon_list *list, const uint32_t *around, const sheen_q30_t *normals,
                    uint32_t v, const sheen_q30_t *own, int64_t least, sheen_q30_t out[3])
{
    const uint32_t *polygons = around + list->point_count + 1;
    int64_t sum[3] = {0, 0, 0}, rounding = 0;

    for (uint32_t i = around[v]; i < around[v + 1]; i++) {
        const sheen_q30_t *normal = normals + 3 * (size_t)polygons[i];
        if (own && !is_within(own, normal, least))
            continue;
        for (int k = 0; k < 3; k++)
            sum[k] += normal[k];
        rounding += 4;
    }
    out[0] = out[1] = out[2] = 0;
    for (int k = 0; k < 3; k++)
        if (sum[k] > rounding || sum[k] < -rounding) {
            (void)sheen_normalize_wide(sum, out); /* the sum is not zero */
            return;
        }
}

void sheen_vertex_normals(const struct sheen_polygon_list *list, const uint32_t *around,
                          const sheen_q30_t *polygon_normals, sheen_q30_t *normals)
{
    for (uint32_t v = 0; v < list->point_count; v++)
        average(list, around, polygon_normals, v, NULL, 0, normals + 3 * (size_t)v);
}

void sheen_corner_normals(const struct sheen_polygon_list *list, const uint32_t *around,
                          const sheen_q30_t *polygon_normals, sheen_q30_t crease, sheen_q30_t *normals)
{
    const sheen_q30_t *own = polygon_normals;

    for (uint32_t p = 0, c = 0; p < list->polygon_count; p++, own += 3) {
        int degenerate = own[0] == 0 && own[1] == 0 && own[2] == 0;
        for (uint32_t end = c + list->sizes[p]; c < end; c++, normals += 3) {
            if (!degenerate)
                average(list, around, polygon_normals, list->corners[c], own, (int64_t)crease - CREASE_SLACK, normals);
            if (degenerate || (normals[0] == 0 && normals[1] == 0 && normals[2] == 0))
                for (int k = 0; k < 3; k++)
                    normals[k] = own[k];
        }
    }
}
