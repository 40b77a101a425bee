/*
 * options.c - the command line of `sheen`: the table and the parser.
 */
#include "options.h"

#include "ramps.h"

#include <getopt.h>
#include <stdio.h>
#include <string.h>

#include "matcaps.h"
#include "shadings.h"

#define AT(field) offsetof(struct sheen_options, field)
#define ANY 1e300 /* an angle may be any finite number */

const struct sheen_option sheen_option_table[] = {
    {SHEEN_FOR_OUTPUT, "output", "FILE", NULL,
     "the picture; with several frames %d or %0Nd becomes the number, or a .gif holds all", SHEEN_OPTION_TEXT,
     SHEEN_RENDER, AT(out), 0, 0, 'o'},
    {SHEEN_FOR_OUTPUT, "output", "FILE.png", NULL, "the picture, a PNG", SHEEN_OPTION_TEXT, SHEEN_FIRST_LIGHT, AT(out),
     0, 0, 'o'},
    {SHEEN_FOR_OUTPUT, "output", "FILE.h", NULL, "the header", SHEEN_OPTION_TEXT, SHEEN_BAKE, AT(out), 0, 0, 'o'},
    {SHEEN_FOR_OUTPUT, "output", "DIR", NULL, "the folder for the pictures, created if needed", SHEEN_OPTION_TEXT,
     SHEEN_LECTURE, AT(out), 0, 0, 'o'},
    {SHEEN_FOR_OUTPUT, "name", "NAME", NULL, "the mesh's name in C [from the output's name]", SHEEN_OPTION_TEXT,
     SHEEN_BAKE, AT(name), 0, 0, 0},
    {SHEEN_FOR_OUTPUT, "texture-out", "FILE.png", NULL,
     "write the texture as it is drawn; with several textures %d or %0Nd becomes the number", SHEEN_OPTION_TEXT,
     SHEEN_RENDER | SHEEN_BAKE, AT(texture_out), 0, 0, 0},
    {SHEEN_FOR_OUTPUT, "gif", "FILE", NULL, "write an animation instead of opening a window", SHEEN_OPTION_TEXT,
     SHEEN_VIEW, AT(out), 0, 0, 0},
    {SHEEN_FOR_OUTPUT, "terminal", NULL, NULL,
     "draw in the terminal with half blocks in 24-bit colour instead of opening a window", SHEEN_OPTION_FLAG,
     SHEEN_VIEW, AT(terminal), 0, 0, 0},
    {SHEEN_FOR_OUTPUT, "stats", NULL, NULL, "print a line of JSON per frame", SHEEN_OPTION_FLAG, SHEEN_RENDER,
     AT(stats), 0, 0, 0},
    {SHEEN_FOR_OUTPUT, "json", NULL, NULL, "print one JSON object", SHEEN_OPTION_FLAG, SHEEN_PLAN, AT(json), 0, 0, 0},
    {SHEEN_FOR_BOARD, "board", "NAME", NULL, "the board [all, one line each]", SHEEN_OPTION_TEXT, SHEEN_PLAN, AT(board),
     0, 0, 0},
    {SHEEN_FOR_BOARD, "bus-clock", "MHZ", NULL,
     "clock of the panel's SPI [the panel's rated clock, or the board's maximum if lower]", SHEEN_OPTION_REAL,
     SHEEN_PLAN, AT(bus_clock), 0.1, 200, 0},
    {SHEEN_FOR_PANEL, "panel", "NAME", "ili9341",
     "the panel to draw on, by controller or full name; ideal takes any size", SHEEN_OPTION_TEXT,
     SHEEN_DRAWS | SHEEN_FIRST_LIGHT, AT(panel), 0, 0, 0},
    {SHEEN_FOR_PANEL, "panel", "NAME", "ili9341", "the panel to report RAM and frame rate for", SHEEN_OPTION_TEXT,
     SHEEN_BAKE, AT(panel), 0, 0, 0},
    {SHEEN_FOR_PANEL, "size", "WxH", NULL, "size of the picture, px; the panel must have it [the panel's]",
     SHEEN_OPTION_SIZE, SHEEN_DRAWS | SHEEN_FIRST_LIGHT, AT(size), 0, 0, 0},
    {SHEEN_FOR_PANEL, "orientation", "K", NULL,
     "0..3: quarter turns of the glass, 4..7: the same mirrored [what fits the size]", SHEEN_OPTION_WHOLE,
     SHEEN_DRAWS | SHEEN_FIRST_LIGHT, AT(orientation), 0, 7, 0},
    {SHEEN_FOR_PANEL, "dither", "on|off", NULL, "ordered 8x8 dither [on, except on panels of 256 greys]",
     SHEEN_OPTION_CHOICE, SHEEN_DRAWS, AT(undithered), 0, 0, 0},
    {SHEEN_FOR_PANEL, "band", "ROWS", NULL, "rows drawn and sent at a time [16, or the picture's height if less]",
     SHEEN_OPTION_WHOLE, SHEEN_DRAWS, AT(band), 1, 480, 0},
    {SHEEN_FOR_PANEL, "band", "ROWS", NULL, "rows of a band to report RAM for [4, 8 and 16]", SHEEN_OPTION_WHOLE,
     SHEEN_BAKE, AT(band), 1, 480, 0},
    {SHEEN_FOR_PANEL, "buffers", "1|2", "1", "2: draw a band while the last one is sent", SHEEN_OPTION_WHOLE,
     SHEEN_DRAWS, AT(buffers), 1, 2, 0},
    {SHEEN_FOR_WINDOW, "scale", "N", NULL, "window pixels per panel pixel [what fits]", SHEEN_OPTION_WHOLE, SHEEN_VIEW,
     AT(scale), 1, 16, 0},
    {SHEEN_FOR_WINDOW, "gap", "N", NULL, "how many of these form a dark gap between panel pixels [1 from scale 4 on]",
     SHEEN_OPTION_WHOLE, SHEEN_VIEW, AT(gap), 0, 15, 0},
    {SHEEN_FOR_WINDOW, "theme", "auto|plain|lcd|oled|blue|yellow|green", "auto", "look of the glass",
     SHEEN_OPTION_CHOICE, SHEEN_VIEW, AT(theme), 0, 0, 0},
    {SHEEN_FOR_VIEW, "yaw", "DEG", "30", "turn the mesh about y", SHEEN_OPTION_REAL, SHEEN_DRAWS, AT(yaw), -ANY, ANY,
     0},
    {SHEEN_FOR_VIEW, "pitch", "DEG", "20", "then about x", SHEEN_OPTION_REAL, SHEEN_DRAWS, AT(pitch), -ANY, ANY, 0},
    {SHEEN_FOR_VIEW, "roll", "DEG", "0", "then about z", SHEEN_OPTION_REAL, SHEEN_DRAWS, AT(roll), -ANY, ANY, 0},
    {SHEEN_FOR_VIEW, "distance", "D", "3", "distance of the eye from the mesh's centre, in radii of the mesh",
     SHEEN_OPTION_REAL, SHEEN_DRAWS, AT(distance), 0.1, 100, 0},
    {SHEEN_FOR_VIEW, "fov", "DEG", "40", "vertical field of view", SHEEN_OPTION_REAL, SHEEN_DRAWS, AT(fov), 1, 150, 0},
    {SHEEN_FOR_VIEW, "ortho", NULL, NULL,
     "orthographic view, with the size that the mesh's centre would have in perspective", SHEEN_OPTION_FLAG,
     SHEEN_DRAWS, AT(ortho), 0, 0, 0},
    {SHEEN_FOR_VIEW, "perspective", "correct|affine", "correct", "shading linear in space, or linear on the screen",
     SHEEN_OPTION_CHOICE, SHEEN_DRAWS, AT(affine), 0, 0, 0},
    {SHEEN_FOR_LIGHT, "shade", "flat|gouraud|phong|slerp|matcap|matcap-vertex", "phong",
     "flat: one normal per polygon; gouraud: light computed at the vertices, the default with a texture or with "
     "colours "
     "of vertices or lights; phong: normals interpolated per pixel; slerp: along great arcs; matcap, matcap-vertex: a "
     "picture of a lit sphere instead of light and textures, looked up per pixel or per vertex",
     SHEEN_OPTION_CHOICE, SHEEN_DRAWS, AT(shade), 0, 0, 0},
    {SHEEN_FOR_LIGHT, "ramp", "lambert|half|gamma|toon", "lambert",
     "diffuse light over the angle. lambert: max(0, L.N); half: half-Lambert, keeps the shape of the dark side; gamma: "
     "on "
     "the panel's curve, 2.2 or as gamma:G says; toon: three steps",
     SHEEN_OPTION_RAMP, SHEEN_DRAWS, AT(ramp), 0, 0, 0},
    {SHEEN_FOR_LIGHT, "light", "X,Y,Z[,COLOR]", "-0.4,0.6,0.8",
     "direction to a light in eye space, and its colour, else white; up to 4 times", SHEEN_OPTION_LIGHT, SHEEN_DRAWS,
     AT(lights), 0, 0, 0},
    {SHEEN_FOR_LIGHT, "point-light", "X,Y,Z,RADIUS[,COLOR]", NULL,
     "a light at X,Y,Z from the mesh's centre, in eye space and radii of the mesh, that fades out over RADIUS; only "
     "flat "
     "and gouraud; up to 4 lights together with --light",
     SHEEN_OPTION_POINT, SHEEN_DRAWS, AT(lights), 0, 1000, 0},
    {SHEEN_FOR_LIGHT, "ambient", "K", "0.2", "ambient light", SHEEN_OPTION_REAL, SHEEN_DRAWS, AT(ambient), 0, 4, 0},
    {SHEEN_FOR_LIGHT, "ambient", "K", "0.2", "the material's ambient light, for ramp:gamma", SHEEN_OPTION_REAL,
     SHEEN_BAKE, AT(ambient), 0, 4, 0},
    {SHEEN_FOR_LIGHT, "ambient-color", "COLOR", "ffffff", "colour of the ambient light", SHEEN_OPTION_COLOR,
     SHEEN_DRAWS, AT(ambient_color), 0, 0, 0},
    {SHEEN_FOR_LIGHT, "diffuse", "K", "0.8", "diffuse light", SHEEN_OPTION_REAL, SHEEN_DRAWS, AT(diffuse), 0, 4, 0},
    {SHEEN_FOR_LIGHT, "diffuse", "K", "0.8", "the material's diffuse light, for ramp:gamma", SHEEN_OPTION_REAL,
     SHEEN_BAKE, AT(diffuse), 0, 4, 0},
    {SHEEN_FOR_LIGHT, "specular", "K", "0.35", "specular light: the highlight", SHEEN_OPTION_REAL, SHEEN_DRAWS,
     AT(specular), 0, 4, 0},
    {SHEEN_FOR_LIGHT, "shininess", "N", "32", "exponent of the highlight: larger is sharper", SHEEN_OPTION_WHOLE,
     SHEEN_DRAWS, AT(shininess), 1, 128, 0},
    {SHEEN_FOR_COLOR, "color", "COLOR|file", NULL,
     "colour of the mesh: rrggbb in hex, a CSS name, or the file's materials [d8a048, ffffff on grey panels]",
     SHEEN_OPTION_PAINT, SHEEN_DRAWS, AT(color), 0, 0, 0},
    {SHEEN_FOR_COLOR, "vertex-colors", "on|off", "on",
     "use the file's vertex colours, multiplied by --color; on textures and matcaps too", SHEEN_OPTION_CHOICE,
     SHEEN_DRAWS | SHEEN_BAKE, AT(no_vertex_colors), 0, 0, 0},
    {SHEEN_FOR_COLOR, "background", "COLOR", "101018", "colour of the background", SHEEN_OPTION_COLOR, SHEEN_DRAWS,
     AT(background), 0, 0, 0},
    {SHEEN_FOR_COLOR, "fog", "START,END", NULL,
     "fog that begins at depth START and hides everything at END, in radii of the mesh, as --distance",
     SHEEN_OPTION_DEPTHS, SHEEN_DRAWS, AT(fog), 0, 127, 0},
    {SHEEN_FOR_COLOR, "fog-color", "COLOR", NULL, "colour of the fog [the background's]", SHEEN_OPTION_PAINT,
     SHEEN_DRAWS, AT(fog_color), 0, 0, 0},
    {SHEEN_FOR_COLOR, "opacity", "K", "1", "the share of the mesh's pixels that are drawn, in an ordered pattern",
     SHEEN_OPTION_REAL, SHEEN_DRAWS, AT(opacity), 0, 1, 0},
    {SHEEN_FOR_COLOR, "phase", "K", "0", "shift that pattern by so many columns, 0..7", SHEEN_OPTION_WHOLE, SHEEN_DRAWS,
     AT(phase), 0, 7, 0},
    {SHEEN_FOR_TEXTURE, "texture", "file|off|FILE", "file",
     "the mesh's texture: the file's own, none, or a PNG or JPEG; shown on faces with texture coordinates",
     SHEEN_OPTION_TEXT, SHEEN_DRAWS | SHEEN_BAKE, AT(texture), 0, 0, 0},
    {SHEEN_FOR_TEXTURE, "texture-size", "1|2|4|8|16|32|64|128|256|512", "256",
     "reduce pictures to at most so many texels a side", SHEEN_OPTION_CHOICE, SHEEN_DRAWS | SHEEN_BAKE,
     AT(texture_log2), 0, 0, 0},
    {SHEEN_FOR_TEXTURE, "filter", "nearest|bilinear", "nearest", "one texel per pixel, or a weighted mean of four",
     SHEEN_OPTION_CHOICE, SHEEN_DRAWS | SHEEN_BAKE, AT(bilinear), 0, 0, 0},
    {SHEEN_FOR_TEXTURE, "wrap", "file|repeat|clamp", "file",
     "beyond a texture's edge: as the file says (by default repeat), repeat it, or hold the edge", SHEEN_OPTION_CHOICE,
     SHEEN_DRAWS | SHEEN_BAKE, AT(wrap), 0, 0, 0},
    {SHEEN_FOR_TEXTURE, "palette", "N", "0",
     "at most N colours per texture, 2 to 256; 0: no palette, 16 bits per texel", SHEEN_OPTION_WHOLE,
     SHEEN_DRAWS | SHEEN_BAKE, AT(palette), 0, 256, 0},
    {SHEEN_FOR_TEXTURE, "alpha-cutoff", "A", NULL,
     "do not draw texels with less alpha, 0 to 1 [what the file says, else 0.5]", SHEEN_OPTION_REAL,
     SHEEN_DRAWS | SHEEN_BAKE, AT(alpha_cutoff), 0, 1, 0},
    {SHEEN_FOR_TEXTURE, "matcap", SHEEN_MATCAP_NAMES "|FILE", "glaze",
     "the picture of the sphere: one of these, or a square PNG or JPEG, reduced to 64 texels a side", SHEEN_OPTION_TEXT,
     SHEEN_DRAWS, AT(matcap), 0, 0, 0},
    {SHEEN_FOR_EDGES, "edges", "none|smooth|outline|wire", NULL,
     "smooth: smooth the contours, on panels of more than two levels; outline: contours and sharp edges as lines; "
     "wire: "
     "all visible edges as lines, faces in the background's colour [smooth; outline on panels of two levels; none with "
     "an opacity below 1]",
     SHEEN_OPTION_CHOICE, SHEEN_RENDER | SHEEN_VIEW, AT(edges), 0, 0, 0},
    {SHEEN_FOR_EDGES, "edges", "none|smooth|outline|wire", NULL, "as for render [none]", SHEEN_OPTION_CHOICE,
     SHEEN_PLAN, AT(edges), 0, 0, 0},
    {SHEEN_FOR_EDGES, "line-color", "COLOR", NULL, "colour of the lines [ffffff, 000000 on a light background]",
     SHEEN_OPTION_PAINT, SHEEN_DRAWS, AT(line), 0, 0, 0},
    {SHEEN_FOR_MESH, "up", "y|z", NULL, "which axis of the file points up [z for STL, else y]", SHEEN_OPTION_CHOICE,
     SHEEN_DRAWS | SHEEN_BAKE, AT(up), 0, 0, 0},
    {SHEEN_FOR_MESH, "reduce", "N", NULL, "simplify the mesh to at most N triangles and report the error",
     SHEEN_OPTION_WHOLE, SHEEN_DRAWS | SHEEN_BAKE, AT(reduce), 4, 65535, 0},
    {SHEEN_FOR_MESH, "cull", "back|none", "back", "leave out faces seen from behind, or draw them too",
     SHEEN_OPTION_CHOICE, SHEEN_DRAWS, AT(two_sided), 0, 0, 0},
    {SHEEN_FOR_MESH, "normals", "file|average", "file",
     "use the file's normals if it has any, or always average those of the faces", SHEEN_OPTION_CHOICE,
     SHEEN_DRAWS | SHEEN_BAKE, AT(average), 0, 0, 0},
    {SHEEN_FOR_MESH, "weights", "angle|equal", "angle",
     "weights of faces in an average: their angle at the vertex, or all equal", SHEEN_OPTION_CHOICE,
     SHEEN_DRAWS | SHEEN_BAKE, AT(equal), 0, 0, 0},
    {SHEEN_FOR_MESH, "crease", "DEG", "60",
     "average only faces within this angle; to keep an edge sharp, take a bit less than its angle (59 for the 60 of a "
     "hexagon); 180: average all",
     SHEEN_OPTION_REAL, SHEEN_DRAWS | SHEEN_BAKE, AT(crease), 0, 180, 0},
    {SHEEN_FOR_MESH, "groups", NULL, NULL, "one mesh per material of the file, and a table of their colours",
     SHEEN_OPTION_FLAG, SHEEN_BAKE, AT(groups), 0, 0, 0},
    {SHEEN_FOR_MESH, "no-flat", NULL, NULL, "leave out polygon normals: flat shading then computes one per triangle",
     SHEEN_OPTION_FLAG, SHEEN_BAKE, AT(no_flat), 0, 0, 0},
    {SHEEN_FOR_MESH, "edges", NULL, NULL, "the mesh's edges too, 8 B per triangle, for firmware that draws them",
     SHEEN_OPTION_FLAG, SHEEN_BAKE, AT(bake_edges), 0, 0, 0},
    {SHEEN_FOR_ANIMATION, "frames", "N", "1", "number of pictures of the turning mesh", SHEEN_OPTION_WHOLE,
     SHEEN_RENDER, AT(frames), 1, 10000, 0},
    {SHEEN_FOR_ANIMATION, "frames", "N", NULL, "number of frames [until closed; 60 in a GIF, 1 in a pipe]",
     SHEEN_OPTION_WHOLE, SHEEN_VIEW, AT(view_frames), 1, 10000, 0},
    {SHEEN_FOR_ANIMATION, "yaw-step", "DEG", "6", "turn from one picture to the next", SHEEN_OPTION_REAL,
     SHEEN_RENDER | SHEEN_VIEW, AT(yaw_step), -ANY, ANY, 0},
    {SHEEN_FOR_ANIMATION, "morph", "FILE", NULL,
     "another frame of the mesh with the same faces: a file, or its glTF morph target if it has any", SHEEN_OPTION_TEXT,
     SHEEN_DRAWS | SHEEN_BAKE, AT(morph), 0, 0, 0},
    {SHEEN_FOR_ANIMATION, "morph-target", "K", "0", "number of the morph target, in the first mesh that has any",
     SHEEN_OPTION_WHOLE, SHEEN_DRAWS | SHEEN_BAKE, AT(morph_target), 0, 65535, 0},
    {SHEEN_FOR_ANIMATION, "morph-weight", "K", "0", "0: draw the mesh, 1: draw the other frame; between: a mix",
     SHEEN_OPTION_REAL, SHEEN_DRAWS, AT(morph_weight), 0, 1, 0},
    {0, NULL, NULL, NULL, NULL, SHEEN_OPTION_FLAG, 0, 0, 0, 0, 0},
};

