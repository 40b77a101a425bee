/*
 * web.c - what the WebAssembly module exports: `sheen view`, `sheen plan` and `sheen bake` for a page.
 *
 * The page hands over the words of a command line, as the command gets them, so that options, ranges and error lines
 * are the command's own. What the command prints reaches the page as the module's output and errors (host.js).
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "bake_text.h"
#include "commands.h"
#include "out_file.h"
#include "progress.h"
#include "report.h"
#include "stats_json.h"
#include "textures_out.h"
#include "view.h"
#include "web_mesh.h"

#define EXPORT(name) __attribute__((export_name(#name))) name
#define WORDS 128

static enum sheen_exit no_run(struct sheen_options *options)
{
    (void)options;
    return SHEEN_EXIT_OK;
}

static const struct sheen_command view_command = {"view", "MESH", "", SHEEN_VIEW, no_run};
static const struct sheen_command plan_command = {"plan", "MESH", "", SHEEN_PLAN, no_run};
static const struct sheen_command bake_command = {"bake", "MESH", "", SHEEN_BAKE, sheen_cmd_bake};

static struct sheen_viewer viewer;
static int is_open;
static struct sheen_problem problem;
static char *words[2]; /* [0]: those of the options in use, [1]: those that the page hands over */
static uint32_t *pixels;
static char *text; /* the text that was made last: a header, a plan, statistics */
static size_t text_size;

/* ---- the command line ---- */

/* Room for `size` bytes of words, each ended by a 0, for the page to fill in. NULL: not enough memory. */
char *EXPORT(web_words)(size_t size)
{
    free(words[1]);
    words[1] = malloc(size + 1);
    if (words[1])
        words[1][size] = '\0';
    return words[1];
}

static int parse(struct sheen_options *options, const struct sheen_command *command, int count,
                 struct sheen_problem *why)
{
    static char *list[WORDS + 1]; /* options point to the words, not into this list */
    char *at = words[1];

    if (count > WORDS)
        return sheen_problem(why, SHEEN_ERR_ARGUMENT, "more than %d words", WORDS);
    for (int i = 0; i < count; i++, at += strlen(at) + 1)
        list[i] = at;
    list[count] = NULL;
    int go = sheen_options_parse(options, command, count, list, why);
    return go == 0 ? sheen_problem(why, SHEEN_ERR_ARGUMENT, "no help in a page") : go;
}

int sheen_web_options(struct sheen_options *options, int count, struct sheen_problem *why)
{
    return parse(options, &view_command, count, why);
}

/* The error line of the last failure. */
const char *EXPORT(web_problem)(void)
{
    return problem.text;
}

/* ---- what is shown ---- */

static void copy_look(struct sheen_options *to, const struct sheen_options *from)
{
    to->shade = from->shade;
    to->shade_given = from->shade_given;
    to->yaw = from->yaw;
    to->pitch = from->pitch;
    to->roll = from->roll;
    to->yaw_step = from->yaw_step;
    to->distance = from->distance;
    to->fov = from->fov;
    to->lights = from->lights;
    memcpy(to->background, from->background, sizeof to->background);
    to->fog = from->fog;
    to->fog_color = from->fog_color;
    to->opacity = from->opacity;
    to->phase = from->phase;
    to->edges = from->edges;
    to->line = from->line;
    to->morph_weight = from->morph_weight;
    to->two_sided = from->two_sided;
    to->cull_given = from->cull_given;
    to->affine = from->affine;
    to->ortho = from->ortho;
    to->undithered = from->undithered;
    to->scale = from->scale;
    to->gap = from->gap;
    to->theme = from->theme;
}

static void copy_panel(struct sheen_options *to, const struct sheen_options *from)
{
    to->panel = from->panel;
    memcpy(to->size, from->size, sizeof to->size);
    to->orientation = from->orientation;
    to->band = from->band;
    to->buffers = from->buffers;
}

/* 1 if both are the same; strings are compared by content. They were parsed into zeroed memory: padding is equal. */
static int are_equal(struct sheen_options a, const struct sheen_options *b)
{
    if ((a.morph == NULL) != (b->morph == NULL) || (a.morph && strcmp(a.morph, b->morph) != 0))
        return 0;
    if (strcmp(a.mesh, b->mesh) != 0 || strcmp(a.panel, b->panel) != 0 || strcmp(a.texture, b->texture) != 0 ||
        strcmp(a.matcap, b->matcap) != 0)
        return 0;
    a.mesh = b->mesh;
    a.panel = b->panel;
    a.texture = b->texture;
    a.matcap = b->matcap;
    a.morph = b->morph;
    return memcmp(&a, b, sizeof a) == 0;
}

static void close_viewer(void)
{
    struct sheen_problem ignored;

    if (is_open)
        sheen_viewer_close(&viewer, &ignored);
    is_open = 0;
}

static int open_viewer(const struct sheen_options *options)
{
    struct sheen_sim_choice choice;
    int error = sheen_turntable_check(&choice, options, &problem);

    close_viewer();
    if (error)
        return error;
    is_open = 1;
    return sheen_viewer_open(&viewer, options, &choice, &problem);
}

