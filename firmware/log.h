/*
 * log.h - text and numbers on the board's serial line, without printf.
 */
#ifndef LOG_H
#define LOG_H

#include <stdint.h>

void log_text(const char *text); /* "\n" is sent as CR LF */
void log_number(uint32_t value);
void log_hex(uint32_t value); /* 0x and eight digits */

#endif
