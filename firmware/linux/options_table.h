/*
 * options_table.h - private to options*.c and man.c: the options for wiring and running. The options for
 * what the mesh looks like are those of the command `sheen` (host-sim/command/options.h).
 */
#ifndef OPTIONS_TABLE_H
#define OPTIONS_TABLE_H

#include "options.h"

#include <stddef.h>

enum option_kind {
    TEXT,
    WHOLE,  /* long; 0x before the digits: hexadecimal */
    NUMBER, /* double */
    PAIR,   /* long[2], both in min..max: "X,Y" */
    WORD,   /* long: the index of the word in `value`, where words are separated by | */
    SWITCH,
    ONLY_HERE
};

struct option_row {
    const char *name;
    enum option_kind kind; /* SWITCH has no value on the command line; ONLY_HERE is a TEXT not allowed in a file */
    size_t field;          /* offset in struct options */
    double min, max;
    const char *value, *help; /* as shown by --help */
};

/* A row without a name is a heading; a row with neither name nor help ends the table. */
extern const struct option_row option_rows[];

/* The texts of --help besides the options. */
extern const char options_what[], options_mesh[], options_look[];

/* Whether an option from the command's table is an option of sheen-panel too. */
int option_is_view(const struct sheen_option *option);

/* Set an option of either table. 0, or -1 and *why, which begins with the option's name. value: NULL for a switch. */
int option_set_row(struct options *options, const struct option_row *row, const char *value, struct sheen_failure *why);
int option_set_view(struct options *options, const struct sheen_option *option, const char *value,
                    struct sheen_failure *why);

#endif
