/*
 * report.c - a plan as text. Each line says how its numbers were found: measured, cycles of an emulated processor;
 * estimated, instructions times a factor; counted, exact on any machine.
 */
#include "report.h"

#define MS 1000

static const char *const shadings[SHEEN_ALL_SHADINGS] = {"flat",  "Gouraud", "Phong",
                                                         "slerp", "matcap",  "matcap by vertices"};
const char *const sheen_plan_stage_names[SHEEN_PLAN_STAGES] = {"transform", "triangles", "rows", "pixels"};

static const char *how(const struct sheen_plan_board *board)
{
    return board->measured ? "measured " : "estimated";
}

const char *sheen_plan_limit(const struct sheen_plan *plan, unsigned board)
{
    const struct sheen_plan_time *t = &plan->times[board][0].mean;
    unsigned most = 0;

    if (sheen_plan_ram_short(plan, sheen_plan_board_at(board)))
        return "RAM";
    if (sheen_plan_flash_short(plan, board))
        return "flash";
    if (t->bus > sheen_plan_drawing(t))
        return "bus";
    for (unsigned i = 1; i < SHEEN_PLAN_STAGES; i++)
        most = t->stage[i] > t->stage[most] ? i : most;
    return sheen_plan_stage_names[most];
}

static void put_head(FILE *out, const struct sheen_plan *plan)
{
    fprintf(out, "%s, %s%s, on %s (%ux%u), bands of %u rows, a turn of %d views\n", plan->options->mesh,
            shadings[plan->shade], plan->look, plan->panel, plan->target.width, plan->target.height,
            sheen_plan_band_rows(plan), SHEEN_PLAN_VIEWS);
    fprintf(out, "counted    mesh: %u triangles, %u vertices; a frame: at most %u triangles, %u vertices\n",
            plan->triangles, plan->vertices, plan->listed, plan->used);
}

/* ---- one board ---- */

static void put_times(FILE *out, const struct sheen_plan *plan, const struct sheen_plan_board *board,
                      const struct sheen_plan_times times[2])
{
    const struct sheen_plan_time *t = &times[0].mean;

    fprintf(out, "%s  drawing: %.1f ms:", how(board), MS * sheen_plan_drawing(t));
    for (unsigned i = 0; i < SHEEN_PLAN_STAGES; i++)
        fprintf(out, "%s %s %.1f", i ? "," : "", sheen_plan_stage_names[i], MS * t->stage[i]);
    fprintf(out, "\ncounted    bus: %.1f ms for what changed, %.0f B, %.1f ms for a whole frame, %.0f B, at %g MHz\n",
            MS * t->bus, times[0].bytes, MS * times[1].mean.bus, times[1].bytes, sheen_plan_bus_hz(plan, board) / 1e6);
    for (int whole = 0; whole < 2; whole++)
        for (int two = SHEEN_PLAN_ONE_BUFFER; two <= SHEEN_PLAN_TWO_BUFFERS; two++)
            fprintf(out, "%s  %-12s %s  %5.1f frames/s in the mean, %5.1f at worst\n", how(board),
                    whole ? "whole frames" : "what changed", two ? "two buffers" : "one buffer ",
                    1 / times[whole].mean.period[two], 1 / times[whole].worst[two]);
}

/* The rates with a second core, if there is one and RAM suffices. */
static void put_two_cores(FILE *out, const struct sheen_plan *plan, const struct sheen_plan_board *board,
                          const struct sheen_plan_times times[2])
{
    const uint32_t more = plan->ram.second_core;

    if (board->cores < 2 || plan->ram.all + more > board->ram)
        return;
    for (int whole = 0; whole < 2; whole++)
        fprintf(out, "%s  %-12s two cores    %5.1f frames/s in the mean, %5.1f at worst, %u B more RAM\n", how(board),
                whole ? "whole frames" : "what changed", 1 / times[whole].mean.period[SHEEN_PLAN_TWO_CORES],
                1 / times[whole].worst[SHEEN_PLAN_TWO_CORES], more);
}

