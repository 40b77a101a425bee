/*
 * problem.h - one line for a person: which file or option, and what is wrong with it.
 */
#ifndef SHEEN_PROBLEM_H
#define SHEEN_PROBLEM_H

#include "sheen_target.h"

struct sheen_problem {
    char text[512]; /* one line without newline; longer ones are cut */
};

/*
 * Set the line and return `error`, so that a caller can `return sheen_problem(...)`.
 * Control characters (a file's name may hold any) become '?'.
 */
__attribute__((format(printf, 3, 4))) int sheen_problem(struct sheen_problem *problem, int error, const char *format,
                                                        ...);

#endif
