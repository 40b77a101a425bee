/*
 * log.c - text and numbers, a character at a time.
 */
#include "log.h"

#include "board.h"

void log_text(const char *text)
{
    for (; *text; text++) {
        if (*text == '\n')
            board_put('\r');
        board_put(*text);
    }
}

void log_number(uint32_t value)
{
    uint32_t power = 1;

    while (value / power >= 10)
        power *= 10;
    for (; power > 0; power /= 10)
        board_put((char)('0' + value / power % 10));
}

void log_hex(uint32_t value)
{
    log_text("0x");
    for (int shift = 28; shift >= 0; shift -= 4)
        board_put("0123456789abcdef"[value >> shift & 15]);
}
