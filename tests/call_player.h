/*
 * call_player.h - a random sequence of calls: of which kinds, in what configuration, on what view.
 */
#ifndef CALL_PLAYER_H
#define CALL_PLAYER_H

#include "call_model.h"

/* How often things happened: a test that meets nothing proves nothing. */
struct call_counts {
    unsigned frames, drawn, incremental; /* that arrived; of these, with triangles; and not sent whole */
    unsigned failures;                   /* frames that a push or a wait broke off */
    unsigned nested;                     /* bands in the midst of another worker's */
    unsigned clipped;                    /* draws that listed pieces */
};

/* A sequence: the model, the generator, and what the next view is. */
struct player {
    unsigned number, calls; /* of the sequence; made so far */
    struct model model;
    struct call_counts *counts;
    uint32_t state;
    struct sheen_view view;
    struct sheen_mesh fan;
    int16_t position[3 * 42];
    uint8_t index[3 * 40];
};

/* counts and stage are borrowed; the stage is made. One player at a time. */
void player_open(struct player *p, const struct stage *stage, unsigned number, struct call_counts *counts);
void player_call(struct player *p);
void player_close(struct player *p);

#endif