enum {
    MAX_OPTIONS = sizeof sheen_option_table / sizeof sheen_option_table[0] + 2, /* help, version and the end */
    HELP = 1000, /* values of struct option: these two, or FIRST plus the number of a table entry */
    VERSION = 1001,
    FIRST = 2000
};

/* The table in getopt_long's form. letters: room for two characters per option and three more. */
static void make_getopt(unsigned command, struct option *longs, char *letters)
{
    int count = 0;

    letters += sprintf(letters, ":h"); /* ':' first: getopt_long tells a missing argument from an unknown option */
    for (int i = 0; sheen_option_table[i].name; i++) {
        const struct sheen_option *option = &sheen_option_table[i];
        if (!(option->commands & command))
            continue;
        longs[count++] =
            (struct option){option->name, option->argument ? required_argument : no_argument, NULL, FIRST + i};
        if (option->letter)
            letters += sprintf(letters, "%c%s", option->letter, option->argument ? ":" : "");
    }
    longs[count++] = (struct option){"help", no_argument, NULL, HELP};
    longs[count++] = (struct option){"version", no_argument, NULL, VERSION};
    longs[count] = (struct option){NULL, 0, NULL, 0};
}

/* The entry for a value from getopt_long, FIRST plus its number or its letter; NULL: no option of the command. */
static const struct sheen_option *find_option(int value, unsigned command)
{
    if (value >= FIRST)
        return &sheen_option_table[value - FIRST];
    for (const struct sheen_option *option = sheen_option_table; option->name; option++) {
        if (option->letter == value && (option->commands & command))
            return option;
    }
    return NULL;
}

