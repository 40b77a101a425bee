/*
 * accuracy_line.c - the lines that test_accuracy prints, and pictures of what failed.
 */
#include "accuracy_line.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const char *const way_name[SHEEN_WAYS] = {"one colour", "linear",   "quadratic", "quotient", "quadratic",
                                                 "cells",      "root",     "lights",    "arcs",     "normals",
                                                 "linear",     "quotient", "quadratic", "normals"};

static double share(long part, long whole)
{
    return whole > 0 ? (double)part / (double)whole : 1;
}

void accuracy_line_begin(struct accuracy_line *line)
{
    *line = (struct accuracy_line){
        .compared = 1, .equal = 2, .within_one = 1, .highlight = 1, .least_compared = ACCURACY_COMPARED};
}

int accuracy_line_add(struct accuracy_line *line, const struct accuracy_shot *shot, const struct ref_scene *scene,
                      int view)
{
    const struct ref_score *score = &shot->score;
    double equal = share(score->equal, score->compared);
    char picture[sizeof line->lowest];

    snprintf(picture, sizeof picture, "view %d %dx%d %s n %.0f%s", view, scene->width, scene->height,
             scene->ortho    ? "ortho"
             : scene->affine ? "affine"
                             : "correct",
             scene->shininess, scene->light_count > 1 ? " lights" : "");
    if (equal < line->equal) {
        line->equal = equal;
        memcpy(line->lowest, picture, sizeof picture);
    }
    line->mean += equal;
    line->pictures++;
    line->compared = fmin(line->compared, share(score->compared, score->covered));
    line->within_one = fmin(line->within_one, share(score->within_one, score->compared));
    line->highlight = fmin(line->highlight, share(score->highlight_equal, score->highlight));
    line->worst = score->worst > line->worst ? score->worst : line->worst;
    line->setups += shot->stats.frame.setups;
    for (int way = 0; way < SHEEN_WAYS; way++)
        line->by_way[way] += shot->stats.by_way[way];
    if (accuracy_kept(score, scene->shading, line->least_compared))
        return 0;
    printf("  FAILED %s: %ld covered, %ld compared, %ld equal, %ld within one step, worst %d at (%d, %d) of triangle "
           "%u\n",
           picture, score->covered, score->compared, score->equal, score->within_one, score->worst, score->worst_x,
           score->worst_y, score->cause);
    return 1;
}

void accuracy_line_heading(void)
{
    printf(
        "mesh           view or share  shading or way      compared  equal mean   lowest   within 1  worst  in highl.  "
        "lowest at\n");
}

void accuracy_line_print(const struct accuracy_line *line, const char *mesh, const char *what, const char *how)
{
    printf("%-14s %-14s %-18s %7.1f %% %8.2f %% %7.2f %% %8.3f %% %5d %9.2f %%  %s\n", mesh, what, how,
           100 * line->compared, 100 * line->mean / line->pictures, 100 * line->equal, 100 * line->within_one,
           line->worst, 100 * line->highlight, line->lowest);
}

double accuracy_line_share(const struct accuracy_line *line, enum sheen_way way)
{
    return line->setups > 0 ? (double)line->by_way[way] / (double)line->setups : 0;
}

void accuracy_line_print_ways(const struct accuracy_line *line)
{
    const char *between = "";

    for (int way = 0; way < SHEEN_WAYS; way++) {
        if (line->by_way[way] == 0)
            continue;
        printf("%s%s %.1f %%", between, way_name[way], 100 * accuracy_line_share(line, (enum sheen_way)way));
        between = ", ";
    }
}

/* ---- pictures of what failed ---- */

static uint16_t core_value(const struct ref_picture *picture, const struct accuracy_shot *shot, int i)
{
    (void)picture;
    return shot->values[i];
}

static uint16_t reference_value(const struct ref_picture *picture, const struct accuracy_shot *shot, int i)
{
    (void)shot;
    return picture->pixels[i].value;
}

/* White where they differ. */
static uint16_t differing_value(const struct ref_picture *picture, const struct accuracy_shot *shot, int i)
{
    return shot->values[i] == picture->pixels[i].value ? 0 : 0xffff;
}

void accuracy_write_difference(const char *prefix, const struct ref_scene *scene, const struct ref_picture *picture,
                               const struct accuracy_shot *shot)
{
    static uint16_t (*const value[3])(const struct ref_picture *, const struct accuracy_shot *,
                                      int) = {core_value, reference_value, differing_value};
    static const char *const name_of[3] = {"core", "reference", "differing"};
    static int number;

    for (int i = 0; i < 3; i++) {
        char name[256];
        snprintf(name, sizeof name, "%s%03d-%s.ppm", prefix, number, name_of[i]);
        FILE *file = fopen(name, "wb");
        if (!file) {
            perror(name);
            return;
        }
        fprintf(file, "P6\n%d %d\n255\n", scene->width, scene->height);
        for (int at = 0; at < scene->width * scene->height; at++) {
            int v = value[i](picture, shot, at), r = v >> 11, g = v >> 5 & 63, b = v & 31;
            fputc(r << 3 | r >> 2, file);
            fputc(g << 2 | g >> 4, file);
            fputc(b << 3 | b >> 2, file);
        }
        fclose(file);
    }
    number++;
}
