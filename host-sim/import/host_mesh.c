/*
 * host_mesh.c - makes a mesh that is ready to be drawn from polygons, step by step.
 */
#include "host_mesh.h"

#include <float.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "builtin.h"
#include "host_build.h"
#include "host_reduce.h"
#include "host_vector.h"
#include "mesh_file.h"
#include "unique.h"

/* The origin subtracted from points before they are compared: 0, or the box's centre if it is far off (host_mesh.h). */
static void weld_origin(const struct sheen_host_build *build, double origin[3])
{
    double side = 0;

    for (int k = 0; k < 3; k++)
        side = fmax(side, build->side[k]);
    for (int k = 0; k < 3; k++)
        origin[k] = fabs(build->mesh->center[k]) > 16 * side ? build->mesh->center[k] : 0;
}

static int weld_points(struct sheen_host_build *build)
{
    const struct sheen_polygons *from = build->from;
    float(*keys)[3] = malloc((from->point_count + 1) * sizeof *keys);
    double origin[3];
    int error = SHEEN_ERR_MEMORY;

    weld_origin(build, origin);
    build->weld = malloc((from->point_count + 1) * sizeof *build->weld);
    if (keys && build->weld) {
        for (size_t i = 0; i < from->point_count; i++) {
            for (int k = 0; k < 3; k++)
                keys[i][k] = (float)(from->points[i][k] - origin[k]) + 0.0f; /* -0 becomes 0 */
        }
        error = sheen_unique(keys, sizeof *keys, from->point_count, build->weld, &build->weld_count);
    }
    free(keys);
    return error;
}

#define REDUCE "--reduce 20000 makes it 20000 triangles"

/* Refuses too many triangles, except if the mesh will be reduced. */
static int check_triangles(const struct sheen_host_mesh *mesh, const struct sheen_host_options *options,
                           const char *name, struct sheen_problem *problem)
{
    if (mesh->triangle_count <= SHEEN_HOST_MESH_MAX || options->reduce)
        return SHEEN_OK;
    return sheen_problem(problem, SHEEN_ERR_CAPACITY, "%s: %zu triangles, at most %u can be drawn; " REDUCE, name,
                         mesh->triangle_count, SHEEN_HOST_MESH_MAX);
}

/*
 * The time to split a face grows with the square of its corners: 4 s on a desktop for SQUARE. Faces of up to
 * FEW_CORNERS do not count, because no file has enough of them to matter.
 */
#define FACE_CORNERS 10000u
#define SQUARE ((uint64_t)FACE_CORNERS * FACE_CORNERS) /* of all faces together */
#define FEW_CORNERS 64u

static int check_faces(const struct sheen_polygons *polygons, const char *name, struct sheen_problem *problem)
{
    uint64_t sum = 0;

    for (size_t p = 0; p < polygons->polygon_count; p++) {
        uint64_t count = polygons->first[p + 1] - polygons->first[p];
        sum += count > FEW_CORNERS ? count * count : 0;
        if (sum > SQUARE)
            return sheen_problem(problem, SHEEN_ERR_CAPACITY,
                                 "%s: face %zu has %llu corners: %s takes too long to split; at most %u in one face",
                                 name, p + 1, (unsigned long long)count,
                                 count > FACE_CORNERS ? "it" : "with those before it", FACE_CORNERS);
    }
    return SHEEN_OK;
}

/* The number of vertices if each place had one normal; 0 if memory runs out. */
static size_t count_places(const struct sheen_host_mesh *mesh)
{
    uint32_t *place = malloc(mesh->vertex_count * sizeof *place);
    size_t count = 0;

    if (!place || sheen_host_places(mesh, place, &count) != SHEEN_OK)
        count = 0;
    free(place);
    return count;
}

