/*
 * problem.h - one line for the user: which file or option, and what is wrong with it.
 */
#ifndef SHEEN_PROBLEM_H
#define SHEEN_PROBLEM_H

#include "sheen_target.h"

/* Characters; with "sheen: " before and " (see sheen help first-light)" after them a line has at most 210. */
#define SHEEN_PROBLEM_MAX 174

struct sheen_problem {
    char text[4 * SHEEN_PROBLEM_MAX + 1]; /* one line of UTF-8 without newline */
};

/*
 * Sets the line and returns `error`, so that a caller can `return sheen_problem(...)`. Any
 * text from a file or a command line may be inserted: control characters and bytes that are
 * not UTF-8 become '?', and the middle of long words, mostly paths, becomes "...".
 */
__attribute__((format(printf, 3, 4))) int sheen_problem(struct sheen_problem *problem, int error, const char *format,
                                                        ...);

#endif
