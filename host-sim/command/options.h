/*
 * options.h - the command line of `sheen`: one table drives the parser, --help and the man page.
 */
#ifndef SHEEN_OPTIONS_H
#define SHEEN_OPTIONS_H

#include <stddef.h>
#include <stdint.h>

#include "problem.h"
#include "shadings.h"
#include "sheen.h"

/* Exit statuses. */
enum sheen_exit {
    SHEEN_EXIT_OK = 0,
    SHEEN_EXIT_FAILURE = 1, /* bad input, a failed write, a complaint of the controller */
    SHEEN_EXIT_USAGE = 2    /* a wrong command line */
};

/* What an option's argument is, and the type of the field at its offset in which it is stored. */
enum sheen_option_kind {
    SHEEN_OPTION_FLAG,   /* int: 1 if given */
    SHEEN_OPTION_REAL,   /* double */
    SHEEN_OPTION_WHOLE,  /* int */
    SHEEN_OPTION_CHOICE, /* int: the number of the word in `argument`, whose words are separated by | */
    SHEEN_OPTION_COLOR,  /* uint8_t[3]: six hex digits, with # or without, or a name (color_names.h) */
    SHEEN_OPTION_PAINT,  /* struct sheen_paint: a colour, or the word `file` if `argument` lists it */
    SHEEN_OPTION_SIZE,   /* unsigned[2] */
    SHEEN_OPTION_LIGHT,  /* struct sheen_light_list: adds a directional light, white if no colour is given */
    SHEEN_OPTION_POINT,  /* the same: adds a point light */
    SHEEN_OPTION_RAMP,   /* struct sheen_ramp_choice: a word of `argument`; gamma may be followed by :G */
    SHEEN_OPTION_DEPTHS, /* struct sheen_depths: START,END, 0 < START < END */
    SHEEN_OPTION_TEXT    /* const char * */
};

struct sheen_paint {
    uint8_t color[3];
    int given;     /* 0: the default applies, which for a mesh is white on panels of greys */
    int from_file; /* 1: the file's colours, and the default where the file has none */
};

enum sheen_ramp_kind {
    SHEEN_RAMP_LAMBERT, /* no ramp */
    SHEEN_RAMP_HALF,
    SHEEN_RAMP_GAMMA,
    SHEEN_RAMP_TOON
};

struct sheen_ramp_choice {
    int kind;     /* enum sheen_ramp_kind */
    double gamma; /* for SHEEN_RAMP_GAMMA */
};

struct sheen_light_list {
    double to[SHEEN_MAX_LIGHTS][3];  /* direction; of a point light, its place from the mesh's centre in mesh radii */
    double radius[SHEEN_MAX_LIGHTS]; /* of a point light, in mesh radii; 0: a directional light */
    uint8_t color[SHEEN_MAX_LIGHTS][3];
    int count;
    int given; /* 0: the list is still the default, which the first light given replaces */
};

struct sheen_depths {
    double start, end; /* in radii of the mesh; 0, 0: not given */
};

struct sheen_options {
    const char *mesh, *out, *panel;
    unsigned size[2];                  /* px; 0: not given */
    int orientation;                   /* -1: not given */
    int shade;                         /* enum sheen_shading */
    int shade_given;                   /* 0: the default, which becomes gouraud if a texture or point lights need it */
    double yaw, pitch, roll, yaw_step; /* degrees */
    double distance, fov;
    struct sheen_light_list lights;
    double ambient, diffuse, specular;
    int shininess;
    struct sheen_ramp_choice ramp;
    struct sheen_paint color;
    uint8_t background[3], ambient_color[3];
    int no_vertex_colors;
    struct sheen_depths fog;
    struct sheen_paint fog_color; /* not given: the background's */
    double opacity;               /* 0..1 */
    int phase;                    /* columns that opacity's pattern is shifted by, 0..7 */
    int edges;                    /* enum sheen_edging; -1: not given */
    struct sheen_paint line;      /* the edges' colour; not given: black on a light background, else white */
    int two_sided, average, affine, ortho;
    int cull_given; /* 1: on the command line */
    double crease;  /* degrees; 180 averages all */
    int equal;      /* 1: averages of normals weigh all faces alike */
    int up;         /* 0: y, 1: z; -1: not given */
    int reduce;     /* triangles; 0: not given */
    int undithered; /* -1: not given */
    int band;       /* rows; 0: not given */
    int buffers;
    int frames;
    int stats;
    const char *texture;     /* "file", "off", or a picture's path */
    int bilinear;            /* 0: nearest */
    int wrap;                /* enum sheen_wrap_option */
    int texture_log2;        /* log2 of the texels per side, 0..9 */
    int palette;             /* 2..256 colours; 0: not limited */
    const char *matcap;      /* one of SHEEN_MATCAP_NAMES, or a picture's path */
    int matcap_given;        /* 1: on the command line */
    const char *texture_out; /* NULL: not given */
    double alpha_cutoff;     /* below 0: not given */
    const char *morph;       /* another frame of the mesh; NULL: none */
    int morph_target;
    double morph_weight; /* 0..1 */
    const char *name;    /* bake: the mesh's C identifier; NULL: made from the output's name */
    int groups, no_flat, bake_edges;
    /* view: */
    int view_frames; /* 0: not given */
    int scale;       /* 0: not given */
    int gap;         /* -1: not given */
    int theme;       /* enum sheen_theme */
    int terminal;
    /* plan: */
    const char *board; /* NULL: all */
    double bus_clock;  /* MHz; 0: the panel's */
    int json;
    int quiet; /* 1: no notes on the mesh; no option sets it */
};