static void put_ram(FILE *out, const struct sheen_plan *plan, const struct sheen_plan_board *board)
{
    const struct sheen_plan_ram *r = &plan->ram;
    struct sheen_config config = plan->config;
    struct sheen_plan_ram other;

    fprintf(out, "counted    RAM: %u B of %u: vertices %u, lists %u, bands %u, the rest of the arena %u, stack %u\n",
            r->all, board->ram, r->vertices, r->lists, r->bands, r->rest, SHEEN_PLAN_STACK);
    fprintf(out, "counted    RAM by rows of a band:");
    for (unsigned rows = 4; rows <= 32 && rows <= plan->target.height; rows *= 2) {
        config.band_rows = (uint16_t)rows;
        sheen_plan_ram(&other, &config, &plan->target);
        fprintf(out, "%s %u: %u B", rows > 4 ? "," : "", rows, other.all);
    }
    config = plan->counted;
    fprintf(out, "\ncounted    RAM with max_used %u, max_triangles %u, max_carried %u", config.max_used,
            config.max_triangles, config.max_carried);
    if (config.max_edges)
        fprintf(out, ", max_edges %u", config.max_edges);
    if (plan->cut > 0)
        fprintf(out, ", the clipper and max_clipped %u", config.max_clipped);
    fprintf(out, ", what this turn takes: %u B%s\n", plan->least.all,
            r->all > board->ram && plan->least.all <= board->ram ? ", which fits" : "");
}

static void put_flash(FILE *out, const struct sheen_plan *plan, const struct sheen_plan_board *board, unsigned number)
{
    const struct sheen_plan_flash *f = &plan->flash[number];

    fprintf(out,
            "%s  flash: %u B of %u: core %u, panel %u, mesh %u, power table %u, textures %u, at -O2; %u B in all at "
            "-Os, slower\n",
            board->nearest ? "estimated" : "counted  ", f->all, board->flash, f->core, f->panel, f->mesh, f->tables,
            f->textures, f->small);
    if (board->flash_is_slow)
        fprintf(out,
                "counted    the times are those of code and constants in RAM (pico-sdk: copy_to_ram), %u B of %u in "
                "all%s; out of flash a frame takes longer\n",
                plan->ram.all + f->all, board->ram, plan->ram.all + f->all > board->ram ? ", which is too much" : "");
}

/* Capacities for a mesh of so many triangles that takes as much of each for a triangle as this one does. */
static void set_capacities(struct sheen_config *config, const struct sheen_plan *plan, uint64_t triangles)
{
    config->max_vertices = (uint16_t)(triangles * plan->vertices / plan->triangles + 3);
    config->max_used = (uint16_t)(triangles * plan->used / plan->triangles + 3);
    config->max_triangles = (uint16_t)(triangles * plan->listed / plan->triangles + 1);
    config->max_edges = (uint16_t)(triangles * plan->counted.max_edges / plan->triangles);
}

/* The largest mesh like this one, in triangles, that the configuration's bands and carried set-ups leave RAM for. */
static uint32_t fitting(const struct sheen_plan *plan, const struct sheen_plan_board *board,
                        struct sheen_config *config)
{
    struct sheen_plan_ram ram;
    uint32_t most = 0;

    for (uint32_t step = 1u << 15; step > 0; step /= 2) {
        set_capacities(config, plan, most + step);
        sheen_plan_ram(&ram, config, &plan->target);
        most += ram.all <= board->ram && most + step <= plan->triangles ? step : 0;
    }
    return most;
}

/* If the largest bands leave no room for half of the mesh, smaller ones are tried, then fewer carried set-ups. */
static void put_fitting(FILE *out, const struct sheen_plan *plan, const struct sheen_plan_board *board)
{
    static const struct {
        uint16_t rows, carried;
    } tries[] = {{16, 80}, {8, 80}, {4, 80}, {4, 16}};
    struct sheen_config config = plan->config;
    uint32_t most = 0;

    for (unsigned i = 0; i < sizeof tries / sizeof tries[0] && 2 * most < plan->triangles; i++) {
        const uint16_t counted = plan->counted.max_carried;
        config.band_rows = tries[i].rows;
        config.max_carried = tries[i].carried < counted ? tries[i].carried : counted;
        most = fitting(plan, board, &config);
    }
    if (most >= 12)
        fprintf(out, "counted    RAM would suffice for %u such triangles in bands of %u rows, with max_carried %u\n",
                most, config.band_rows, config.max_carried);
}

static void put_changes(FILE *out, const struct sheen_plan *plan, const struct sheen_plan_board *board, unsigned number)
{
    struct sheen_plan_change changes[SHEEN_PLAN_CHANGES];
    const uint32_t ram = sheen_plan_ram_short(plan, board), flash = sheen_plan_flash_short(plan, number);
    double now;
    unsigned n = sheen_plan_changes(plan, number, changes, &now);

    if (ram) {
        fprintf(out, "counted    not enough RAM: %u B short\n", ram);
        put_fitting(out, plan, board);
    }
    if (flash)
        fprintf(out, "counted    not enough flash: %u B short\n", flash);
    fprintf(out, "%s  limit: %s\n", how(board), sheen_plan_limit(plan, number));
    for (unsigned i = 0; i < n; i++)
        fprintf(out, "%s  %-10s %5.1f frames/s with %s\n", how(board), i ? "then try" : "first try", changes[i].rate,
                changes[i].what);
}

