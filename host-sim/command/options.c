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
    {"output", "FILE", NULL, "the picture; of several frames %d or %0Nd is the number, or a .gif takes all",
     SHEEN_OPTION_TEXT, SHEEN_RENDER, AT(out), 0, 0, 'o'},
    {"output", "FILE.png", NULL, "the picture, a PNG", SHEEN_OPTION_TEXT, SHEEN_FIRST_LIGHT, AT(out), 0, 0, 'o'},
    {"output", "FILE.h", NULL, "the header", SHEEN_OPTION_TEXT, SHEEN_BAKE, AT(out), 0, 0, 'o'},
    {"output", "DIR", NULL, "the folder for the pictures, made where it is not there", SHEEN_OPTION_TEXT, SHEEN_LECTURE,
     AT(out), 0, 0, 'o'},
    {"name", "NAME", NULL, "what the mesh is called in C [from the output's name]", SHEEN_OPTION_TEXT, SHEEN_BAKE,
     AT(name), 0, 0, 0},
    {"groups", NULL, NULL, "a mesh for each material of the file, and a table of their colours", SHEEN_OPTION_FLAG,
     SHEEN_BAKE, AT(groups), 0, 0, 0},
    {"no-flat", NULL, NULL, "without polygon normals: flat shading then takes each triangle's own", SHEEN_OPTION_FLAG,
     SHEEN_BAKE, AT(no_flat), 0, 0, 0},
    {"panel", "NAME", "ili9341", "the panel to draw on, by controller or full name; ideal takes any size",
     SHEEN_OPTION_TEXT, SHEEN_DRAWS | SHEEN_FIRST_LIGHT, AT(panel), 0, 0, 0},
    {"panel", "NAME", "ili9341", "the panel that RAM and frames a second are told for", SHEEN_OPTION_TEXT, SHEEN_BAKE,
     AT(panel), 0, 0, 0},
    {"size", "WxH", NULL, "of the picture, px; the panel must have it [the panel's]", SHEEN_OPTION_SIZE,
     SHEEN_DRAWS | SHEEN_FIRST_LIGHT, AT(size), 0, 0, 0},
    {"orientation", "K", NULL, "0..3 quarter turns of the glass, 4..7 mirrored [what fits the size]",
     SHEEN_OPTION_WHOLE, SHEEN_DRAWS | SHEEN_FIRST_LIGHT, AT(orientation), 0, 7, 0},
    {"shade", "flat|gouraud|phong|slerp|matcap|matcap-vertex", "phong",
     "flat: a normal a polygon; gouraud: light at the corners, and the default where a texture or colours of vertices "
     "or lights are shown; phong: "
     "normals at the pixels; slerp: along great arcs; matcap, at the pixels or the corners: a picture of a lit sphere "
     "in place of light and textures",
     SHEEN_OPTION_CHOICE, SHEEN_DRAWS, AT(shade), 0, 0, 0},
    {"matcap", SHEEN_MATCAP_NAMES "|FILE", "glaze",
     "the sphere: one of these, or a square picture, PNG or JPEG, reduced to 64 texels a side", SHEEN_OPTION_TEXT,
     SHEEN_DRAWS, AT(matcap), 0, 0, 0},
    {"yaw", "DEG", "30", "turn of the mesh about y, first", SHEEN_OPTION_REAL, SHEEN_DRAWS, AT(yaw), -ANY, ANY, 0},
    {"pitch", "DEG", "20", "then about x", SHEEN_OPTION_REAL, SHEEN_DRAWS, AT(pitch), -ANY, ANY, 0},
    {"roll", "DEG", "0", "then about z", SHEEN_OPTION_REAL, SHEEN_DRAWS, AT(roll), -ANY, ANY, 0},
    {"distance", "D", "3", "of the eye from the mesh's centre, in radii of the mesh", SHEEN_OPTION_REAL, SHEEN_DRAWS,
     AT(distance), 0.1, 100, 0},
    {"fov", "DEG", "40", "vertical field of view", SHEEN_OPTION_REAL, SHEEN_DRAWS, AT(fov), 1, 150, 0},
    {"perspective", "correct|affine", "correct", "shading linear in space, or on the screen", SHEEN_OPTION_CHOICE,
     SHEEN_DRAWS, AT(affine), 0, 0, 0},
    {"ortho", NULL, NULL, "no perspective: sizes as at the mesh's centre", SHEEN_OPTION_FLAG, SHEEN_DRAWS, AT(ortho), 0,
     0, 0},
    {"light", "X,Y,Z[,COLOR]", "-0.4,0.6,0.8",
     "direction to a light, seen from the eye, and its colour, else white; up to 4 times", SHEEN_OPTION_LIGHT,
     SHEEN_DRAWS, AT(lights), 0, 0, 0},
    {"point-light", "X,Y,Z,RADIUS[,COLOR]", NULL,
     "a light seen from the eye so far from the mesh's centre, in its radii, that fades over RADIUS; flat and gouraud; "
     "with --light up to 4 together",
     SHEEN_OPTION_POINT, SHEEN_DRAWS, AT(lights), 0, 1000, 0},
    {"ambient-color", "COLOR", "ffffff", "of the light from everywhere", SHEEN_OPTION_COLOR, SHEEN_DRAWS,
     AT(ambient_color), 0, 0, 0},
    {"vertex-colors", "on|off", "on",
     "the file's colours of vertices, which --color multiplies; shown on textures and matcaps too", SHEEN_OPTION_CHOICE,
     SHEEN_DRAWS | SHEEN_BAKE, AT(no_vertex_colors), 0, 0, 0},
    {"ambient", "K", "0.2", "light from everywhere", SHEEN_OPTION_REAL, SHEEN_DRAWS, AT(ambient), 0, 4, 0},
    {"diffuse", "K", "0.8", "light that scatters", SHEEN_OPTION_REAL, SHEEN_DRAWS, AT(diffuse), 0, 4, 0},
    {"ambient", "K", "0.2", "the material's, which ramp:gamma is made for", SHEEN_OPTION_REAL, SHEEN_BAKE, AT(ambient),
     0, 4, 0},
    {"diffuse", "K", "0.8", "likewise", SHEEN_OPTION_REAL, SHEEN_BAKE, AT(diffuse), 0, 4, 0},
    {"specular", "K", "0.35", "light that mirrors: the highlight", SHEEN_OPTION_REAL, SHEEN_DRAWS, AT(specular), 0, 4,
     0},
    {"shininess", "N", "32", "its sharpness, the exponent", SHEEN_OPTION_WHOLE, SHEEN_DRAWS, AT(shininess), 1, 128, 0},
    {"ramp", "lambert|half|gamma|toon", "lambert",
     "light that scatters, over the angle: as the lecture has it; half-Lambert, whose dark side keeps its shape; on a "
     "panel's own curve, gamma:G for another than 2.2; in three steps",
     SHEEN_OPTION_RAMP, SHEEN_DRAWS, AT(ramp), 0, 0, 0},
    {"color", "COLOR|file", NULL,
     "of the mesh: rrggbb in hex or a name of CSS; or the file's materials' [d8a048, ffffff on panels of greys]",
     SHEEN_OPTION_PAINT, SHEEN_DRAWS, AT(color), 0, 0, 0},
    {"background", "COLOR", "101018", "what is behind the mesh", SHEEN_OPTION_COLOR, SHEEN_DRAWS, AT(background), 0, 0,
     0},
    {"fog", "START,END", NULL,
     "over to a fog's colour, from none at START to all at END: depths before the eye, as --distance in radii of the "
     "mesh",
     SHEEN_OPTION_DEPTHS, SHEEN_DRAWS, AT(fog), 0, 127, 0},
    {"fog-color", "COLOR", NULL, "of the fog [the background's]", SHEEN_OPTION_PAINT, SHEEN_DRAWS, AT(fog_color), 0, 0,
     0},
    {"opacity", "K", "1", "the part of the mesh's pixels that is drawn, in an ordered pattern", SHEEN_OPTION_REAL,
     SHEEN_DRAWS, AT(opacity), 0, 1, 0},
    {"phase", "K", "0", "columns that the pattern is shifted by, 0..7", SHEEN_OPTION_WHOLE, SHEEN_DRAWS, AT(phase), 0,
     7, 0},
    {"cull", "back|none", "back", "leave out faces seen from behind, or draw them too", SHEEN_OPTION_CHOICE,
     SHEEN_DRAWS, AT(two_sided), 0, 0, 0},
    {"edges", "none|smooth|outline|wire", NULL,
     "over the faces: smooth: contours, on panels of more than two levels; outline: contours and sharp edges as lines; "
     "wire: all edges as lines, the faces in the background's colour [smooth, on panels of two levels outline, none "
     "with an opacity below 1]",
     SHEEN_OPTION_CHOICE, SHEEN_RENDER | SHEEN_VIEW, AT(edges), 0, 0, 0},
    {"edges", "none|smooth|outline|wire", NULL, "what is drawn of them, as by render [none]", SHEEN_OPTION_CHOICE,
     SHEEN_PLAN, AT(edges), 0, 0, 0},
    {"edges", NULL, NULL, "the mesh's edges too, for what a firmware draws of them: 8 B a triangle", SHEEN_OPTION_FLAG,
     SHEEN_BAKE, AT(bake_edges), 0, 0, 0},
    {"line-color", "COLOR", NULL, "of these lines [ffffff, 000000 on a light background]", SHEEN_OPTION_PAINT,
     SHEEN_DRAWS, AT(line), 0, 0, 0},
    {"normals", "file|average", "file", "the file's normals where it has them, or always averages of the faces",
     SHEEN_OPTION_CHOICE, SHEEN_DRAWS | SHEEN_BAKE, AT(average), 0, 0, 0},
    {"weights", "angle|equal", "angle", "in an average: by the face's angle at the corner, or all alike",
     SHEEN_OPTION_CHOICE, SHEEN_DRAWS | SHEEN_BAKE, AT(equal), 0, 0, 0},
    {"crease", "DEG", "60",
     "average only over faces within this angle (just below that of an edge that is to stay, as 59 for "
     "a hexagon's 60); 180: over all",
     SHEEN_OPTION_REAL, SHEEN_DRAWS | SHEEN_BAKE, AT(crease), 0, 180, 0},
    {"up", "y|z", NULL, "which axis of the file points up [z for STL, else y]", SHEEN_OPTION_CHOICE,
     SHEEN_DRAWS | SHEEN_BAKE, AT(up), 0, 0, 0},
    {"reduce", "N", NULL, "simplify the mesh to at most so many triangles, and tell how far off that is",
     SHEEN_OPTION_WHOLE, SHEEN_DRAWS | SHEEN_BAKE, AT(reduce), 4, 65535, 0},
    {"texture", "file|off|FILE", "file",
     "of the mesh: its own, none, or the PNG or JPEG in FILE; shown where faces have texture coordinates",
     SHEEN_OPTION_TEXT, SHEEN_DRAWS | SHEEN_BAKE, AT(texture), 0, 0, 0},
    {"filter", "nearest|bilinear", "nearest", "a pixel's texel, or a mean of four", SHEEN_OPTION_CHOICE,
     SHEEN_DRAWS | SHEEN_BAKE, AT(bilinear), 0, 0, 0},
    {"wrap", "file|repeat|clamp", "file", "beyond a texture's edge: as the file says, else it repeats",
     SHEEN_OPTION_CHOICE, SHEEN_DRAWS | SHEEN_BAKE, AT(wrap), 0, 0, 0},
    {"texture-size", "1|2|4|8|16|32|64|128|256|512", "256", "texels a side at most, to which pictures are reduced",
     SHEEN_OPTION_CHOICE, SHEEN_DRAWS | SHEEN_BAKE, AT(texture_log2), 0, 0, 0},
    {"palette", "N", "0", "at most so many colours a texture, 2 to 256; 0: as many as 16 bits hold", SHEEN_OPTION_WHOLE,
     SHEEN_DRAWS | SHEEN_BAKE, AT(palette), 0, 256, 0},
    {"texture-out", "FILE.png", NULL, "write the texture as it is drawn; of several %d or %0Nd is the number",
     SHEEN_OPTION_TEXT, SHEEN_RENDER | SHEEN_BAKE, AT(texture_out), 0, 0, 0},
    {"alpha-cutoff", "A", NULL, "texels of less alpha are not drawn, 0 to 1 [what the file says, else 0.5]",
     SHEEN_OPTION_REAL, SHEEN_DRAWS | SHEEN_BAKE, AT(alpha_cutoff), 0, 1, 0},
    {"morph", "FILE", NULL,
     "another frame of the mesh, its faces one for one: a file, whose glTF morph target stands for it where it has any",
     SHEEN_OPTION_TEXT, SHEEN_DRAWS | SHEEN_BAKE, AT(morph), 0, 0, 0},
    {"morph-target", "K", "0", "the number of that target, of the first mesh that has any", SHEEN_OPTION_WHOLE,
     SHEEN_DRAWS | SHEEN_BAKE, AT(morph_target), 0, 65535, 0},
    {"morph-weight", "K", "0", "what is drawn is the mesh at 0, the other frame at 1", SHEEN_OPTION_REAL, SHEEN_DRAWS,
     AT(morph_weight), 0, 1, 0},
    {"dither", "on|off", NULL, "ordered 8x8 [on, but for panels of 256 greys]", SHEEN_OPTION_CHOICE, SHEEN_DRAWS,
     AT(undithered), 0, 0, 0},
    {"band", "ROWS", NULL, "rows drawn and sent at a time [16, or all of a lower picture]", SHEEN_OPTION_WHOLE,
     SHEEN_DRAWS, AT(band), 1, 480, 0},
    {"band", "ROWS", NULL, "the rows of a band that they are told for [4, 8 and 16]", SHEEN_OPTION_WHOLE, SHEEN_BAKE,
     AT(band), 1, 480, 0},
    {"buffers", "1|2", "1", "2: draw a band while the last one is sent", SHEEN_OPTION_WHOLE, SHEEN_DRAWS, AT(buffers),
     1, 2, 0},
    {"frames", "N", "1", "so many pictures of the turning mesh", SHEEN_OPTION_WHOLE, SHEEN_RENDER, AT(frames), 1, 10000,
     0},
    {"yaw-step", "DEG", "6", "turn from a picture to the next", SHEEN_OPTION_REAL, SHEEN_RENDER | SHEEN_VIEW,
     AT(yaw_step), -ANY, ANY, 0},
    {"stats", NULL, NULL, "a line of JSON a frame on standard output", SHEEN_OPTION_FLAG, SHEEN_RENDER, AT(stats), 0, 0,
     0},
    {"frames", "N", NULL, "so many, then the end [until closed; 60 in a GIF, 1 in a pipe]", SHEEN_OPTION_WHOLE,
     SHEEN_VIEW, AT(view_frames), 1, 10000, 0},
    {"scale", "N", NULL, "pixels of the window for one of the panel [what fits]", SHEEN_OPTION_WHOLE, SHEEN_VIEW,
     AT(scale), 1, 16, 0},
    {"gap", "N", NULL, "of them dark, between the panel's pixels [1 from scale 4 on]", SHEEN_OPTION_WHOLE, SHEEN_VIEW,
     AT(gap), 0, 15, 0},
    {"theme", "auto|plain|lcd|oled|blue|yellow|green", "auto", "how the glass looks", SHEEN_OPTION_CHOICE, SHEEN_VIEW,
     AT(theme), 0, 0, 0},
    {"gif", "FILE", NULL, "write an animation of the glass; no window", SHEEN_OPTION_TEXT, SHEEN_VIEW, AT(out), 0, 0,
     0},
    {"terminal", NULL, NULL, "as text, half blocks in 24-bit colour; no window", SHEEN_OPTION_FLAG, SHEEN_VIEW,
     AT(terminal), 0, 0, 0},
    {"board", "NAME", NULL, "the board; without it all of them, a line each", SHEEN_OPTION_TEXT, SHEEN_PLAN, AT(board),
     0, 0, 0},
    {"bus-clock", "MHZ", NULL, "of the panel's SPI [the panel's rated one, as far as the board goes]",
     SHEEN_OPTION_REAL, SHEEN_PLAN, AT(bus_clock), 0.1, 200, 0},
    {"json", NULL, NULL, "one object of JSON", SHEEN_OPTION_FLAG, SHEEN_PLAN, AT(json), 0, 0, 0},
    {NULL, NULL, NULL, NULL, SHEEN_OPTION_FLAG, 0, 0, 0, 0, 0},
};

