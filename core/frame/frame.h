/*
 * frame.h - private: what each stage of a frame hands to the next.
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
    uint32_t first_vertex;           /* where the mesh's vertices begin in the frame's `place` */
    uint32_t end_entry;              /* one past this draw's last entry */
    struct draw as;                  /* what its triangles' set-ups need */
    const struct sheen_edges *edges; /* NULL: it draws none */
    uint16_t end_line, line;         /* one past its last line; the lines' colour as stored in a tile */
};

/* Something to be drawn; entries are in submission order, `next` links those that begin in the same band. */
struct entry {
    uint16_t triangle; /* index in the draw's mesh, a quad's first | QUAD; or of a piece, if its bit in `cut` is set */
    uint16_t next;
};

#define QUAD 0x8000u /* marks a quad in `triangle`, in draws that may list quads */

/* A piece of a triangle that was cut. */
struct piece {
    struct vertex corner[3];
    /* interpolated between the mesh's, brought to unit length for slerp only; or what the shader's `carry` gives */
    int16_t normal[3][3];
    uint16_t triangle;
};

struct band {
    struct sheen_rect cover; /* what this frame's triangles and lines may touch */
    struct sheen_rect stale; /* what the last frame's touched, and this frame's marks */
    uint16_t first;          /* head of the list of entries that begin here, or NONE */
    uint16_t back;           /* an entry that reaches this band begins at most this many bands above */
};

/* ---- workers and the frame ---- */

#define MAX_WORKERS 4

/* What struct sheen_stats takes from a frame's draws, and from each worker's bands. */
struct draw_counts {
    uint32_t triangles, front, drawn, clipped, edges;
};

struct band_counts {
    uint32_t spans, covered, shaded, rectangles, pixels;
};

struct worker {
    void *pixels[2];
    uint16_t *depth;
    struct span *spans; /* a span per row of the band and its apron; then what smoothing keeps */
    uint32_t *pending;  /* a bit per entry: it has begun and is not done */
    uint8_t *carried;   /* max_carried slots of SETUP_BYTES each, and a spare one that ends both lists */
    uint8_t first_carried, first_free;
    uint8_t buffer;                    /* index of the one to draw into next */
    uint8_t most_carried;              /* set-ups, in this frame, when one more was to be carried */
    int32_t last_band;                 /* the band drawn last; -2: `pending` is of no band */
    const threshold_t *dither_rows[8]; /* thresholds for the tile that is being drawn */
    struct band_counts count;          /* counters from here on, 0 when a frame begins */
    uint32_t by_way[SHEEN_WAYS];       /* set-ups made, by enum sheen_way */
};

/* The SHEEN_BYTES_CLIPPING before `carried`: a morph's normals until a set-up is made, then stippled rows. */
static inline void *scratch_of(const struct worker *w)
{
    return w->carried - SHEEN_BYTES_CLIPPING;
}

enum frame_state {
    IDLE, /* before sheen_begin, and from sheen_finish on */
    OPEN, /* draws and marks are accepted */
    BANDS /* a band has begun: no more draws or marks are accepted */
};

#define NOBODY MAX_WORKERS

static inline struct setup *slot_of(const struct worker *w, unsigned slot)
{
    return (struct setup *)(void *)(w->carried + slot * SETUP_BYTES);
}