/* Bits of the commands that take an option. */
enum sheen_command_bit {
    SHEEN_RENDER = 1,
    SHEEN_FIRST_LIGHT = 2,
    SHEEN_PANELS = 4,
    SHEEN_BAKE = 8,
    SHEEN_LECTURE = 16,
    SHEEN_VIEW = 32,
    SHEEN_PLAN = 64,
    SHEEN_DRAWS = SHEEN_RENDER | SHEEN_VIEW | SHEEN_PLAN,
    SHEEN_TAKES_MESH = SHEEN_DRAWS | SHEEN_BAKE
};

/* What an option is about: its heading in the help, in this order. From 1 on, because 0 is an option without any. */
enum sheen_option_section {
    SHEEN_FOR_OUTPUT = 1,
    SHEEN_FOR_BOARD,
    SHEEN_FOR_PANEL,
    SHEEN_FOR_WINDOW,
    SHEEN_FOR_VIEW,
    SHEEN_FOR_LIGHT,
    SHEEN_FOR_COLOR,
    SHEEN_FOR_TEXTURE,
    SHEEN_FOR_EDGES,
    SHEEN_FOR_MESH,
    SHEEN_FOR_ANIMATION,
    SHEEN_SECTIONS_END
};

struct sheen_option {
    enum sheen_option_section section; /* first, so that an entry without one does not compile */

    const char *name;     /* long, without dashes */
    const char *argument; /* the argument's name in the help, or the words of a choice; NULL: none */
    const char *value;    /* the default, as typed on a command line; NULL: none */
    const char *help;
    enum sheen_option_kind kind;
    unsigned commands; /* of enum sheen_command_bit */
    size_t offset;     /* into struct sheen_options */
    double low, high;  /* range of a number */
    char letter;       /* short form, or 0 */
};

struct sheen_command {
    const char *name;
    const char *operands; /* "MESH -o OUT.png" */
    const char *summary;
    unsigned bit;
    enum sheen_exit (*run)(struct sheen_options *options);
};

/* The table, ended by an entry without a name. */
extern const struct sheen_option sheen_option_table[];

/*
 * Sets the defaults, then parses argv[1..]; options and the operand may come in any order.
 * 1: go on; 0: help or the version was asked for and printed; or SHEEN_ERR_ARGUMENT and *problem.
 */
int sheen_options_parse(struct sheen_options *options, const struct sheen_command *command, int argc, char **argv,
                        struct sheen_problem *problem);

/* Print --version, and --help of a command, on standard output. */
void sheen_options_version(void);
void sheen_options_help(const struct sheen_command *command);

/*
 * Calls put_heading, with the heading's text, and put_option for each of a command's options, by section; a section
 * without options of the command is left out.
 */
void sheen_options_each(const struct sheen_command *command, void (*put_heading)(const char *text),
                        void (*put_option)(const struct sheen_option *option));

/* Prints a part of the help on standard output. Lines are wrapped, except those that begin with a space. */
void sheen_options_paragraph(const char *text);

/* An option's description and default, for the help and the man page; free() it. NULL: not enough memory. */
char *sheen_option_text(const struct sheen_option *option);

/* The version, such as "0.2.0", and what the help and the man page say of the command as a whole. */
extern const char sheen_version[], sheen_text_what[], sheen_text_help[], sheen_text_mesh[], sheen_text_exit[];

/* Stores an option's argument in its field. 0, or SHEEN_ERR_ARGUMENT and *problem. */
int sheen_option_set(struct sheen_options *options, const struct sheen_option *option, const char *text,
                     struct sheen_problem *problem);

#endif