/* Few triangles may have many vertices if they share none, because of sharp edges or a file's normals. */
static int check_vertices(const struct sheen_host_mesh *mesh, const char *name, struct sheen_problem *problem)
{
    char rounder[80] = "";

    if (mesh->vertex_count <= SHEEN_HOST_MESH_MAX)
        return SHEEN_OK;
    size_t places = count_places(mesh);
    if (places > 0 && places <= SHEEN_HOST_MESH_MAX)
        snprintf(rounder, sizeof rounder, "--normals average --crease 180 makes it about %zu, ", places);
    return sheen_problem(problem, SHEEN_ERR_CAPACITY,
                         "%s: %zu vertices (by position%s normal%s), at most %u can be drawn; %s" REDUCE, name,
                         mesh->vertex_count, mesh->picture_count ? "," : " and", mesh->picture_count ? " and uv" : "",
                         SHEEN_HOST_MESH_MAX, rounder);
}

/* Whether the next polygon that the first frame kept is the one whose first corner is `corner`. */
static int is_kept(const struct sheen_host_build *build, uint32_t corner)
{
    const struct sheen_host_build *first = build->first_frame;
    size_t next = build->mesh->polygon_count;

    return next < first->mesh->polygon_count && first->source[first->mesh->polygons[next].first] == corner;
}

/* Keeps the polygons that have an area, and their corners; in another frame, the polygons that the first one kept. */
static int keep_polygons(struct sheen_host_build *build, const char *name, struct sheen_problem *problem)
{
    const struct sheen_polygons *from = build->from;
    struct sheen_host_mesh *mesh = build->mesh;

    mesh->polygons = calloc(from->polygon_count, sizeof *mesh->polygons);
    build->source = malloc(from->corner_count * sizeof *build->source);
    build->facing = malloc(from->polygon_count * sizeof *build->facing);
    build->angles = malloc(from->corner_count * sizeof *build->angles);
    if (!mesh->polygons || !build->source || !build->facing || !build->angles)
        return SHEEN_ERR_MEMORY;
    for (size_t p = 0; p < from->polygon_count; p++) {
        struct sheen_host_polygon *keep = &mesh->polygons[mesh->polygon_count];
        uint32_t first = from->first[p], count = from->first[p + 1] - first;

        sheen_host_localise(build, from->corners + first, count);
        sheen_q30_t *facing = build->facing[mesh->polygon_count];
        int has_area = sheen_polygon_normal(build->local.points, build->local.order, count, facing) == SHEEN_OK;
        if (build->first_frame ? !is_kept(build, first) : !has_area)
            continue;
        for (int k = 0; !has_area && k < 3; k++)
            facing[k] = 0;
        sheen_host_unit(facing, keep->normal);
        const struct sheen_polygon_list one = {build->local.points, build->local.order, &count, count, count, 1};
        sheen_corner_angles(&one, facing, build->angles + mesh->corner_count);
        keep->first = (uint32_t)mesh->corner_count;
        keep->count = count;
        keep->group = from->groups[p];
        for (uint32_t c = 0; c < count; c++)
            build->source[mesh->corner_count++] = first + c;
        mesh->polygon_count++;
        mesh->triangle_count += count - 2;
    }
    if (mesh->polygon_count == 0)
        return sheen_problem(problem, SHEEN_ERR_ARGUMENT, "%s: no face has an area", name);
    return check_triangles(mesh, build->options, name, problem);
}

static void widen(const struct sheen_polygons *from, double low[3], double high[3])
{
    for (size_t c = 0; c < from->corner_count; c++) {
        const double *point = from->points[from->corners[c]];
        for (int k = 0; k < 3; k++) {
            low[k] = fmin(low[k], point[k]);
            high[k] = fmax(high[k], point[k]);
        }
    }
}

static double reach(const struct sheen_polygons *from, const double center[3])
{
    double most = 0;

    for (size_t c = 0; c < from->corner_count; c++) {
        const double *point = from->points[from->corners[c]];
        double d[3] = {point[0] - center[0], point[1] - center[1], point[2] - center[2]};
        most = fmax(most, sqrt(dot3(d, d)));
    }
    return most;
}

