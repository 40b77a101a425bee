/*
 * confine.h - a process gives up everything but reading files and computing.
 */
#ifndef SHEEN_CONFINE_H
#define SHEEN_CONFINE_H

#include "problem.h"

/*
 * From here on this process can open files for reading, read, allocate, and write to
 * the descriptor `output`; other system calls fail with EPERM, and those that only an
 * intruder makes (execve, socket, ptrace, new processes) end it with SIGSYS. After
 * `seconds` it is ended by SIGALRM or SIGXCPU; `bytes` bounds its address space, but
 * not under the address sanitizer, which reserves terabytes.
 * 0, or SHEEN_ERR_UNSUPPORTED and *problem where the system cannot do this.
 */
int sheen_confine(int output, unsigned seconds, unsigned long bytes, struct sheen_problem *problem);

#endif
