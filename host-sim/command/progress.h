/*
 * progress.h - one line that shows how far long work has got, on a terminal only.
 */
#ifndef SHEEN_PROGRESS_H
#define SHEEN_PROGRESS_H

/*
 * Prints "what 12/60" in place of the previous such line; a whole of 0 leaves the numbers out. Prints nothing unless
 * standard error is a terminal.
 */
void sheen_progress(const char *what, int done, int whole);

/* Erases the line: call it before anything else is printed. */
void sheen_progress_end(void);

#endif
