/*
 * main.c - sheen in an SDL2 window: it draws into a surface of 565 pixels, with the surface's pitch.
 *
 *   cc main.c ../cube.c ... $(pkg-config --cflags --libs sdl2)
 *   main [FILE.bmp]      FILE.bmp: also writes the last frame to this file
 */
#include <SDL.h>

#include "example.h"

int main(int argc, char **argv)
{
    struct sheen_target target;
    struct sheen_memory memory;
    int error = -1;

    if (SDL_Init(SDL_INIT_VIDEO) == 0) {
        SDL_Window *window = SDL_CreateWindow("sheen", SDL_WINDOWPOS_CENTERED, SDL_WINDOWPOS_CENTERED, 240, 240, 0);
        SDL_Surface *surface = SDL_CreateRGBSurfaceWithFormat(0, 240, 240, 16, SDL_PIXELFORMAT_RGB565);

        if (window && surface) {
            memory = (struct sheen_memory){.pixels = surface->pixels, .stride = (size_t)surface->pitch};
            error = sheen_memory_target(&target, &memory, 240, 240,
                                        SDL_BYTEORDER == SDL_LIL_ENDIAN ? SHEEN_RGB565_LE : SHEEN_RGB565_BE);
            if (!error)
                error = example(&target, 3);
            if (!error)
                error = SDL_BlitSurface(surface, NULL, SDL_GetWindowSurface(window), NULL);
            if (!error)
                error = SDL_UpdateWindowSurface(window);
            if (!error && argc > 1)
                error = SDL_SaveBMP(surface, argv[1]);
        }
        SDL_FreeSurface(surface);
        SDL_DestroyWindow(window);
    }
    if (error)
        SDL_Log("sheen: %d %s", error, SDL_GetError());
    SDL_Quit();
    return error != 0;
}
