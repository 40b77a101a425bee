/*
 * pins.c - requesting, driving and releasing a line, with messages for what can go wrong.
 */
#include "sheen_pins.h"

#include "pins_gpiod.h"
#include "sheen_target.h"

#include <errno.h>
#include <gpiod.h>
#include <stdio.h>
#include <string.h>
#include <time.h>

#define EDGES_QUEUED 16 /* edges that the kernel queues per requested line (gpiolib-cdev.c) */

/* Explains why the kernel refused the line; if the line is in use, by whom. */
static int request_fail(struct sheen_pin *pin, unsigned offset, int error, struct sheen_failure *why)
{
    struct sheen_pin_info info = {.consumer = ""};

    if (error != EBUSY)
        return sheen_failed(why, SHEEN_ERR_BUS, "line %s: %s", pin->name, strerror(error));
    if (sheen_gpiod_info(pin->chip, offset, &info) || !info.consumer[0])
        snprintf(info.consumer, sizeof info.consumer, "another program or driver");
    return sheen_failed(why, SHEEN_ERR_BUS,
                        "line %s is in use by %s; end that or take another line (" SHEEN_LIST_THEM ")", pin->name,
                        info.consumer);
}

static int take(struct sheen_pin *pin, const char *line, int (*request)(struct sheen_pin *pin, unsigned offset),
                struct sheen_failure *why)
{
    struct sheen_pin_place place;
    char label[64];
    unsigned lines;
    int error = sheen_pin_find(&place, line, why);

    if (error == 0)
        error = sheen_chip_open(&pin->chip, place.path, why);
    if (error < 0)
        return error;
    snprintf(pin->name, sizeof pin->name, place.by_name ? "%.48s (%.32s:%u)" : "%.0s%.32s:%u", line,
             strrchr(place.path, '/') + 1, place.offset);
    if (sheen_gpiod_describe(pin->chip, label, sizeof label, &lines))
        return sheen_chip_fail(why, place.path, errno);
    if (place.offset >= lines)
        return sheen_failed(why, SHEEN_ERR_ARGUMENT, "no line %s: the chip has %u, from 0", pin->name, lines);
    return request(pin, place.offset) ? request_fail(pin, place.offset, errno, why) : 0;
}

int sheen_pin_output(struct sheen_pin *pin, const char *line, int level, struct sheen_failure *why)
{
    int error;

    *pin = (struct sheen_pin){.level = level != 0};
    error = take(pin, line, sheen_gpiod_output, why);
    if (error < 0)
        sheen_pin_close(pin);
    return error;
}

int sheen_pin_rising(struct sheen_pin *pin, const char *line, struct sheen_failure *why)
{
    int error;

    *pin = (struct sheen_pin){0};
    error = take(pin, line, sheen_gpiod_rising, why);
    if (error < 0)
        sheen_pin_close(pin);
    return error;
}

int sheen_pin_set(struct sheen_pin *pin, int level, struct sheen_failure *why)
{
    level = level != 0;
    if (pin->level == level)
        return 0;
    if (sheen_gpiod_set(pin, level)) {
        pin->level = -1; /* unknown, so that the next call drives the line whichever level it asks for */
        return sheen_failed(why, SHEEN_ERR_BUS, "line %s: %s", pin->name, strerror(errno));
    }
    pin->level = level;
    return 0;
}

static int64_t now_us(void)
{
    struct timespec now;

    clock_gettime(CLOCK_MONOTONIC, &now);
    return now.tv_sec * (int64_t)1000000 + now.tv_nsec / 1000;
}

/* As sheen_gpiod_edge, but after a signal it waits for the time that is left, and returns 0 when none is left. */
static int next_edge(struct sheen_pin *pin, uint32_t timeout_us)
{
    const int64_t end = now_us() + timeout_us;
    int64_t left = timeout_us;
    int found;

    do {
        found = sheen_gpiod_edge(pin, (uint32_t)left);
        left = end - now_us();
    } while (found < 0 && (errno == EINTR || errno == EAGAIN) && left > 0);
    return found < 0 && left <= 0 && (errno == EINTR || errno == EAGAIN) ? 0 : found;
}

int sheen_pin_await(struct sheen_pin *pin, uint32_t timeout_us, struct sheen_failure *why)
{
    int found = 1;

    for (int stale = 0; found > 0 && stale < EDGES_QUEUED; stale++)
        found = next_edge(pin, 0);
    if (found >= 0)
        found = next_edge(pin, timeout_us);
    if (found < 0)
        return sheen_failed(why, SHEEN_ERR_BUS, "line %s: %s", pin->name, strerror(errno));
    if (found == 0)
        return sheen_failed(why, SHEEN_ERR_TIMEOUT, "line %s: no rising edge within %u ms", pin->name,
                            timeout_us / 1000);
    return 0;
}

void sheen_pin_close(struct sheen_pin *pin)
{
    sheen_gpiod_release(pin);
    if (pin->chip)
        gpiod_chip_close(pin->chip);
    *pin = (struct sheen_pin){0};
}
