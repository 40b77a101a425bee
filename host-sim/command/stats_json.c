/*
 * stats_json.c - `--stats`: a line of JSON per frame.
 */
#include "stats_json.h"

#include <inttypes.h>

#include "ramps.h"

#include "frame/ways.h"

/* Indexed by enum sheen_way. */
static const char *const way_names[SHEEN_WAYS] = {"flat",
                                                  "gouraud_linear",
                                                  "gouraud_quadratic",
                                                  "gouraud_quotient",
                                                  "phong_quadratic",
                                                  "phong_cells",
                                                  "phong_root",
                                                  "phong_lights",
                                                  "slerp",
                                                  "slerp_normals",
                                                  "textured_linear",
                                                  "textured_quotient",
                                                  "matcap_quadratic",
                                                  "matcap_normals"};

static void print_triangles(FILE *stream, const struct sheen_stats *stats, const struct sheen_frame *frame)
{
    uint32_t by_way[SHEEN_WAYS];

    sheen_frame_ways(frame, by_way);
    fprintf(stream,
            "\"triangles\": {\"in\": %" PRIu32 ", \"front\": %" PRIu32 ", \"drawn\": %" PRIu32 ", \"clipped\": %" PRIu32
            ", \"by_shading\": {",
            stats->triangles, stats->front, stats->drawn, stats->clipped);
    for (size_t i = 0; i < sizeof way_names / sizeof way_names[0]; i++)
        fprintf(stream, "%s\"%s\": %" PRIu32, i ? ", " : "", way_names[i], by_way[i]);
    fprintf(stream, "}}, \"setups\": %" PRIu32 ", \"carried\": %" PRIu32 ", \"spans\": %" PRIu32, stats->setups,
            stats->carried, stats->spans);
}

int sheen_stats_json(FILE *stream, const struct sheen_turntable *table, int number)
{
    struct sheen_sim_counters bus = sheen_sim_bus_counters(sheen_sim_panel_bus(table->panel));
    struct sheen_stats stats;

    sheen_frame_stats(table->scene.frame, &stats);
    fprintf(stream, "{\"frame\": %d, ", number);
    print_triangles(stream, &stats, table->scene.frame);
    fprintf(stream, ", \"pixels\": {\"covered\": %" PRIu32 ", \"shaded\": %" PRIu32 "}", stats.covered, stats.shaded);
    fprintf(stream,
            ", \"bus\": {\"bytes\": %" PRIu64 ", \"commands\": %" PRIu64 ", \"transactions\": %" PRIu64
            ", \"rectangles\": %" PRIu64 "}",
            bus.bytes, bus.commands, bus.transactions, bus.rectangles);
    fprintf(stream,
            ", \"ram\": {\"arena\": %" PRIu32 ", \"vertices\": %" PRIu32 ", \"lists\": %" PRIu32 ", \"bands\": %" PRIu32
            ", \"tables\": %zu}}\n",
            stats.ram_arena, stats.ram_vertices, stats.ram_lists, stats.ram_bands,
            sizeof table->scene.shine + (table->scene.options->ramp.kind ? SHEEN_RAMP_BYTES : 0));
    return fflush(stream) == 0 && !ferror(stream) ? SHEEN_OK : SHEEN_ERR_ARGUMENT;
}
