/*
 * view_terminal.c - the glass as text: on a terminal it moves and takes keys, in a pipe frames follow one another.
 */
#include <errno.h>
#include <poll.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <time.h>
#include <unistd.h>

#include "terminal.h"
#include "view.h"

enum {
    COLUMNS = 80, /* if the terminal does not tell its size */
    ROWS = 24,
    STATUS_ROWS = 3
};

struct screen {
    int moves; /* standard output is a terminal */
    int keys;  /* standard input is one too, and `before` is its state at the start */
    struct termios before;
};

static volatile sig_atomic_t stopped;

static void stop(int signal_number)
{
    (void)signal_number;
    stopped = 1;
}

/* ---- the terminal's state: the alternate screen without a cursor, keys one by one and not echoed ---- */

static void enter(struct screen *screen)
{
    struct sigaction action = {.sa_handler = stop};
    struct termios raw;

    stopped = 0;
    screen->moves = isatty(STDOUT_FILENO);
    screen->keys = screen->moves && tcgetattr(STDIN_FILENO, &screen->before) == 0;
    if (!screen->moves)
        return;
    sigaction(SIGINT, &action, NULL);
    sigaction(SIGTERM, &action, NULL);
    sigaction(SIGHUP, &action, NULL);
    if (screen->keys) {
        raw = screen->before;
        raw.c_lflag &= ~(tcflag_t)(ICANON | ECHO);
        raw.c_cc[VSUSP] = _POSIX_VDISABLE; /* a suspended program would leave the terminal in this state */
        raw.c_cc[VMIN] = 0;
        raw.c_cc[VTIME] = 0;
        tcsetattr(STDIN_FILENO, TCSADRAIN, &raw);
    }
    fputs("\x1b[?1049h\x1b[?25l\x1b[2J", stdout);
}

static void leave(const struct screen *screen)
{
    if (!screen->moves)
        return;
    fputs("\x1b[0m\x1b[?25h\x1b[?1049l", stdout);
    fflush(stdout);
    if (screen->keys)
        tcsetattr(STDIN_FILENO, TCSADRAIN, &screen->before);
}

/* ---- a frame ----
 *
 * Lines erase what is left of older ones to their right. Lines as wide as the window do not: the cursor stays on their
 * last character, which would be erased.
 */

static void write_status(const struct sheen_viewer *viewer, const struct screen *screen, unsigned columns)
{
    char line[sizeof viewer->message];
    int cut = screen->moves ? (int)columns - 1 : (int)sizeof line;
    const char *end = screen->moves ? "\x1b[K\r\n" : "\n";

    sheen_viewer_title(viewer, line, sizeof line);
    printf("%.*s%s", cut, line, end);
    sheen_viewer_counts(viewer, line, sizeof line);
    printf("%.*s%s", cut, line, end);
    if (!screen->moves)
        return;
    const char *hint = screen->keys ? "space n b s l d a o r p t w g, q: end (see --help)" : "";
    printf("%.*s\x1b[K\x1b[J", cut, viewer->message[0] ? viewer->message : hint);
}

static int show(const struct sheen_viewer *viewer, const struct screen *screen, struct sheen_problem *problem)
{
    struct winsize window = {.ws_row = ROWS, .ws_col = COLUMNS};
    unsigned size[2], columns, rows;
    uint8_t *rgb = sheen_viewer_picture(viewer, size);

    if (!rgb)
        return sheen_problem(problem, SHEEN_ERR_MEMORY, "no picture: not enough memory");
    if (screen->moves && (ioctl(STDOUT_FILENO, TIOCGWINSZ, &window) != 0 || !window.ws_col || !window.ws_row))
        window = (struct winsize){.ws_row = ROWS, .ws_col = COLUMNS};
    if (window.ws_row > STATUS_ROWS)
        window.ws_row = (unsigned short)(window.ws_row - STATUS_ROWS);
    sheen_terminal_size(size[0], size[1], window.ws_col, window.ws_row, &columns, &rows);
    if (screen->moves)
        fputs("\x1b[H", stdout);
    const char *end = !screen->moves ? "\n" : columns < window.ws_col ? "\x1b[K\r\n" : "\r\n";
    sheen_terminal_picture(stdout, rgb, size[0], size[1], columns, rows, end);
    free(rgb);
    write_status(viewer, screen, window.ws_col);
    if (fflush(stdout) != 0 || ferror(stdout))
        return sheen_problem(problem, SHEEN_ERR_ARGUMENT, "standard output: %s", strerror(errno));
    return SHEEN_OK;
}