static void put_board(FILE *out, const struct sheen_plan *plan, unsigned number)
{
    const struct sheen_plan_board *board = sheen_plan_board_at(number);

    fprintf(out, "%s, %s at %g MHz: %s\n", board->title, board->processor, board->clock_hz / 1e6, board->basis);
    put_times(out, plan, board, plan->times[number]);
    put_two_cores(out, plan, board, plan->times[number]);
    put_ram(out, plan, board);
    put_flash(out, plan, board, number);
    put_changes(out, plan, board, number);
}

/* ---- all boards ---- */

/* What limits frames, or that the board cannot hold the mesh. */
static const char *limit_or_lack(const struct sheen_plan *plan, unsigned number)
{
    if (sheen_plan_ram_short(plan, sheen_plan_board_at(number)))
        return "no RAM";
    return sheen_plan_flash_short(plan, number) ? "no flash" : sheen_plan_limit(plan, number);
}

static void put_line(FILE *out, const struct sheen_plan *plan, unsigned number)
{
    const struct sheen_plan_board *board = sheen_plan_board_at(number);
    const struct sheen_plan_times *changed = &plan->times[number][0], *whole = &plan->times[number][1];

    fprintf(out, "%s %-11s %6.1f %6.1f %6.1f %6.1f %6.1f %6.1f %6u %s\n", how(board), board->name,
            MS * sheen_plan_drawing(&changed->mean), MS * changed->mean.bus, 1 / changed->mean.period[0],
            1 / changed->mean.period[1], 1 / whole->mean.period[0], 1 / whole->mean.period[1], plan->flash[number].all,
            limit_or_lack(plan, number));
}

/* What all boards need, and how much of it which of them lack. */
static void put_memory(FILE *out, const struct sheen_plan *plan)
{
    const struct sheen_plan_board *board;

    fprintf(out, "counted    RAM: %u B, %u B with the capacities that this turn takes", plan->ram.all, plan->least.all);
    for (unsigned i = 0; (board = sheen_plan_board_at(i)) != NULL; i++) {
        if (sheen_plan_ram_short(plan, board))
            fprintf(out, ", %s is %u B short", board->name, sheen_plan_ram_short(plan, board));
    }
    fputs("\n", out);
    for (unsigned i = 0; (board = sheen_plan_board_at(i)) != NULL; i++) {
        if (sheen_plan_flash_short(plan, i))
            fprintf(out, "counted    flash: %s is %u B short\n", board->name, sheen_plan_flash_short(plan, i));
    }
}

static void put_all(FILE *out, const struct sheen_plan *plan)
{
    fprintf(out, "%21s %13s %13s %13s\n", "", "ms a frame", "changed", "whole frames");
    fprintf(out, "%-9s %-11s %6s %6s %6s %6s %6s %6s %6s %s\n", "", "board", "draw", "bus", "1 buf", "2 buf", "1 buf",
            "2 buf", "flash", "limit");
    for (unsigned i = 0; sheen_plan_board_at(i); i++)
        put_line(out, plan, i);
    put_memory(out, plan);
    fprintf(out, "buf: frames a second in the mean, with one buffer and with two. measured:\n"
                 "cycles of the emulated processor; estimated: instructions times a factor\n"
                 "(--board NAME tells). RAM, flash (B) and bus are counted.\n");
}

void sheen_plan_text(FILE *out, const struct sheen_plan *plan, int board)
{
    put_head(out, plan);
    if (board >= 0)
        put_board(out, plan, (unsigned)board);
    else
        put_all(out, plan);
}

static void put_rates(FILE *out, const struct sheen_plan *plan, int measured)
{
    const struct sheen_plan_board *board;
    const char *before = measured ? "measured" : "; estimated";

    for (unsigned i = 0; (board = sheen_plan_board_at(i)) != NULL; i++) {
        if (board->measured != measured)
            continue;
        fprintf(out, "%s %s ", before, board->name);
        if (sheen_plan_ram_short(plan, board) || sheen_plan_flash_short(plan, i))
            fputs("-", out);
        else
            fprintf(out, "%.0f", 1 / plan->times[i][0].mean.period[plan->options->buffers > 1]);
        before = ",";
    }
}

void sheen_plan_brief(FILE *out, const struct sheen_plan *plan)
{
    fprintf(out, "%s, bands of %u rows, %s: RAM %u B, at least %u B; frames/s: ", plan->panel,
            sheen_plan_band_rows(plan), shadings[plan->shade], plan->ram.all, plan->least.all);
    put_rates(out, plan, 1);
    put_rates(out, plan, 0);
    putc('\n', out);
}
