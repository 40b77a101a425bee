/*
 * main.c - the demo on a board: draws frames for ever, reads keys, logs errors and faults.
 *
 * One key more than in demo.h: f shows the first-light picture, at a bus clock that works with any wiring.
 */
#include "board.h"
#include "demo.h"
#include "log.h"
#include "sheen_first_light.h"
#include "start.h"
#include "ticks.h"

#define FIRST_LIGHT_HZ 1000000u

static uint64_t arena[BOARD_ARENA_BYTES / 8];
static uint8_t line[BOARD_LINE_BYTES]; /* first light's buffer: a row of the panel's longer side, on greys two rows */

static struct sheen_panel panel;
static struct sheen_target panel_target, target;
static struct demo demo;

/* start.c calls this on a fault. Nothing feeds the watchdog any more, so it restarts the board. */
void start_fault(uint32_t pc, uint32_t lr)
{
    log_text("\nHardFault at ");
    log_hex(pc);
    log_text(", lr ");
    log_hex(lr);
    log_text(board_core() == 1 ? ", core 1" : "");
    log_text(pc == 0 && lr == 0 ? ": the stack ran over\n" : "\n");
    for (;;)
        ;
}

/* A lap of about a second, over which the log averages. */
static struct {
    uint32_t clocks, bytes; /* ticks() and board_bus_bytes at its start */
    uint32_t waited; /* clocks in which core 0 waited for the bus or the other core, or sent, instead of drawing */
    unsigned frames;
    unsigned tenths; /* frames per second, times ten, in the last complete lap */
} lap;
static uint32_t bus_hz;

/* Counts the clocks from `since` until now as waiting, on core 0. */
static void waited(uint32_t since)
{
    if (board_core() == 0)
        lap.waited += ticks() - since;
}

/* The panel's push, which also feeds the watchdog, once per band. */
static int push(void *ctx, struct sheen_rect rect, const void *pixels)
{
    uint32_t since = ticks();

    board_feed();
    int error = panel_target.push(ctx, rect, pixels);
    waited(since);
    return error;
}

static int wait(void *ctx)
{
    uint32_t since = ticks();
    int error = panel_target.wait(ctx);

    waited(since);
    return error;
}

static void join(void)
{
    uint32_t since = ticks();

    board_crew()->join();
    waited(since);
}

/* The board's crew, with a join that counts the time that core 0 waits in it. */
static const struct demo_crew *open_crew(void)
{
    static struct demo_crew crew;

    if (board_crew() == NULL)
        return NULL;
    crew = *board_crew();
    crew.join = join;
    return &crew;
}

static int open_all(void)
{
    size_t size = sizeof arena;
    int error = sheen_panel_open(&panel, board_panel, &board_bus, sheen_panel_default_orientation(board_panel));

    if (error == SHEEN_OK)
        error = sheen_panel_target(&panel, &panel_target);
    target = panel_target;
    target.push = push;
    target.wait = wait;
    if (error == SHEEN_OK)
        error = demo_open(&demo, &target, arena, &size, board_buffers, open_crew());
    log_text("arena ");
    log_number((uint32_t)size);
    log_text(" B of ");
    log_number(sizeof arena);
    log_text(" B\n");
    return error;
}

static void log_error(const char *what, int error)
{
    log_text(what);
    log_text(": ");
    log_text(sheen_strerror(error));
    log_text(" (-");
    log_number((uint32_t)-error);
    log_text(")\n");
}

static void first_light(void)
{
    (void)sheen_wait(demo.frame); /* end a band that is under way at the old clock; ignore errors, as all begins anew */
    board_bus_clock(FIRST_LIGHT_HZ);
    int error = sheen_panel_init(&panel);

    if (error == SHEEN_OK)
        error = sheen_first_light(&target, line, sizeof line);
    board_bus_clock(board_panel->clock_hz);
    sheen_invalidate(demo.frame);
    if (error < 0)
        log_error("first light", error);
    else
        log_text("first light\n");
}

static void lap_begin(void)
{
    lap.clocks = ticks();
    lap.bytes = board_bus_bytes;
    lap.waited = 0;
    lap.frames = 0;
}

/*
 * "phong, light 0: 1840000 clocks, bus 115200 B, 14745 us, drawing 1750000, waiting 90000, 67.9 frames/s": values per
 * frame, averaged over the lap. With two buffers the bus sends while the processor draws, so their times overlap.
 */
static void lap_report(uint32_t clocks)
{
    uint32_t sent = (board_bus_bytes - lap.bytes) / lap.frames;
    uint32_t tenths = (uint32_t)((uint64_t)lap.frames * 10u * ticks_of_us(1000000) / clocks);

    log_text(demo_shading_name(&demo));
    log_text(", light ");
    log_number(demo.light);
    log_text(": ");
    log_number(clocks / lap.frames);
    log_text(" clocks, bus ");
    log_number(sent);
    log_text(" B, ");
    log_number((uint32_t)(sent * 8000000ull / bus_hz));
    log_text(" us, drawing ");
    log_number((clocks - lap.waited) / lap.frames);
    log_text(", waiting ");
    log_number(lap.waited / lap.frames);
    log_text(", ");
    log_number(tenths / 10);
    log_text(".");
    log_number(tenths % 10);
    log_text(" frames/s\n");
}

/* Draws the frame that is due. An error is logged, and the same frame stays due. */
static void draw(void)
{
    unsigned number = demo.number;
    int error = demo_frame(&demo, lap.tenths);
    uint32_t clocks = ticks() - lap.clocks;

    if (error == SHEEN_OK && !demo.held) {
        lap.frames++;
        return;
    }
    log_text("frame ");
    log_number(number);
    if (error < 0) {
        log_error("", error);
        lap_begin();
        return;
    }
    log_text(" ");
    lap.frames = 1;
    lap_report(clocks);
}

/* About once a second, logs the lap and updates the frame rate that the picture shows. */
static void lap_end(uint32_t hz)
{
    uint32_t clocks = ticks() - lap.clocks;

    if (demo.held || lap.frames == 0 || clocks < hz)
        return;
    lap.tenths = (unsigned)((uint64_t)lap.frames * 10u * hz / clocks);
    lap_report(clocks);
    lap_begin();
}

static void run(uint32_t hz)
{
    for (;;) {
        int key = board_key();

        board_feed();
        (void)ticks();
        if (key == 'f')
            first_light();
        demo_key(&demo, key);
        if (key >= 0 || demo.held)
            lap_begin();
        if (demo_due(&demo))
            draw();
        lap_end(hz);
    }
}

int main(void)
{
    int restarted = board_open(board_panel->clock_hz, board_panel->spi_mode);
    uint32_t hz = ticks_of_us(1000000);

    bus_hz = board_bus_clock(board_panel->clock_hz);
    log_text(restarted ? "\nrestarted by the watchdog\n" : "\n");
    log_text(board_name);
    log_text(": ");
    log_text(board_panel->name);
    log_text(", processor ");
    log_number(hz);
    log_text(" Hz, SPI ");
    log_number(bus_hz);
    log_text(board_crew() != NULL ? " Hz, two cores\n" : " Hz\n");
    int error = open_all();
    if (error == SHEEN_OK) {
        error = sheen_panel_init(&panel); /* here, so that it does not count as the first frame's time */
        if (error < 0)
            log_error("panel", error); /* the first push tries again */
        run(hz);
    }
    log_error("demo", error);
    return 1;
}