/* ---- keys ---- */

/* The next key in text[*at..count), 0 for an unknown sequence: an arrow is ESC [ A..D or ESC O A..D. */
static int next_key(const char *text, int count, int *at)
{
    static const int arrows[4] = {SHEEN_KEY_UP, SHEEN_KEY_DOWN, SHEEN_KEY_RIGHT, SHEEN_KEY_LEFT};
    const char *key = text + *at;

    if (*key == SHEEN_KEY_ESCAPE && count - *at >= 3 && (key[1] == '[' || key[1] == 'O')) {
        *at += 3;
        return key[2] >= 'A' && key[2] <= 'D' ? arrows[key[2] - 'A'] : 0;
    }
    ++*at;
    return (unsigned char)*key;
}

/* Handles all keys typed so far. Returns as sheen_viewer_key; *dirty: 1 if there was a key. */
static int take_keys(struct sheen_viewer *viewer, int *dirty, struct sheen_problem *problem)
{
    char text[64];
    ssize_t count = read(STDIN_FILENO, text, sizeof text);
    int answer = 0;

    for (int at = 0; answer == 0 && at < count;) {
        answer = sheen_viewer_key(viewer, next_key(text, (int)count, &at), problem);
        *dirty = 1;
    }
    return answer;
}

static int64_t now_ms(void)
{
    struct timespec now;

    clock_gettime(CLOCK_MONOTONIC, &now);
    return (int64_t)now.tv_sec * 1000 + now.tv_nsec / 1000000;
}

/* Waits until the time has come, a key was typed or a signal came. Returns as take_keys. */
static int rest(struct sheen_viewer *viewer, const struct screen *screen, int64_t until, int *dirty,
                struct sheen_problem *problem)
{
    struct pollfd input = {.fd = screen->keys ? STDIN_FILENO : -1, .events = POLLIN};
    int64_t left = until - now_ms();

    if (left <= 0 && viewer->playing)
        left = 0;
    else if (left <= 0)
        left = SHEEN_VIEW_MS;
    if (poll(&input, 1, (int)left) <= 0)
        return 0;
    if (input.revents & (POLLHUP | POLLERR | POLLNVAL))
        return 1; /* the terminal is gone */
    return take_keys(viewer, dirty, problem);
}

static int play(struct sheen_viewer *viewer, const struct screen *screen, struct sheen_problem *problem)
{
    int limit = viewer->options.view_frames ? viewer->options.view_frames : !screen->moves, shown = 1;
    int64_t due = now_ms() + SHEEN_VIEW_MS;
    int answer = show(viewer, screen, problem);

    while (answer == 0 && !stopped) {
        int dirty = 0;
        if (screen->moves)
            answer = rest(viewer, screen, due, &dirty, problem);
        if (answer == 0 && viewer->playing && (!screen->moves || now_ms() >= due)) {
            if (limit && shown++ == limit)
                return SHEEN_OK;
            due = now_ms() + SHEEN_VIEW_MS;
            dirty = 1;
            answer = sheen_viewer_next(viewer, problem);
            if (answer == 0)
                sheen_viewer_record(viewer);
        }
        if (answer == 0 && dirty)
            answer = show(viewer, screen, problem);
    }
    return answer < 0 ? answer : SHEEN_OK;
}

int sheen_view_terminal(struct sheen_viewer *viewer, struct sheen_problem *problem)
{
    struct screen screen;

    enter(&screen);
    int error = play(viewer, &screen, problem);
    leave(&screen);
    return error;
}
