/*
 * option_value.c - stores an option's argument in its field.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "color_names.h"
#include "nearest.h"
#include "options.h"
#include "ramps.h"

static int refuse(const struct sheen_option *option, const char *text, const char *what, struct sheen_problem *problem)
{
    return sheen_problem(problem, SHEEN_ERR_ARGUMENT, "--%s '%s': %s", option->name, text, what);
}

/* Reads a finite decimal number up to `end`, a comma or '\0'; *text moves behind the comma. 0 or -1. */
static int read_real(const char **text, char end, double *value)
{
    char *stop;

    if (**text == '\0' || strspn(*text, "+-.0123456789eE") != strcspn(*text, end ? "," : ""))
        return -1; /* strtod would take spaces, hexadecimal, inf and nan as well */
    *value = strtod(*text, &stop);
    if (stop == *text || *stop != end || !isfinite(*value))
        return -1;
    *text = stop + (end != '\0');
    return 0;
}

static int set_number(const struct sheen_option *option, const char *text, void *field, struct sheen_problem *problem)
{
    const char *rest = text;
    double value;

    if (read_real(&rest, '\0', &value) != 0)
        return refuse(option, text, "not a number", problem);
    if (option->kind == SHEEN_OPTION_WHOLE && value != floor(value))
        return refuse(option, text, "not a whole number", problem);
    if (value < option->low || value > option->high)
        return sheen_problem(problem, SHEEN_ERR_ARGUMENT, "--%s '%s': out of range %g..%g", option->name, text,
                             option->low, option->high);
    if (option->kind == SHEEN_OPTION_WHOLE)
        *(int *)field = (int)value;
    else
        *(double *)field = value;
    return SHEEN_OK;
}

static int set_choice(const struct sheen_option *option, const char *text, int *field, struct sheen_problem *problem)
{
    size_t length = strlen(text);
    int number = 0;

    for (const char *word = option->argument; *word; number++) {
        size_t end = strcspn(word, "|");
        if (end == length && strncmp(word, text, length) == 0) {
            *field = number;
            return SHEEN_OK;
        }
        word += end + (word[end] == '|');
    }
    return sheen_problem(problem, SHEEN_ERR_ARGUMENT, "--%s '%s': not one of %s", option->name, text, option->argument);
}

static void put_rgb(unsigned long rgb, uint8_t color[3])
{
    for (int k = 0; k < 3; k++)
        color[k] = (uint8_t)(rgb >> (16 - 8 * k));
}

static int set_color(const struct sheen_option *option, const char *text, uint8_t color[3],
                     struct sheen_problem *problem)
{
    const char *digits = text + (*text == '#');

    if (strlen(digits) == 6 && strspn(digits, "0123456789abcdefABCDEF") == 6) {
        put_rgb(strtoul(digits, NULL, 16), color);
        return SHEEN_OK;
    }
    struct sheen_nearest nearest = {.word = text};
    for (size_t i = 0; i < SHEEN_COLOR_NAMES; i++) {
        const char *name = sheen_color_names[i].name;
        if (strcasecmp(name, text) == 0) {
            put_rgb(sheen_color_names[i].rgb, color);
            return SHEEN_OK;
        }
        sheen_nearest_try(&nearest, name, strlen(name));
    }
    int is_near = nearest.distance < strlen(text); /* not every letter differs */
    return sheen_problem(problem, SHEEN_ERR_ARGUMENT,
                         "--%s '%s': neither a colour of six hex digits nor a name of CSS%s%s", option->name, text,
                         is_near ? "; the nearest is " : "", is_near ? nearest.name : "");
}

static int set_size(const struct sheen_option *option, const char *text, unsigned size[2],
                    struct sheen_problem *problem)
{
    size_t width = strspn(text, "0123456789"), height = 0;

    if (text[width] == 'x')
        height = strspn(text + width + 1, "0123456789");
    if (width < 1 || width > 4 || height < 1 || height > 4 || text[width + 1 + height] != '\0')
        return refuse(option, text, "not a size such as 320x240, at most 640x480", problem);
    size[0] = (unsigned)strtoul(text, NULL, 10);
    size[1] = (unsigned)strtoul(text + width + 1, NULL, 10);
    return size[0] && size[1] ? SHEEN_OK : refuse(option, text, "no pixels", problem);
}

#define MOST_AWAY 20 /* |coordinate| of a point light from the mesh's centre, in radii */

static int commas(const char *text)
{
    int count = 0;

    for (; *text; text++)
        count += *text == ',';
    return count;
}

/* Reads `count` numbers and an optional colour, by default white. 0, or -1 if the text is something else. */
static int read_light(const struct sheen_option *option, const char *text, int count, double number[], uint8_t color[3])
{
    const int with_color = commas(text) == count;
    struct sheen_problem unused;

    memset(color, 255, 3);
    for (int k = 0; k < count; k++) {
        if (read_real(&text, k < count - 1 || with_color ? ',' : '\0', &number[k]) != 0)
            return -1;
    }
    return with_color ? set_color(option, text, color, &unused) : 0;
}

