/*
 * frame.h - private: what each stage of a frame hands the next.
 *
 *   transform -> clip -> bin -> light -> setup -> spans -> *_rows.c -> target
 *
 * frame.c calls the first four in this order, band.c the others. Everything here lives in the caller's arena.
 */
#ifndef SHEEN_FRAME_H
#define SHEEN_FRAME_H

#include <string.h>

#include "../lines/lines.h"
#include "../shading/shading.h"
#include "../triangle/fog.h"
#include "../triangle/morph.h"
#include "../triangle/stipple.h"

#define NONE 0xffffu /* end of a list of entries */

/* ---- draws and lists ---- */

/* What a draw call left behind for the bands. */
struct draw_record {
    uint32_t first_vertex;           /* of the mesh in the frame's `place` */
    uint32_t end_entry;              /* entries of this draw end here */
    struct draw as;                  /* what its triangles need */
    const struct sheen_edges *edges; /* NULL: it has none */
    uint16_t end_line, line;         /* lines of this draw end here; their pixel, in the target's form */
};

/* A visible triangle, in submission order; `next` links those that begin in the same band. */
struct entry {
    uint16_t triangle; /* of the draw's mesh, a quad's first | QUAD; or a piece's index where its bit in `cut` is set */
    uint16_t next;
};

#define QUAD 0x8000u /* two triangles of a plane polygon as one, of draws that list quads */

/* A piece of a triangle that was cut. */
struct piece {
    struct vertex corner[3];
    int16_t normal[3][3]; /* linear in space between the mesh's, so no unit vectors; or what the shading carries */
    uint16_t triangle;
};

struct band {
    struct sheen_rect cover; /* what this frame's triangles may touch */
    struct sheen_rect stale; /* what the last frame's touched, and marks */
    uint16_t first;          /* entry that begins here, or NONE */
    uint16_t back;           /* the oldest triangle here begins this many bands back */
};

/* ---- workers and the frame ---- */

#define MAX_WORKERS 4

struct worker {
    void *pixels[2];
    uint16_t *depth;
    struct span *spans; /* band_rows, and those of the apron; then what smoothing keeps */
    uint32_t *pending;  /* a bit an entry: begun, not done */
    uint8_t *carried;   /* SETUP_BYTES each: max_carried slots, and a spare one that both lists of them end in */
    uint8_t first_carried, first_free;
    uint8_t buffer;                    /* the one to draw into next */
    int32_t last_band;                 /* -2 before the first */
    const threshold_t *dither_rows[8]; /* of the tile that is drawn, where something dithers */
    struct sheen_stats stats;          /* from here on counters, 0 when a frame begins */
    uint32_t by_way[SHEEN_WAYS];       /* set-ups */
};

/* SHEEN_BYTES_CLIPPING before `carried`: a morph's normals, until an entry's set-up is made; then stippled rows. */
static inline void *scratch_of(const struct worker *w)
{
    return w->carried - SHEEN_BYTES_CLIPPING;
}

enum frame_state {
    IDLE, /* until sheen_begin, and from sheen_finish on */
    OPEN, /* draws and marks are taken */
    BANDS /* a band has begun: what was drawn stays as it is */
};

#define NOBODY MAX_WORKERS

static inline struct setup *slot_of(const struct worker *w, unsigned slot)
{
    return (struct setup *)(void *)(w->carried + slot * SETUP_BYTES);
}

