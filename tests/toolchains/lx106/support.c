/*
 * support.c - what stands under a test on the lx106: printing by QEMU's calls, the few functions of string.h, and the
 * arithmetic that an ESP8266 has in its ROM and Debian's libgcc therefore leaves out.
 */
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

enum {
    SYS_EXIT = 1,
    SYS_WRITE = 4
};

long simcall(int call, int a, int b, int c);
int main(void);

FILE lx106_out = 1, lx106_err = 2;
static char line[512];

void support_main(void)
{
    int status = main();

    for (;;)
        simcall(SYS_EXIT, status, 0, 0);
}

/* ---- string.h ---- */

void *memcpy(void *restrict to, const void *restrict from, size_t count)
{
    for (size_t i = 0; i < count; i++)
        ((volatile uint8_t *)to)[i] = ((const uint8_t *)from)[i];
    return to;
}

void *memset(void *to, int byte, size_t count)
{
    for (size_t i = 0; i < count; i++)
        ((volatile uint8_t *)to)[i] = (uint8_t)byte;
    return to;
}

int memcmp(const void *a, const void *b, size_t count)
{
    for (size_t i = 0; i < count; i++)
        if (((const uint8_t *)a)[i] != ((const uint8_t *)b)[i])
            return ((const uint8_t *)a)[i] < ((const uint8_t *)b)[i] ? -1 : 1;
    return 0;
}

/* ---- stdio.h ---- */

static unsigned put_padded(unsigned at, const char *text, unsigned length, int width, char pad)
{
    int left = width < 0;
    unsigned fill = (unsigned)(left ? -width : width);

    for (unsigned i = length; !left && i < fill; i++)
        line[at++] = pad;
    for (unsigned i = 0; i < length; i++)
        line[at++] = text[i];
    for (unsigned i = length; left && i < fill; i++)
        line[at++] = ' ';
    return at;
}

static unsigned put_number(unsigned at, uint32_t value, unsigned base, int negative, int width, char pad)
{
    char digits[12];
    unsigned first = sizeof digits;

    do
        digits[--first] = "0123456789abcdef"[value % base];
    while ((value /= base) != 0);
    if (negative)
        digits[--first] = '-';
    return put_padded(at, digits + first, sizeof digits - first, width, pad);
}

static int print(FILE *file, const char *format, va_list args)
{
    unsigned at = 0;

    for (const char *c = format; *c; c++) {
        int left = 0, width = 0;
        char pad = ' ';

        if (*c != '%') {
            line[at++] = *c;
            continue;
        }
        for (c++; *c == '-' || *c == '0'; c++) {
            left |= *c == '-';
            pad = *c == '0' ? '0' : pad;
        }
        for (; *c >= '0' && *c <= '9'; c++)
            width = 10 * width + *c - '0';
        width = left ? -width : width;
        if (*c == 's') {
            const char *text = va_arg(args, const char *);
            unsigned length = 0;

            while (text[length])
                length++;
            at = put_padded(at, text, length, width, ' ');
        } else {
            int32_t value = va_arg(args, int32_t);
            int negative = *c == 'd' && value < 0;

            at = put_number(at, negative ? 0u - (uint32_t)value : (uint32_t)value, *c == 'x' ? 16 : 10, negative, width,
                            pad);
        }
    }
    simcall(SYS_WRITE, *file, (int)line, (int)at);
    return (int)at;
}

int printf(const char *format, ...)
{
    va_list args;
    int count;

    va_start(args, format);
    count = print(stdout, format, args);
    va_end(args);
    return count;
}

int fprintf(FILE *file, const char *format, ...)
{
    va_list args;
    int count;

    va_start(args, format);
    count = print(file, format, args);
    va_end(args);
    return count;
}

int fflush(FILE *file)
{
    (void)file;
    return 0;
}

int ferror(FILE *file)
{
    (void)file;
    return 0;
}

/* ---- in the ESP8266's ROM: products of 64 bits, quotients, remainders. Divisors are not 0. ---- */

uint64_t __muldi3(uint64_t a, uint64_t b);
uint32_t __udivsi3(uint32_t n, uint32_t d);
uint32_t __umodsi3(uint32_t n, uint32_t d);
int32_t __divsi3(int32_t n, int32_t d);
int32_t __modsi3(int32_t n, int32_t d);
uint64_t __udivdi3(uint64_t n, uint64_t d);
uint64_t __umoddi3(uint64_t n, uint64_t d);
int64_t __divdi3(int64_t n, int64_t d);

union pair {
    uint64_t all;
    struct {
        uint32_t low, high;
    } word;
};

uint64_t __muldi3(uint64_t a, uint64_t b)
{
    union pair x = {a}, y = {b}, r;
    uint32_t a0 = x.word.low & 0xffff, a1 = x.word.low >> 16, b0 = y.word.low & 0xffff, b1 = y.word.low >> 16;
    uint32_t low = a0 * b0, left = a1 * b0, right = a0 * b1;
    uint32_t middle = (low >> 16) + (left & 0xffff) + (right & 0xffff);

    r.word.low = (low & 0xffff) | middle << 16;
    r.word.high =
        a1 * b1 + (left >> 16) + (right >> 16) + (middle >> 16) + x.word.low * y.word.high + x.word.high * y.word.low;
    return r.all;
}

uint32_t __udivsi3(uint32_t n, uint32_t d)
{
    uint32_t quotient = 0, rest = 0;

    for (int i = 31; i >= 0; i--) {
        uint32_t carry = rest >> 31;

        rest = rest << 1 | (n >> i & 1);
        if (carry || rest >= d) {
            rest -= d;
            quotient |= 1u << i;
        }
    }
    return quotient;
}

uint32_t __umodsi3(uint32_t n, uint32_t d)
{
    return n - __udivsi3(n, d) * d;
}

int32_t __divsi3(int32_t n, int32_t d)
{
    uint32_t quotient = __udivsi3(n < 0 ? 0u - (uint32_t)n : (uint32_t)n, d < 0 ? 0u - (uint32_t)d : (uint32_t)d);

    return (int32_t)((n < 0) != (d < 0) ? 0u - quotient : quotient);
}

int32_t __modsi3(int32_t n, int32_t d)
{
    return (int32_t)((uint32_t)n - (uint32_t)__divsi3(n, d) * (uint32_t)d);
}

uint64_t __udivdi3(uint64_t n, uint64_t d)
{
    uint64_t quotient = 0, rest = 0;

    for (int i = 63; i >= 0; i--) {
        uint64_t carry = rest >> 63;

        rest = rest << 1 | (n >> i & 1);
        if (carry || rest >= d) {
            rest -= d;
            quotient |= (uint64_t)1 << i;
        }
    }
    return quotient;
}

uint64_t __umoddi3(uint64_t n, uint64_t d)
{
    return n - __udivdi3(n, d) * d;
}

int64_t __divdi3(int64_t n, int64_t d)
{
    uint64_t quotient = __udivdi3(n < 0 ? 0u - (uint64_t)n : (uint64_t)n, d < 0 ? 0u - (uint64_t)d : (uint64_t)d);

    return (int64_t)((n < 0) != (d < 0) ? 0u - quotient : quotient);
}