static int set_light(const struct sheen_option *option, const char *text, struct sheen_light_list *lights,
                     struct sheen_problem *problem)
{
    const int is_point = option->kind == SHEEN_OPTION_POINT;
    double number[4] = {0, 0, 0, 0};
    uint8_t color[3];

    if (read_light(option, text, is_point ? 4 : 3, number, color) != 0)
        return refuse(option, text,
                      is_point ? "not a place and how far it reaches, x,y,z,radius, nor x,y,z,radius,colour"
                               : "not a direction x,y,z, nor x,y,z,colour",
                      problem);
    if ((color[0] | color[1] | color[2]) == 0)
        return refuse(option, text, "black gives no light", problem);
    if (!is_point && number[0] == 0 && number[1] == 0 && number[2] == 0)
        return refuse(option, text, "points nowhere", problem);
    for (int k = 0; k < 3 && is_point; k++) {
        if (fabs(number[k]) > MOST_AWAY)
            return sheen_problem(problem, SHEEN_ERR_ARGUMENT, "--%s '%s': farther away than %d", option->name, text,
                                 MOST_AWAY);
    }
    if (is_point && !(number[3] > 0 && number[3] <= option->high))
        return sheen_problem(problem, SHEEN_ERR_ARGUMENT, "--%s '%s': not 0 < RADIUS <= %g", option->name, text,
                             option->high);
    if (!lights->given)
        lights->count = 0;
    if (lights->count == SHEEN_MAX_LIGHTS)
        return sheen_problem(problem, SHEEN_ERR_ARGUMENT, "--%s '%s': at most %d lights", option->name, text,
                             SHEEN_MAX_LIGHTS);
    memcpy(lights->color[lights->count], color, sizeof color);
    lights->radius[lights->count] = number[3];
    memcpy(lights->to[lights->count++], number, sizeof lights->to[0]);
    lights->given = 1;
    return SHEEN_OK;
}

static int set_depths(const struct sheen_option *option, const char *text, struct sheen_depths *depths,
                      struct sheen_problem *problem)
{
    const char *rest = text;
    struct sheen_depths given;

    if (read_real(&rest, ',', &given.start) != 0 || read_real(&rest, '\0', &given.end) != 0)
        return refuse(option, text, "not two depths START,END", problem);
    if (!(given.start > 0 && given.start < given.end && given.end <= option->high))
        return sheen_problem(problem, SHEEN_ERR_ARGUMENT, "--%s '%s': not 0 < START < END <= %g", option->name, text,
                             option->high);
    *depths = given;
    return SHEEN_OK;
}

static int set_paint(const struct sheen_option *option, const char *text, struct sheen_paint *paint,
                     struct sheen_problem *problem)
{
    paint->from_file = strchr(option->argument, '|') && strcmp(text, "file") == 0;
    if (paint->from_file)
        return SHEEN_OK;
    int error = set_color(option, text, paint->color, problem);
    paint->given |= !error;
    return error;
}

int sheen_option_set(struct sheen_options *options, const struct sheen_option *option, const char *text,
                     struct sheen_problem *problem)
{
    void *field = (char *)options + option->offset;

    switch (option->kind) {
    case SHEEN_OPTION_FLAG:
        *(int *)field = 1;
        return SHEEN_OK;
    case SHEEN_OPTION_REAL:
    case SHEEN_OPTION_WHOLE:
        return set_number(option, text, field, problem);
    case SHEEN_OPTION_CHOICE:
        return set_choice(option, text, field, problem);
    case SHEEN_OPTION_COLOR:
        return set_color(option, text, field, problem);
    case SHEEN_OPTION_PAINT:
        return set_paint(option, text, field, problem);
    case SHEEN_OPTION_SIZE:
        return set_size(option, text, field, problem);
    case SHEEN_OPTION_LIGHT:
    case SHEEN_OPTION_POINT:
        return set_light(option, text, field, problem);
    case SHEEN_OPTION_DEPTHS:
        return set_depths(option, text, field, problem);
    case SHEEN_OPTION_RAMP:
        return sheen_ramp_read(field, text) == 0
                   ? SHEEN_OK
                   : sheen_problem(problem, SHEEN_ERR_ARGUMENT, "--%s '%s': not one of %s, nor gamma:G, G in %g..%g",
                                   option->name, text, option->argument, SHEEN_LEAST_GAMMA, SHEEN_MOST_GAMMA);
    case SHEEN_OPTION_TEXT:
        if (!*text)
            return refuse(option, text, "no name", problem);
        *(const char **)field = text;
        return SHEEN_OK;
    }
    return SHEEN_ERR_ARGUMENT;
}
