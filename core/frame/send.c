/*
 * send.c - what the workers of a frame share: which bands are done, the push under way, the first error.
 *
 * All of this is read and written between the configuration's lock and unlock, and the target's push and wait are
 * called there. So two pushes are never under way, two workers never wait at once, and nothing is pushed after an
 * error, whichever worker it happened to.
 */
#include "frame.h"

static void lock(const struct sheen_frame *f)
{
    if (f->config.lock != NULL)
        f->config.lock(f->config.lock_ctx);
}

static void unlock(const struct sheen_frame *f)
{
    if (f->config.lock != NULL)
        f->config.unlock(f->config.lock_ctx);
}

/* A push or a wait failed: nothing more of this frame is sent, and the next one sends everything. */
static void break_off(struct sheen_frame *f, int error)
{
    f->send_all_next = 1;
    if (f->state != IDLE && f->error == 0)
        f->error = error;
}

/* Wait for the push under way, if any; its result. MUST be called under the lock, like push_tile and band_refused. */
static int collect_push(struct sheen_frame *f)
{
    const struct sheen_target *t = f->target;

    if (f->pushing == NOBODY)
        return SHEEN_OK;
    f->pushing = NOBODY;
    int error = t->wait != NULL ? t->wait(t->ctx) : SHEEN_OK;
    if (error >= 0)
        return SHEEN_OK;
    break_off(f, error);
    return error;
}

static void push_tile(struct sheen_frame *f, unsigned worker, const struct tile *t)
{
    struct worker *w = &f->worker[worker];
    int error = f->target->push(f->target->ctx, t->rect, t->pixels);

    if (error < 0) {
        break_off(f, error);
        return;
    }
    f->pushing = (uint8_t)worker;
    w->buffer = (uint8_t)((w->buffer + 1u) & (f->config.buffers - 1u));
    w->count.rectangles++;
    w->count.pixels += (uint32_t)t->pitch * (uint32_t)(t->rect.y1 - t->rect.y0);
}

int sheen_wait(struct sheen_frame *f)
{
    lock(f);
    int error = collect_push(f);
    unlock(f);
    return error;
}

/* The error that a worker's call for band b returns, or SHEEN_OK. */
static int band_refused(const struct sheen_frame *f, unsigned worker, unsigned b)
{
    if (f->state == IDLE)
        return SHEEN_ERR_STATE;
    if (worker >= f->config.workers || b >= f->bands)
        return SHEEN_ERR_ARGUMENT;
    if (f->error < 0)
        return f->error;
    return (f->done[b >> 5] >> (b & 31u) & 1u) != 0 ? SHEEN_ERR_STATE : SHEEN_OK;
}

COLD int sheen_claim_band(struct sheen_frame *f, unsigned worker, unsigned b)
{
    lock(f);
    int error = band_refused(f, worker, b);
    if (error == SHEEN_OK) {
        f->state = BANDS;
        f->bands_left--;
        f->done[b >> 5] |= 1u << (b & 31u);
    }
    unlock(f);
    return error;
}

/* Two buffers: one is free, as a push only begins when the last one was waited for. One buffer: wait for its push. */
int sheen_free_buffer(struct sheen_frame *f, unsigned worker)
{
    int error = SHEEN_OK;

    if (f->config.buffers > 1)
        return error;
    lock(f);
    if (f->pushing == worker)
        error = collect_push(f);
    unlock(f);
    return error;
}

int sheen_send_tile(struct sheen_frame *f, unsigned worker, const struct tile *t)
{
    lock(f);
    (void)collect_push(f);
    if (f->error == 0)
        push_tile(f, worker, t);
    int error = f->error;
    unlock(f);
    return error;
}

static APART int frame_error(const struct sheen_frame *f)
{
    lock(f);
    int error = f->state == IDLE ? SHEEN_ERR_STATE : f->error;
    unlock(f);
    return error;
}

/* The first band of a worker's part of the bands. */
static unsigned part_begin(const struct sheen_frame *f, unsigned worker)
{
    return QUOTIENT(f->bands * worker, f->config.workers);
}

/* Draw the worker's part downwards, which carries set-ups on; then others' from the end, which these reach last. */
int sheen_bands(struct sheen_frame *f, unsigned worker)
{
    const unsigned workers = f->config.workers;
    int error = frame_error(f);

    if (error < 0 || worker >= workers)
        return error < 0 ? error : SHEEN_ERR_ARGUMENT;
    for (unsigned i = 0, part = worker; i < workers; i++, part = part + 1 < workers ? part + 1 : 0) {
        const unsigned begin = part_begin(f, part), end = part_begin(f, part + 1);
        for (unsigned k = 0; k < end - begin; k++) {
            error = sheen_band(f, worker, i == 0 ? begin + k : end - 1 - k);
            /* Returned for a band that is done already; if a target returned this number, frame_error() tells. */
            if (error < 0 && error != SHEEN_ERR_STATE)
                return error;
        }
    }
    return frame_error(f);
}
