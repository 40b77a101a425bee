/*
 * plan.c - times of a turn, computed from what its frames are made of.
 */
#include "plan.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

unsigned sheen_plan_band_rows(const struct sheen_plan *plan)
{
    const unsigned align = plan->target.align_y ? plan->target.align_y : 1;
    const unsigned asked = plan->config.band_rows ? plan->config.band_rows : 16;
    const unsigned rows = (asked + align - 1) / align * align;

    return rows < plan->target.height ? rows : plan->target.height;
}

double sheen_plan_bus_hz(const struct sheen_plan *plan, const struct sheen_plan_board *board)
{
    const struct sheen_panel_record *record = plan->choice.record;
    double most = plan->options->bus_clock > 0 ? plan->options->bus_clock * 1e6 : record ? record->clock_hz : 1e9;

    return most < board->bus_hz ? most : board->bus_hz;
}

uint32_t sheen_plan_ram_short(const struct sheen_plan *plan, const struct sheen_plan_board *board)
{
    return plan->least.all > board->ram ? plan->least.all - board->ram : 0;
}

uint32_t sheen_plan_flash_short(const struct sheen_plan *plan, unsigned board)
{
    const uint32_t has = sheen_plan_board_at(board)->flash, needs = plan->flash[board].all;

    return needs > has ? needs - has : 0;
}

double sheen_plan_drawing(const struct sheen_plan_time *time)
{
    double sum = 0;

    for (unsigned i = 0; i < SHEEN_PLAN_STAGES; i++)
        sum += time->stage[i];
    return sum;
}

/* ---- a frame ---- */

/* Adds the seconds that the counts cost to *time, by stage. Returns their sum. */
static double band_time(const struct sheen_plan_counts *counts, const struct sheen_plan_board *board,
                        struct sheen_plan_time *time)
{
    const double cycle = board->cycles / board->clock_hz;
    double sum = 0;

    for (unsigned i = 0; i < SHEEN_PLAN_COUNTS; i++) {
        if (counts->of[i] == 0)
            continue;
        double seconds = counts->of[i] * (double)sheen_plan_cost[i][board->cpu] * cycle;
        time->stage[sheen_plan_feature_stage(i)] += seconds;
        sum += seconds;
    }
    return sum;
}

/* Seconds of a frame's parts. */
struct frame_parts {
    double front, drawing[480], bus[480];
    double again[480]; /* more, if another core drew the band above: what is carried from there is set up again */
    unsigned bands;
};

/* The bands that are left of a core's share. */
struct core_share {
    unsigned next, end, below; /* below: the band below the last one that it drew */
    double clock;              /* when the core is free; negative: there is no such core */
};

/* The core whose next band is ready first; *band: the first of its share, or if none is left, the other's last one. */
static unsigned next_ready(struct core_share core[2], const struct frame_parts *frame, unsigned *band, double *ready)
{
    unsigned first = 2;

    for (unsigned c = 0; c < 2; c++) {
        const struct core_share *own = &core[c], *from = own->next < own->end ? own : &core[1 - c];
        if (from->next == from->end || own->clock < 0)
            continue;
        const unsigned b = from == own ? own->next : from->end - 1;
        const double done = own->clock + frame->drawing[b] + (b == own->below ? 0 : frame->again[b]);
        if (first < 2 && done >= *ready)
            continue;
        first = c;
        *band = b;
        *ready = done;
    }
    return first;
}

/*
 * Seconds from one frame to the next. With one buffer a band is drawn when the one before has been sent; with two it is
 * drawn meanwhile and sent once both are done; two cores share bands as sheen_bands() does. A frame begins when the
 * last band of the frame before has been sent.
 */
