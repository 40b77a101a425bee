/*
 * main.c - stands for the end of a program on a Pico: what main() returned, and the picture is complete.
 */
#include "pico/stdlib.h"

__attribute__((destructor)) static void standin_end(void)
{
    wire_number('F', 0);
    fflush(stdout);
}