/* Reports what getopt_long refused; answer: '?' or ':'. */
static int refuse(int answer, unsigned command, char **argv, struct sheen_problem *problem)
{
    const struct sheen_option *option = optopt ? find_option(optopt, command) : NULL;

    if (option && answer == ':')
        return sheen_problem(problem, SHEEN_ERR_ARGUMENT, "--%s needs %s", option->name, option->argument);
    if (option)
        return sheen_problem(problem, SHEEN_ERR_ARGUMENT, "--%s takes no value", option->name);
    if (optopt > 0 && optopt < 256)
        return sheen_problem(problem, SHEEN_ERR_ARGUMENT, "unknown option -%c", optopt);
    return sheen_problem(problem, SHEEN_ERR_ARGUMENT, "unknown or ambiguous option %s", argv[optind - 1]);
}

static const uint8_t default_color[3] = {0xd8, 0xa0, 0x48};

static int set_defaults(struct sheen_options *options, unsigned command, struct sheen_problem *problem)
{
    memset(options, 0, sizeof *options);
    options->orientation = -1;
    options->undithered = -1;
    options->edges = (command & (SHEEN_RENDER | SHEEN_VIEW)) != 0 ? -1 : SHEEN_NO_EDGES;
    options->up = -1;
    options->alpha_cutoff = -1;
    memcpy(options->color.color, default_color, sizeof default_color);
    options->gap = -1;
    for (const struct sheen_option *option = sheen_option_table; option->name; option++) {
        int error = option->value ? sheen_option_set(options, option, option->value, problem) : SHEEN_OK;
        if (error)
            return error;
    }
    options->lights.given = 0;
    return SHEEN_OK;
}

