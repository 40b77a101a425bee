/*
 * lx106.c - the processor of an ESP8266 on qemu's machine `sim`. With -icount shift=0 an instruction takes 1 ns, and
 * CCOUNT counts at the machine's 40 MHz, so a tick is 25 instructions.
 *
 * Divisions, products of 64 bits, memset and memcpy come from tests/toolchains/lx106/support.c.
 */
#include "guest.h"

enum {
    SYS_EXIT = 1,
    SYS_WRITE = 4
};

long simcall(int call, int a, int b, int c);
int main(void);

void guest_print(const char *text)
{
    int count = 0;

    while (text[count] != '\0')
        count++;
    simcall(SYS_WRITE, 1, (int)text, count);
}

void guest_leave(int status)
{
    for (;;)
        simcall(SYS_EXIT, status, 0, 0);
}

static uint32_t since;

static uint32_t ticks(void)
{
    uint32_t count;

    __asm__ volatile("rsr %0, ccount" : "=r"(count) : : "memory");
    return count;
}

void guest_count(void)
{
    since = ticks();
}

uint32_t guest_counted(void)
{
    return (ticks() - since) * 25;
}

void guest_loop(uint32_t rounds)
{
    __asm__ volatile("1: addi %0, %0, -1\n bnez %0, 1b" : "+r"(rounds) : : "memory");
}

int main(void)
{
    guest_main();
}
