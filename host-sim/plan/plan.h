/*
 * plan.h - times and memory of a mesh's frames on boards over a turn, from counts and costs of what frames are made of.
 */
#ifndef SHEEN_PLAN_H
#define SHEEN_PLAN_H

#include "memory.h"
#include "run.h"

#define SHEEN_PLAN_VIEWS 60 /* over one turn */
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
    double stage[SHEEN_PLAN_STAGES]; /* the processor's, by enum sheen_plan_stage */
    double bus;
    double period[SHEEN_PLAN_PERIODS]; /* from one frame to the next */
};

/* Over the views of a turn. */
struct sheen_plan_times {
    struct sheen_plan_time mean;
    double worst[SHEEN_PLAN_PERIODS];
    double bytes; /* on the bus, mean per frame */
};

struct sheen_plan {
    const struct sheen_options *options;
    enum sheen_shading shade; /* as drawn: gouraud or flat with a texture or point lights, flat for wire */
    char look[128];           /* what else is shown, in words, each after a comma and a space */
    int is_usage;             /* 1: an error is the command line's, not the mesh's */
    struct sheen_sim_choice choice;
    const char *panel;
    uint32_t vertices, triangles;                        /* of the meshes */
    uint32_t used, listed, carried, edges;               /* the most in any frame */
    uint32_t cut;                                        /* triangles cut, in all frames */
    struct sheen_target target;                          /* a copy; its callbacks MUST not be called, ctx is NULL */
    struct sheen_config config;                          /* its target is NULL */
    struct sheen_plan_times times[SHEEN_PLAN_BOARDS][2]; /* [0]: what changed is sent, [1]: whole frames */
    struct sheen_plan_flash flash[SHEEN_PLAN_BOARDS];
    struct sheen_plan_ram ram;   /* with default capacities */
    struct sheen_config counted; /* the capacities that this turn takes */
    struct sheen_plan_ram least; /* with these */
};

/* Draws `views` frames of a turn and makes the plan from them. 0, or a negative code and *problem. */
int sheen_plan_make(struct sheen_plan *plan, const struct sheen_options *options, const struct sheen_sim_choice *choice,
                    int views, struct sheen_problem *problem);

/* Rows per band: as asked for, or 16, rounded up to what the panel can address, at most the picture's. */
unsigned sheen_plan_band_rows(const struct sheen_plan *plan);

/* Hz: as asked for, else what the panel is rated for, and at most what the board has. */
double sheen_plan_bus_hz(const struct sheen_plan *plan, const struct sheen_plan_board *board);

/* The B of RAM, with the capacities that this turn takes, or of flash, that are missing; 0: it fits. */
uint32_t sheen_plan_ram_short(const struct sheen_plan *plan, const struct sheen_plan_board *board);
uint32_t sheen_plan_flash_short(const struct sheen_plan *plan, unsigned board);

/* The processor's seconds of a frame: the sum of its stages. */
double sheen_plan_drawing(const struct sheen_plan_time *time);

/* A change to the command line and the rate that it gives. */
struct sheen_plan_change {
    char what[64];
    double rate; /* mean frames per second if only what changed is sent */
};
#define SHEEN_PLAN_CHANGES 9

/* Finds the changes that help on a board, best first; *now: the rate without them. Returns how many there are. */
unsigned sheen_plan_changes(const struct sheen_plan *plan, unsigned board, struct sheen_plan_change *changes,
                            double *now);

#endif