/* Centre and radius over all points of polygons, including polygons without area, in both frames. */
static int fit(struct sheen_host_build *build, const char *name, struct sheen_problem *problem)
{
    const struct sheen_polygons *from = build->from, *second = build->second ? build->second->from : NULL;
    struct sheen_host_mesh *mesh = build->mesh;
    double low[3], high[3];

    memcpy(low, from->points[from->corners[0]], sizeof low);
    memcpy(high, low, sizeof high);
    widen(from, low, high);
    if (second)
        widen(second, low, high);
    for (int k = 0; k < 3; k++) {
        mesh->center[k] = (low[k] + high[k]) / 2;
        build->side[k] = high[k] - low[k];
    }
    mesh->radius = fmax(reach(from, mesh->center), second ? reach(second, mesh->center) : 0);
    if (!(mesh->radius > FLT_MIN))
        return sheen_problem(problem, SHEEN_ERR_ARGUMENT, "%s: no extent: all vertices are at one place", name);
    return SHEEN_OK;
}

/* Corners with equal keys share a vertex. Every byte is compared, so the struct has no padding. */
struct vertex_key {
    double normal[3], uv[2], second_normal[3];
    uint32_t weld, group, has_uv, second_weld;
    uint8_t color[4], unused[4];
};

static void set_vertex(struct sheen_host_build *build, size_t corner, const struct vertex_key *key)
{
    struct sheen_host_mesh *mesh = build->mesh;
    struct sheen_host_vertex *vertex = &mesh->vertices[mesh->corners[corner]];
    const double *point = build->from->points[build->from->corners[build->source[corner]]];

    for (int k = 0; k < 3; k++)
        vertex->position[k] = (point[k] - mesh->center[k]) / mesh->radius;
    memcpy(vertex->normal, key->normal, sizeof vertex->normal);
    memcpy(vertex->uv, key->uv, sizeof vertex->uv);
    memcpy(vertex->color, key->color, sizeof vertex->color);
    vertex->weld = key->weld;
    vertex->group = key->group;
    vertex->has_uv = key->has_uv;
}

/* Makes the key of a corner of polygon p; is_textured says whether the polygon is. */
static void set_key(const struct sheen_host_build *build, size_t p, size_t corner, int is_textured,
                    struct vertex_key *key)
{
    const struct sheen_polygons *from = build->from;
    uint32_t source = build->source[corner];

    for (int k = 0; k < 3; k++)
        key->normal[k] = build->normals[corner][k] + 0.0; /* -0 becomes 0 */
    for (int k = 0; is_textured && k < 2; k++)
        key->uv[k] = from->uvs[source][k] + 0.0;
    key->has_uv = (uint32_t)is_textured;
    memset(key->color, 255, sizeof key->color);
    if (build->options->colors && from->colors)
        memcpy(key->color, from->colors[source], 3);
    key->weld = sheen_corner_weld(build, corner);
    for (int k = 0; build->second && k < 3; k++)
        key->second_normal[k] = build->second->normals[corner][k] + 0.0;
    key->second_weld = build->second ? sheen_corner_weld(build->second, corner) : 0;
    key->group = build->options->by_group || from->picture_count ? build->mesh->polygons[p].group : 0;
}

/* p counts the mesh's polygons, not the file's: polygons without area are left out of the mesh. */
static int is_polygon_textured(const struct sheen_host_build *build, size_t p)
{
    const struct sheen_host_polygon *polygon = &build->mesh->polygons[p];

    if (!build->from->uvs || !build->from->group[polygon->group].picture)
        return 0;
    for (uint32_t c = polygon->first; c < polygon->first + polygon->count; c++) {
        const double *uv = build->from->uvs[build->source[c]];
        if (isnan(uv[0]) || isnan(uv[1]))
            return 0;
    }
    return 1;
}