enum {
    MAX_OPTIONS = sizeof sheen_option_table / sizeof sheen_option_table[0] + 2, /* help, version and the end */
    HELP = 1000, /* values of struct option: the number of a table entry plus FIRST */
    VERSION = 1001,
    FIRST = 2000
};

/* The table in the form that getopt_long takes. letters: room for two characters an option and three more. */
static void make_getopt(unsigned command, struct option *longs, char *letters)
{
    int count = 0;

    letters += sprintf(letters, ":h"); /* a missing argument is told from an unknown option */
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

/* NULL: no option of the command. */
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

/* What getopt_long did not like: '?' or ':'. */
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

/* What the range of one value cannot say. */
static int check_values(const struct sheen_options *options, unsigned command, struct sheen_problem *problem)
{
    /* view comes to a matcap by a key */
    if (options->matcap_given && options->shade < SHEEN_MATCAP && command != SHEEN_VIEW)
        return sheen_problem(problem, SHEEN_ERR_ARGUMENT, "--matcap: it is shown by --shade matcap or matcap-vertex");
    if (options->palette == 1)
        return sheen_problem(problem, SHEEN_ERR_ARGUMENT, "--palette '1': not 0, nor 2..256");
    if (!options->morph && (options->morph_target > 0 || options->morph_weight > 0))
        return sheen_problem(problem, SHEEN_ERR_ARGUMENT, "--morph-%s: there is no --morph",
                             options->morph_target > 0 ? "target" : "weight");
    if (options->morph && options->reduce)
        return sheen_problem(problem, SHEEN_ERR_ARGUMENT, "--reduce: a mesh with --morph keeps its faces");
    return sheen_ramp_check(options, problem);
}

/* The operand: one mesh, for the command that draws one. */
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
    optind = 0; /* GNU: start anew, as another command line may have been parsed */
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
    }
    if (!error)
        error = check_values(options, command->bit, problem);
    return error ? error : take_operand(options, command, argc, argv, problem);
}
