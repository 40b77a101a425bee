/*
 * list.h - what can be chosen from: GPIO lines and panels, on standard output.
 */
#ifndef LIST_H
#define LIST_H

#include "sheen_failure.h"

int list_lines(struct sheen_failure *why);
void list_panels(void);

#endif
