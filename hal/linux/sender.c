/*
 * sender.c - see sheen_sender.h. There is at most one call at a time, because the driver waits between any two.
 */
#include "sheen_sender.h"

#include "sheen_target.h"

#include <signal.h>
#include <string.h>
#include <time.h>

#define HAND_OVER_BYTES 64 /* waking a thread takes 5..50 us, sending 64 bytes at 20 MHz takes 26 us */

static uint64_t now_ns(void)
{
    struct timespec now;

    clock_gettime(CLOCK_MONOTONIC, &now);
    return (uint64_t)now.tv_sec * 1000000000u + (uint64_t)now.tv_nsec;
}

/* Sends on the calling thread; the caller must not hold the lock. */
static int send_now(struct sheen_sender *sender, const uint8_t *command, size_t commands, const void *data,
                    size_t count, uint64_t *spent_ns)
{
    const struct sheen_bus *to = sender->layer.to;
    uint64_t start = now_ns();
    int error = to->send(to->ctx, command, commands, data, count);

    if (error == 0 && to->wait)
        error = to->wait(to->ctx);
    *spent_ns = now_ns() - start;
    return error;
}

static void *run(void *arg)
{
    struct sheen_sender *sender = arg;
    uint64_t spent_ns;

    pthread_mutex_lock(&sender->lock);
    for (;;) {
        while (!sender->bytes && !sender->quit)
            pthread_cond_wait(&sender->changed, &sender->lock);
        if (!sender->bytes)
            break;
        pthread_mutex_unlock(&sender->lock);
        int error = send_now(sender, sender->command, sender->commands, sender->bytes, sender->count, &spent_ns);
        pthread_mutex_lock(&sender->lock);
        sender->error = error;
        sender->busy_ns += spent_ns;
        sender->bytes = NULL;
        pthread_cond_broadcast(&sender->changed);
    }
    pthread_mutex_unlock(&sender->lock);
    return NULL;
}

static int wait(void *ctx)
{
    struct sheen_sender *sender = ctx;
    int error;

    pthread_mutex_lock(&sender->lock);
    while (sender->bytes)
        pthread_cond_wait(&sender->changed, &sender->lock);
    error = sender->error;
    sender->error = 0;
    pthread_mutex_unlock(&sender->lock);
    return error;
}

static int send(void *ctx, const uint8_t *command, size_t commands, const void *data, size_t count)
{
    struct sheen_sender *sender = ctx;
    uint64_t spent_ns = 0;
    int error = wait(sender); /* returns at once if the driver keeps the bus's rules */

    if (error == 0 && commands > SHEEN_BUS_COMMANDS)
        error = SHEEN_ERR_ARGUMENT;
    if (error < 0)
        return error;
    if (count < HAND_OVER_BYTES)
        error = send_now(sender, command, commands, data, count, &spent_ns);
    pthread_mutex_lock(&sender->lock);
    sender->busy_ns += spent_ns;
    if (count >= HAND_OVER_BYTES) {
        if (commands)
            memcpy(sender->command, command, commands);
        sender->commands = commands;
        sender->count = count;
        sender->bytes = data;
        pthread_cond_broadcast(&sender->changed);
    }
    pthread_mutex_unlock(&sender->lock);
    return error;
}

int sheen_sender_open(struct sheen_sender *sender, const struct sheen_bus *to)
{
    sigset_t all, before;
    int error;

    *sender = (struct sheen_sender){0};
    sheen_bus_layer_open(&sender->layer, to);
    sender->layer.bus.send = send;
    sender->layer.bus.wait = wait;
    pthread_mutex_init(&sender->lock, NULL);
    pthread_cond_init(&sender->changed, NULL);
    /* The thread blocks all signals, so that none interrupts a transfer; the program's own threads get them. */
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &before);
    error = pthread_create(&sender->thread, NULL, run, sender);
    pthread_sigmask(SIG_SETMASK, &before, NULL);
    if (error) {
        pthread_cond_destroy(&sender->changed);
        pthread_mutex_destroy(&sender->lock);
        return SHEEN_ERR_MEMORY;
    }
    return 0;
}

void sheen_sender_close(struct sheen_sender *sender)
{
    pthread_mutex_lock(&sender->lock);
    sender->quit = 1;
    pthread_cond_broadcast(&sender->changed);
    pthread_mutex_unlock(&sender->lock);
    pthread_join(sender->thread, NULL);
    pthread_cond_destroy(&sender->changed);
    pthread_mutex_destroy(&sender->lock);
}

uint64_t sheen_sender_busy_ns(struct sheen_sender *sender)
{
    uint64_t busy_ns;

    pthread_mutex_lock(&sender->lock);
    busy_ns = sender->busy_ns;
    sender->busy_ns = 0;
    pthread_mutex_unlock(&sender->lock);
    return busy_ns;
}
