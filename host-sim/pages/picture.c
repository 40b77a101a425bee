/*
 * picture.c - runs an example of firmware/examples on this machine, and writes its last frame to standard output.
 *
 *   picture WIDTH[xHEIGHT] FRAMES      a PPM of that size; without HEIGHT it is a square
 *
 * Stands in for the board: a thread is the other core, and the knob is turned once, at the beginning.
 */
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>

#include "example.h"

static pthread_t thread;
static pthread_mutex_t mutex = PTHREAD_MUTEX_INITIALIZER;
static struct work {
    void (*run)(void *ctx);
    void *ctx;
} work;

static void *run_work(void *unused)
{
    work.run(work.ctx);
    return unused;
}

void board_start(void (*run)(void *ctx), void *ctx)
{
    work = (struct work){run, ctx};
    if (pthread_create(&thread, NULL, run_work, NULL) != 0)
        abort();
}

int board_ended(void)
{
    return pthread_join(thread, NULL) == 0;
}

void board_lock(void *ctx)
{
    (void)ctx;
    pthread_mutex_lock(&mutex);
}

void board_unlock(void *ctx)
{
    (void)ctx;
    pthread_mutex_unlock(&mutex);
}

int board_turned(void)
{
    static int steps = 12;
    int turned = steps;

    steps = 0;
    return turned;
}

static void put_picture(const struct sheen_memory *memory, unsigned width, unsigned height)
{
    printf("P6 %u %u 255\n", width, height);
    for (unsigned y = 0; y < height; y++) {
        const uint8_t *row = (const uint8_t *)memory->pixels + y * memory->stride;

        for (unsigned x = 0; x < width; x++) {
            unsigned value = row[2 * x] | (unsigned)row[2 * x + 1] << 8;

            putchar((int)((value >> 11) * 255 / 31));
            putchar((int)((value >> 5 & 63) * 255 / 63));
            putchar((int)((value & 31) * 255 / 31));
        }
    }
}

int main(int argc, char **argv)
{
    unsigned width = 0, height = 0, frames = argc == 3 ? (unsigned)atoi(argv[2]) : 0;
    int sizes = argc == 3 ? sscanf(argv[1], "%ux%u", &width, &height) : 0;
    struct sheen_target target;

    if (sizes == 1)
        height = width;
    if (width < 16 || width > 480 || height < 16 || height > 480 || frames < 1) {
        fprintf(stderr, "usage: picture WIDTH[xHEIGHT] FRAMES (16..480, from 1 on)\n");
        return 2;
    }
    struct sheen_memory memory = {.pixels = calloc(height, (size_t)width * 2), .stride = (size_t)width * 2};
    int error = memory.pixels
                    ? sheen_memory_target(&target, &memory, (uint16_t)width, (uint16_t)height, SHEEN_RGB565_LE)
                    : SHEEN_ERR_MEMORY;
    if (!error)
        error = example_run(&target, frames);
    if (error)
        fprintf(stderr, "picture: %s\n", sheen_strerror(error));
    else
        put_picture(&memory, width, height);
    free(memory.pixels);
    return error != 0 || fflush(stdout) != 0;
}
