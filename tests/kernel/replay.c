/*
 * replay.c - a trace of real GPIO lines, replayed through the pin watcher to a simulated controller, gives pictures.
 *
 *   replay kernel|qemu TRACE BASE DIR NAME=PANEL:ORIENTATION:MODE|i2c ...
 *
 * TRACE holds what the lines of the emulated board did during several runs of a program; during each run the marker
 * line is high. Each run gives DIR/NAME.png, the picture on the panel's glass as its viewer sees it, and a line of
 * counts. Fails if a line breaks the rules of SPI or I2C, a controller complains, a run sent nothing, or there are more
 * or fewer runs than names.
 *
 * kernel: tracefs, event gpio_value ("1.412651: gpio_value: 511 set 1"); lines are numbered from the chip's base, BASE.
 * qemu: its own log ("1@1.5:pl061_set_output ... setting output 7 to 1"). Both contain times, to which the controller's
 * clock is set.
 *
 * SCL and SDA are open drains, whose level follows from their direction: an output is low, an input high. kernel: event
 * gpio_direction ("505 out", "505  in"); qemu: writes to the direction register ("pl061_write ... offset 0x400 value
 * 0x82").
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "glass.h"
#include "i2c_watcher.h"
#include "pin_watcher.h"
#include "png_file.h"
#include "sim_panel.h"

enum {
    CLOCK = 0,
    DATA,
    SELECT,
    TEARING,
    COMMAND,
    RESET,
    BACKLIGHT,
    MARKER,
    LINES
}; /* offsets on the chip */

/* A change of a line. */
struct event {
    double seconds;
    unsigned line; /* 0..LINES - 1 */
    int level;
    int open_drain; /* the level follows from the line's direction */
};

/* A run: its panel, and what is connected to the far end of its wires. */
struct run {
    char name[64], panel_name[64];
    char mode[8]; /* of SPI, or i2c */
    unsigned orientation;
    struct sheen_sim_choice choice;
    struct sheen_sim_panel *panel;
    struct sheen_sim_controller *controller;
    struct sheen_bus far_end;
    struct sheen_pin_watcher watcher;
    struct sheen_i2c_watcher i2c;
    double seconds; /* of the last event */
    double start;
};

static const char *trace_name;

_Noreturn static void die(const char *name, const char *what)
{
    fprintf(stderr, "replay: %s: %s: %s\n", trace_name, name, what);
    exit(1);
}

static int receive(void *ctx, const uint8_t *command, size_t commands, const void *data, size_t count)
{
    sheen_sim_receive(ctx, SHEEN_SIM_COMMAND, command, commands);
    sheen_sim_receive(ctx, SHEEN_SIM_DATA, data, count);
    return 0;
}

static int reset_line(void *ctx, int level)
{
    sheen_sim_reset_line(ctx, level);
    return 0;
}

static int is_i2c(const struct run *run)
{
    return strcmp(run->mode, "i2c") == 0;
}

/* Passes on a message; it is complete then, so nothing stays under way. */
static int receive_message(void *ctx, const uint8_t *command, size_t commands, const void *data, size_t count)
{
    struct sheen_sim_bus *bus = ctx;
    int error = bus->bus.send(bus, command, commands, data, count);

    return error < 0 ? error : bus->bus.wait(bus);
}

static int message_reset(void *ctx, int level)
{
    struct sheen_sim_bus *bus = ctx;

    return bus->bus.reset(bus, level);
}

/* The panel is powered up when the run begins; the lines are as the previous run left them. */
static void begin(struct run *run, const uint8_t level[LINES], double seconds)
{
    const uint8_t wires[SHEEN_WIRE_COUNT] = {level[CLOCK], level[DATA], level[SELECT], level[COMMAND], level[RESET]};
    char why[256];

    if (sheen_sim_choose(&run->choice, run->panel_name, (int)run->orientation, 0, 0, why, sizeof why) < 0)
        die(run->name, why);
    if (sheen_sim_panel_open(&run->panel, &run->choice) < 0)
        die(run->name, "no simulated panel");
    run->controller = sheen_sim_panel_bus(run->panel)->controller;
    run->far_end = (struct sheen_bus){.ctx = run->controller, .send = receive, .reset = reset_line};
    if (is_i2c(run)) {
        struct sheen_sim_bus *bus = sheen_sim_panel_bus(run->panel);

        run->far_end = (struct sheen_bus){.ctx = bus, .send = receive_message, .reset = message_reset};
        sheen_sim_bus_i2c(bus, run->controller->module->i2c_address);
        sheen_i2c_watcher_init(&run->i2c, &run->far_end, run->controller->module->i2c_address);
    }
    sheen_pin_watcher_init(&run->watcher, &run->far_end, (unsigned)strtoul(run->mode, NULL, 10), wires);
    run->seconds = run->start = seconds;
}

