/*
 * main.c - stands for the end of a program on a Pico: when main() has returned, the picture is complete.
 */
#include "pico/stdlib.h"

__attribute__((destructor)) static void standin_end(void)
{
    wire_number('F', 0);
    fflush(stdout);
}
