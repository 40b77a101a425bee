/*
 * main.c - sheen in an SDL2 window: it draws into a surface of 565 pixels, with the surface's pitch.
 *
 *   cc main.c ../cube.c ... $(pkg-config --cflags --libs sdl2)
 *   main [FILE.bmp]      turns until the window is closed; FILE.bmp: also writes the last frame to this file
 */
#include <SDL.h>

#include "example.h"

#define PERIOD_MS 16

static int is_closed(void)
{
    SDL_Event event;

    while (SDL_PollEvent(&event))
        if (event.type == SDL_QUIT)
            return 1;
    return 0;
}

/* The window's surface is asked for again for each picture, because it may change with the window. */
static int run(SDL_Window *window, SDL_Surface *surface)
{
    struct sheen_memory memory = {.pixels = surface->pixels, .stride = (size_t)surface->pitch};
    struct sheen_target target;
    struct sheen_frame *frame;
    int error = sheen_memory_target(&target, &memory, 240, 240,
                                    SDL_BYTEORDER == SDL_LIL_ENDIAN ? SHEEN_RGB565_LE : SHEEN_RGB565_BE);

    if (!error)
        error = example_init(&frame, &target);
    for (unsigned i = 0; !error && i < EXAMPLE_FRAMES && !is_closed(); i++) {
        error = example_draw(frame, i);
        if (!error)
            error = SDL_BlitSurface(surface, NULL, SDL_GetWindowSurface(window), NULL);
        if (!error)
            error = SDL_UpdateWindowSurface(window);
        SDL_Delay(PERIOD_MS);
    }
    return error;
}

int main(int argc, char **argv)
{
    int error = -1;

    if (SDL_Init(SDL_INIT_VIDEO) == 0) {
        SDL_Window *window = SDL_CreateWindow("sheen", SDL_WINDOWPOS_CENTERED, SDL_WINDOWPOS_CENTERED, 240, 240, 0);
        SDL_Surface *surface = SDL_CreateRGBSurfaceWithFormat(0, 240, 240, 16, SDL_PIXELFORMAT_RGB565);

        if (window && surface)
            error = run(window, surface);
        if (!error && argc > 1)
            error = SDL_SaveBMP(surface, argv[1]);
        SDL_FreeSurface(surface);
        SDL_DestroyWindow(window);
    }
    if (error)
        SDL_Log("sheen: %d %s", error, SDL_GetError());
    SDL_Quit();
    return error != 0;
}
