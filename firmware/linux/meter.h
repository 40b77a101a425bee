/*
 * meter.h - once a second on standard error: how long drawing and sending take, and how many frames come of it.
 */
#ifndef METER_H
#define METER_H

#include "sheen_sender.h"

struct meter {
    uint64_t since_ns; /* of this second */
    uint64_t draw_ns;  /* processor time of the drawing thread at its start */
    unsigned frames;   /* in it */
};

void meter_start(struct meter *meter);

/* A frame is done. */
void meter_frame(struct meter *meter, struct sheen_sender *sender);

#endif
