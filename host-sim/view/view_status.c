/*
 * view_status.c - the viewer's lines of text about the frame that it shows.
 */
#include <inttypes.h>
#include <stdio.h>

#include "view.h"

/* The frame's number, or the band's and what it sent. */
static void put_frame(const struct sheen_viewer *viewer, char *text, size_t size)
{
    const struct sheen_rect *sent = &viewer->sent;
    char what[40] = "nothing to send";

    if (viewer->shown_band < 0) {
        snprintf(text, size, "frame %d", viewer->number);
        return;
    }
    if (sent->x0 < sent->x1)
        snprintf(what, sizeof what, "%dx%d px sent", sent->x1 - sent->x0, sent->y1 - sent->y0);
    snprintf(text, size, "frame %d, band %d of %u: %s", viewer->number, viewer->shown_band + 1,
             sheen_band_count(viewer->table.scene.frame), what);
}

void sheen_viewer_title(const struct sheen_viewer *viewer, char *text, size_t size)
{
    static const char *const edges[] = {"", ", smooth edges", ", outline", ", wire"};
    const struct sheen_turntable *table = &viewer->table;
    const struct sheen_view *view = &table->scene.view;
    char frame[80];

    put_frame(viewer, frame, sizeof frame);
    snprintf(text, size, "%s  %s  %s%s%s%s%s  %ux%u, orientation %u", sheen_turntable_panel_name(table), frame,
             sheen_shading_word(sheen_scene_shading(&table->scene)), edges[sheen_scene_edging(&table->scene)],
             view->affine ? ", affine" : "", view->orthographic ? ", ortho" : "", view->dither ? ", dithered" : "",
             table->choice.width, table->choice.height, table->choice.orientation);
}

/* Frames per second by the wire alone, one bit per cycle of the rated clock: no firmware can beat it. */
static void put_ceiling(const struct sheen_viewer *viewer, uint64_t bytes, char *text, size_t size)
{
    const struct sheen_panel_record *record = viewer->table.choice.record;

    if (!record) {
        snprintf(text, size, "no wire, no frame ceiling");
        return;
    }
    double whole = record->clock_hz / (8.0 * sheen_sim_frame_bytes(record));
    int used = snprintf(text, size, "at %.4g MHz at most %.1f whole frames/s", record->clock_hz / 1e6, whole);

    if (bytes && viewer->band < 0 && used > 0 && (size_t)used < size)
        snprintf(text + used, size - (size_t)used, ", %.1f like this", record->clock_hz / (8.0 * (double)bytes));
}

void sheen_viewer_counts(const struct sheen_viewer *viewer, char *text, size_t size)
{
    const struct sheen_turntable *table = &viewer->table;
    struct sheen_sim_counters bus = sheen_sim_bus_counters(sheen_sim_panel_bus(table->panel));
    struct sheen_stats stats;
    char ceiling[80];

    sheen_frame_stats(table->scene.frame, &stats);
    put_ceiling(viewer, bus.bytes, ceiling, sizeof ceiling);
    snprintf(text, size, "%" PRIu32 " of %" PRIu32 " triangles  %" PRIu32 " px shaded  %" PRIu64 " B on the bus  %s",
             stats.drawn, stats.triangles, stats.shaded, bus.bytes, ceiling);
}
