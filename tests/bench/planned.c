/*
 * planned.c - the frames of planned.h and of the bench's scenes on a processor: what each takes.
 *
 * A line each: name, number, count; "arena", bytes. Of PARTS programs each runs a part, PART.
 */
#include "planned.h"

#include "../../host-sim/command/shadings.h"
#include "guest.h"
#include "scenes.h"

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
    struct sheen_object object = {.shader = sheen_shader_of(p->shading),
                                  .lights = p->lights,
                                  .light_count = p->light_count,
                                  .two_sided = p->two_sided,
                                  .pose = p->pose[number]};
    int error = sheen_begin(frame, &p->view);

    for (unsigned i = 0; i < p->draws && error == SHEEN_OK; i++) {
        object.mesh = p->meshes[i];
        object.material = &p->materials[i];
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

static int measure_bench(const struct bench_scene *scene, unsigned shading, int dither)
{
    static const char *const name[] = {"-flat", "-gouraud", "-phong", "-slerp"};
    static struct bench bench;

    bench_config(&bench, scene, (enum sheen_shading)shading, 16);
    bench.dither = (uint8_t)dither;
    int error = bench_begin(&bench, arena, sizeof arena);
    if (error == SHEEN_OK)
        error = bench_first(&bench);
    guest_count();
    if (error == SHEEN_OK)
        error = bench_measured(&bench);
    uint32_t count = guest_counted();
    guest_print(scene->name);
    guest_print(name[shading]);
    report(dither ? "-dithered" : "", " 1 ", count);
    return error;
}

void guest_main(void)
{
    int error = SHEEN_OK;

    guest_check_counter();
    for (unsigned i = PART; i < planned_count && error == SHEEN_OK; i += PARTS)
        error = measure(&planned[i]);
    for (unsigned i = PART; i < BENCH_SCENES * 2 * SHEEN_SHADINGS && error == SHEEN_OK; i += PARTS)
        error = measure_bench(&bench_scenes[i / (2 * SHEEN_SHADINGS)], i / 2 % SHEEN_SHADINGS, (int)i % 2);
    guest_leave(error != SHEEN_OK);
}
