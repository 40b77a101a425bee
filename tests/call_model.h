/*
 * call_model.h - a model of the contract of a frame's calls, small enough to be read: three states, a done bit per
 * band, one error.
 *
 * Each function makes the call and checks what it returns, and what the panel shows, against the model. Drawing itself
 * is not modelled: the picture has to equal that of a fresh frame with the accepted draws that sends everything.
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
    int error;                                /* the first error of a push or a wait of this frame; 0: none */
    bool all, all_next;                       /* this frame, the next frame has to send everything */
    bool whole;                               /* no error and no missing band has spoiled this frame's picture */
    bool due;                                 /* check the last frame's picture once its last push has ended */
    bool done[GLASS_HEIGHT];                  /* per band: sheen_band has accepted it */
    bool busy[MODEL_WORKERS];                 /* per worker: it is in sheen_band */
    unsigned bands;                           /* number of the view's bands */
    struct sheen_view view;                   /* of the last frame that began, if any */
    struct sheen_rect viewport;               /* px */
    bool marked[GLASS_PIXELS];                /* pixels that a mark of this frame asked to be sent */
    unsigned vertices, listed, pieces, draws; /* totals of this frame's accepted draws */
    struct sheen_object draw[MODEL_DRAWS];

    struct glass plain;     /* the panel of `full` */
    struct core_frame full; /* a second frame, for pictures that are sent whole, and for counting */
    bool aside;             /* `full` is drawing, not the frame under test */
};

/* The model's glass MUST be made; target and lock of config are replaced by the glass and its functions. */
void model_make(struct model *m, const struct sheen_config *config, bool lock);
void model_free(struct model *m);

/* valid: the result that the arguments call for: 0, or an error if one of them is out of range. */
void model_begin(struct model *m, const struct sheen_view *view, int valid);
void model_draw(struct model *m, const struct sheen_object *draw, int valid);
void model_mark(struct model *m, struct sheen_rect rect);
void model_band(struct model *m, unsigned worker, unsigned band);
void model_finish(struct model *m);
void model_end(struct model *m);
void model_wait(struct model *m);
void model_invalidate(struct model *m);

#endif
