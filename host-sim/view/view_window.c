/*
 * view_window.c - the glass in a window, by SDL; the lines below it by cairo.
 *
 * Everything is drawn into memory and copied to the window's surface, so that it
 * works with every video driver of SDL, also the one without a screen.
 */
#include <SDL.h>
#include <cairo.h>
#include <fontconfig/fontconfig.h>
#include <stdio.h>

#include "view.h"

enum {
    MARGIN = 16, /* px round the glass */
    LINE = 18,   /* px a line of text */
    LINES = 4,
    TEXT_SIZE = 13,
    MIN_WIDTH = 800, /* px: the lines */
    MAX_ROOM_W = 960,
    MAX_ROOM_H = 720
};

struct window {
    struct sheen_viewer *viewer;
    SDL_Window *window;
    cairo_surface_t *canvas;
    int width, height; /* px of the canvas */
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

/* SDL has drivers without a screen, on which it falls back, too: a window that nobody sees, and nobody can close. */
static int is_unseen(void)
{
    const char *driver = SDL_GetCurrentVideoDriver();

    return SDL_strcasecmp(driver, "offscreen") == 0 || SDL_strcasecmp(driver, "dummy") == 0;
}

int sheen_view_window_room(unsigned room[2], int frames, struct sheen_problem *problem)
{
    SDL_Rect screen;

    SDL_SetHint(SDL_HINT_NO_SIGNAL_HANDLERS, "1"); /* an interrupt ends the program, as elsewhere */
    if (!SDL_getenv("XDG_RUNTIME_DIR"))
        SDL_SetHint(SDL_HINT_VIDEODRIVER, "x11,kmsdrm"); /* Wayland's library would complain beside our line */
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

/* A canvas and a window for the glass as it is now scaled. */
static int fit(struct window *window, struct sheen_problem *problem)
{
    const struct sheen_viewer *viewer = window->viewer;
    int glass_w = (int)(viewer->table.choice.width * viewer->look.scale);
    int width = (glass_w > MIN_WIDTH ? glass_w : MIN_WIDTH) + 2 * MARGIN;
    int height = (int)(viewer->table.choice.height * viewer->look.scale) + 2 * MARGIN + LINES * LINE;

    if (window->canvas && window->width == width && window->height == height)
        return SHEEN_OK;
    if (window->canvas)
        cairo_surface_destroy(window->canvas);
    window->canvas = cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height);
    if (cairo_surface_status(window->canvas) != CAIRO_STATUS_SUCCESS)
        return sheen_problem(problem, SHEEN_ERR_MEMORY, "no window: not enough memory");
    window->width = width;
    window->height = height;
    SDL_SetWindowSize(window->window, width, height);
    return SHEEN_OK;
}

/* The rows of the last band, marked beside the glass, and what it sent, framed on it. */
static void mark_band(const struct window *window, cairo_t *cr, int left)
{
    const struct sheen_viewer *viewer = window->viewer;
    int scale = (int)viewer->look.scale, first, end;
    const struct sheen_rect *sent = &viewer->sent;

    if (viewer->shown_band < 0)
        return;
    sheen_viewer_rows(viewer, &first, &end);
    cairo_set_source_rgb(cr, 1.0, 0.35, 0.2);
    cairo_rectangle(cr, left - MARGIN / 2, MARGIN + first * scale, MARGIN / 4, (end - first) * scale);
    cairo_fill(cr);
    if (sent->x0 >= sent->x1)
        return;
    cairo_set_line_width(cr, 2);
    cairo_rectangle(cr, left + sent->x0 * scale - 1, MARGIN + sent->y0 * scale - 1, (sent->x1 - sent->x0) * scale + 2,
                    (sent->y1 - sent->y0) * scale + 2);
    cairo_stroke(cr);
}

static void write_lines(const struct window *window, cairo_t *cr)
{
    char lines[LINES][sizeof window->viewer->message + 16];
    const struct sheen_viewer *viewer = window->viewer;

    sheen_viewer_title(viewer, lines[0], sizeof lines[0]);
    sheen_viewer_counts(viewer, lines[1], sizeof lines[1]);
    snprintf(lines[2], sizeof lines[2], "%s%s", viewer->gif ? "recording  " : "", viewer->message);
    snprintf(lines[3], sizeof lines[3],
             "space stop  n frame  b band  s shade  l light  d dither  a affine  o ortho  r turn  p panel  t theme  "
             "w PNG  g GIF  q end");
    cairo_select_font_face(cr, "sans-serif", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(cr, TEXT_SIZE);
    for (int i = 0; i < LINES; i++) {
        double shade = i < 3 ? 0.9 : 0.55;
        cairo_set_source_rgb(cr, shade, shade, shade);
        cairo_move_to(cr, MARGIN, window->height - MARGIN / 2 - (LINES - 1 - i) * LINE);
        cairo_show_text(cr, lines[i]);
    }
    SDL_SetWindowTitle(window->window, lines[0]);
}

static void draw_canvas(const struct window *window)
{
    const struct sheen_viewer *viewer = window->viewer;
    int stride = cairo_image_surface_get_stride(window->canvas) / 4;
    int left = (window->width - (int)(viewer->table.choice.width * viewer->look.scale)) / 2;
    cairo_t *cr = cairo_create(window->canvas);

    cairo_set_source_rgb(cr, (SHEEN_BEZEL >> 16) / 255.0, (SHEEN_BEZEL >> 8 & 255) / 255.0,
                         (SHEEN_BEZEL & 255) / 255.0);
    cairo_paint(cr);
    cairo_surface_flush(window->canvas);
    uint32_t *pixels = (uint32_t *)(void *)cairo_image_surface_get_data(window->canvas);
    sheen_viewer_paint(viewer, pixels + MARGIN * stride + left, (unsigned)stride);
    cairo_surface_mark_dirty(window->canvas);
    mark_band(window, cr, left);
    write_lines(window, cr);
    cairo_destroy(cr);
    cairo_surface_flush(window->canvas);
}

static int show(struct window *window, struct sheen_problem *problem)
{
    int error = fit(window, problem);

    if (error)
        return error;
    draw_canvas(window);
    SDL_Surface *to = SDL_GetWindowSurface(window->window);
    SDL_Surface *from =
        SDL_CreateRGBSurfaceWithFormatFrom(cairo_image_surface_get_data(window->canvas), window->width, window->height,
                                           32, cairo_image_surface_get_stride(window->canvas), SDL_PIXELFORMAT_RGB888);
    int shown =
        to && from && SDL_BlitSurface(from, NULL, to, NULL) == 0 && SDL_UpdateWindowSurface(window->window) == 0;

    SDL_FreeSurface(from);
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

/* All that have come. As sheen_viewer_key, 1 also for a closed window. *dirty: 1 where there is something to show. */
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
    if (window.canvas)
        cairo_surface_destroy(window.canvas);
    if (window.window)
        SDL_DestroyWindow(window.window);
    SDL_Quit();
    cairo_debug_reset_static_data(); /* what both keep of the font is not lost, but looks it */
    FcFini();
    return error;
}
