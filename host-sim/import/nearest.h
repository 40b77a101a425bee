/*
 * nearest.h - which known name an unknown one was probably meant to be.
 */
#ifndef SHEEN_NEAREST_H
#define SHEEN_NEAREST_H

#include <stddef.h>

struct sheen_nearest {
    const char *word; /* the unknown name */
    const char *name; /* the nearest so far, with `length` letters; NULL: none was tried */
    int length;
    size_t distance; /* letters to insert, delete or change, upper and lower case being the same */
};

/* Tries the first `length` letters of a name; of equally near ones the first wins. */
void sheen_nearest_try(struct sheen_nearest *nearest, const char *name, size_t length);

/* Tries the panels, by full name and by controller. */
void sheen_nearest_panel(struct sheen_nearest *nearest);

#endif
