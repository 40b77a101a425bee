/*
 * host_normals.c - polygons in the core's integers, and the normals of corners, which the core averages.
 */
#include <stdlib.h>
#include <string.h>

#include "host_build.h"
#include "host_vector.h"

/*
 * In steps of Q1.30, 3e-8 in all. Normals of polygons come from rounded points; with this slack a crease of 60 degrees
 * still smooths edges of exactly 60.
 */
#define CREASE_SLACK 32

void sheen_host_unit(const sheen_q30_t from[3], double unit[3])
{
    for (int k = 0; k < 3; k++)
        unit[k] = from[k];
    unit3(unit);
}

int sheen_host_local_alloc(struct sheen_host_build *build)
{
    uint32_t most = 0;

    for (size_t p = 0; p < build->from->polygon_count; p++) {
        uint32_t count = build->from->first[p + 1] - build->from->first[p];
        most = count > most ? count : most;
    }
    build->local.points = malloc(most * 3 * sizeof *build->local.points);
    build->local.order = malloc(most * sizeof *build->local.order);
    build->local.scratch = malloc(SHEEN_TRIANGULATE_WORDS((size_t)most) * sizeof *build->local.scratch);
    if (!build->local.points || !build->local.order || !build->local.scratch)
        return SHEEN_ERR_MEMORY;
    for (uint32_t i = 0; i < most; i++)
        build->local.order[i] = i;
    return SHEEN_OK;
}

void sheen_host_local_free(struct sheen_host_build *build)
{
    free(build->local.points);
    free(build->local.order);
    free(build->local.scratch);
}

void sheen_host_localise(struct sheen_host_build *build, const uint32_t *corners, uint32_t count)
{
    const double(*points)[3] = (const double(*)[3])build->from->points;
    const double *origin = points[corners[0]];
    double extent = 0;
    int exponent;

    for (uint32_t i = 1; i < count; i++) {
        for (int k = 0; k < 3; k++)
            extent = fmax(extent, fabs(points[corners[i]][k] - origin[k]));
    }
    (void)frexp(extent, &exponent); /* extent < 2^exponent */
    for (uint32_t i = 0; i < count; i++) {
        for (int k = 0; k < 3; k++)
            /* ldexp, because for extents below 2^-996 the power of two as a factor would be infinite. */
            build->local.points[3 * (size_t)i + (size_t)k] =
                (int32_t)floor(ldexp(points[corners[i]][k] - origin[k], 28 - exponent) + 0.5);
    }
}

/* What the core needs to average normals: the place of each corner, but not its coordinates. */
struct places {
    struct sheen_polygon_list list;
    uint32_t *corners, *sizes, *around;
    sheen_q30_t (*vertex)[3]; /* normals: one per place, or with a crease one per corner */
};

static int find_places(const struct sheen_host_build *build, struct places *places)
{
    const struct sheen_host_mesh *mesh = build->mesh;
    size_t units = build->options->use_crease ? mesh->corner_count : build->weld_count;

    places->corners = malloc(mesh->corner_count * sizeof *places->corners);
    places->sizes = malloc(mesh->polygon_count * sizeof *places->sizes);
    places->around = malloc(SHEEN_AROUND_WORDS(build->weld_count, mesh->corner_count) * sizeof *places->around);
    places->vertex = malloc(units * sizeof *places->vertex);
    if (!places->corners || !places->sizes || !places->around || !places->vertex)
        return SHEEN_ERR_MEMORY;
    for (size_t c = 0; c < mesh->corner_count; c++)
        places->corners[c] = sheen_corner_weld(build, c);
    for (size_t p = 0; p < mesh->polygon_count; p++)
        places->sizes[p] = mesh->polygons[p].count;
    places->list = (struct sheen_polygon_list){.corners = places->corners,
                                               .sizes = places->sizes,
                                               .point_count = (uint32_t)build->weld_count,
                                               .corner_count = (uint32_t)mesh->corner_count,
                                               .polygon_count = (uint32_t)mesh->polygon_count};
    return sheen_polygons_around(&places->list, places->around);
}

