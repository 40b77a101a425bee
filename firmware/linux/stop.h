/*
 * stop.h - SIGINT, SIGTERM, SIGHUP, and SIGPIPE when nobody reads the statistics any more, ask the program to end
 * after the current frame.
 */
#ifndef STOP_H
#define STOP_H

/*
 * After this call the first of these signals sets a flag. One more within a second is taken for the same request; a
 * later one, unless it is SIGPIPE, ends the program at once.
 */
void stop_watch(void);
int stop_asked(void); /* whether the flag is set */

/* Sleeps until the flag is set. */
void stop_wait(void);

#endif
