/*
 * lecture.h - the figures of `sheen lecture`, a page each. Private to lecture*.c and the command.
 *
 * The lecture is Goldman's "Shading Algorithms". What a figure measures it measures on pixels
 * that the core drew; what the core does not do (a polygon by scan lines, the naive
 * recursion) stands in the figure's own file, in double precision, as the lecture prints it.
 * Each returns 0, or a negative code of the core's.
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
 * The angle in degrees between the left normal and the one at each pixel of a row, for normals `degrees`
 * (at most 90) apart at its ends: t at pixel i is (i + 1/2) / count. shading: SHEEN_PHONG or SHEEN_SLERP.
 */
int sheen_lecture_angles(int shading, double degrees, int count, double *angle);

#endif