static int make_vertices(struct sheen_host_build *build)
{
    struct sheen_host_mesh *mesh = build->mesh;
    struct vertex_key *keys = calloc(mesh->corner_count, sizeof *keys);

    mesh->corners = malloc(mesh->corner_count * sizeof *mesh->corners);
    if (!keys || !mesh->corners) {
        free(keys);
        return SHEEN_ERR_MEMORY;
    }
    for (size_t p = 0; p < mesh->polygon_count; p++) {
        const struct sheen_host_polygon *polygon = &mesh->polygons[p];
        int is_textured = is_polygon_textured(build, p);
        for (uint32_t c = polygon->first; c < polygon->first + polygon->count; c++)
            set_key(build, p, c, is_textured, &keys[c]);
    }
    int error = sheen_unique(keys, sizeof *keys, mesh->corner_count, mesh->corners, &mesh->vertex_count);
    if (!error) {
        mesh->vertices = calloc(mesh->vertex_count, sizeof *mesh->vertices);
        error = mesh->vertices ? SHEEN_OK : SHEEN_ERR_MEMORY;
    }
    for (size_t c = 0; !error && c < mesh->corner_count; c++)
        set_vertex(build, c, &keys[c]);
    free(keys);
    return error;
}

static int make_triangles(struct sheen_host_build *build)
{
    struct sheen_host_mesh *mesh = build->mesh;
    const struct sheen_host_local *local = &build->local;
    uint32_t(*cut)[3] = malloc(mesh->corner_count * sizeof *cut);
    struct sheen_host_triangle *out = malloc(mesh->triangle_count * sizeof *out);
    int error = cut && out ? SHEEN_OK : SHEEN_ERR_MEMORY;

    mesh->triangles = out;
    for (size_t p = 0; !error && p < mesh->polygon_count; p++) {
        const struct sheen_host_polygon *polygon = &mesh->polygons[p];

        /* A polygon's corners are consecutive in the file too. */
        sheen_host_localise(build, build->from->corners + build->source[polygon->first], polygon->count);
        error = sheen_triangulate(local->points, local->order, polygon->count, build->facing[p], local->scratch, *cut);
        for (uint32_t t = 0; !error && t + 2 < polygon->count; t++, out++) {
            for (int k = 0; k < 3; k++)
                out->vertex[k] = mesh->corners[polygon->first + cut[t][k]];
            out->polygon = (uint32_t)p;
        }
    }
    free(cut);
    return error;
}

static int compare_parts(const void *a, const void *b)
{
    const struct sheen_host_part *x = a, *y = b;

    return x->group != y->group ? (x->group < y->group ? -1 : 1)
                                : (x->picture > y->picture) - (x->picture < y->picture);
}

static struct sheen_host_part part_of(const struct sheen_host_build *build, size_t p)
{
    uint32_t group = build->mesh->polygons[p].group;

    return (struct sheen_host_part){build->options->by_group ? group : 0,
                                    is_polygon_textured(build, p) ? build->from->group[group].picture : 0};
}

static int make_parts(struct sheen_host_build *build)
{
    struct sheen_host_mesh *mesh = build->mesh;
    struct sheen_host_part *part = malloc(mesh->polygon_count * sizeof *part);
    size_t count = 0;

    mesh->part = part;
    if (!part)
        return SHEEN_ERR_MEMORY;
    for (size_t p = 0; p < mesh->polygon_count; p++)
        part[p] = part_of(build, p);
    qsort(part, mesh->polygon_count, sizeof *part, compare_parts);
    for (size_t p = 0; p < mesh->polygon_count; p++) {
        if (count == 0 || compare_parts(&part[count - 1], &part[p]) != 0)
            part[count++] = part[p];
    }
    mesh->part_count = count;
    for (size_t p = 0; p < mesh->polygon_count; p++) {
        struct sheen_host_part key = part_of(build, p);
        struct sheen_host_part *found = bsearch(&key, part, count, sizeof *part, compare_parts);
        mesh->polygons[p].part = (uint32_t)(found - part);
    }
    return SHEEN_OK;
}

