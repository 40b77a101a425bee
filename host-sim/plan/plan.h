/*
 * plan.h - how long frames of a mesh take on boards, and what memory: over a turn, from what is counted and costs.
 */
#ifndef SHEEN_PLAN_H
#define SHEEN_PLAN_H

#include "memory.h"
#include "run.h"

#define SHEEN_PLAN_VIEWS 60 /* of a turn */
#define SHEEN_PLAN_BOARDS 16

/* How a frame is drawn and sent. */
enum sheen_plan_period {
    SHEEN_PLAN_ONE_BUFFER,
    SHEEN_PLAN_TWO_BUFFERS,
    SHEEN_PLAN_TWO_CORES, /* with two buffers each */
    SHEEN_PLAN_PERIODS
};

/* Seconds. */
struct sheen_plan_time {
    double stage[SHEEN_PLAN_STAGES]; /* the processor, by enum sheen_plan_stage */
    double bus;
    double period[SHEEN_PLAN_PERIODS]; /* from one frame to the next */
};

/* Of the views of a turn. */
struct sheen_plan_times {
    struct sheen_plan_time mean;
    double worst[SHEEN_PLAN_PERIODS];
    double bytes; /* on the bus, in the mean */
};

struct sheen_plan {
    const struct sheen_options *options;
    enum sheen_shading shade; /* where a texture is shown or lights are points gouraud, or flat */
    char look[128];           /* what else is shown, in words, each after a comma */
    int is_usage;             /* 1: the command line is what is wrong, not the mesh */
    struct sheen_sim_choice choice;
    const char *panel;
    uint32_t vertices, triangles;                        /* of the meshes */
    uint32_t used, listed, edges;                        /* the most of a frame */
    uint32_t cut;                                        /* triangles, of all frames */
    struct sheen_target target;                          /* but ctx and callbacks */
    struct sheen_config config;                          /* but the target */
    struct sheen_plan_times times[SHEEN_PLAN_BOARDS][2]; /* what changed, and whole frames */
    struct sheen_plan_flash flash[SHEEN_PLAN_BOARDS];
    struct sheen_plan_ram ram;
};

/* views: so many of a turn. 0, or a negative code and *problem. */
int sheen_plan_make(struct sheen_plan *plan, const struct sheen_options *options, const struct sheen_sim_choice *choice,
                    int views, struct sheen_problem *problem);

/* Rows of a band: what is asked for, or 16, in steps that the panel can address, and no more than it has. */
unsigned sheen_plan_band_rows(const struct sheen_plan *plan);

/* Hz: what the board has, the panel takes, or is asked for. */
double sheen_plan_bus_hz(const struct sheen_plan *plan, const struct sheen_plan_board *board);

/* B that RAM, or flash, is short of; 0: it fits. */
uint32_t sheen_plan_ram_short(const struct sheen_plan *plan, const struct sheen_plan_board *board);
uint32_t sheen_plan_flash_short(const struct sheen_plan *plan, unsigned board);

/* The processor's part of a frame. */
double sheen_plan_drawing(const struct sheen_plan_time *time);

/* A change to the command line and what comes of it. */
struct sheen_plan_change {
    char what[64];
    double rate; /* frames a second, in the mean, of what changed */
};
#define SHEEN_PLAN_CHANGES 9

/* What helps on a board, the most first; *now: the rate to compare with. How many there are. */
unsigned sheen_plan_changes(const struct sheen_plan *plan, unsigned board, struct sheen_plan_change *changes,
                            double *now);

#endif
