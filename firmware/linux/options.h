/*
 * options.h - what sheen-panel is told, on its command line or in a file of the same words.
 */
#ifndef OPTIONS_H
#define OPTIONS_H

#include "sheen_failure.h"
#include "sheen_panel.h"

/* The view: the same words as `sheen render`, from the same table. */
#include "../../host-sim/command/options.h"

#define OPTIONS_TEXT 128 /* B of an option's text, with its NUL */

/* "" where an option was not given, unless a default is noted in options.c. */
struct options {
    /* wiring */
    char panel[OPTIONS_TEXT], spi[OPTIONS_TEXT], i2c[OPTIONS_TEXT], sclk[OPTIONS_TEXT], mosi[OPTIONS_TEXT],
        cs[OPTIONS_TEXT], dc[OPTIONS_TEXT], reset[OPTIONS_TEXT], backlight[OPTIONS_TEXT], te[OPTIONS_TEXT];
    long clock;       /* Hz; 0: the panel's rated clock */
    long spi_mode;    /* 0..3; -1: the panel's */
    long address;     /* of I2C; 0: the panel's */
    long orientation; /* 0..7; -1: the panel's default */
    /* the module; -1: as the panel's record has it */
    long gap[2], invert, order, brightness;
    /* what is shown */
    char mesh[4096];
    struct sheen_options view;
    long first_light, frames; /* frames: 0 is without end */
    long buffers;
    double fps; /* at most so many; 0: as fast as it goes */
    long quiet; /* no statistics */
    /* other than showing */
    long list, panels, help, man, version;
    char *file; /* the text of --config, which names of the view point into; NULL: none. Kept to the program's end */
};

/*
 * Defaults, then the file named by --config, then the command line. 0; 2 for a
 * wrong command line, 1 for a wrong file, and *why says what is wrong.
 */
int options_read(struct options *options, int argc, char **argv, struct sheen_failure *why);

/* Whether all is there that a panel needs: 0, or 2 and *why. */
int options_check(const struct options *options, struct sheen_failure *why);

/* The panel's record with what was said of the module: 0, or 2 and *why. */
int options_record(const struct options *options, struct sheen_panel_record *record, struct sheen_failure *why);

/* Of a checked panel: as given, or the panel's default. */
unsigned options_orientation(const struct options *options);

/* The help text, on standard output. */
void options_help(void);

/* The page of the manual, in roff, on standard output. */
void options_man(void);

/* Private to options*.c: an option by its name, 0 or -1 and *why; and the lines of a file, 0 or 1 and *why. */
int options_set(struct options *options, const char *name, const char *value, struct sheen_failure *why);
int options_read_file(struct options *options, const char *path, struct sheen_failure *why);

#endif
