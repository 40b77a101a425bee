/*
 * planned.c - the frames of planned.h and of the bench's scenes on a processor: what each costs.
 *
 * Prints a line for each: name, number, count; or "arena" and bytes. The work is divided among PARTS programs, of which
 * this is number PART.
 */
#include "planned.h"

#include "guest.h"

#ifndef PARTS
#define PARTS 1
#define PART 0
#endif

static uint64_t arena[21 * 1024];

static int send(void *ctx, const uint8_t *command, size_t commands, const void *data, size_t count)
{
    (void)ctx, (void)command, (void)commands, (void)data, (void)count;
    return SHEEN_OK;
}

static int delay(void *ctx, uint32_t us)
{
    (void)ctx, (void)us;
    return SHEEN_OK;
}

static const struct sheen_bus bus = {.send = send, .delay = delay};

static int draw(struct sheen_frame *frame, const struct planned *p, int number)
{
    int error = sheen_begin(frame, &p->view);

    for (unsigned i = 0; i < p->draws && error == SHEEN_OK; i++) {
        struct sheen_object object = p->objects[i];
        object.pose = p->pose[number];
        error = sheen_draw(frame, &object);
    }
    if (error == SHEEN_OK)
        error = sheen_end(frame);
    return error == SHEEN_OK ? sheen_wait(frame) : error;
}

static void report(const char *name, const char *what, uint32_t count)
{
    guest_print(name);
    guest_print(what);
    guest_print_number(count);
    guest_print("\n");
}

static int measure(const struct planned *p)
{
    struct sheen_panel panel;
    struct sheen_target target;
    struct sheen_config config = p->config;
    struct sheen_frame *frame;
    size_t size = sizeof arena;

    config.target = &target;
    int error = sheen_panel_open(&panel, sheen_panel_find(p->panel), &bus, p->orientation);
    if (error == SHEEN_OK)
        error = sheen_panel_target(&panel, &target);
    if (error == SHEEN_OK)
        error = sheen_panel_init(&panel);
    if (error == SHEEN_OK)
        error = sheen_init(&frame, arena, &size, &config);
    report(p->name, " arena ", (uint32_t)sheen_arena_size(&config));
    for (int number = 0; number < PLANNED_FRAMES && error == SHEEN_OK; number++) {
        guest_count();
        error = draw(frame, p, number);
        uint32_t count = guest_counted();
        report(p->name, number == 0 ? " 0 " : " 1 ", count);
    }
    if (error != SHEEN_OK) {
        guest_print(p->name);
        guest_print(": ");
        guest_print(sheen_strerror(error));
        guest_print("\n");
    }
    return error;
}

static int measure_bench(struct bench *bench, const char *name)
{
    int error = bench_begin(bench, arena, sizeof arena);

    if (error == SHEEN_OK)
        error = bench_first(bench);
    guest_count();
    if (error == SHEEN_OK)
        error = bench_measured(bench);
    report(name, " 1 ", guest_counted());
    return error;
}

void guest_main(void)
{
    static struct bench bench;
    int error = SHEEN_OK;
    char name[40];

    guest_check_counter();
    for (unsigned i = PART; i < planned_count && error == SHEEN_OK; i += PARTS)
        error = measure(&planned[i]);
    for (unsigned i = PART; error == SHEEN_OK && planned_bench(&bench, i, name); i += PARTS)
        error = measure_bench(&bench, name);
    guest_leave(error != SHEEN_OK);
}
