/*
 * edges.c - what a frame does for the edges of its draws; not linked if a program names none.
 *
 * Lines look at the pixels around them, also at those in the bands above and below. Therefore tiles are drawn with an
 * apron, whose rows are drawn again as part of the next band.
 */
#include <string.h>

#include "frame.h"

/* How many elements of f->line it takes to store a bit for each triangle of a mesh. */
static uint32_t front_lines(const struct sheen_mesh *mesh)
{
    const uint32_t each = 8 * (uint32_t)sizeof(struct line);

    return (mesh->triangles + each - 1) / each;
}

/* Add the lines' own pixels, and the neighbours that they look at, to the bands' covers. */
static void edges_cover(struct sheen_frame *f, uint32_t first)
{
    for (const struct line *l = f->line + first; l != f->line + f->count.edges; l++) {
        const struct vertex *from = &f->vertex[l->from], *to = &f->vertex[l->to];
        int32_t left = asr32(min32(from->x, to->x) + f->screen.centre_x, SUBPIXEL_BITS) - 1;
        int32_t right = asr32(max32(from->x, to->x) + f->screen.centre_x, SUBPIXEL_BITS) + 2;
        const struct sheen_rect rect = {
            (int16_t)max32(left, f->viewport.x0), (int16_t)max32(l->row - 1, f->viewport.y0),
            (int16_t)min32(right, f->viewport.x1), (int16_t)min32((l->end & LINE_END) + 1, f->viewport.y1)};
        sheen_bin_cover(f, rect);
    }
}

/* What smoothing keeps for a worker's band, behind its spans: `mixed` and `marks` of struct line_tile. */
static struct mixed *smooth_mixed(const struct sheen_frame *f, const struct worker *w)
{
    return (struct mixed *)(void *)(w->spans + f->config.band_rows + 2 * LINE_APRON);
}

static uint8_t *smooth_marks(const struct sheen_frame *f, const struct worker *w)
{
    return (uint8_t *)smooth_mixed(f, w) + MARK_ROWS * MARK_PITCH((size_t)f->target->width);
}

/* Clear the marks of all workers. */
static APART void smooth_begin(const struct sheen_frame *f)
{
    for (unsigned i = 0; i < f->config.workers; i++)
        memset(smooth_marks(f, &f->worker[i]), 0, MARK_PITCH((size_t)f->target->width) * f->config.band_rows);
}

/* List a draw's lines, after its triangles. Meanwhile the end of f->line stores which triangles face the eye. */
static COLD int edges_list(struct sheen_frame *f, struct draw_record *d, const struct sheen_object *object,
                           const struct transform *t)
{
    const struct sheen_mesh *mesh = d->as.mesh;
    const uint32_t noted = front_lines(mesh), most = f->config.max_edges, first = f->count.edges;

    if (d->edges->kind->finish != NULL) {
        if (f->format.level_bits == 1) {
            d->edges = NULL;
            return SHEEN_OK;
        }
        if (!f->config.smooth)
            return refuse(f, SHEEN_ERR_CAPACITY, SHEEN_ABOUT_SMOOTH, 1);
    }
    if (mesh->edges == NULL)
        return refuse(f, SHEEN_ERR_ARGUMENT, SHEEN_ABOUT_EDGES, 0);
    if (first + noted > most)
        return refuse(f, SHEEN_ERR_CAPACITY, SHEEN_ABOUT_MAX_EDGES, first + noted);
    if (d->edges->kind->finish != NULL)
        smooth_begin(f);
    struct line_list list = {.mesh = mesh,
                             .draw = &d->as,
                             .front = (uint32_t *)(void *)(f->line + most - noted),
                             .place = f->place + d->first_vertex,
                             .vertex = f->vertex,
                             .used = f->used,
                             .max_used = f->config.max_used,
                             .projection = &f->projection,
                             .transform = t,
                             .screen = &f->screen,
                             .line = f->line,
                             .lines = first,
                             .max_lines = most - noted,
                             .two_sided = d->as.two_sided};
    memset(list.front, 0, noted * sizeof(struct line));
    sheen_list_edges(&list, d->edges->kind);
    if (list.used > list.max_used)
        return refuse_used(f, list.used);
    if (list.lines > list.max_lines)
        return refuse(f, SHEEN_ERR_CAPACITY, SHEEN_ABOUT_MAX_EDGES, list.lines + noted);
    f->edges = d->edges;
    f->screen.shared_rows = 2 * LINE_APRON;
    f->used = list.used;
    f->count.edges = list.lines;
    d->end_line = (uint16_t)list.lines;
    d->line = sheen_colour_pixel(&f->format, object->material->line);
    edges_cover(f, first);
    return SHEEN_OK;
}

/* Whether an entry has a row above `row`; for pieces the answer is always yes. */
static int begins_above(const struct sheen_frame *f, uint32_t e, int32_t row)
{
    const int32_t below = row * SUBPIXEL_ONE + SUBPIXEL_HALF - f->screen.centre_y;
    const struct draw_record *d = f->draw;
    uint32_t first = 3u * f->entry[e].triangle, corners = 3;

    if (is_cut(f, e))
        return 1;
    while (e >= d->end_entry)
        d++;
    if (is_quad(d, f->entry[e].triangle)) {
        first -= 3 * QUAD;
        corners = 6;
    }
    for (uint32_t i = first; i < first + corners; i++)
        if (used_vertex(f, d, mesh_index(d->as.mesh, i))->y <= below - SUBPIXEL_ONE)
            return 1;
    return 0;
}

