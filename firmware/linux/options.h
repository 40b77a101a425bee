/*
 * options.h - the options of sheen-panel, from its command line or from a file that uses the same names.
 */
#ifndef OPTIONS_H
#define OPTIONS_H

#include "sheen_failure.h"
#include "sheen_panel.h"

/* The view, which is what the mesh looks like: the same options as for `sheen render`, from the same table. */
#include "../../host-sim/command/options.h"

#define OPTIONS_TEXT 128 /* size of an option's text with its NUL, B */

/* A text option that was not given is "", unless options.c sets a default. */
struct options {
    /* wiring */
    char panel[OPTIONS_TEXT], spi[OPTIONS_TEXT], i2c[OPTIONS_TEXT], sclk[OPTIONS_TEXT], mosi[OPTIONS_TEXT],
        cs[OPTIONS_TEXT], dc[OPTIONS_TEXT], reset[OPTIONS_TEXT], backlight[OPTIONS_TEXT], te[OPTIONS_TEXT];
    long clock;       /* Hz; 0: the panel's rated clock */
    long spi_mode;    /* 0..3; -1: the panel's */
    long address;     /* I2C address; 0: the panel's */
    long orientation; /* 0..7; -1: the panel's default */
    /* the module; -1: as the panel's record has it */
    long gap[2], invert, order, brightness;
    /* what is shown */
    char mesh[4096];
    struct sheen_options view;
    long first_light, frames; /* frames: 0 is endless */
    long buffers;
    double fps; /* frame rate limit; 0: as fast as possible */
    long quiet; /* print no statistics */
    /* actions other than showing something */
    long list, panels, help, man, version;
    char *file; /* the text of --config, NULL: none; lives until the program ends, because the view points into it */
};

/*
 * Sets the defaults, then reads the file named by --config, then the command line.
 * Returns 0; or 2 for a wrong command line, 1 for a wrong file, and *why says what is wrong.
 */
int options_read(struct options *options, int argc, char **argv, struct sheen_failure *why);

/* Checks that everything that a panel needs is given: 0, or 2 and *why. */
int options_check(const struct options *options, struct sheen_failure *why);

/* Makes the record: that of --panel, changed by the options about the module. 0, or 2 and *why. */
int options_record(const struct options *options, struct sheen_panel_record *record, struct sheen_failure *why);

/* The orientation as given, or the panel's default; after options_check(). */
unsigned options_orientation(const struct options *options);

/* Prints the help text on standard output. */
void options_help(void);

/* Prints the manual page, in roff, on standard output. */
void options_man(void);

/* Private to options*.c: set an option by its name: 0, or -1 and *why; read a file of options: 0, or 1 and *why. */
int options_set(struct options *options, const char *name, const char *value, struct sheen_failure *why);
int options_read_file(struct options *options, const char *path, struct sheen_failure *why);

#endif
