/*
 * sheen_arena.h - the bytes of a frame's arena at compile time: what sheen_arena_size() computes at run time.
 *
 *     static uint64_t arena[SHEEN_ARENA_DEFAULT_BYTES(240, 240, 2, 530, 512) / 8];
 *
 * is for a configuration that sets nothing but target, max_vertices and max_triangles (on a target of less than 16 rows
 * it is more than needed), and so for up to 4 objects a frame.
 * SHEEN_ARENA_BYTES takes all that a configuration can set, with defaults written out: band_rows 16, at most height,
 * rounded up to align_y; buffers 1; used as many as vertices, and at most so many; draws 4; carried as many as
 * triangles, at most 80. pixel_bytes is 2 on 565, 1 on greys. The result is a multiple of 8. Add for
 *
 * - each further worker: SHEEN_WORKER_BYTES
 * - max_shades above 1, on 565: SHEEN_STORE(shades - 1, SHEEN_BYTES_SHADES), of which up to 8 bytes may stay unused
 * - max_edges: SHEEN_EDGE_BYTES, and SHEEN_EDGE_WORKER_BYTES for each further worker
 * - smooth: SHEEN_SMOOTH_BYTES for each worker
 */
#ifndef SHEEN_ARENA_H
#define SHEEN_ARENA_H

#include <stddef.h>
#include <stdint.h>

/* Sizes of the core's structs with pointers of 8 or 4 bytes; core/frame/arena.c asserts them. */
#if UINTPTR_MAX > 0xffffffffu
#define SHEEN_BYTES_FRAME 536
#define SHEEN_BYTES_DRAW 328
#define SHEEN_BYTES_WORKER 200
#define SHEEN_BYTES_SETUP 192
#else
#define SHEEN_BYTES_FRAME 412
#define SHEEN_BYTES_DRAW 272
#define SHEEN_BYTES_WORKER 140
#define SHEEN_BYTES_SETUP 176
#endif
#define SHEEN_BYTES_VERTEX 12
#define SHEEN_BYTES_ENTRY 4
#define SHEEN_BYTES_PIECE 56
#define SHEEN_BYTES_BAND 20
#define SHEEN_BYTES_SPAN 4
#define SHEEN_BYTES_EDGE 8
#define SHEEN_BYTES_SHADES 2100
#define SHEEN_BYTES_CLIPPING 648

#define SHEEN_STORE(count, bytes) (((size_t)(count) * (bytes) + 7) / 8 * 8)
#define SHEEN_BIT_STORE(count) SHEEN_STORE(((size_t)(count) + 31) / 32, 4)
#define SHEEN_BANDS(height, band_rows) (((size_t)(height) + (band_rows)-1) / (band_rows))

/* What each worker has: set-ups, pending bits, spans, depth, pixels. */
#define SHEEN_WORKER_STORES(width, pixel_bytes, band_rows, buffers, triangles, carried)                                \
    (SHEEN_STORE((carried) + 1, SHEEN_BYTES_SETUP) + SHEEN_BIT_STORE(triangles) +                                      \
     SHEEN_STORE(band_rows, SHEEN_BYTES_SPAN) + SHEEN_STORE((width) * (size_t)(band_rows), 2) +                        \
     (buffers)*SHEEN_STORE((width) * (size_t)(band_rows), pixel_bytes))

/* Bytes for each further worker. */
#define SHEEN_WORKER_BYTES(width, pixel_bytes, band_rows, buffers, triangles, carried)                                 \
    (SHEEN_BYTES_CLIPPING + SHEEN_STORE(1, SHEEN_BYTES_WORKER) +                                                       \
     SHEEN_WORKER_STORES(width, pixel_bytes, band_rows, buffers, triangles, carried))

/* Bytes that max_edges adds for each worker: two more rows of spans, depth and pixels. */
#define SHEEN_APRON_BYTES(width, rows, bytes)                                                                          \
    (SHEEN_STORE((width) * ((size_t)(rows) + 2), bytes) - SHEEN_STORE((width) * (size_t)(rows), bytes))
#define SHEEN_EDGE_WORKER_BYTES(width, pixel_bytes, band_rows, buffers)                                                \
    (SHEEN_APRON_BYTES(1, band_rows, SHEEN_BYTES_SPAN) + SHEEN_APRON_BYTES(width, band_rows, 2) +                      \
     (buffers)*SHEEN_APRON_BYTES(width, band_rows, pixel_bytes))

/* Bytes that smooth adds for each worker. */
#define SHEEN_SMOOTH_BYTES(width, band_rows) (((width) + (size_t)7) / 8 * 8 * ((size_t)(band_rows) + 8))

/* Bytes that max_edges adds to an arena with one worker. */
#define SHEEN_EDGE_BYTES(width, pixel_bytes, band_rows, buffers, edges)                                                \
    (SHEEN_STORE(edges, SHEEN_BYTES_EDGE) + SHEEN_EDGE_WORKER_BYTES(width, pixel_bytes, band_rows, buffers))

/* Bytes of an arena, see the top of this file. */
#define SHEEN_ARENA_BYTES(width, height, pixel_bytes, band_rows, buffers, vertices, used, triangles, draws, clipped,   \
                          carried)                                                                                     \
    (SHEEN_STORE(1, SHEEN_BYTES_FRAME) + SHEEN_STORE(SHEEN_BANDS(height, band_rows), SHEEN_BYTES_BAND) +               \
     SHEEN_BIT_STORE(SHEEN_BANDS(height, band_rows)) + SHEEN_STORE(draws, SHEEN_BYTES_DRAW) +                          \
     SHEEN_STORE(vertices, 2) + SHEEN_STORE(used, SHEEN_BYTES_VERTEX) + SHEEN_STORE(triangles, SHEEN_BYTES_ENTRY) +    \
     SHEEN_STORE(clipped, SHEEN_BYTES_PIECE) + ((clipped) > 0 ? SHEEN_BIT_STORE(triangles) : 0) +                      \
     ((pixel_bytes) > 1 ? SHEEN_STORE(1, SHEEN_BYTES_SHADES) : 0) +                                                    \
     SHEEN_WORKER_BYTES(width, pixel_bytes, band_rows, buffers, triangles, carried))

/* The same with defaults, see the top of this file. */
#define SHEEN_ARENA_DEFAULT_BYTES(width, height, pixel_bytes, vertices, triangles)                                     \
    SHEEN_ARENA_BYTES(width, height, pixel_bytes, 16, 1, vertices, vertices, triangles, 4, 0,                          \
                      (triangles) < 80 ? (triangles) : 80)

#endif
