/*
 * cores.h - the RP2040's second core: started from board_open, it waits for work (board_crew, board.h).
 */
#ifndef CORES_H
#define CORES_H

/* Starts core 1. Where it does not answer, board_crew() is NULL and core 0 goes on alone. */
void cores_open(void);

#endif
