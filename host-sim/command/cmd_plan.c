/*
 * cmd_plan.c - `sheen plan`: frames per second, RAM and flash of a mesh on boards.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "builtin.h"
#include "commands.h"
#include "report.h"

enum {
    COLUMNS = 80,
    LABEL = 11 /* of `measured`, `estimated`, `counted` and what follows them: the rest of a long line stands below */
};

/* *board: its number, -1: all; *choice: the panel. 0, or SHEEN_ERR_ARGUMENT and *problem: a wrong command line. */
static int check(const struct sheen_options *options, int *board, struct sheen_sim_choice *choice,
                 struct sheen_problem *problem)
{
    *board = options->board ? sheen_plan_board_find(options->board, problem) : -1;
    int error = options->board && *board < 0 ? *board : sheen_turntable_check(choice, options, problem);

    return error ? error : sheen_builtin_check(options->mesh, problem);
}

/* Prints a line without its end, broken between words. */
static void put_broken(const char *line, size_t length)
{
    int indent = 0;

    while (length > (size_t)(COLUMNS - indent)) {
        size_t part = (size_t)(COLUMNS - indent);
        while (part > 0 && (line[part] != ' ' || line[part + 1] == 'B')) /* not between a number and its unit, B */
            part--;
        if (part == 0) /* a name without blanks */
            break;
        printf("%*s%.*s\n", indent, "", (int)part, line);
        line += part + 1;
        length -= part + 1;
        indent = LABEL;
    }
    printf("%*s%.*s\n", indent, "", (int)length, line);
}

/* Prints the plan's text for a terminal of 80 columns. */
static int put_text(const struct sheen_plan *plan, int board, struct sheen_problem *problem)
{
    char *text = NULL;
    size_t size;
    FILE *lines = open_memstream(&text, &size);
    int is_whole = lines != NULL;

    if (lines) {
        sheen_plan_text(lines, plan, board);
        is_whole = !ferror(lines);
        is_whole &= fclose(lines) == 0;
    }
    for (const char *line = text; is_whole && *line;) {
        const size_t length = strcspn(line, "\n");
        put_broken(line, length);
        line += length + 1; /* every line has an end */
    }
    free(text);
    return is_whole ? SHEEN_OK : sheen_problem(problem, SHEEN_ERR_MEMORY, "%s: not enough memory", plan->options->mesh);
}

/* The board that was asked for must have enough RAM and flash. */
static int judge(const struct sheen_plan *plan, int board, struct sheen_problem *problem)
{
    const struct sheen_plan_board *b = board >= 0 ? sheen_plan_board_at((unsigned)board) : NULL;
    uint32_t ram = b ? sheen_plan_ram_short(plan, b) : 0, flash = b ? sheen_plan_flash_short(plan, (unsigned)board) : 0;

    if (ram)
        return sheen_problem(problem, SHEEN_ERR_MEMORY, "%s on %s needs %u B of RAM, %u more than it has",
                             plan->options->mesh, b->name, plan->least.all, ram);
    if (flash)
        return sheen_problem(problem, SHEEN_ERR_MEMORY, "%s on %s needs %u B of flash, %u more than it has",
                             plan->options->mesh, b->name, plan->flash[board].all, flash);
    return SHEEN_OK;
}

enum sheen_exit sheen_cmd_plan(struct sheen_options *options)
{
    struct sheen_sim_choice choice;
    struct sheen_problem problem;
    int board;

    if (check(options, &board, &choice, &problem) != 0)
        return sheen_fail(SHEEN_EXIT_USAGE, &problem);
    struct sheen_plan *plan = malloc(sizeof *plan);
    int error = plan ? sheen_plan_make(plan, options, &choice, SHEEN_PLAN_VIEWS, &problem)
                     : sheen_problem(&problem, SHEEN_ERR_MEMORY, "%s: not enough memory", options->mesh);
    if (!error) {
        if (options->json)
            sheen_plan_json(stdout, plan, board);
        else
            error = put_text(plan, board, &problem);
    }
    if (!error)
        error = judge(plan, board, &problem);
    const int is_usage = plan && plan->is_usage;
    free(plan);
    return error ? sheen_fail(is_usage ? SHEEN_EXIT_USAGE : SHEEN_EXIT_FAILURE, &problem) : SHEEN_EXIT_OK;
}
