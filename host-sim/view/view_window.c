/*
 * view_window.c - the glass in an SDL window, with lines of text below it (view_letters.h).
 *
 * Everything is drawn into memory and copied to the window's surface, so that it works with every video driver of SDL,
 * even the one without a screen.
 */
#include <SDL.h>
#include <stdio.h>

#include "view.h"
#include "view_letters.h"

enum {
    MARGIN = 16, /* px around the glass */
    LINE = 18,   /* px per line of text */
    LINES = 4,
    MIN_WIDTH = 800, /* px for the lines of text */
    MAX_ROOM_W = 960,
    MAX_ROOM_H = 720
};

#define BAND_RED 255, 89, 51

struct window {
    struct sheen_viewer *viewer;
    SDL_Window *window;
    SDL_Surface *canvas; /* 0xRRGGBB */
};

static int sdl_problem(struct sheen_problem *problem)
{
    return sheen_problem(problem, SHEEN_ERR_UNSUPPORTED, "no window: %s (--terminal and --gif need none)",
                         SDL_GetError());
}

static int is_asked_for(void)
{
    const char *driver = SDL_getenv("SDL_VIDEODRIVER");

    return driver && *driver;
}

/* SDL may fall back on a driver without a screen: nobody sees such a window, and nobody can close it. */
static int is_unseen(void)
{
    const char *driver = SDL_GetCurrentVideoDriver();

    return SDL_strcasecmp(driver, "offscreen") == 0 || SDL_strcasecmp(driver, "dummy") == 0;
}

int sheen_view_window_room(unsigned room[2], int frames, struct sheen_problem *problem)
{
    SDL_Rect screen;

    SDL_SetHint(SDL_HINT_NO_SIGNAL_HANDLERS, "1"); /* so that an interrupt ends the program, as in other commands */
    if (!SDL_getenv("XDG_RUNTIME_DIR"))
        SDL_SetHint(SDL_HINT_VIDEODRIVER,
                    "x11,kmsdrm"); /* Wayland's library would print a complaint besides our line */
    int failed = SDL_Init(SDL_INIT_VIDEO) != 0, asked = is_asked_for();
    int unseen = failed ? !asked : is_unseen() && !(asked && frames > 0);
    if (unseen || failed || SDL_GetDisplayUsableBounds(0, &screen) != 0) {
        int error = unseen ? sheen_problem(problem, SHEEN_ERR_UNSUPPORTED,
                                           "no window: there is no display (--terminal and --gif need none)")
                           : sdl_problem(problem);
        SDL_Quit();
        return error;
    }
    int width = screen.w - 2 * MARGIN, height = screen.h - 2 * MARGIN - LINES * LINE - 40; /* 40: the title bar */
    room[0] = (unsigned)(width < 1 ? 1 : width < MAX_ROOM_W ? width : MAX_ROOM_W);
    room[1] = (unsigned)(height < 1 ? 1 : height < MAX_ROOM_H ? height : MAX_ROOM_H);
    return SHEEN_OK;
}

/* ---- the canvas ---- */

/* Resizes canvas and window for the glass at its present scale. */
static int fit(struct window *window, struct sheen_problem *problem)
{
    const struct sheen_viewer *viewer = window->viewer;
    int glass_w = (int)(viewer->table.choice.width * viewer->look.scale);
    int width = (glass_w > MIN_WIDTH ? glass_w : MIN_WIDTH) + 2 * MARGIN;
    int height = (int)(viewer->table.choice.height * viewer->look.scale) + 2 * MARGIN + LINES * LINE;

    if (window->canvas && window->canvas->w == width && window->canvas->h == height)
        return SHEEN_OK;
    SDL_FreeSurface(window->canvas);
    window->canvas = SDL_CreateRGBSurfaceWithFormat(0, width, height, 32, SDL_PIXELFORMAT_RGB888);
    if (!window->canvas)
        return sheen_problem(problem, SHEEN_ERR_MEMORY, "no window: not enough memory");
    SDL_SetWindowSize(window->window, width, height);
    return SHEEN_OK;
}

static void fill(const struct window *window, int x, int y, int width, int height)
{
    SDL_Rect rect = {x, y, width, height};

    SDL_FillRect(window->canvas, &rect, SDL_MapRGB(window->canvas->format, BAND_RED));
}

/* Marks the last band's rows beside the glass, and frames on the glass the rectangle that it sent. */
static void mark_band(const struct window *window, int left)
{
    const struct sheen_viewer *viewer = window->viewer;
    int scale = (int)viewer->look.scale, first, end;
    const struct sheen_rect *sent = &viewer->sent;
    int x = left + sent->x0 * scale - 2, width = (sent->x1 - sent->x0) * scale + 4;
    int y = MARGIN + sent->y0 * scale - 2, height = (sent->y1 - sent->y0) * scale + 4;

    if (viewer->shown_band < 0)
        return;
    sheen_viewer_rows(viewer, &first, &end);
    fill(window, left - MARGIN / 2, MARGIN + first * scale, MARGIN / 4, (end - first) * scale);
    if (sent->x0 >= sent->x1)
        return;
    fill(window, x, y, width, 2);
    fill(window, x, y + height - 2, width, 2);
    fill(window, x, y, 2, height);
    fill(window, x + width - 2, y, 2, height);
}

