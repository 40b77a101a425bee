/*
 * confine.h - makes a process give up everything except reading files and computing.
 */
#ifndef SHEEN_CONFINE_H
#define SHEEN_CONFINE_H

#include "problem.h"

/*
 * From here on this process can open files for reading, read, allocate, and write to
 * the descriptor `output`; other system calls fail with EPERM, and those that only an
 * intruder makes (execve, socket, ptrace, new processes) end it with SIGSYS. Files are
 * opened with O_NONBLOCK or not at all, so that none waits for ever. After `seconds` of
 * processor time SIGXCPU ends the process. It may allocate `bytes` of memory beyond what it
 * has, and more for the files that it reads (sheen_confine_file); under the address
 * sanitizer, which reserves terabytes, memory is not limited.
 * 0, or SHEEN_ERR_UNSUPPORTED and *problem if the system cannot do this.
 */
int sheen_confine(int output, unsigned seconds, unsigned long bytes, struct sheen_problem *problem);

/* Bytes of memory allowed for each byte of a file, which decoding needs. */
#define SHEEN_CONFINE_TIMES 16u

/*
 * Call it for a file that the confined process has opened: SHEEN_CONFINE_TIMES its size may be allocated from now on,
 * once for each of the first 64 files. In a process that is not confined it does nothing.
 */
void sheen_confine_file(int file);

#endif
