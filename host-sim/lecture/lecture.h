/*
 * lecture.h - the figures of `sheen lecture`, one page each. Private to lecture*.c and the command.
 *
 * The lecture is Goldman's "Shading Algorithms". A figure measures pixels that the core drew.
 * What the core does not do (shading a whole polygon by scan lines, the naive recursion) is
 * computed in the figure's own file, in double precision, as the lecture prints it.
 * Each function returns 0, or one of the core's negative error codes.
 */
#ifndef SHEEN_LECTURE_H
#define SHEEN_LECTURE_H

#include "lecture_plot.h"
#include "shadings.h"

int sheen_lecture_terms(struct sheen_page *page);
int sheen_lecture_mach(struct sheen_page *page);
int sheen_lecture_highlight(struct sheen_page *page);
int sheen_lecture_barycentric(struct sheen_page *page);
int sheen_lecture_orientation(struct sheen_page *page);
int sheen_lecture_distortion(struct sheen_page *page);
int sheen_lecture_arc(struct sheen_page *page);
int sheen_lecture_drift(struct sheen_page *page);
int sheen_lecture_length(struct sheen_page *page);
int sheen_lecture_newton(struct sheen_page *page);
int sheen_lecture_specular(struct sheen_page *page);
int sheen_lecture_increments(struct sheen_page *page);
int sheen_lecture_newell(struct sheen_page *page);
int sheen_lecture_cost(struct sheen_page *page);

/*
 * For each pixel of a row, the angle in degrees between the normal there and the one at the row's left end. The
 * normals at the ends are `degrees` (at most 90) apart; t at pixel i is (i + 1/2) / count. shading: SHEEN_PHONG
 * or SHEEN_SLERP.
 */
int sheen_lecture_angles(int shading, double degrees, int count, double *angle);

#endif
