/*
 * commands.h - the subcommands of `sheen`.
 */
#ifndef SHEEN_COMMANDS_H
#define SHEEN_COMMANDS_H

#include "options.h"

/* The table, ended by an entry without a name. */
extern const struct sheen_command sheen_command_table[];

enum sheen_exit sheen_cmd_render(struct sheen_options *options);
enum sheen_exit sheen_cmd_view(struct sheen_options *options);
enum sheen_exit sheen_cmd_plan(struct sheen_options *options);
enum sheen_exit sheen_cmd_bake(struct sheen_options *options);
enum sheen_exit sheen_cmd_first_light(struct sheen_options *options);
enum sheen_exit sheen_cmd_panels(struct sheen_options *options);
enum sheen_exit sheen_cmd_lecture(struct sheen_options *options);
enum sheen_exit sheen_cmd_man(struct sheen_options *options);

/* Prints the one error line, "sheen: ...", after a wrong command line with the help to see. Returns status. */
enum sheen_exit sheen_fail(enum sheen_exit status, const struct sheen_problem *problem);

#endif