static double period_of(const struct frame_parts *frame, enum sheen_plan_period how)
{
    const unsigned two = how == SHEEN_PLAN_TWO_CORES, half = two ? frame->bands / 2 : frame->bands;
    struct core_share core[2] = {{0, half, 0, frame->front}, {half, frame->bands, 0, two ? frame->front : -1}};
    double sent = frame->front, ready = 0;

    for (unsigned left = frame->bands, band = 0; left > 0; left--) {
        struct core_share *own = &core[next_ready(core, frame, &band, &ready)];
        if (band == own->next)
            own->next++;
        else
            core[own == core].end--;
        const double start = ready > sent ? ready : sent;
        sent = start + frame->bus[band];
        own->below = band + 1;
        own->clock = how == SHEEN_PLAN_ONE_BUFFER ? sent : start;
    }
    return sent;
}

static void frame_time(const struct sheen_plan_run *run, const struct sheen_plan_board *board, double bus_hz,
                       struct sheen_plan_time *time)
{
    struct frame_parts frame;

    memset(time, 0, sizeof *time);
    frame.front = band_time(&run->front, board, time);
    frame.bands = run->bands;
    const double listed = time->stage[SHEEN_PLAN_TRIANGLES];
    for (unsigned b = 0; b < run->bands; b++) {
        frame.drawing[b] = band_time(&run->band[b].counts, board, time);
        frame.bus[b] = 8 * run->band[b].bytes / bus_hz;
        time->bus += frame.bus[b];
    }
    const double setup = run->setups > 0 ? (time->stage[SHEEN_PLAN_TRIANGLES] - listed) / run->setups : 0;
    for (unsigned b = 0; b < run->bands; b++)
        frame.again[b] = setup * run->band[b].counts.of[SHEEN_PLAN_CARRIED];
    for (int how = 0; how < SHEEN_PLAN_PERIODS; how++)
        time->period[how] = period_of(&frame, (enum sheen_plan_period)how);
}

static void add_frame(struct sheen_plan_times *times, const struct sheen_plan_time *time, double share)
{
    for (unsigned i = 0; i < SHEEN_PLAN_STAGES; i++)
        times->mean.stage[i] += share * time->stage[i];
    times->mean.bus += share * time->bus;
    for (unsigned i = 0; i < SHEEN_PLAN_PERIODS; i++) {
        times->mean.period[i] += share * time->period[i];
        times->worst[i] = time->period[i] > times->worst[i] ? time->period[i] : times->worst[i];
    }
}

static void add_view(struct sheen_plan *plan, const struct sheen_plan_run *run, int whole, double share)
{
    const struct sheen_plan_board *board;
    struct sheen_plan_time time;
    uint32_t bytes = 0;

    for (unsigned b = 0; b < run->bands; b++)
        bytes += run->band[b].bytes;
    for (unsigned i = 0; (board = sheen_plan_board_at(i)) != NULL; i++) {
        frame_time(run, board, sheen_plan_bus_hz(plan, board), &time);
        add_frame(&plan->times[i][whole], &time, share);
        plan->times[i][whole].bytes += share * bytes;
    }
}

static void note_most(struct sheen_plan *plan, const struct sheen_plan_run *run)
{
    struct sheen_stats stats;

    sheen_frame_stats(run->table.scene.frame, &stats);
    plan->used = stats.used > plan->used ? stats.used : plan->used;
    plan->listed = stats.drawn > plan->listed ? stats.drawn : plan->listed;
    plan->carried = stats.carried > plan->carried ? stats.carried : plan->carried;
    plan->edges = stats.edges > plan->edges ? stats.edges : plan->edges;
    plan->cut += stats.clipped;
}

/* ---- a turn ---- */

/* If only what changed is sent, the frame before the first one is drawn as well, but not counted. */
static int turn(struct sheen_plan *plan, struct sheen_plan_run *run, int views, struct sheen_problem *problem)
{
    int error = SHEEN_OK;

    for (int whole = 0; whole < 2; whole++) {
        for (int view = whole - 1; view < views && !error; view++) {
            error = sheen_plan_draw(run, view, whole, problem);
            if (!error && view >= 0) {
                add_view(plan, run, whole, 1.0 / views);
                note_most(plan, run);
            }
        }
    }
    return error;
}