/* Checks what the range of a single value cannot express. */
static int check_values(const struct sheen_options *options, unsigned command, struct sheen_problem *problem)
{
    /* in `view` a key may switch to the matcap later */
    if (options->matcap_given && options->shade < SHEEN_MATCAP && command != SHEEN_VIEW)
        return sheen_problem(problem, SHEEN_ERR_ARGUMENT, "--matcap needs --shade matcap or matcap-vertex");
    if (options->palette == 1)
        return sheen_problem(problem, SHEEN_ERR_ARGUMENT, "--palette '1': not 0, nor 2..256");
    if (!options->morph && (options->morph_target > 0 || options->morph_weight > 0))
        return sheen_problem(problem, SHEEN_ERR_ARGUMENT, "--morph-%s needs --morph",
                             options->morph_target > 0 ? "target" : "weight");
    if (options->morph && options->reduce)
        return sheen_problem(problem, SHEEN_ERR_ARGUMENT, "--reduce: a mesh with --morph keeps its faces");
    return sheen_ramp_check(options, problem);
}

/* Takes the operand: exactly one mesh if the command takes a mesh, otherwise none. */
static int take_operand(struct sheen_options *options, const struct sheen_command *command, int argc, char **argv,
                        struct sheen_problem *problem)
{
    if (!(command->bit & SHEEN_TAKES_MESH) && optind < argc)
        return sheen_problem(problem, SHEEN_ERR_ARGUMENT, "%s takes no '%s'", command->name, argv[optind]);
    if (!(command->bit & SHEEN_TAKES_MESH))
        return 1;
    if (optind == argc || !*argv[optind])
        return sheen_problem(problem, SHEEN_ERR_ARGUMENT, "no mesh given");
    if (optind + 1 < argc)
        return sheen_problem(problem, SHEEN_ERR_ARGUMENT, "one mesh at a time, not also '%s'", argv[optind + 1]);
    options->mesh = argv[optind];
    return 1;
}

int sheen_options_parse(struct sheen_options *options, const struct sheen_command *command, int argc, char **argv,
                        struct sheen_problem *problem)
{
    struct option longs[MAX_OPTIONS];
    char letters[2 * MAX_OPTIONS + 3];
    int answer, error = set_defaults(options, command->bit, problem);

    make_getopt(command->bit, longs, letters);
    opterr = 0;
    optind = 0; /* GNU: start anew, because another command line may have been parsed before */
    while (!error && (answer = getopt_long(argc, argv, letters, longs, NULL)) != -1) {
        if (answer == HELP || answer == 'h') {
            sheen_options_help(command);
            return 0;
        }
        if (answer == VERSION) {
            sheen_options_version();
            return 0;
        }
        if (answer == '?' || answer == ':')
            return refuse(answer, command->bit, argv, problem);
        const struct sheen_option *option = find_option(answer, command->bit);
        error = sheen_option_set(options, option, optarg, problem);
        options->shade_given |= option->offset == AT(shade);
        options->matcap_given |= option->offset == AT(matcap);
        options->cull_given |= option->offset == AT(two_sided);
    }
    if (!error)
        error = check_values(options, command->bit, problem);
    return error ? error : take_operand(options, command, argc, argv, problem);
}
