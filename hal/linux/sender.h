/*
 * sender.h - a thread that sends, so that the next band is drawn meanwhile: the DMA of a board without DMA.
 *
 * A bus around a bus. Long writes of data are handed to the thread and return at
 * once; wait collects them and their error. Commands and short writes go out on
 * the caller's thread: handing them over would take longer than sending them.
 * Between a write and its wait the inner bus, and its struct sheen_failure, are
 * the thread's.
 */
#ifndef SHEEN_SENDER_H
#define SHEEN_SENDER_H

#include "sheen_bus.h"

#include <pthread.h>

#ifdef __cplusplus
extern "C" {
#endif

struct sheen_sender {
    struct sheen_bus bus;       /* what the panel driver is given; ctx is this struct: it must not be moved */
    const struct sheen_bus *to; /* whose bytes leave */
    pthread_t thread;
    pthread_mutex_t lock; /* guards what follows */
    pthread_cond_t changed;
    const void *bytes; /* the write under way; NULL: none */
    size_t count;
    uint64_t busy_ns; /* time spent in the inner bus's write, since the start */
    int error;        /* of the last write, until wait takes it */
    int quit;
};

/* 0, or SHEEN_ERR_MEMORY where there is no thread to be had. *to must outlive the sender. */
int sheen_sender_open(struct sheen_sender *sender, const struct sheen_bus *to);

/* Waits for the write under way and ends the thread. */
void sheen_sender_close(struct sheen_sender *sender);

/* Nanoseconds that the bus has been busy writing, since the last call. */
uint64_t sheen_sender_busy_ns(struct sheen_sender *sender);

#ifdef __cplusplus
}
#endif
#endif
