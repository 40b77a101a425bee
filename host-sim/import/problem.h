/*
 * problem.h - one line for a person: which file or option, and what is wrong with it.
 */
#ifndef SHEEN_PROBLEM_H
#define SHEEN_PROBLEM_H

#include "sheen_target.h"

/* Characters: with "sheen: " before it and " (see sheen help first-light)" after it a line has at most 210. */
#define SHEEN_PROBLEM_MAX 174

struct sheen_problem {
    char text[4 * SHEEN_PROBLEM_MAX + 1]; /* one line of UTF-8 without newline */
};

/*
 * Set the line and return `error`, so that a caller can `return sheen_problem(...)`.
 * Whatever a file or a command line holds may be put in: control characters and bytes that
 * are not UTF-8 become '?', and the middle of long words, paths as a rule, becomes "...".
 */
__attribute__((format(printf, 3, 4))) int sheen_problem(struct sheen_problem *problem, int error, const char *format,
                                                        ...);

#endif