/* What is small stands first, within reach of one instruction; the rest as it takes least code on ARMv6-M. */
struct sheen_frame {
    uint8_t state;         /* enum frame_state */
    uint8_t send_all;      /* this frame sends every band whole */
    uint8_t send_all_next; /* so will the next one: a push or a wait failed, a band was left out, or sheen_invalidate */
    uint8_t forced;        /* for the draws to come, as in struct draw */
    uint8_t about;         /* enum sheen_subject of the last error, see `needed` */
    uint8_t flying;        /* the worker whose push awaits its wait, or NOBODY */
    uint32_t needed;       /* how much would have done, for the last error */
    struct sheen_config config;
    const struct sheen_target *target;
    uint16_t *place; /* of each vertex of the drawn meshes its place in `vertex`; config.max_used and more: none */
    struct vertex *vertex; /* the used ones: transformed */
    struct entry *entry;
    struct shades *shades; /* config.max_shades */
    uint32_t *cut;         /* a bit an entry: its triangle is a piece */
    struct piece *piece;
    struct draw_record *draw;
    struct band *band;
    struct worker *worker;           /* config.workers */
    const struct sheen_edges *edges; /* NULL: no draw has any yet; else the first one's. From here on: COUNTED_BYTES */
    uint32_t vertices, draws;
    int error;                                        /* the first of this frame's pushes and waits */
    uint32_t used_short, entries_short, pieces_short; /* of this draw, found no room. From here on: TAKEN_BYTES */
    uint32_t used, entries, pieces;
    unsigned shaded_colors; /* of `shades`, which have this frame's */
    struct sheen_stats stats;
    unsigned bands, bands_left;
    uint32_t band_scale; /* UQ0.20, rounded up: row * band_scale >> 20 = row / band_rows, row <= 480 */
    unsigned max_bands;
    uint32_t *done;                      /* a bit a band of this frame that has begun */
    const struct sheen_stipple *stipple; /* of the draws that leave pixels out */
    struct line *line;                   /* config.max_edges, the first stats.edges are listed */
    void *scratch;                       /* of worker 0: two polygons of MAX_CLIP_CORNERS */
    struct pixel_format format;
    struct screen screen;
    struct projection projection;
    struct fog_terms fog; /* of the view */
    size_t arena_bytes;
    struct sheen_view view;
    struct sheen_rect viewport;
};

/* Screen coordinates of a vertex on the target, 1/64 px. */
static inline int32_t target_x(const struct sheen_frame *f, int32_t x)
{
    return x + f->screen.centre_x;
}

static inline int32_t target_y(const struct sheen_frame *f, int32_t y)
{
    return y + f->screen.centre_y;
}

#define NO_PLACE 0xffffu /* not used yet; a vertex that found no room has config.max_used */

/* Vertex `index` of a draw's mesh, which is used. */
static inline struct vertex *used_vertex(const struct sheen_frame *f, const struct draw_record *d, uint32_t index)
{
    return &f->vertex[f->place[d->first_vertex + index]];
}

/* Whether an entry's `triangle` is a piece of one. */
static inline int is_cut(const struct sheen_frame *f, uint32_t entry)
{
    return f->cut != NULL && (f->cut[entry >> 5] >> (entry & 31u) & 1u) != 0;
}

/* Whether it begins a quad, of an entry that is no piece. */
static inline int is_quad(const struct draw_record *d, uint32_t triangle)
{
    return d->as.quads && (triangle & QUAD) != 0;
}

/* pieces.c, linked where a caller names it. */
struct sheen_clipper {
    /* Cut a triangle and list what is left; pieces that find no room are counted in f->pieces_short. */
    void (*cut)(struct sheen_frame *f, const struct draw_record *d, const struct transform *t, uint16_t triangle);
    /* As sheen_entry_corners, of an entry that is a piece. */
    void (*corners)(const struct piece *piece, struct corners *c);
};

/* Corner k of an entry: meshes are counterclockwise. */
static inline unsigned clockwise(unsigned k)
{
    static const uint8_t order[3] = {0, 2, 1};

    return order[k];
}

/* quads.c, linked where a caller names it. */
struct sheen_quads {
    /* What a draw's `quads` is, once its light is known. */
    uint8_t (*most)(const struct sheen_frame *f, const struct draw *d);
    /*
     * List triangles i and i + 1 of a plane polygon as a quad, or pass over them where both face away: 1; 0 where they
     * have to be drawn by themselves.
     */
    int (*list)(struct sheen_frame *f, const struct draw_record *d, const struct transform *t, const uint16_t *place,
                uint32_t i);
    /* As sheen_entry_corners, of a quad. */
    void (*corners)(const struct sheen_frame *f, const struct draw_record *d, uint32_t triangle, struct corners *c);
};

/*
 * Pieces that a triangle gives at most: the near plane may leave four corners, two triangles where the screen is
 * affine; the other five planes add a corner each, so each of the two has eight at most, which are six pieces.
 */
#define MOST_PIECES (2 * (3 + (CLIP_PLANES - 1) - 2))

/* What begins in a band is pending. */
static inline void add_list(const struct sheen_frame *f, struct worker *w, unsigned band)
{
    for (uint32_t e = f->band[band].first; e != NONE; e = f->entry[e].next)
        w->pending[e >> 5] |= 1u << (e & 31u);
}