/* Passes SCL and SDA to the I2C watcher; the reset line still goes to the pin watcher. */
static void play_i2c(struct run *run, const struct event *event)
{
    int scl = event->line == CLOCK ? event->level : run->i2c.scl,
        sda = event->line == DATA ? event->level : run->i2c.sda;

    if (sheen_i2c_watcher_levels(&run->i2c, scl, sda) < 0)
        die(run->name, run->i2c.complaint ? run->i2c.complaint : "the controller refused");
}

static void play(struct run *run, const struct event *event)
{
    static const int wire_of[LINES] = {
        SHEEN_WIRE_SCLK, SHEEN_WIRE_MOSI, SHEEN_WIRE_CS, -1, SHEEN_WIRE_DC, SHEEN_WIRE_RESET, -1, -1};

    if (wire_of[event->line] < 0)
        return;
    sheen_sim_advance(run->controller, (uint32_t)((event->seconds - run->seconds) * 1e6 + 0.5));
    run->seconds = event->seconds;
    if (is_i2c(run) && (event->line == CLOCK || event->line == DATA)) {
        if (event->open_drain) /* other values, driven while the direction changes, are no levels of the wire */
            play_i2c(run, event);
        return;
    }
    if (event->open_drain)
        return;
    if (sheen_pin_watcher_edge(&run->watcher, (enum sheen_wire)wire_of[event->line], event->level) < 0)
        die(run->name, run->watcher.complaint ? run->watcher.complaint : "the controller refused");
}

static void write_picture(struct run *run, const char *dir)
{
    size_t pixels = (size_t)run->choice.width * run->choice.height;
    uint16_t *values = malloc(pixels * sizeof *values);
    uint8_t *rgb = malloc(pixels * 3);
    struct sheen_problem problem;
    char path[4096];

    if (!values || !rgb || sheen_sim_panel_picture(run->panel, values) < 0)
        die(run->name, "no picture");
    for (size_t i = 0; i < pixels; i++)
        sheen_sim_expand(values[i], sheen_sim_panel_levels(run->panel), rgb + 3 * i);
    snprintf(path, sizeof path, "%s/%s.png", dir, run->name);
    if (sheen_png_write(path, rgb, run->choice.width, run->choice.height, &problem) < 0)
        die(run->name, problem.text);
    free(values);
    free(rgb);
}

static void end(struct run *run, const char *dir)
{
    if (is_i2c(run) && sheen_i2c_watcher_finish(&run->i2c) < 0)
        die(run->name, run->i2c.complaint);
    if (!is_i2c(run) && sheen_pin_watcher_finish(&run->watcher) < 0)
        die(run->name, run->watcher.complaint);
    if (sheen_sim_panel_complaints(run->panel))
        die(run->name, sheen_sim_panel_complaint(run->panel));
    write_picture(run, dir);
    if (is_i2c(run))
        printf("%-14s %6zu messages %8zu bytes %2zu resets in %6.3f s\n", run->name, run->i2c.messages, run->i2c.bytes,
               run->watcher.resets, run->seconds - run->start);
    else
        printf("%-14s %6zu commands %8zu data bytes %5zu selections %2zu resets in %6.3f s\n", run->name,
               run->watcher.bytes[SHEEN_SIM_COMMAND], run->watcher.bytes[SHEEN_SIM_DATA], run->watcher.selections,
               run->watcher.resets, run->seconds - run->start);
    sheen_sim_panel_close(run->panel);
}