/* Small fields come first, within reach of one instruction; the rest in the order of least code on ARMv6-M. */
struct sheen_frame {
    uint8_t state;         /* enum frame_state */
    uint8_t send_all;      /* this frame sends all of every band */
    uint8_t send_all_next; /* so will the next one: a push or wait failed, a band was left out, or sheen_invalidate() */
    uint8_t forced;        /* of the draws to come, see struct draw */
    uint8_t about;         /* enum sheen_subject of the last error */
    uint8_t pushing;       /* the worker whose push has not been waited for yet, or NOBODY */
    uint32_t needed;       /* the capacity that would have sufficed, for the last error */
    struct sheen_config config;
    const struct sheen_target *target;
    uint16_t *place; /* for each vertex of the drawn meshes its index in `vertex`; from config.max_used on: none */
    struct vertex *vertex; /* the used ones, transformed */
    struct entry *entry;
    struct shades *shades; /* config.max_shades of them */
    uint32_t *cut;         /* a bit per entry: it is a piece */
    struct piece *piece;
    struct draw_record *draw;
    struct band *band;
    struct worker *worker;           /* config.workers of them */
    const struct sheen_edges *edges; /* NULL: no draw has any yet; else the last one's. COUNTED_BYTES begin here */
    uint32_t vertices, draws;
    int error;                                        /* the first that a push or a wait of this frame returned */
    uint32_t used_short, entries_short, pieces_short; /* of this draw, found no room. UNDONE_BYTES begin here */
    uint32_t used, entries, pieces;
    unsigned shaded_colors; /* the first ones of `shades`, which hold this frame's */
    struct draw_counts count;
    unsigned bands, bands_left;
    uint32_t band_scale; /* UQ0.20, rounded up: row * band_scale >> 20 = row / band_rows, row <= 480 */
    unsigned max_bands;
    uint32_t *done;                      /* a bit per band: it has begun in this frame */
    const struct sheen_stipple *stipple; /* what draws the rows of stippled draws */
    struct line *line;                   /* config.max_edges of them; the first count.edges are listed */
    void *scratch;                       /* worker 0's: room for two polygons of MAX_CLIP_CORNERS */
    struct pixel_format format;
    struct screen screen;
    struct projection projection;
    struct fog_terms fog; /* the view's */
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

#define NO_PLACE 0xffffu /* in `place`: not used yet; a vertex that found no room has config.max_used */

/* The transformed vertex `index` of a draw's mesh; it has to be a used one. */
static inline struct vertex *used_vertex(const struct sheen_frame *f, const struct draw_record *d, uint32_t index)
{
    return &f->vertex[f->place[d->first_vertex + index]];
}

/* Whether an entry is a piece. */
static inline int is_cut(const struct sheen_frame *f, uint32_t entry)
{
    return f->cut != NULL && (f->cut[entry >> 5] >> (entry & 31u) & 1u) != 0;
}

/* Whether an entry is a quad, from its `triangle`; the entry must not be a piece. */
static inline int is_quad(const struct draw_record *d, uint32_t triangle)
{
    return d->as.quads && (triangle & QUAD) != 0;
}

/* pieces.c, linked if a program names it. */
struct sheen_clipper {
    /* Cut a triangle and list the pieces that are left; those without room are counted in f->pieces_short. */
    void (*cut)(struct sheen_frame *f, const struct draw_record *d, const struct transform *t, uint16_t triangle);
    /* sheen_entry_corners() for an entry that is a piece. */
    void (*corners)(const struct piece *piece, struct corners *c);
};

/* The corner of a mesh's triangle, which is counter-clockwise, that is corner k of an entry, which is clockwise. */
static inline unsigned clockwise_corner(unsigned k)
{
    static const uint8_t order[3] = {0, 2, 1};

    return order[k];
}

/* quads.c, linked if a program names it. */
struct sheen_quads {
    /* The value of a draw's `quads`; the draw's light has to be known. */
    uint8_t (*most)(const struct sheen_frame *f, const struct draw *d);
    /*
     * List triangles i and i + 1 of a plane polygon as one quad, or skip both if they face away; returns 1. Returns 0
     * if they have to be drawn one by one.
     */
    int (*list)(struct sheen_frame *f, const struct draw_record *d, const struct transform *t, const uint16_t *place,
                uint32_t i);
    /* sheen_entry_corners() for a quad; triangle: its first. */
    void (*corners)(const struct sheen_frame *f, const struct draw_record *d, uint32_t triangle, struct corners *c);
};

/*
 * The most pieces that a triangle gives. The near plane may leave four corners, which affine views treat as two
 * triangles; each of the other five planes adds at most one corner to either, so each has at most eight: six pieces.
 */
#define MOST_PIECES (2 * (3 + (CLIP_PLANES - 1) - 2))

/* Make the entries that begin in a band pending. */
static inline void add_list(const struct sheen_frame *f, struct worker *w, unsigned band)
{
    for (uint32_t e = f->band[band].first; e != NONE; e = f->entry[e].next)
        w->pending[e >> 5] |= 1u << (e & 31u);
}

/* No entry is pending, and no set-up is carried. */
static inline void pending_clear(const struct sheen_frame *f, struct worker *w)
{
    const unsigned slots = f->config.max_carried;

    memset(w->pending, 0, (f->entries + 31) / 32 * sizeof(uint32_t));
    w->first_carried = (uint8_t)slots;
    w->first_free = 0;
    for (unsigned i = 0; i < slots; i++)
        slot_of(w, i)->next = (uint8_t)(i + 1);
}

/* Note what an error is about; returns the error. */
static inline int refuse(struct sheen_frame *f, int error, enum sheen_subject subject, uint32_t needed)
{
    f->about = (uint8_t)subject;
    f->needed = needed;
    return error;
}

/* `needed` used vertices suffice. Ends of cut lines may need more than max_vertices, the most that max_used can be. */
static inline int refuse_used(struct sheen_frame *f, uint32_t needed)
{
    return refuse(f, SHEEN_ERR_CAPACITY,
                  needed > f->config.max_vertices ? SHEEN_ABOUT_MAX_VERTICES : SHEEN_ABOUT_MAX_USED, needed);
}

/*
 * edges.c: what a frame does for the edges of its draws, linked if a program names them.
 *
 * list: lists a draw's lines, after its triangles; sets d->edges to NULL if this target shows none of them. On an error
 *   the caller undoes the draw.
 * cover: adds the lines from line `first` on to the `cover` of the bands that they cross.
 * begin: called before band b is drawn: gives the tile an apron and makes the entries that the apron shows pending.
 * draw: called after the tile's triangles: draws lines on the rows of `rect` and cuts the tile back to `rect`.
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
 * frame.c: transform those of `count` vertices that are used for the first time, 0 if one of them finds no room; light
 * vertices, each only once.
 */
int sheen_use_corners(struct sheen_frame *f, const struct draw_record *d, const struct transform *t,
                      const uint32_t *index, int count);
void sheen_light_corners(const struct draw *d, const struct vertex *const v[], const uint32_t *index, int count);

/* bin.c */
void sheen_bin_clear(struct sheen_frame *f);
int sheen_bin_triangle(struct sheen_frame *f, const struct vertex *const v[4], uint32_t triangle, unsigned flags);
/* Add a rectangle to the `cover` of the bands it crosses; it lies within the viewport and is not empty. */
void sheen_bin_cover(struct sheen_frame *f, struct sheen_rect rect);
void sheen_bin_rollback(struct sheen_frame *f, uint32_t entries);
void sheen_entry_corners(const struct sheen_frame *f, const struct draw_record *d, uint32_t entry, struct corners *c);

/* Empty; united with another rectangle it gives that one. */
#define NO_RECT ((struct sheen_rect){INT16_MAX, INT16_MAX, INT16_MIN, INT16_MIN})

/* *r becomes the smallest rectangle around both, or their intersection. */
void sheen_rect_unite(struct sheen_rect *r, const struct sheen_rect *with);
void sheen_rect_cut(struct sheen_rect *r, const struct sheen_rect *by);
/* Grow *r outwards to multiples of the target's alignment. */
void sheen_rect_align(struct sheen_rect *r, const struct sheen_target *target);
/* The rows of the viewport that are band b. */
void sheen_band_strip(const struct sheen_frame *f, unsigned b, struct sheen_rect *strip);

static inline int rect_empty(struct sheen_rect r)
{
    return r.x0 >= r.x1 || r.y0 >= r.y1;
}

/*
 * send.c: a worker claims band b (0, or the error that sheen_band returns); makes sure that its buffer is free (0, or a
 * wait's error); sends its tile (0, or the frame's error, whichever worker caused it).
 */
int sheen_claim_band(struct sheen_frame *f, unsigned worker, unsigned b);
int sheen_free_buffer(struct sheen_frame *f, unsigned worker);
int sheen_send_tile(struct sheen_frame *f, unsigned worker, const struct tile *t);

#endif
