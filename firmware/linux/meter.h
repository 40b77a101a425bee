/*
 * meter.h - prints once a second, on standard error, how long drawing and sending take, and the frame rate.
 */
#ifndef METER_H
#define METER_H

#include "sheen_sender.h"

struct meter {
    uint64_t since_ns; /* when this second began */
    uint64_t draw_ns;  /* processor time of the drawing thread when this second began */
    unsigned frames;   /* in this second */
};

void meter_start(struct meter *meter);

/* Call this after each frame. */
void meter_frame(struct meter *meter, struct sheen_sender *sender);

#endif