static int copy_pictures(struct sheen_host_mesh *mesh, const struct sheen_polygons *from)
{
    mesh->picture = calloc(from->picture_count + 1, sizeof *mesh->picture);
    for (size_t i = 0; mesh->picture && i < from->picture_count; i++) {
        struct sheen_picture *picture = &mesh->picture[mesh->picture_count++];
        size_t bytes = 4 * (size_t)from->picture[i].size[0] * from->picture[i].size[1];
        *picture = from->picture[i];
        picture->rgba = malloc(bytes);
        if (!picture->rgba)
            return SHEEN_ERR_MEMORY;
        memcpy(picture->rgba, from->picture[i].rgba, bytes);
    }
    return mesh->picture ? SHEEN_OK : SHEEN_ERR_MEMORY;
}

static int copy_groups(struct sheen_host_build *build)
{
    struct sheen_host_mesh *mesh = build->mesh;

    mesh->group = malloc(build->from->group_count * sizeof *mesh->group);
    if (!mesh->group)
        return SHEEN_ERR_MEMORY;
    memcpy(mesh->group, build->from->group, build->from->group_count * sizeof *mesh->group);
    mesh->group_count = build->from->group_count;
    mesh->z_up = build->from->z_up;
    mesh->notes = build->from->notes;
    mesh->has_colors = build->options->colors && build->from->colors;
    return copy_pictures(mesh, build->from);
}

/* Makes the polygons, places and normals of one frame. */
static int make_frame(struct sheen_host_build *build, const char *name, struct sheen_problem *problem)
{
    int error = sheen_host_local_alloc(build);

    if (!error)
        error = keep_polygons(build, name, problem);
    if (!error)
        error = weld_points(build);
    return error ? error : sheen_host_normals(build, name, problem);
}

/* Makes those of the second frame, if there is one, after the first frame's. */
static int make_second(struct sheen_host_build *build, const char *name, struct sheen_problem *problem)
{
    struct sheen_host_build *second = build->second;

    if (!second)
        return SHEEN_OK;
    memcpy(second->mesh->center, build->mesh->center, sizeof second->mesh->center);
    memcpy(second->side, build->side, sizeof second->side);
    return make_frame(second, name, problem);
}

static void free_frame(struct sheen_host_build *build)
{
    sheen_host_local_free(build);
    free(build->weld);
    free(build->source);
    free(build->facing);
    free(build->angles);
    free(build->normals);
}

/* All steps except the last, which reduces the mesh. second may be NULL. */
static int build_all(struct sheen_host_mesh *mesh, const struct sheen_polygons *polygons,
                     const struct sheen_polygons *second, const struct sheen_host_options *options, const char *name,
                     struct sheen_problem *problem)
{
    struct sheen_host_build build = {.from = polygons, .options = options, .mesh = mesh};
    struct sheen_host_mesh other_mesh = {.polygon_count = 0};
    struct sheen_host_build other = {.from = second, .options = options, .mesh = &other_mesh, .first_frame = &build};

    memset(mesh, 0, sizeof *mesh);
    mesh->crease = options->use_crease ? options->crease : 180;
    int error = sheen_polygons_check(polygons, name, problem);
    if (!error)
        error = check_faces(polygons, name, problem);
    if (!error && second)
        error = sheen_host_frames_fit(polygons, second, name, options->morph, problem);
    if (error)
        return error; /* the problem is set, nothing was allocated */
    build.second = second ? &other : NULL;
    error = fit(&build, name, problem);
    if (!error)
        error = make_frame(&build, name, problem);
    if (!error)
        error = make_second(&build, name, problem);
    if (!error)
        error = make_vertices(&build);
    if (!error)
        error = make_triangles(&build);
    if (!error)
        error = make_parts(&build);
    if (!error)
        error = copy_groups(&build);
    if (!error && second)
        error = sheen_host_second(&build);
    free_frame(&build);
    free_frame(&other);
    sheen_host_mesh_free(&other_mesh);
    if (error)
        sheen_host_mesh_free(mesh);
    if (error == SHEEN_ERR_MEMORY)
        sheen_problem(problem, error, "%s: not enough memory", name);
    return error;
}

