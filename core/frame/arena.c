/*
 * arena.c - a frame's stores in the caller's memory: their sizes, and where each one lies.
 */
#include <string.h>

#include "frame.h"

static int target_valid(const struct sheen_target *t)
{
    unsigned x = or_default(t->align_x, 1), y = or_default(t->align_y, 1);

    return t->push != NULL && t->width >= 1 && t->width <= 640 && t->height >= 1 && t->height <= 480 &&
           t->pixel <= SHEEN_GREY256 && x * sheen_pixel_bits((enum sheen_pixel)t->pixel) % 8 == 0 && x <= 16 &&
           (x & (x - 1)) == 0 && y <= 16 && (y & (y - 1)) == 0;
}

/* Fill in the defaults and align the band's height; returns what is out of range, or SHEEN_ABOUT_NOTHING. */
static COLD enum sheen_subject config_complete(struct sheen_config *c)
{
    if (c->target == NULL || !target_valid(c->target))
        return SHEEN_ABOUT_TARGET;
    unsigned align = or_default(c->target->align_y, 1);

    c->band_rows = (uint16_t)or_default(c->band_rows, 16);
    if (c->band_rows > c->target->height)
        c->band_rows = c->target->height;
    c->band_rows = (uint16_t)((c->band_rows + align - 1) & ~(align - 1));
    c->buffers = (uint8_t)or_default(c->buffers, 1);
    c->workers = (uint8_t)or_default(c->workers, 1);
    c->max_used = (uint16_t)min32((int32_t)or_default(c->max_used, c->max_vertices), c->max_vertices);
    c->max_draws = (uint16_t)or_default(c->max_draws, 4);
    c->max_shades = (uint8_t)or_default(c->max_shades, 1);
    c->max_carried = (uint16_t)or_default(c->max_carried, c->max_triangles < 80 ? c->max_triangles : 80);
    return c->buffers > 2                             ? SHEEN_ABOUT_BUFFERS
           : c->workers > MAX_WORKERS                 ? SHEEN_ABOUT_WORKERS
           : (c->lock == NULL) != (c->unlock == NULL) ? SHEEN_ABOUT_LOCK
           : c->max_vertices == 0                     ? SHEEN_ABOUT_MAX_VERTICES
           : c->max_triangles == 0                    ? SHEEN_ABOUT_MAX_TRIANGLES
           : c->max_carried > 254                     ? SHEEN_ABOUT_MAX_CARRIED
           : c->max_clipped > 0 && c->clipper == NULL ? SHEEN_ABOUT_CLIPPER
                                                      : SHEEN_ABOUT_NOTHING;
}

COLD enum sheen_subject sheen_config_about(const struct sheen_config *config)
{
    struct sheen_config c = *config;

    return config_complete(&c);
}

/* The sizes that SHEEN_ARENA_BYTES assumes are the actual ones. */
_Static_assert(sizeof(struct sheen_frame) == SHEEN_BYTES_FRAME && sizeof(struct draw_record) == SHEEN_BYTES_DRAW &&
                   sizeof(struct worker) == SHEEN_BYTES_WORKER && SETUP_BYTES == SHEEN_BYTES_SETUP &&
                   sizeof(struct vertex) == SHEEN_BYTES_VERTEX && sizeof(struct entry) == SHEEN_BYTES_ENTRY &&
                   sizeof(struct piece) == SHEEN_BYTES_PIECE && sizeof(struct band) == SHEEN_BYTES_BAND &&
                   sizeof(struct span) == SHEEN_BYTES_SPAN && sizeof(struct line) == SHEEN_BYTES_EDGE &&
                   sizeof(struct shades) == SHEEN_BYTES_SHADES &&
                   sizeof(struct stippled_rows) <= SHEEN_BYTES_CLIPPING && SHEEN_BYTES_CLIPPING % 8 == 0 &&
                   2 * MAX_CLIP_CORNERS * sizeof(struct clip_corner) == SHEEN_BYTES_CLIPPING,
               "sheen_arena.h does not count with the stores' sizes");

/* An arena, and how much of it is taken; base NULL: sizes are only added up. */
struct arena {
    uint8_t *base;
    size_t used;
};

