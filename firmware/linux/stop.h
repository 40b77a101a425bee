/*
 * stop.h - SIGINT, SIGTERM and SIGHUP ask the program to end after the frame that it is in.
 */
#ifndef STOP_H
#define STOP_H

/* From here on the signals set a flag; a second one ends the program at once. */
void stop_watch(void);
int stop_asked(void);

/* Sleeps until one comes. */
void stop_wait(void);

#endif