static void write_lines(const struct window *window)
{
    char lines[LINES][sizeof window->viewer->message + 16];
    const struct sheen_viewer *viewer = window->viewer;
    SDL_Surface *canvas = window->canvas;

    sheen_viewer_title(viewer, lines[0], sizeof lines[0]);
    sheen_viewer_counts(viewer, lines[1], sizeof lines[1]);
    snprintf(lines[2], sizeof lines[2], "%s%s", viewer->gif ? "recording  " : "", viewer->message);
    snprintf(lines[3], sizeof lines[3],
             "space stop  n frame  b band  s shade  l light  d dither  e edges  a affine  o ortho  r turn  p panel  t "
             "theme  "
             "w PNG  g GIF  q end");
    struct sheen_letters letters = {canvas->pixels, canvas->w, canvas->h, canvas->pitch};
    for (int i = 0; i < LINES; i++)
        sheen_letters(&letters, MARGIN, canvas->h - MARGIN / 2 - (LINES - 1 - i) * LINE, i < 3 ? 230 : 140, lines[i]);
    SDL_SetWindowTitle(window->window, lines[0]);
}

static void draw_canvas(const struct window *window)
{
    const struct sheen_viewer *viewer = window->viewer;
    int stride = window->canvas->pitch / 4;
    int left = (window->canvas->w - (int)(viewer->table.choice.width * viewer->look.scale)) / 2;

    SDL_FillRect(window->canvas, NULL, SHEEN_BEZEL);
    sheen_viewer_paint(viewer, (uint32_t *)window->canvas->pixels + MARGIN * stride + left, (unsigned)stride);
    mark_band(window, left);
    write_lines(window);
}

static int show(struct window *window, struct sheen_problem *problem)
{
    int error = fit(window, problem);

    if (error)
        return error;
    draw_canvas(window);
    SDL_Surface *to = SDL_GetWindowSurface(window->window);
    int shown =
        to && SDL_BlitSurface(window->canvas, NULL, to, NULL) == 0 && SDL_UpdateWindowSurface(window->window) == 0;

    return shown ? SHEEN_OK : sdl_problem(problem);
}

/* ---- events ---- */

static int key_of(const SDL_Keysym *symbol)
{
    switch (symbol->sym) {
    case SDLK_LEFT:
        return SHEEN_KEY_LEFT;
    case SDLK_RIGHT:
        return SHEEN_KEY_RIGHT;
    case SDLK_UP:
        return SHEEN_KEY_UP;
    case SDLK_DOWN:
        return SHEEN_KEY_DOWN;
    case SDLK_KP_PLUS:
        return '+';
    case SDLK_KP_MINUS:
        return '-';
    case SDLK_p:
        return symbol->mod & KMOD_SHIFT ? 'P' : 'p';
    default:
        return symbol->sym > 0 && symbol->sym < 128 ? symbol->sym : 0;
    }
}

/* Handles all waiting events. Returns as sheen_viewer_key, 1 also for a closed window. *dirty: 1 if a redraw is due. */
static int take_events(struct window *window, int *dirty, struct sheen_problem *problem)
{
    SDL_Event event;
    int answer = 0;

    while (answer == 0 && SDL_PollEvent(&event)) {
        if (event.type == SDL_QUIT)
            return 1;
        *dirty |= event.type == SDL_KEYDOWN || event.type == SDL_WINDOWEVENT;
        if (event.type == SDL_KEYDOWN)
            answer = sheen_viewer_key(window->viewer, key_of(&event.key.keysym), problem);
    }
    return answer;
}

static int run(struct window *window, struct sheen_problem *problem)
{
    struct sheen_viewer *viewer = window->viewer;
    int shown = 1, limit = viewer->options.view_frames;
    uint32_t due = SDL_GetTicks() + SHEEN_VIEW_MS;
    int answer = show(window, problem);

    while (answer == 0) {
        int dirty = 0;
        answer = take_events(window, &dirty, problem);
        if (answer == 0 && viewer->playing && (int32_t)(SDL_GetTicks() - due) >= 0) {
            if (limit && shown++ == limit)
                return SHEEN_OK;
            due = SDL_GetTicks() + SHEEN_VIEW_MS;
            dirty = 1;
            answer = sheen_viewer_next(viewer, problem);
            if (answer == 0)
                sheen_viewer_record(viewer);
        }
        if (answer == 0 && dirty)
            answer = show(window, problem);
        SDL_Delay(5);
    }
    return answer < 0 ? answer : SHEEN_OK;
}

int sheen_view_window(struct sheen_viewer *viewer, struct sheen_problem *problem)
{
    struct window window = {.viewer = viewer};
    int error;

    window.window =
        SDL_CreateWindow("sheen", SDL_WINDOWPOS_UNDEFINED, SDL_WINDOWPOS_UNDEFINED, MIN_WIDTH, MIN_WIDTH, 0);
    error = window.window ? run(&window, problem) : sdl_problem(problem);
    SDL_FreeSurface(window.canvas);
    if (window.window)
        SDL_DestroyWindow(window.window);
    SDL_Quit();
    sheen_letters_end();
    return error;
}
