/*
 * averages.c - vertex normals: averages over the polygons around each vertex (run at load or when a mesh moves).
 */
#include "../math/fixed.h"
#include "../math/vector.h"
#include "../sheen.h"

int sheen_polygons_around(const struct sheen_polygon_list *list, uint32_t *around)
{
    uint32_t *begin = around, *polygons = around + list->point_count + 1, all = 0;
    uint32_t *corners = polygons + list->corner_count;

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
    /*
     * The running sum turns each point's count into its list's end. Filling the lists from the last corner backwards
     * turns ends into beginnings and leaves each list in the corners' order.
     */
    for (uint32_t v = 1; v <= list->point_count; v++)
        begin[v] += begin[v - 1];
    for (uint32_t p = list->polygon_count, c = all; p-- > 0;)
        for (uint32_t first = c - list->sizes[p]; c > first;) {
            uint32_t at = --begin[list->corners[--c]];
            polygons[at] = p;
            corners[at] = c;
        }
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
 * Slack of cosine comparisons, in raw steps of Q1.30, so that "within 60 degrees" includes 60: the two unit normals
 * are off by at most 7 each (4 in each part), the limit by 3.
 */
#define CREASE_SLACK 18

/* What the averages around all points share. */
struct around {
    const uint32_t *begin, *polygons, *corners;
    const sheen_q30_t *normals; /* of the polygons */
    const uint32_t *weights;    /* of the corners, or NULL */
};

static struct around set_around(const struct sheen_polygon_list *list, const uint32_t *around,
                                const sheen_q30_t *normals, const uint32_t *weights)
{
    const uint32_t *polygons = around + list->point_count + 1;

    return (struct around){around, polygons, polygons + list->corner_count, normals, weights};
}

/* 1 if a.b is at least `least`, Q1.30. Range: of unit normals |a.b| * 2^60 < 2^61, which fits Q1.30 when rounded. */
static int is_within(const sheen_q30_t a[3], const sheen_q30_t b[3], int64_t least)
{
    int64_t dot = (int64_t)a[0] * b[0] + (int64_t)a[1] * b[1] + (int64_t)a[2] * b[2];

    return round_shift64(dot, 30) >= least;
}

/* The right shift after which the weights around point v add up to less than 2^32. */
static unsigned shift_of(const struct around *around, uint32_t v)
{
    uint64_t sum = 0;

    for (uint32_t i = around->begin[v]; i < around->begin[v + 1]; i++)
        sum += around->weights[around->corners[i]];
    return sum >> 32 ? 32 - clz32((uint32_t)(sum >> 32)) : 0;
}

/*
 * The average of the polygon normals around point v: of those whose cosine with the normal `own` is at least `least`,
 * or of all if own is NULL. Zero if the sum does not exceed its own rounding error: 4 raw steps per normal and, for
 * weights that are angles, SHEEN_ANGLE_ROUNDING per weight.
 * Range: weights add up to less than 2^32 (without weights each counts 1, and there are fewer polygons), a part of a
 * normal is at most 2^30 + 4, so the sum stays below 2^63; so does the error with fewer than 2^28 polygons at a point.
 */
static void average(const struct around *around, uint32_t v, const sheen_q30_t *own, int64_t least, sheen_q30_t out[3])
{
    unsigned shift = around->weights ? shift_of(around, v) : 0;
    int64_t sum[3] = {0, 0, 0}, rounding = 0;

    for (uint32_t i = around->begin[v]; i < around->begin[v + 1]; i++) {
        const sheen_q30_t *normal = around->normals + 3 * (size_t)around->polygons[i];
        if (own && !is_within(own, normal, least))
            continue;
        int64_t weight = around->weights ? around->weights[around->corners[i]] >> shift : 1;
        for (int k = 0; k < 3; k++)
            sum[k] += weight * normal[k];
        rounding += 4 * weight + (around->weights ? (int64_t)SHEEN_ANGLE_ROUNDING << 30 : 0);
    }
    out[0] = out[1] = out[2] = 0;
    for (int k = 0; k < 3; k++)
        if (sum[k] > rounding || sum[k] < -rounding) {
            (void)sheen_normalize_wide(sum, out); /* the sum is not zero */
            return;
        }
}

void sheen_vertex_normals(const struct sheen_polygon_list *list, const uint32_t *around,
                          const sheen_q30_t *polygon_normals, const uint32_t *weights, sheen_q30_t *normals)
{
    struct around of = set_around(list, around, polygon_normals, weights);

    for (uint32_t v = 0; v < list->point_count; v++)
        average(&of, v, NULL, 0, normals + 3 * (size_t)v);
}

/*
 * The first corner at point v (corner c's) whose polygon has the normal `own`: its average is corner c's too. Returns
 * c itself if no earlier corner has that normal; the loop ends there, because v's list is in order and contains c.
 */
static APART uint32_t first_alike(const struct around *around, uint32_t v, uint32_t c, const sheen_q30_t own[3])
{
    uint32_t i = around->begin[v];

    for (; around->corners[i] < c; i++) {
        const sheen_q30_t *normal = around->normals + 3 * (size_t)around->polygons[i];
        if (normal[0] == own[0] && normal[1] == own[1] && normal[2] == own[2])
            break;
    }
    return around->corners[i];
}

/* The normal of corner c, at point v, of a polygon with the normal `own`: the average, or `own` if that is zero. */
static void corner_average(const struct around *around, uint32_t v, uint32_t c, const sheen_q30_t own[3], int64_t least,
                           sheen_q30_t *normals)
{
    const uint32_t alike = first_alike(around, v, c, own);
    sheen_q30_t *normal = normals + 3 * (size_t)c;
    const sheen_q30_t *from = normals + 3 * (size_t)alike;

    if (alike == c) {
        average(around, v, own, least, normal);
        from = normal[0] == 0 && normal[1] == 0 && normal[2] == 0 ? own : normal;
    }
    for (int k = 0; k < 3; k++)
        normal[k] = from[k];
}

void sheen_corner_normals(const struct sheen_polygon_list *list, const uint32_t *around,
                          const sheen_q30_t *polygon_normals, const uint32_t *weights, sheen_q30_t crease,
                          sheen_q30_t *normals)
{
    struct around of = set_around(list, around, polygon_normals, weights);
    const sheen_q30_t *own = polygon_normals;

    for (uint32_t p = 0, c = 0; p < list->polygon_count; p++, own += 3) {
        int degenerate = own[0] == 0 && own[1] == 0 && own[2] == 0;
        for (uint32_t end = c + list->sizes[p]; c < end; c++) {
            if (!degenerate)
                corner_average(&of, list->corners[c], c, own, (int64_t)crease - CREASE_SLACK, normals);
            else
                for (int k = 0; k < 3; k++)
                    normals[3 * (size_t)c + (size_t)k] = 0;
        }
    }
}