/* The head of a tracefs trace tells whether any event was lost. */
static void check_complete(const char *line)
{
    unsigned long kept, written;

    if (sscanf(line, "# entries-in-buffer/entries-written: %lu/%lu", &kept, &written) == 2 &&
        (kept != written || kept == 0))
        die("events lost", line);
}

/* Whether the line is a write to the direction register that changes SCL or SDA. */
static int parse_direction(const char *line, struct event *event)
{
    static unsigned before;
    const char *text = strstr(line, "offset 0x400 value 0x");
    unsigned now, changed;

    if (!text || sscanf(text, "offset 0x400 value 0x%x", &now) != 1 || sscanf(line, "%*d@%lf:", &event->seconds) != 1)
        return 0;
    changed = (before ^ now) & (1u << CLOCK | 1u << DATA);
    before = now;
    if (!changed)
        return 0;
    event->line = changed >> CLOCK & 1 ? CLOCK : DATA;
    event->level = !(now >> event->line & 1);
    event->open_drain = 1;
    return 1;
}

/* 1 if the line of text is an event. base: the number of the chip's first line. */
static int parse(const char *line, int is_kernel, unsigned base, struct event *event)
{
    const char *text = strstr(line, is_kernel ? ": gpio_value: " : "pl061_set_output ");
    unsigned number;
    char direction[4];

    if (!text && is_kernel) {
        text = strstr(line, ": gpio_direction: ");
        event->open_drain = 1;
    }
    if (!text)
        return !is_kernel && strstr(line, "pl061_write ") ? parse_direction(line, event) : 0;
    if (is_kernel) {
        const char *time = text;

        while (time > line && time[-1] != ' ')
            time--;
        event->seconds = strtod(time, NULL);
        if (event->open_drain && sscanf(text, ": gpio_direction: %u %3s", &number, direction) == 2)
            event->level = strcmp(direction, "in") == 0;
        else if (sscanf(text, ": gpio_value: %u set %d", &number, &event->level) != 2)
            return 0;
    } else {
        text = strstr(text, "setting output ");
        if (!text || sscanf(text, "setting output %u to %d", &number, &event->level) != 2 ||
            sscanf(line, "%*d@%lf:", &event->seconds) != 1)
            die("a line that is not understood", line);
    }
    if (number < base || number - base >= LINES)
        die("a line of another chip", line);
    event->line = number - base;
    return 1;
}

static void parse_run(struct run *run, const char *text)
{
    if (sscanf(text, "%63[^=]=%63[^:]:%u:%7s", run->name, run->panel_name, &run->orientation, run->mode) != 4)
        die(text, "is not NAME=PANEL:ORIENTATION:MODE|i2c");
}

int main(int argc, char **argv)
{
    struct run run = {0};
    uint8_t level[LINES] = {0};
    char line[512];
    int is_kernel, next = 5, running = 0;

    if (argc < 6) {
        fputs("usage: replay kernel|qemu TRACE BASE DIR NAME=PANEL:ORIENTATION:MODE|i2c ...\n", stderr);
        return 2;
    }
    trace_name = argv[2];
    is_kernel = strcmp(argv[1], "kernel") == 0;
    FILE *file = fopen(argv[2], "r");
    if (!file)
        die(argv[2], "cannot be read");
    while (fgets(line, sizeof line, file)) {
        struct event event = {0};

        check_complete(line);
        if (!parse(line, is_kernel, (unsigned)strtoul(argv[3], NULL, 10), &event))
            continue;
        if (event.line == MARKER && !event.level && running) {
            end(&run, argv[4]);
            running = 0;
        } else if (event.line == MARKER && event.level && !level[MARKER]) {
            if (next == argc)
                die("more runs than names", argv[argc - 1]);
            memset(&run, 0, sizeof run);
            parse_run(&run, argv[next++]);
            begin(&run, level, event.seconds);
            running = 1;
        } else if (running) {
            play(&run, &event);
        }
        if (!event.open_drain)
            level[event.line] = event.level != 0;
    }
    if (running)
        die(run.name, "the trace ends inside the run");
    if (ferror(file) || next != argc)
        die("fewer runs than names", argv[next < argc ? next : argc - 1]);
    fclose(file);
    return 0;
}