/*
 * Steps that compare pairs of faces around a vertex take time that grows with the square of the faces, summed over all
 * vertices: on a desktop 4 s for a vertex of MOST_FACES with a crease, and 3 s more if a reduced mesh chooses among a
 * file's normals; for three times as many faces, finding edges or simplifying takes 5 s. Vertices of up to FEW_FACES do
 * not count, because no file has enough of them to matter.
 */
#define MOST_FACES 15000u
#define TIMES_WITHOUT 3u /* times as many faces are allowed without a crease and without choosing */
#define FEW_FACES 64u

static int check_around(const struct sheen_host_build *build, const struct places *places, const char *name,
                        struct sheen_problem *problem)
{
    const struct sheen_host_options *options = build->options;
    int chooses = options->reduce && build->from->normals && !options->average;
    int takes_long = options->use_crease || chooses;
    uint64_t sum = 0, most_without = (uint64_t)TIMES_WITHOUT * MOST_FACES;
    uint64_t limit = takes_long ? (uint64_t)MOST_FACES * MOST_FACES : most_without * most_without;
    uint32_t most = 0;

    for (uint32_t v = 0; v < places->list.point_count; v++) {
        uint32_t faces = places->around[v + 1] - places->around[v];
        sum += faces > FEW_FACES ? (uint64_t)faces * faces : 0;
        most = faces > most ? faces : most;
    }
    if (sum <= limit)
        return SHEEN_OK;
    int helps = takes_long && sum <= most_without * most_without;
    return sheen_problem(problem, SHEEN_ERR_CAPACITY, "%s: %lu faces around one vertex take too long%s", name,
                         (unsigned long)most, helps ? "; --normals average --crease 180 takes them" : "");
}

/* Sets each corner's normal: the file's if there is one, else the average, else the polygon's. */
static void choose(struct sheen_host_build *build, const struct places *places)
{
    const double *file = build->from->normals && !build->options->average ? build->from->normals[0] : NULL;

    for (size_t p = 0; p < build->mesh->polygon_count; p++) {
        const struct sheen_host_polygon *polygon = &build->mesh->polygons[p];
        for (uint32_t c = polygon->first; c < polygon->first + polygon->count; c++) {
            double *normal = build->normals[c];
            if (file) {
                memcpy(normal, file + 3 * (size_t)build->source[c], 3 * sizeof *normal);
                if (unit3(normal))
                    continue;
            }
            sheen_host_unit(places->vertex[build->options->use_crease ? c : places->corners[c]], normal);
            if (normal[0] == 0 && normal[1] == 0 && normal[2] == 0)
                memcpy(normal, polygon->normal, sizeof polygon->normal);
        }
    }
}

int sheen_host_normals(struct sheen_host_build *build, const char *name, struct sheen_problem *problem)
{
    struct places places = {0};
    int error = find_places(build, &places);

    if (!error)
        error = check_around(build, &places, name, problem);
    build->normals = calloc(build->mesh->corner_count, sizeof *build->normals);
    if (!error && !build->normals)
        error = SHEEN_ERR_MEMORY;
    if (!error) {
        const uint32_t *weights = build->options->equal ? NULL : build->angles;
        double turns = build->options->crease / 360; /* 0..1/2 */
        if (build->options->use_crease)
            sheen_corner_normals(&places.list, places.around, build->facing[0], weights,
                                 sheen_cos((sheen_angle_t)(turns * 4294967296.0)) - CREASE_SLACK, places.vertex[0]);
        else
            sheen_vertex_normals(&places.list, places.around, build->facing[0], weights, places.vertex[0]);
        choose(build, &places);
    }
    free(places.corners);
    free(places.sizes);
    free(places.around);
    free(places.vertex);
    return error;
}
