/*
 * confine.h - a process gives up everything but reading files and computing.
 */
#ifndef SHEEN_CONFINE_H
#define SHEEN_CONFINE_H

#include "problem.h"

/*
 * From here on this process can open files for reading, read, allocate, and write to
 * the descriptor `output`; other system calls fail with EPERM, and those that only an
 * intruder makes (execve, socket, ptrace, new processes) end it with SIGSYS. Files are
 * opened with O_NONBLOCK or not at all, so that none waits for ever. After `seconds` of
 * processor time it is ended by SIGXCPU. It may take `bytes` of memory beyond what it has,
 * and more for the files that it reads (sheen_confine_file); under the address sanitizer,
 * which reserves terabytes, as much as it likes.
 * 0, or SHEEN_ERR_UNSUPPORTED and *problem where the system cannot do this.
 */
int sheen_confine(int output, unsigned seconds, unsigned long bytes, struct sheen_problem *problem);

/* How much more for each byte of a file: decoding takes it. */
#define SHEEN_CONFINE_TIMES 16u

/*
 * A file that this process, confined, has opened: SHEEN_CONFINE_TIMES its size may be taken from here on,
 * once for each of the first 64 files. Elsewhere it does nothing.
 */
void sheen_confine_file(int file);

#endif
