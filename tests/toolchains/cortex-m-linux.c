/*
 * cortex-m-linux.c - what stands under a test on a Cortex-M's instructions: where a program begins, what it prints and
 * its end, by Linux's calls; and memory for newlib's buffer.
 */
#include <stddef.h>

enum {
    CALL_EXIT = 1,
    CALL_WRITE = 4
};

_Noreturn void _exit(int status);
int _write(int file, const char *bytes, int count);
void *_sbrk(ptrdiff_t more);

__asm__(".thumb_func\n.global _start\n_start: bl main\n bl _exit\n");

static int call(int number, int a, const char *b, int c)
{
    register int r0 __asm__("r0") = a, r2 __asm__("r2") = c, r7 __asm__("r7") = number;
    register const char *r1 __asm__("r1") = b;

    __asm__ volatile("svc 0" : "+r"(r0) : "r"(r1), "r"(r2), "r"(r7) : "memory");
    return r0;
}

void _exit(int status)
{
    for (;;)
        call(CALL_EXIT, status, NULL, 0);
}

int _write(int file, const char *bytes, int count)
{
    return call(CALL_WRITE, file, bytes, count);
}

void *_sbrk(ptrdiff_t more)
{
    static _Alignas(8) char memory[16384];
    static ptrdiff_t used;

    if (more > (ptrdiff_t)sizeof memory - used)
        return (void *)-1;
    used += more;
    return memory + used - more;
}
