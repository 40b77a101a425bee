/*
 * sheen_sender.h - a thread that sends, so that the next band is drawn meanwhile: the DMA of a board without DMA.
 *
 * A bus around a bus. Calls with much data are handed to the thread and return at
 * once; wait collects them and their error. Commands and short data go out on the
 * caller's thread: handing them over would take longer than sending them. Between
 * a call and its wait the inner bus, and its struct sheen_failure, are the thread's.
 */
#ifndef SHEEN_SENDER_H
#define SHEEN_SENDER_H

#include "sheen_bus.h"

#include <pthread.h>

#ifdef __cplusplus
extern "C" {
#endif

/* A bus whose calls a thread makes. Private but for layer.bus. */
struct sheen_sender {
    struct sheen_bus_layer layer;        /* layer.bus is what the panel driver is given; not to be moved */
    pthread_t thread;                    /* makes the calls */
    pthread_mutex_t lock;                /* guards what follows */
    pthread_cond_t changed;              /* a call came, or has been made */
    uint8_t command[SHEEN_BUS_COMMANDS]; /* of that call, copied */
    size_t commands;                     /* how many of them */
    const void *bytes;                   /* the call under way, with the command; NULL: none */
    size_t count;                        /* B of them */
    uint64_t busy_ns;                    /* time spent in the inner bus's send, until asked for */
    int error;                           /* of the last call, until wait takes it */
    int quit;                            /* 1: the thread is to end */
};

/* 0, or SHEEN_ERR_MEMORY where there is no thread to be had. *to must outlive the sender. */
int sheen_sender_open(struct sheen_sender *sender, const struct sheen_bus *to);

/* Waits for the call under way, whose error is lost (wait takes it), and ends the thread. */
void sheen_sender_close(struct sheen_sender *sender);

/* Nanoseconds that the bus has been busy sending, since the last call. */
uint64_t sheen_sender_busy_ns(struct sheen_sender *sender);

#ifdef __cplusplus
}
#endif
#endif
