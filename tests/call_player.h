/*
 * call_player.h - a random sequence of calls on one frame, with a random configuration and random views.
 */
#ifndef CALL_PLAYER_H
#define CALL_PLAYER_H

#include "call_model.h"

/* How often things happened, because a test in which nothing happens proves nothing. */
struct call_counts {
    unsigned frames, drawn, incremental; /* complete frames; those with triangles; those that did not send everything */
    unsigned failures;                   /* frames that a failed push or wait ended */
    unsigned nested;                     /* bands drawn in the middle of another worker's band */
    unsigned clipped;                    /* draws that listed pieces */
};

/* A sequence: the model, the random generator's state, the view of the next frame. */
struct player {
    unsigned number, calls; /* the sequence's number; calls made so far */
    struct model model;
    struct call_counts *counts;
    uint32_t state;
    struct sheen_view view;
    struct sheen_mesh fan;
    int16_t position[3 * 42];
    uint8_t index[3 * 40];
};

/* counts and stage are borrowed; stage_make() has made the stage. Only one player may be open at a time. */
void player_open(struct player *p, const struct stage *stage, unsigned number, struct call_counts *counts);
void player_call(struct player *p);
void player_close(struct player *p);

#endif
