/*
 * sender.c - see sender.h. One write at a time: the driver waits between any two.
 */
#include "sender.h"

#include "sheen_target.h"

#include <signal.h>
#include <string.h>
#include <time.h>

#define HAND_OVER_BYTES 64 /* waking a thread takes 5..50 us, 64 bytes at 20 MHz 26 us */

static uint64_t now_ns(void)
{
    struct timespec now;

    clock_gettime(CLOCK_MONOTONIC, &now);
    return (uint64_t)now.tv_sec * 1000000000u + (uint64_t)now.tv_nsec;
}

/* Sends on this thread; the lock is not held. */
static int send_now(struct sheen_sender *sender, enum sheen_dc dc, const void *bytes, size_t count, uint64_t *spent_ns)
{
    uint64_t start = now_ns();
    int error = sender->to->write(sender->to->ctx, dc, bytes, count);

    if (error == 0 && sender->to->wait)
        error = sender->to->wait(sender->to->ctx);
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
        int error = send_now(sender, SHEEN_DATA, sender->bytes, sender->count, &spent_ns);
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

static int write_bytes(void *ctx, enum sheen_dc dc, const void *bytes, size_t count)
{
    struct sheen_sender *sender = ctx;
    uint64_t spent_ns = 0;
    int error = wait(sender); /* nothing is under way where the driver keeps the bus's rules */

    if (error < 0)
        return error;
    if (dc == SHEEN_COMMAND || count < HAND_OVER_BYTES)
        error = send_now(sender, dc, bytes, count, &spent_ns);
    pthread_mutex_lock(&sender->lock);
    sender->busy_ns += spent_ns;
    if (dc == SHEEN_DATA && count >= HAND_OVER_BYTES) {
        sender->count = count;
        sender->bytes = bytes;
        pthread_cond_broadcast(&sender->changed);
    }
    pthread_mutex_unlock(&sender->lock);
    return error;
}

static int reset(void *ctx, int level)
{
    struct sheen_sender *sender = ctx;

    return sender->to->reset(sender->to->ctx, level);
}

static int delay(void *ctx, uint32_t us)
{
    struct sheen_sender *sender = ctx;

    return sender->to->delay(sender->to->ctx, us);
}

int sheen_sender_open(struct sheen_sender *sender, const struct sheen_bus *to)
{
    sigset_t all, before;
    int error;

    *sender =
        (struct sheen_sender){.to = to, .bus = {.ctx = sender, .write = write_bytes, .wait = wait, .delay = delay}};
    sender->bus.reset = to->reset ? reset : NULL;
    pthread_mutex_init(&sender->lock, NULL);
    pthread_cond_init(&sender->changed, NULL);
    /* Signals are the program's: none may interrupt a transfer. */
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
