/*
 * ramps.c - the ramps over L.N that the command line names.
 */
#include "ramps.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define PANEL_GAMMA 2.2 /* the exponent of sheen_ramp_make_gamma */
#define LIT_STEPS (SHEEN_RAMP_STEPS / 2)
#define LEAST_DIFFUSE 0.001 /* the core's limit is 64 in Q15.16, 1/1024 */

int sheen_ramp_read(struct sheen_ramp_choice *choice, const char *text)
{
    static const char *const names[] = {"lambert", "half", "gamma", "toon"};
    const size_t length = strcspn(text, ":");
    const char *digits = text + length + 1;
    char *end;

    for (int kind = 0; kind < (int)(sizeof names / sizeof names[0]); kind++) {
        if (strlen(names[kind]) != length || strncmp(names[kind], text, length) != 0)
            continue;
        if (text[length] == '\0') {
            *choice = (struct sheen_ramp_choice){kind, PANEL_GAMMA};
            return 0;
        }
        if (kind != SHEEN_RAMP_GAMMA || *digits == '\0' || digits[strspn(digits, "0123456789.")] != '\0')
            return -1;
        const double gamma = strtod(digits, &end);
        if (*end != '\0' || !(gamma >= SHEEN_LEAST_GAMMA && gamma <= SHEEN_MOST_GAMMA))
            return -1;
        *choice = (struct sheen_ramp_choice){kind, gamma};
        return 0;
    }
    return -1;
}

int sheen_ramp_check(const struct sheen_options *options, struct sheen_problem *problem)
{
    if (options->ramp.kind != SHEEN_RAMP_GAMMA || options->diffuse >= LEAST_DIFFUSE)
        return SHEEN_OK;
    return sheen_problem(problem, SHEEN_ERR_ARGUMENT, "--diffuse '%g': below %g, which gamma divides by",
                         options->diffuse, LEAST_DIFFUSE);
}

/* As sheen_ramp_make_gamma, but for any exponent. With ambient light above 1.0 the ramp's dark end is negative. */
static void make_curve(struct sheen_ramp *ramp, double ambient, double diffuse, double gamma)
{
    const double dark = pow(ambient, 1 / gamma) - ambient, bright = pow(ambient + diffuse, 1 / gamma) - ambient;
    const double low = fmin(dark, 0), span = bright - low;
    const double first = pow(ambient + diffuse / LIT_STEPS, 1 / gamma) - ambient;

    for (int i = 0; i <= SHEEN_RAMP_STEPS; i++) {
        const double x = fmax(i - LIT_STEPS, 0) / LIT_STEPS;
        ramp->value[i] = (uint16_t)lround(
            fmin(fmax(32768 * (pow(ambient + diffuse * x, 1 / gamma) - ambient - low) / span, 0), 32768));
    }
    ramp->low = (sheen_q16_t)lround(low / diffuse * 65536);
    ramp->span = (sheen_q16_t)lround(span / diffuse * 65536);
    for (ramp->steep = 0; (first - dark) * LIT_STEPS / diffuse > ldexp(1, ramp->steep) && ramp->steep < 15;)
        ramp->steep++;
    ramp->reader = &sheen_ramp_reader;
}

const struct sheen_ramp *sheen_ramp_of(struct sheen_ramp *room, const struct sheen_options *options)
{
    const double gamma = options->ramp.gamma, ambient = options->ambient, diffuse = options->diffuse;

    memset(room, 0, sizeof *room);
    switch (options->ramp.kind) {
    case SHEEN_RAMP_HALF:
        return &sheen_ramp_half;
    case SHEEN_RAMP_TOON:
        return &sheen_ramp_toon;
    case SHEEN_RAMP_GAMMA:
        if (gamma != PANEL_GAMMA)
            make_curve(room, ambient, diffuse, gamma);
        else if (sheen_ramp_make_gamma(room, (sheen_q16_t)lround(ambient * 65536),
                                       (sheen_q16_t)lround(diffuse * 65536)) != SHEEN_OK)
            return NULL; /* cannot happen after sheen_ramp_check */
        return room;
    default:
        return NULL;
    }
}
