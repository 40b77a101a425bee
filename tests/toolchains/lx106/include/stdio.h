/*
 * stdio.h - what a test that prints uses of it: %s, %d, %x with widths and zeros. What cannot be written ends the test.
 */
#ifndef LX106_STDIO_H
#define LX106_STDIO_H

typedef int FILE; /* a file descriptor of the host's */
extern FILE lx106_out, lx106_err;
#define stdout (&lx106_out)
#define stderr (&lx106_err)

int printf(const char *format, ...) __attribute__((format(printf, 1, 2)));
int fprintf(FILE *file, const char *format, ...) __attribute__((format(printf, 2, 3)));
int fflush(FILE *file);
int ferror(FILE *file);

#endif
