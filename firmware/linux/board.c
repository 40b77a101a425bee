/*
 * board.c - see board.h.
 */
#include "board.h"

#include "stop.h"

#include <errno.h>
#include <time.h>

static const char *given(const char *text)
{
    return text[0] ? text : NULL;
}

static int open_bus(struct board *board, const struct options *options, struct sheen_failure *why)
{
    const struct sheen_wiring wiring = {
        .spi = given(options->spi),
        .i2c = given(options->i2c),
        .sclk = given(options->sclk),
        .mosi = given(options->mosi),
        .cs = given(options->cs),
        .dc = given(options->dc),
        .reset = given(options->reset),
        .te = given(options->te),
        .clock_hz = board->record.clock_hz,
        .spi_mode = board->record.spi_mode,
        .address = board->record.i2c_address,
    };
    int error = sheen_linux_bus_open(&board->bus, &wiring, &board->sending);

    if (error < 0)
        return sheen_failed(why, error, "%s", board->sending.text);
    error = sheen_sender_open(&board->sender, &board->bus.bus);
    board->has_sender = error == 0;
    return error < 0 ? sheen_failed(why, error, "no thread to send from") : 0;
}

static int open_panel(struct board *board, const struct options *options, struct sheen_failure *why)
{
    int error = sheen_panel_open(&board->panel, &board->record, &board->sender.layer.bus, options_orientation(options));

    if (error == 0 && options->te[0])
        error = sheen_panel_sync(&board->panel);
    if (error == 0 && options->brightness >= 0)
        error = sheen_panel_brightness(&board->panel, (unsigned)options->brightness);
    if (error == 0)
        error = sheen_panel_target(&board->panel, &board->target);
    return error < 0 ? sheen_failed(why, error, "panel %s: %s", board->record.name, sheen_strerror(error)) : 0;
}

int board_open(struct board *board, const struct options *options, struct sheen_failure *why)
{
    int error;

    *board = (struct board){.bus.fd = -1};
    error = options_record(options, &board->record, why);
    if (error > 0)
        error = SHEEN_ERR_ARGUMENT;
    if (error == 0)
        error = open_bus(board, options, why);
    if (error == 0 && options->backlight[0])
        error = sheen_pin_output(&board->backlight, options->backlight, 1, why);
    if (error == 0)
        error = open_panel(board, options, why);
    if (error < 0)
        board_close(board, 1, NULL);
    return error;
}

int board_close(struct board *board, int dark, struct sheen_failure *why)
{
    int error = 0;

    if (dark && board->panel.record) {
        error = sheen_panel_off(&board->panel);
        if (error < 0)
            sheen_failed(why, error, "%s", board->sending.text);
    }
    if (dark && sheen_pin_is_open(&board->backlight)) {
        int off = sheen_pin_set(&board->backlight, 0, error ? NULL : why);

        error = error ? error : off;
    }
    if (board->has_sender)
        sheen_sender_close(&board->sender);
    sheen_pin_close(&board->backlight);
    sheen_linux_bus_close(&board->bus);
    *board = (struct board){.bus.fd = -1};
    return error;
}

static uint64_t now_ns(void)
{
    struct timespec now;

    clock_gettime(CLOCK_MONOTONIC, &now);
    return (uint64_t)now.tv_sec * 1000000000u + (uint64_t)now.tv_nsec;
}

int board_pace(struct board *board, double fps, uint64_t *due_ns)
{
    if (fps > 0) {
        uint64_t now = now_ns();
        struct timespec until = {.tv_sec = (time_t)(*due_ns / 1000000000u), .tv_nsec = (long)(*due_ns % 1000000000u)};

        /* After a late frame, count from now: do not catch up with a burst of frames. */
        if (*due_ns < now)
            *due_ns = now;
        else
            while (!stop_asked() && clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &until, NULL) == EINTR)
                continue;
        *due_ns += (uint64_t)(1e9 / fps);
    }
    if (board->bus.bus.tearing)
        sheen_panel_sync(&board->panel);
    return !stop_asked();
}