/* Nothing is. */
static inline void pending_clear(const struct sheen_frame *f, struct worker *w)
{
    const unsigned slots = f->config.max_carried;

    memset(w->pending, 0, (f->entries + 31) / 32 * sizeof(uint32_t));
    w->first_carried = (uint8_t)slots;
    w->first_free = 0;
    for (unsigned i = 0; i < slots; i++)
        slot_of(w, i)->next = (uint8_t)(i + 1);
}

/* Notes what an error is about, and returns it. */
static inline int refuse(struct sheen_frame *f, int error, enum sheen_subject subject, uint32_t needed)
{
    f->about = (uint8_t)subject;
    f->needed = needed;
    return error;
}

/* So many places were needed. max_used is held at max_vertices, which ends of lines that are cut may exceed. */
static inline int refuse_used(struct sheen_frame *f, uint32_t needed)
{
    return refuse(f, SHEEN_ERR_CAPACITY,
                  needed > f->config.max_vertices ? SHEEN_ABOUT_MAX_VERTICES : SHEEN_ABOUT_MAX_USED, needed);
}

/*
 * edges.c: what a frame does for the edges of its draws, linked where a caller names them.
 *
 * list: of a draw, after its triangles; draws that have no edges on this target lose d->edges. On an error the draw is
 *   taken back.
 * cover: the bands that lines cross, from line `first` on, are to be drawn.
 * begin: before band b is drawn: the tile gets an apron, what that shows is pending.
 * draw: after its triangles: lines on the tile's rows within `rect`, which the tile then has again.
 */
struct sheen_edges {
    int (*list)(struct sheen_frame *f, struct draw_record *d, const struct sheen_object *object,
                const struct transform *t);
    void (*cover)(struct sheen_frame *f, uint32_t first);
    void (*begin)(const struct sheen_frame *f, struct worker *w, struct tile *t, unsigned b);
    void (*draw)(const struct sheen_frame *f, struct worker *w, struct tile *t, struct sheen_rect rect);
    const struct line_kind *kind;
};

static inline uint32_t or_default(uint32_t value, uint32_t fallback)
{
    return value != 0 ? value : fallback;
}

/*
 * frame.c: transform those of `count` vertices that are used for the first time, 0 where one found no room; light them,
 * each once.
 */
int sheen_use_corners(struct sheen_frame *f, const struct draw_record *d, const struct transform *t,
                      const uint32_t *index, int count);
void sheen_light_corners(const struct draw *d, const struct vertex *const v[], const uint32_t *index, int count);

/* bin.c */
void sheen_bin_clear(struct sheen_frame *f);
int sheen_bin_triangle(struct sheen_frame *f, const struct vertex *const v[4], uint32_t triangle, unsigned flags);
/* Grow the bands that a rectangle within the viewport, not empty, crosses. */
void sheen_bin_cover(struct sheen_frame *f, struct sheen_rect rect);
void sheen_bin_rollback(struct sheen_frame *f, uint32_t entries);
void sheen_entry_corners(const struct sheen_frame *f, const struct draw_record *d, uint32_t entry, struct corners *c);

/* Holds nothing, and united with another is that. */
#define NO_RECT ((struct sheen_rect){INT16_MAX, INT16_MAX, INT16_MIN, INT16_MIN})

/* r becomes what holds both, or what is in both. */
void sheen_rect_unite(struct sheen_rect *r, const struct sheen_rect *with);
void sheen_rect_cut(struct sheen_rect *r, const struct sheen_rect *by);
/* Outwards to multiples of the target's alignment. */
void sheen_rect_align(struct sheen_rect *r, const struct sheen_target *target);
/* Band b's rows of the viewport. */
void sheen_band_strip(const struct sheen_frame *f, unsigned b, struct sheen_rect *strip);

static inline int rect_empty(struct sheen_rect r)
{
    return r.x0 >= r.x1 || r.y0 >= r.y1;
}

/*
 * send.c. A worker takes band b: 0, or what sheen_band answers. Then, if there is something to draw, it sees to a free
 * buffer (0, or the error that a wait brought) and sends: the frame's error, whoever met it.
 */
int sheen_claim_band(struct sheen_frame *f, unsigned worker, unsigned b);
int sheen_free_buffer(struct sheen_frame *f, unsigned worker);
int sheen_send_tile(struct sheen_frame *f, unsigned worker, const struct tile *t);

#endif
