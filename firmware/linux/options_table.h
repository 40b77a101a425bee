/*
 * options_table.h - private to options*.c: the options of wiring and running. Those of what the mesh
 * looks like are the command's (host-sim/command/options.h).
 */
#ifndef OPTIONS_TABLE_H
#define OPTIONS_TABLE_H

#include "options.h"

#include <stddef.h>

enum option_kind {
    TEXT,
    WHOLE,  /* long; 0x before it: hexadecimal */
    NUMBER, /* double */
    PAIR,   /* long[2], both in min..max: "X,Y" */
    WORD,   /* long: the number of the word in `value`, words parted by | */
    SWITCH,
    ONLY_HERE
};

struct option_row {
    const char *name;
    enum option_kind kind; /* SWITCH takes no value on the command line; ONLY_HERE is a TEXT that no file may hold */
    size_t field;          /* offset in struct options */
    double min, max;
    const char *value, *help; /* as in the help text */
};

/* Ended by a row with neither name nor help; one without a name is a heading. */
extern const struct option_row option_rows[];

/* What --help says besides the options. */
extern const char options_what[], options_mesh[], options_look[];

/* Whether an option of the command's table is one of sheen-panel's too. */
int option_is_view(const struct sheen_option *option);

/* Of either kind, by value: 0, or -1 and *why, which begins with the option's name. value: NULL for a bare switch. */
int option_set_row(struct options *options, const struct option_row *row, const char *value, struct sheen_failure *why);
int option_set_view(struct options *options, const struct sheen_option *option, const char *value,
                    struct sheen_failure *why);

#endif