/*
 * Called before collect(): entries that begin in the next band and reach the apron become pending; so do, after a jump,
 * those that may reach the last row of the band above. A tile that begins below the band's first row counts as a jump,
 * because triangles that were carried only for the apron end above it.
 */
static void edges_begin(const struct sheen_frame *f, struct worker *w, struct tile *t, unsigned b)
{
    const int32_t strip = f->viewport.y0 + (int32_t)b * f->config.band_rows;

    if (w->last_band + 1 != (int32_t)b || t->rect.y0 != strip) {
        pending_clear(f, w);
        for (unsigned above = b > 0 ? b - 1 - f->band[b - 1].back : 0; above < b; above++)
            add_list(f, w, above);
        w->last_band = (int32_t)b - 1;
    }
    if (b + 1 < f->bands)
        for (uint32_t e = f->band[b + 1].first; e != NONE; e = f->entry[e].next)
            if (begins_above(f, e, t->rect.y1 + LINE_APRON))
                w->pending[e >> 5] |= 1u << (e & 31u);
    t->rect.y0 = (int16_t)max32(t->rect.y0 - LINE_APRON, f->viewport.y0);
    t->rect.y1 = (int16_t)min32(t->rect.y1 + LINE_APRON, f->viewport.y1);
}

/* Draw the lines whose kind has `finish` (finished: 1), or all others (0); returns a kind that drew, or NULL. */
static const struct line_kind *draw_lines_of(const struct sheen_frame *f, struct line_tile *lt, int finished)
{
    const struct line *line = f->line;
    const struct line_kind *found = NULL;

    for (const struct draw_record *d = f->draw; d != f->draw + f->draws; d++) {
        if (d->edges == NULL)
            continue;
        const struct line_kind *kind = d->edges->kind;
        const struct line *end = f->line + d->end_line;
        if ((kind->finish != NULL) == finished) {
            found = kind;
            SHEEN_TAP(LINE_LOOKED_AT, end - line);
            lt->depth_bias = d->as.depth_bias;
            kind->draw(lt, line, end, d->line);
        }
        line = end;
    }
    return found;
}

/* 5..11: 2^whole_bits steps of z16 are about 1/32 of the distance at far, or of the depth from far to near if less. */
static uint32_t whole_share_bits(const struct projection *p)
{
    const uint32_t span = (uint32_t)p->far - (uint32_t)p->near;
    uint32_t near = (uint32_t)p->near + ((uint32_t)p->near >> 1), bits = 11;

    for (; near < span && bits > 5; near *= 2)
        bits--;
    return p->orthographic != 0 ? 11 : bits;
}

/* Draw the lines of all draws on the tile's rows [y0, y1). */
static void draw_all_lines(const struct sheen_frame *f, const struct worker *w, const struct tile *t, int32_t y0,
                           int32_t y1)
{
    const struct span none = {INT16_MAX, -1};
    struct line_tile lt = {.tile = t,
                           .vertex = f->vertex,
                           .y0 = y0,
                           .y1 = y1,
                           .whole_bits = whole_share_bits(&f->projection),
                           .apron = y0 - t->rect.y0,
                           .fog = f->view.fog != NULL ? &f->fog : NULL,
                           .rows = (uint32_t)(y1 - y0),
                           .touched = w->spans,
                           .marks = smooth_marks(f, w),
                           .mixed = smooth_mixed(f, w)};

    for (uint32_t row = 0; row < lt.rows; row++)
        w->spans[row] = none;
    const struct line_kind *smoothed = draw_lines_of(f, &lt, 1);
    if (smoothed != NULL)
        smoothed->finish(&lt);
    (void)draw_lines_of(f, &lt, 0);
}

/* Draw lines on the tile's rows within `rect`; the apron around them is cut off afterwards. */
static void edges_draw(const struct sheen_frame *f, struct worker *w, struct tile *t, struct sheen_rect rect)
{
    const size_t above = (size_t)t->pitch * (size_t)(rect.y0 - t->rect.y0);
    const int32_t strip_end = f->viewport.y0 + (w->last_band + 1) * f->config.band_rows;

    draw_all_lines(f, w, t, rect.y0, rect.y1);
    if (rect.y1 != strip_end) /* set-ups go on right below these rows, not at the next band */
        w->last_band = -2;
    const int32_t again = max32(t->rect.y1 - f->screen.shared_rows, t->rect.y0); /* a tile of one row has no apron */
    for (unsigned slot = w->first_carried; slot != f->config.max_carried; slot = slot_of(w, slot)->next)
        sheen_spans_back(slot_of(w, slot), again);
    t->depth += above;
    t->pixels = (char *)t->pixels + above * (t->format->grey ? 1 : 2);
    t->rect = rect;
}

#define FRAME_PART .list = edges_list, .cover = edges_cover, .begin = edges_begin, .draw = edges_draw

const struct sheen_edges sheen_edges_smooth = {FRAME_PART, .kind = &sheen_smooth_lines};
const struct sheen_edges sheen_edges_outline = {FRAME_PART, .kind = &sheen_outline_lines};
const struct sheen_edges sheen_edges_wire = {FRAME_PART, .kind = &sheen_wire_lines};
