/*
 * accuracy_line.h - the lines that test_accuracy prints.
 */
#ifndef ACCURACY_LINE_H
#define ACCURACY_LINE_H

#include "accuracy.h"

/* The lowest shares and the worst pixel among a line's pictures, and how their triangles were shaded. */
struct accuracy_line {
    double compared, equal, mean, within_one, highlight;
    int worst, pictures;
    double least_compared; /* demanded share of the covered pixels; ACCURACY_COMPARED after accuracy_line_begin */
    char lowest[64];       /* which picture had the lowest equal share */
    uint64_t setups, by_way[SHEEN_WAYS];
};

void accuracy_line_begin(struct accuracy_line *line);

/* Add a picture of view number `view`. 1 if it misses its limits, which is printed at once, else 0. */
int accuracy_line_add(struct accuracy_line *line, const struct accuracy_shot *shot, const struct ref_scene *scene,
                      int view);

void accuracy_line_heading(void);
/* what: views and variant; how: a shading or a way. */
void accuracy_line_print(const struct accuracy_line *line, const char *mesh, const char *what, const char *how);

/* Continue a line of text with the ways that the set-ups took and their shares. */
void accuracy_line_print_ways(const struct accuracy_line *line);

/* The share of set-ups that took this way, 0..1. */
double accuracy_line_share(const struct accuracy_line *line, enum sheen_way way);

/* Write the core's picture, the reference's and where they differ as PREFIX%03d-....ppm. */
void accuracy_write_difference(const char *prefix, const struct ref_scene *scene, const struct ref_picture *picture,
                               const struct accuracy_shot *shot);

#endif
