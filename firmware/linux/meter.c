/*
 * meter.c - see meter.h.
 *
 * Render time is the processor time of the drawing thread, so it does not include
 * waiting; bus time is the time that writes took, on either thread.
 */
#include "meter.h"

#include <stdio.h>
#include <time.h>

#define SECOND_NS 1000000000u

static uint64_t clock_ns(clockid_t clock)
{
    struct timespec now;

    clock_gettime(clock, &now);
    return (uint64_t)now.tv_sec * SECOND_NS + (uint64_t)now.tv_nsec;
}

void meter_start(struct meter *meter)
{
    *meter = (struct meter){.since_ns = clock_ns(CLOCK_MONOTONIC), .draw_ns = clock_ns(CLOCK_THREAD_CPUTIME_ID)};
}

void meter_frame(struct meter *meter, struct sheen_sender *sender)
{
    uint64_t now = clock_ns(CLOCK_MONOTONIC), passed = now - meter->since_ns;
    double frames = ++meter->frames;

    if (passed < SECOND_NS)
        return;
    fprintf(stderr, "render %.2f ms, bus %.2f ms, %.1f fps\n",
            (double)(clock_ns(CLOCK_THREAD_CPUTIME_ID) - meter->draw_ns) / 1e6 / frames,
            (double)sheen_sender_busy_ns(sender) / 1e6 / frames, frames * SECOND_NS / (double)passed);
    meter_start(meter);
}