/* second: another frame, whose name is options->morph, or NULL; SHEEN_ERR_ARGUMENT if its polygons differ. */
static int build_frames(struct sheen_host_mesh *mesh, const struct sheen_polygons *polygons,
                        const struct sheen_polygons *second, const struct sheen_host_options *options, const char *name,
                        struct sheen_problem *problem)
{
    int error = build_all(mesh, polygons, second, options, name, problem);

    if (error)
        return error;
    if (options->reduce && mesh->triangle_count > options->reduce)
        return sheen_host_mesh_reduce(mesh, options, name, problem);
    error = check_vertices(mesh, name, problem);
    if (error)
        sheen_host_mesh_free(mesh);
    return error;
}

int sheen_host_mesh_build(struct sheen_host_mesh *mesh, const struct sheen_polygons *polygons,
                          const struct sheen_host_options *options, const char *name, struct sheen_problem *problem)
{
    return build_frames(mesh, polygons, NULL, options, name, problem);
}

void sheen_host_mesh_free(struct sheen_host_mesh *mesh)
{
    free(mesh->second.positions);
    free(mesh->second.normals);
    free(mesh->second.polygon_normals);
    free(mesh->vertices);
    free(mesh->polygons);
    free(mesh->corners);
    free(mesh->triangles);
    free(mesh->group);
    free(mesh->part);
    for (size_t i = 0; i < mesh->picture_count; i++)
        sheen_picture_free(&mesh->picture[i]);
    free(mesh->picture);
    memset(mesh, 0, sizeof *mesh);
}

int sheen_polygons_load(struct sheen_polygons *polygons, const char *name, const struct sheen_texture_options *textures,
                        struct sheen_problem *problem)
{
    if (strncmp(name, SHEEN_BUILTIN, strlen(SHEEN_BUILTIN)) != 0)
        return sheen_mesh_file_read(polygons, name, textures, problem);
    int error = sheen_builtin(polygons, name, problem);
    if (!error && textures && textures->most && textures->file)
        error =
            sheen_problem(problem, SHEEN_ERR_ARGUMENT, "%s: has no texture coordinates for %s", name, textures->file);
    return error;
}

static int load_frame(struct sheen_polygons *polygons, const char *name, const struct sheen_host_options *options,
                      const struct sheen_texture_options *textures, struct sheen_problem *problem)
{
    int error = sheen_polygons_load(polygons, name, textures, problem);

    if (!error && (options->up == SHEEN_UP_Z || (options->up == SHEEN_UP_FORMAT && polygons->z_up)))
        sheen_polygons_turn(polygons);
    return error;
}

int sheen_host_mesh_load(struct sheen_host_mesh *mesh, const char *name, const struct sheen_host_options *options,
                         struct sheen_problem *problem)
{
    const struct sheen_texture_options whole = {.cutoff = -1, .target = options->morph_target + 1};
    struct sheen_polygons polygons, second = {.polygon_count = 0};
    int error = load_frame(&polygons, name, options, options->textures, problem);

    if (!error && options->morph)
        error = load_frame(&second, options->morph, options, &whole, problem);
    if (!error)
        error = build_frames(mesh, &polygons, options->morph ? &second : NULL, options, name, problem);
    sheen_polygons_free(&polygons);
    sheen_polygons_free(&second);
    return error;
}
