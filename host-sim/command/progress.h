/*
 * progress.h - one line that tells how far long work is, on a terminal only.
 */
#ifndef SHEEN_PROGRESS_H
#define SHEEN_PROGRESS_H

/*
 * "what 12/60" on standard error in place of the line before, where that is a
 * terminal; a whole of 0 leaves the numbers out. Nothing into a pipe or file.
 */
void sheen_progress(const char *what, int done, int whole);

/* Takes the line away again: call it before anything else is said. */
void sheen_progress_end(void);

#endif
