/*
 * sheen_sender.h - a thread that sends while the next band is drawn, as DMA does on a microcontroller.
 *
 * A sender is a bus around another bus. Calls with much data are handed to the
 * thread and return at once; wait waits for the thread and returns its error.
 * Commands and short data are sent by the calling thread, because handing them over
 * would take longer. From the hand-over of a call until wait has returned, only the
 * thread may use the inner bus and its struct sheen_failure.
 */
#ifndef SHEEN_SENDER_H
#define SHEEN_SENDER_H

#include "sheen_bus.h"

#include <pthread.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Private, except layer.bus. */
struct sheen_sender {
    struct sheen_bus_layer layer;        /* give layer.bus to the panel; must not be moved */
    pthread_t thread;                    /* makes the calls of the inner bus */
    pthread_mutex_t lock;                /* guards all fields below */
    pthread_cond_t changed;              /* a call was handed over, or is finished */
    uint8_t command[SHEEN_BUS_COMMANDS]; /* command bytes of the call under way, copied */
    size_t commands;                     /* number of command bytes */
    const void *bytes;                   /* data of the call under way; NULL: no call */
    size_t count;                        /* number of data bytes */
    uint64_t busy_ns;                    /* time spent in the inner bus's send since it was last asked for */
    int error;                           /* of the last call, until wait returns it */
    int quit;                            /* 1: the thread shall end */
};

/* Starts the thread: 0, or SHEEN_ERR_MEMORY if the system has none to give. *to must outlive the sender. */
int sheen_sender_open(struct sheen_sender *sender, const struct sheen_bus *to);

/* Waits for the call under way and ends the thread. The call's error is lost: only wait returns it. */
void sheen_sender_close(struct sheen_sender *sender);

/* Nanoseconds that the inner bus has spent sending since the last call of this function. */
uint64_t sheen_sender_busy_ns(struct sheen_sender *sender);

#ifdef __cplusplus
}
#endif
#endif