/* The next store of an arena, aligned to 8 bytes; NULL if sizes are only added up. */
static APART void *take(struct arena *a, size_t count, size_t bytes)
{
    void *piece = a->base != NULL ? a->base + a->used : NULL;

    a->used += (count * bytes + 7) & ~(size_t)7;
    return piece;
}

/* Lay the stores out in the arena; returns its size. With base NULL only *f is written. */
static COLD size_t lay_out(struct sheen_frame *f, uint8_t *base)
{
    const struct sheen_config *c = &f->config;
    struct arena arena = {base, 0};
    size_t bits = ((size_t)c->max_triangles + 31) / 32, width = c->target->width;
    size_t rows = c->band_rows + (c->max_edges > 0 ? 2u * LINE_APRON : 0), tile = width * rows;
    size_t marks = c->smooth * (MARK_PITCH(width) / 4) * (c->band_rows + MARK_ROWS);

    (void)take(&arena, 1, SHEEN_BYTES_FRAME);
    f->max_bands = QUOTIENT(c->target->height + c->band_rows - 1u, c->band_rows);
    f->band = take(&arena, f->max_bands, SHEEN_BYTES_BAND);
    f->done = take(&arena, (f->max_bands + 31u) / 32, sizeof(uint32_t));
    f->draw = take(&arena, c->max_draws, SHEEN_BYTES_DRAW);
    f->shades = take(&arena, c->target->pixel > SHEEN_RGB565_LE ? 0 : c->max_shades, SHEEN_BYTES_SHADES);
    f->place = take(&arena, c->max_vertices, sizeof *f->place);
    f->vertex = take(&arena, c->max_used, SHEEN_BYTES_VERTEX);
    f->entry = take(&arena, c->max_triangles, SHEEN_BYTES_ENTRY);
    f->piece = take(&arena, c->max_clipped, SHEEN_BYTES_PIECE);
    f->cut = take(&arena, c->max_clipped > 0 ? bits : 0, sizeof(uint32_t));
    if (c->max_clipped == 0)
        f->cut = NULL;
    f->line = take(&arena, c->max_edges, SHEEN_BYTES_EDGE);
    f->worker = take(&arena, c->workers, SHEEN_BYTES_WORKER);
    for (unsigned i = 0; i < c->workers; i++) {
        struct worker counted, *w = base != NULL ? &f->worker[i] : &counted;
        void *scratch = take(&arena, 1, SHEEN_BYTES_CLIPPING); /* for stippling, morphs; worker 0's: clipping too */
        f->scratch = i == 0 ? scratch : f->scratch;
        w->carried = take(&arena, c->max_carried + 1u, SHEEN_BYTES_SETUP);
        w->pending = take(&arena, bits, sizeof(uint32_t));
        w->spans = take(&arena, rows + marks, SHEEN_BYTES_SPAN);
        w->depth = take(&arena, tile, sizeof(uint16_t));
        for (unsigned k = 0; k < c->buffers; k++)
            w->pixels[k] = take(&arena, tile, c->target->pixel > SHEEN_RGB565_LE ? 1 : 2);
    }
    return arena.used;
}

COLD size_t sheen_arena_size(const struct sheen_config *config)
{
    struct sheen_frame f;

    f.config = *config;
    return config_complete(&f.config) != SHEEN_ABOUT_NOTHING ? 0 : lay_out(&f, NULL);
}

COLD int sheen_init(struct sheen_frame **frame, void *arena, size_t *size, const struct sheen_config *config)
{
    if (frame == NULL || arena == NULL || size == NULL || config == NULL || ((uintptr_t)arena & 7u) != 0)
        return SHEEN_ERR_ARGUMENT;
    size_t needed = sheen_arena_size(config);
    if (needed == 0)
        return SHEEN_ERR_ARGUMENT;
    if (*size < needed) {
        *size = needed;
        return SHEEN_ERR_MEMORY;
    }

    struct sheen_frame *f = arena;
    memset(f, 0, needed);
    f->config = *config;
    (void)config_complete(&f->config);
    f->target = config->target;
    sheen_format_begin(&f->format, f->target);
    f->arena_bytes = lay_out(f, arena);
    f->pushing = NOBODY;
    f->send_all_next = 1;
    *frame = f;
    return SHEEN_OK;
}
