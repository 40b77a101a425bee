/*
 * main.c - sheen draws into memory: a part of a framebuffer, whose rows are longer than the picture's. Prints a PPM.
 */
#include <stdio.h>

#include "example.h"

#define SCREEN_WIDTH 320
#define SCREEN_HEIGHT 272

static uint16_t screen[SCREEN_HEIGHT * SCREEN_WIDTH];

int main(void)
{
    /* 240 x 240 pixels of the screen, from column 40 and row 16 on. */
    struct sheen_memory memory = {.pixels = &screen[16 * SCREEN_WIDTH + 40], .stride = 2 * SCREEN_WIDTH};
    const uint16_t probe = 1;
    struct sheen_target target;
    int error =
        sheen_memory_target(&target, &memory, 240, 240, *(const uint8_t *)&probe ? SHEEN_RGB565_LE : SHEEN_RGB565_BE);

    if (!error)
        error = example_run(&target, 3);
    if (error) {
        fprintf(stderr, "memory: %s\n", sheen_strerror(error));
        return 1;
    }
    printf("P6 %d %d 255\n", SCREEN_WIDTH, SCREEN_HEIGHT);
    for (int i = 0; i < SCREEN_WIDTH * SCREEN_HEIGHT; i++) {
        unsigned value = screen[i];

        putchar((int)((value >> 11) * 255 / 31));
        putchar((int)((value >> 5 & 63) * 255 / 63));
        putchar((int)((value & 31) * 255 / 31));
    }
    return fflush(stdout) != 0;
}
