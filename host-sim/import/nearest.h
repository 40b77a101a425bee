/*
 * nearest.h - which of some names one that there is not was meant for.
 */
#ifndef SHEEN_NEAREST_H
#define SHEEN_NEAREST_H

#include <stddef.h>

struct sheen_nearest {
    const char *word; /* that was given */
    const char *name; /* the nearest so far, of `length` letters; NULL: none was tried */
    int length;
    size_t distance; /* letters to put in, take out or change, small and large being the same */
};

/* The first `length` letters of a name; of equally near ones the first stays. */
void sheen_nearest_try(struct sheen_nearest *nearest, const char *name, size_t length);

/* The panels, by full name and by controller. */
void sheen_nearest_panel(struct sheen_nearest *nearest);

#endif
