/*
 * list.h - prints the GPIO lines and the panels that there are.
 */
#ifndef LIST_H
#define LIST_H

#include "sheen_failure.h"

int list_lines(struct sheen_failure *why);
void list_panels(void);

#endif