static const char *texture_of(const struct sheen_scene *scene)
{
    const int is_shown = scene->texel_count && scene->options->shade < SHEEN_MATCAP;

    return !is_shown ? "" : scene->options->bilinear ? ", textured bilinear" : ", textured";
}

/* Describes the look in words: ", textured, under fog, dithered". */
static void note_look(struct sheen_plan *plan, const struct sheen_scene *scene)
{
    static const char *const edges[SHEEN_EDGINGS] = {"", ", smooth", ", with outlines", ", wire"};
    const struct sheen_options *o = scene->options;

    plan->shade = o->edges == SHEEN_WIRE ? SHEEN_FLAT : sheen_scene_shading(scene);
    snprintf(plan->look, sizeof plan->look, "%s%s%s%s%s%s%s%s", texture_of(scene),
             sheen_scene_is_colored(scene) ? ", coloured" : "", o->ramp.kind != SHEEN_RAMP_LAMBERT ? ", by a ramp" : "",
             o->morph ? ", between two frames" : "", scene->view.fog ? ", under fog" : "",
             o->opacity < 1 ? ", by a pattern" : "", edges[sheen_scene_edging(scene)],
             scene->view.dither ? ", dithered" : "");
}

/* RAM with default capacities, and with those that this turn takes. */
static void take_memory(struct sheen_plan *plan)
{
    struct sheen_config *c = &plan->counted;

    sheen_plan_ram(&plan->ram, &plan->config, &plan->target);
    *c = plan->config;
    c->max_used = (uint16_t)plan->used;
    c->max_triangles = (uint16_t)plan->listed;
    c->max_carried = (uint16_t)(plan->carried < SHEEN_PLAN_CARRIED ? plan->carried : SHEEN_PLAN_CARRIED);
    c->max_edges = c->max_edges ? (uint16_t)(plan->edges + plan->triangles / 64 + 1) : 0;
    sheen_plan_ram(&plan->least, c, &plan->target);
}

/* Takes over sizes and computes RAM and flash, once the frames have been drawn. */
static void take_sizes(struct sheen_plan *plan, const struct sheen_plan_run *run)
{
    const struct sheen_scene *scene = &run->table.scene;
    const struct sheen_plan_board *board;

    note_look(plan, scene);
    for (size_t i = 0; i < scene->count; i++) {
        plan->vertices += scene->meshes[i].mesh.vertices;
        plan->triangles += scene->meshes[i].mesh.triangles;
    }
    plan->config = scene->config;
    plan->config.target = NULL;
    plan->target = *run->panel;
    plan->target.ctx = NULL;
    take_memory(plan);
    for (unsigned i = 0; (board = sheen_plan_board_at(i)) != NULL; i++)
        sheen_plan_flash(&plan->flash[i], board->cpu, scene, plan->cut > 0, plan->choice.record);
}

int sheen_plan_make(struct sheen_plan *plan, const struct sheen_options *options, const struct sheen_sim_choice *choice,
                    int views, struct sheen_problem *problem)
{
    struct sheen_plan_run *run = calloc(1, sizeof *run);
    struct sheen_options turned = *options;

    memset(plan, 0, sizeof *plan);
    plan->options = options;
    plan->choice = *choice;
    plan->panel = choice->record ? choice->record->name : "ideal";
    if (!run)
        return sheen_problem(problem, SHEEN_ERR_MEMORY, "%s: not enough memory", options->mesh);
    turned.yaw_step = 360.0 / views;
    int error = sheen_plan_open(run, &turned, choice, problem);
    plan->is_usage = run->table.scene.is_usage;
    if (!error)
        error = turn(plan, run, views, problem);
    if (!error)
        take_sizes(plan, run);
    sheen_plan_close(run);
    free(run);
    return error;
}
