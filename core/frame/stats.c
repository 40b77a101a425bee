/*
 * stats.c - counters of a frame, error texts and checks of what the caller hands in.
 */
#include "frame.h"
#include "ways.h"

COLD void sheen_frame_stats(const struct sheen_frame *f, struct sheen_stats *stats)
{
    const struct sheen_config *c = &f->config;
    size_t tile = (size_t)c->target->width * (c->band_rows + (c->max_edges > 0 ? 2u * LINE_APRON : 0)),
           pixel = f->format.grey ? 1 : 2;

    *stats = (struct sheen_stats){.objects = f->draws,
                                  .triangles = f->count.triangles,
                                  .front = f->count.front,
                                  .drawn = f->count.drawn,
                                  .clipped = f->count.clipped,
                                  .used = f->used,
                                  .pieces = f->pieces,
                                  .edges = f->count.edges};
    for (unsigned i = 0; i < c->workers; i++) {
        const struct worker *w = &f->worker[i];
        for (unsigned way = 0; way < SHEEN_WAYS; way++)
            stats->setups += w->by_way[way];
        stats->spans += w->count.spans;
        stats->covered += SHEEN_STATS ? w->count.covered : 0;
        stats->shaded += SHEEN_STATS ? w->count.shaded : 0;
        stats->rectangles += w->count.rectangles;
        stats->pixels += w->count.pixels;
        stats->carried = (uint32_t)max32((int32_t)stats->carried, w->most_carried + 1);
    }
    stats->ram_arena = (uint32_t)f->arena_bytes;
    stats->ram_vertices = (uint32_t)(c->max_vertices * sizeof *f->place + c->max_used * sizeof(struct vertex));
    stats->ram_lists = (uint32_t)(c->max_triangles * sizeof(struct entry));
    stats->ram_bands = (uint32_t)(c->workers * tile * (c->buffers * pixel + sizeof(uint16_t)));
}

COLD void sheen_frame_ways(const struct sheen_frame *f, uint32_t by_way[SHEEN_WAYS])
{
    for (unsigned way = 0; way < SHEEN_WAYS; way++) {
        by_way[way] = 0;
        for (unsigned i = 0; i < f->config.workers; i++)
            by_way[way] += f->worker[i].by_way[way];
    }
}

void sheen_frame_force(struct sheen_frame *f, unsigned way)
{
    f->forced = (uint8_t)way;
}

COLD enum sheen_subject sheen_frame_about(const struct sheen_frame *f, uint32_t *needed)
{
    if (needed != NULL)
        *needed = f->needed;
    return (enum sheen_subject)f->about;
}

const char *sheen_subject_name(enum sheen_subject subject)
{
    static const char *const name[] = {
        "nothing",       "target",    "buffers",     "workers",     "lock",         "max_vertices", "max_used",
        "max_triangles", "max_draws", "max_clipped", "max_carried", "viewport",     "fov",          "z_near, z_far",
        "view.pose",     "pose",      "mesh",        "normals",     "material",     "shine",        "ramp",
        "shader",        "lights",    "uvs",         "texture",     "transparency", "fog",          "depth_bias",
        "morph",         "edges",     "max_edges",   "smooth",      "clipper"};

    return (unsigned)subject < sizeof name / sizeof name[0] ? name[subject] : name[0];
}

COLD int sheen_mesh_check(const struct sheen_mesh *mesh, uint32_t polygon_count)
{
    if (mesh == NULL || mesh->positions == NULL || mesh->indices == NULL || mesh->vertices == 0 ||
        mesh->triangles == 0 || mesh->scale <= 0 || mesh->index_bytes < 1 || mesh->index_bytes > 2)
        return SHEEN_ERR_ARGUMENT;
    for (uint32_t i = 0; i < 3u * mesh->triangles; i++)
        if (mesh_index(mesh, i) >= mesh->vertices)
            return SHEEN_ERR_ARGUMENT;
    for (uint32_t i = 0; i < mesh->triangles && mesh->polygon_normals != NULL; i++)
        if ((mesh->polygons != NULL ? mesh->polygons[i] : i) >= polygon_count)
            return SHEEN_ERR_ARGUMENT;
    for (uint32_t i = 0; i < 3u * mesh->triangles && mesh->edges != NULL; i++) {
        uint32_t other = mesh->edges[i / 3].across[i % 3];
        if (other != SHEEN_NO_TRIANGLE && other >= mesh->triangles)
            return SHEEN_ERR_ARGUMENT;
    }
    return SHEEN_OK;
}

const char *sheen_strerror(int error)
{
    switch (error) {
    case SHEEN_OK:
        return "no error";
    case SHEEN_ERR_ARGUMENT:
        return "value missing or out of range";
    case SHEEN_ERR_MEMORY:
        return "arena too small";
    case SHEEN_ERR_CAPACITY:
        return "capacity exceeded";
    case SHEEN_ERR_STATE:
        return "call out of order";
    case SHEEN_ERR_DEGENERATE:
        return "no direction";
    case SHEEN_ERR_BUS:
        return "bus error";
    case SHEEN_ERR_TIMEOUT:
        return "bus timed out";
    case SHEEN_ERR_UNSUPPORTED:
        return "not supported";
    default:
        return "unknown error";
    }
}