/* Makes only as much anew as the options need: everything, the panel, or the look. */
static int change(const struct sheen_options *options)
{
    struct sheen_options same_mesh = *options, same_panel = *options;

    copy_look(&same_panel, &viewer.options);
    same_mesh = same_panel;
    copy_panel(&same_mesh, &viewer.options);
    if (!is_open || !are_equal(same_mesh, &viewer.options))
        return open_viewer(options);
    int is_same_panel = are_equal(same_panel, &viewer.options);
    viewer.options = *options;
    if (!is_same_panel)
        return sheen_viewer_panel(&viewer, &problem);
    sheen_viewer_look(&viewer);
    sheen_scene_look(&viewer.table.scene);
    int error = sheen_scene_check_fog(&viewer.table.scene, &problem);
    return error ? error : sheen_viewer_redraw(&viewer, &problem);
}

/* Shows what the words of web_words() ask for. 0, or a negative code and web_problem(): then nothing is shown. */
int EXPORT(web_show)(int count)
{
    static struct sheen_options options;
    int go = parse(&options, &view_command, count, &problem);
    viewer.number = 0;
    int error = go < 0 ? go : change(&options);

    if (error)
        close_viewer();
    free(words[0]);
    words[0] = words[1];
    words[1] = NULL;
    return error;
}

/* Forgets what is shown: another file may have taken the mesh's name. */
void EXPORT(web_forget)(void)
{
    close_viewer();
}

/* Sends the next band; if no frame is under way, of a new one, turned by yaw_step. 0, or a code and web_problem(). */
int EXPORT(web_band)(void)
{
    return sheen_viewer_band(&viewer, &problem);
}

/* The last band that was sent by itself, -1 after whole frames; its first row, and its end; the frame's band count. */
int EXPORT(web_shown_band)(void)
{
    return viewer.shown_band;
}

int EXPORT(web_band_row)(int end)
{
    int rows[2];

    sheen_viewer_rows(&viewer, &rows[0], &rows[1]);
    return rows[end != 0];
}

unsigned EXPORT(web_bands)(void)
{
    return sheen_band_count(viewer.table.scene.frame);
}

/* Draws the frame again and sends all of it, to time core, driver and controller by. 0, or a negative code. */
int EXPORT(web_again)(void)
{
    struct sheen_scene *scene = &viewer.table.scene;

    sheen_invalidate(scene->frame);
    int error = sheen_scene_draw(scene, viewer.number);
    return error ? error : sheen_wait(scene->frame);
}

/* The picture: its size, and 3 bytes r, g, b per pixel. */
unsigned EXPORT(web_width)(void)
{
    return viewer.table.choice.width;
}

unsigned EXPORT(web_height)(void)
{
    return viewer.table.choice.height;
}

const uint8_t *EXPORT(web_rgb)(void)
{
    return viewer.table.rgb;
}

/* The glass as it looks at `scale`: 4 bytes r, g, b, a per pixel of the screen. NULL: not enough memory. */
const uint32_t *EXPORT(web_glass)(unsigned scale)
{
    viewer.options.scale = (int)scale;
    sheen_viewer_look(&viewer);
    viewer.options.scale = 0;
    size_t count = (size_t)web_width() * web_height() * scale * scale;
    free(pixels);
    pixels = malloc(count * sizeof *pixels);
    if (!pixels)
        return NULL;
    sheen_viewer_paint(&viewer, pixels, web_width() * scale);
    for (size_t i = 0; i < count; i++)
        pixels[i] = 0xff000000u | __builtin_bswap32(pixels[i]) >> 8;
    return pixels;
}

/* ---- numbers and texts ---- */

/* As `sheen render --stats`: a line of JSON about the last frame. NULL: not enough memory. */
const char *EXPORT(web_stats)(void)
{
    free(text);
    text = NULL;
    FILE *stream = open_memstream(&text, &text_size);

    if (!stream)
        return NULL;
    sheen_stats_json(stream, &viewer.table, viewer.number);
    return fclose(stream) == 0 ? text : NULL;
}

/* The panel's name; its clock in Hz, 0 for ideal; the B of a whole frame on the wire; 1 if it is round; orientation. */
const char *EXPORT(web_panel)(void)
{
    return sheen_turntable_panel_name(&viewer.table);
}

unsigned EXPORT(web_clock)(void)
{
    return viewer.table.choice.record ? viewer.table.choice.record->clock_hz : 0;
}

unsigned EXPORT(web_frame_bytes)(void)
{
    const struct sheen_panel_record *record = viewer.table.choice.record;
    const struct sheen_target *target = viewer.table.scene.target;

    return record ? sheen_sim_frame_bytes(record) : target->height * sheen_row_bytes(target->pixel, target->width);
}

int EXPORT(web_is_round)(void)
{
    return viewer.table.choice.record && viewer.table.choice.record->round;
}

unsigned EXPORT(web_orientation)(void)
{
    return viewer.table.choice.orientation;
}

