/*
 * example.c - the scene of firmware/examples/mist.c on a processor in an emulator: the instructions of its second
 * frame.
 */
#include "example.h"

#include "guest.h"
#include "scenes.h"

static int throw_away(void *ctx, struct sheen_rect rect, const void *pixels)
{
    (void)ctx;
    (void)rect;
    (void)pixels;
    return SHEEN_OK;
}

/* Counts what `frames` frames take, including what comes before the first one. */
static uint32_t count(unsigned frames)
{
    static const struct sheen_target target = {
        .push = throw_away, .width = BENCH_WIDTH, .height = BENCH_HEIGHT, .pixel = SHEEN_RGB565_BE};

    guest_count();
    int status = example_run(&target, frames);
    uint32_t counted = guest_counted();
    if (status != SHEEN_OK) {
        guest_print(sheen_strerror(status));
        guest_leave(1);
    }
    return counted;
}

void guest_main(void)
{
    guest_check_counter();
    uint32_t first = count(1);
    guest_print("mist ");
    guest_print_number(count(2) - first);
    guest_print("\n");
    guest_leave(0);
}
