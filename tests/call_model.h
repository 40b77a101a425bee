/*
 * call_model.h - the contract of a frame's calls, small enough to be read: three states, a done bit a band, one error.
 *
 * Each function makes the call, and checks what it returns and what the panel shows against the model. What is drawn
 * is not modelled: a picture has to be the one that a fresh full frame of the accepted draws gives.
 */
#ifndef CALL_MODEL_H
#define CALL_MODEL_H

#include "call_glass.h"
#include "frame_stage.h"

#define MODEL_DRAWS 3
#define MODEL_WORKERS 4

enum model_state {
    MODEL_IDLE,
    MODEL_OPEN,
    MODEL_BANDS
};

struct model {
    struct glass glass;
    struct sheen_config config;
    struct core_frame f;

    enum model_state state;
    int error;                                /* the frame's: the first that a push or a wait of it returned */
    bool all, all_next;                       /* this frame, the next one sends everything */
    bool whole;                               /* nothing has spoiled what this frame sends */
    bool due;                                 /* the last frame is to be seen once its last push has landed */
    bool done[GLASS_HEIGHT];                  /* a band: it was taken */
    bool busy[MODEL_WORKERS];                 /* a worker: it is in sheen_band */
    unsigned bands;                           /* of the view */
    struct sheen_view view;                   /* of the last frame that began, if any */
    struct sheen_rect viewport;               /* px */
    bool marked[GLASS_PIXELS];                /* pixels that a mark of this frame asked to be sent */
    unsigned vertices, listed, pieces, draws; /* accepted of this frame */
    struct sheen_object draw[MODEL_DRAWS];

    struct glass plain; /* for a fresh full frame, and for counting */
    struct core_frame full;
    bool aside; /* that frame is at work, not the one under test */
};

/* config: its target and lock are set to the model's glass, which glass_make has made. */
void model_make(struct model *m, const struct sheen_config *config, bool lock);
void model_free(struct model *m);

/* valid: 0, or what is owed to an argument out of range. */
void model_begin(struct model *m, const struct sheen_view *view, int valid);
void model_draw(struct model *m, const struct sheen_object *draw, int valid);
void model_mark(struct model *m, struct sheen_rect rect);
void model_band(struct model *m, unsigned worker, unsigned band);
void model_finish(struct model *m);
void model_end(struct model *m);
void model_wait(struct model *m);
void model_invalidate(struct model *m);

#endif