/* The B of the frame's arena. */
unsigned EXPORT(web_arena)(void)
{
    return (unsigned)sheen_arena_size(&viewer.table.scene.config);
}

/* What is drawn of edges, as the number of a word of --edges. */
unsigned EXPORT(web_edges)(void)
{
    return (unsigned)sheen_scene_edging(&viewer.table.scene);
}

/* The B of flash that the meshes need if they are baked with their polygons' normals. */
unsigned EXPORT(web_flash)(void)
{
    size_t bytes = 0;

    for (size_t i = 0; i < viewer.table.scene.count; i++)
        bytes += sheen_bake_bytes(&viewer.table.scene.meshes[i], 1, 0);
    return (unsigned)bytes;
}

unsigned EXPORT(web_vertices)(void)
{
    unsigned count = 0;

    for (size_t i = 0; i < viewer.table.scene.count; i++)
        count += viewer.table.scene.meshes[i].mesh.vertices;
    return count;
}

/*
 * The panels' names, NULL past the last, and notes. part 0..3 of an option: its name, NULL past the last; its words or
 * its value's name, its default, its help, NULL if `view` does not have the option.
 */
const char *EXPORT(web_panel_name)(unsigned index)
{
    const struct sheen_panel_record *record = sheen_panel_at(index);

    return record ? record->name : NULL;
}

const char *EXPORT(web_panel_about)(unsigned index)
{
    const struct sheen_panel_record *record = sheen_panel_at(index);

    return record && record->note ? record->note : "";
}

const char *EXPORT(web_option)(unsigned index, unsigned part)
{
    const struct sheen_option *option = &sheen_option_table[index];

    if (part > 0 && !(option->commands & SHEEN_VIEW))
        return NULL;
    return part == 0 ? option->name : part == 1 ? option->argument : part == 2 ? option->value : option->help;
}

/* ---- sheen plan ---- */

const char *EXPORT(web_board)(unsigned index)
{
    const struct sheen_plan_board *board = sheen_plan_board_at(index);

    return board ? board->name : NULL;
}

static int plan(const struct sheen_options *options, int board)
{
    struct sheen_plan *planned = malloc(sizeof *planned);
    struct sheen_sim_choice choice;
    FILE *stream = planned ? open_memstream(&text, &text_size) : NULL;
    int error = stream ? sheen_turntable_check(&choice, options, &problem)
                       : sheen_problem(&problem, SHEEN_ERR_MEMORY, "%s: not enough memory", options->mesh);

    if (!error)
        error = sheen_plan_make(planned, options, &choice, SHEEN_PLAN_VIEWS, &problem);
    if (!error)
        sheen_plan_text(stream, planned, board);
    if (stream)
        fclose(stream);
    free(planned);
    return error;
}

/* Runs `sheen plan` on the words of web_words(), for one board or all (-1), into web_text(). 0, or a negative code. */
int EXPORT(web_plan)(int count, int board)
{
    static struct sheen_options options;
    int go = parse(&options, &plan_command, count, &problem);

    free(text);
    text = NULL;
    return go < 0 ? go : plan(&options, board);
}

/* ---- sheen bake ---- */

/* Runs `sheen bake` on the words of web_words(). 0 and the header in web_text(), or the command's exit status. */
int EXPORT(web_bake)(int count)
{
    static struct sheen_options options;
    int go = parse(&options, &bake_command, count, &problem);

    int status = go < 0 ? (int)sheen_fail(SHEEN_EXIT_USAGE, &problem) : (int)sheen_cmd_bake(&options);

    fflush(stdout);
    return status;
}

const char *EXPORT(web_text)(void)
{
    return text;
}

/* Functions that the command's other files call, as a page needs them. */

enum sheen_exit sheen_fail(enum sheen_exit status, const struct sheen_problem *why)
{
    problem = *why;
    return status;
}

int sheen_out_file(const char *path, const void *bytes, size_t count, struct sheen_problem *why)
{
    free(text);
    text = malloc(count + 1);
    if (!text)
        return sheen_problem(why, SHEEN_ERR_MEMORY, "%s: not enough memory", path);
    memcpy(text, bytes, count);
    text[count] = '\0';
    return SHEEN_OK;
}

int sheen_textures_out_check(const struct sheen_options *options, struct sheen_problem *why)
{
    (void)options, (void)why; /* no name is wrong: sheen_textures_out refuses them all */
    return SHEEN_OK;
}

int sheen_textures_out(const struct sheen_options *options, const struct sheen_texels *texels, size_t count,
                       struct sheen_problem *why)
{
    (void)texels, (void)count;
    return options->texture_out
               ? sheen_problem(why, SHEEN_ERR_UNSUPPORTED, "--texture-out is for the command sheen, not for a page")
               : SHEEN_OK;
}

void sheen_progress(const char *what, int done, int whole)
{
    (void)what, (void)done, (void)whole;
}

void sheen_progress_end(void)
{
}

/* A page records no animations. */
int sheen_viewer_gif_end(struct sheen_viewer *ended, const char *path, struct sheen_problem *why)
{
    (void)ended, (void)path, (void)why;
    return SHEEN_OK;
}
