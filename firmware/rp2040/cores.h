/*
 * cores.h - the RP2040's second core: board_open() starts it, then it waits for work (board_crew() in board.h).
 */
#ifndef CORES_H
#define CORES_H

/* Starts core 1. If it does not answer, board_crew() returns NULL and core 0 draws alone. */
void cores_open(void);

#endif
