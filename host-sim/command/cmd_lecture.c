/*
 * cmd_lecture.c - `sheen lecture`: a figure for each claim of the lecture, and a contact sheet of all.
 */
#include <errno.h>
#include <fontconfig/fontconfig.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

#include "commands.h"
#include "lecture.h"

static const struct {
    const char *name;
    int (*draw)(struct sheen_page *page);
} figures[] = {
    {"mach-bands", sheen_lecture_mach},
    {"highlights", sheen_lecture_highlight},
    {"orientation", sheen_lecture_orientation},
    {"distortion", sheen_lecture_distortion},
    {"normals", sheen_lecture_arc},
    {"drift", sheen_lecture_drift},
};

enum {
    FIGURES = sizeof figures / sizeof figures[0]
};

#define SHEET "contact-sheet"

/* "DIR/NAME.png". */
static int file_name(char *path, size_t size, const char *folder, const char *name, struct sheen_problem *problem)
{
    int length = snprintf(path, size, "%s/%s.png", folder, name);

    if (length < 0 || (size_t)length >= size)
        return sheen_problem(problem, SHEEN_ERR_ARGUMENT, "%s: %s", folder, strerror(ENAMETOOLONG));
    return SHEEN_OK;
}

/* A folder that is there is as good as a new one. */
static int make_folder(const char *folder, struct sheen_problem *problem)
{
    struct stat status;

    if (mkdir(folder, 0777) == 0)
        return SHEEN_OK;
    int why = errno;
    if (why == EEXIST && stat(folder, &status) == 0 && !S_ISDIR(status.st_mode))
        why = ENOTDIR;
    return why == EEXIST ? SHEEN_OK : sheen_problem(problem, SHEEN_ERR_ARGUMENT, "%s: %s", folder, strerror(why));
}

static int draw_pages(struct sheen_page *pages, int *open, struct sheen_problem *problem)
{
    for (int i = 0; i < FIGURES; i++) {
        int error = sheen_page_open(&pages[(*open)++], figures[i].name);
        if (!error)
            error = figures[i].draw(&pages[i]);
        if (error)
            return sheen_problem(problem, error, "%s: %s", figures[i].name, sheen_strerror(error));
    }
    return SHEEN_OK;
}

/* All pages are drawn before the first file is written. */
static int write_pages(const struct sheen_page *pages, const char *folder, struct sheen_problem *problem)
{
    char path[4096];
    int error = SHEEN_OK;

    for (int i = 0; !error && i < FIGURES; i++) {
        error = file_name(path, sizeof path, folder, pages[i].name, problem);
        if (!error)
            error = sheen_page_write(&pages[i], path, problem);
    }
    if (!error)
        error = file_name(path, sizeof path, folder, SHEET, problem);
    return error ? error : sheen_page_write_sheet(pages, FIGURES, path, problem);
}

enum sheen_exit sheen_cmd_lecture(struct sheen_options *options)
{
    struct sheen_page pages[FIGURES];
    struct sheen_problem problem;
    int open = 0;

    if (!options->out) {
        sheen_problem(&problem, SHEEN_ERR_ARGUMENT, "no output given (-o DIR)");
        return sheen_fail(SHEEN_EXIT_USAGE, &problem);
    }
    int error = SHEEN_OK;
    if (!sheen_page_has_font())
        error = sheen_problem(&problem, SHEEN_ERR_UNSUPPORTED, "fontconfig finds no font to write the figures with");
    if (!error)
        error = make_folder(options->out, &problem);
    if (!error)
        error = draw_pages(pages, &open, &problem);
    if (!error)
        error = write_pages(pages, options->out, &problem);
    while (open > 0)
        sheen_page_close(&pages[--open]);
    cairo_debug_reset_static_data(); /* what both keep for the next page is not lost, but looks it */
    FcFini();
    return error ? sheen_fail(SHEEN_EXIT_FAILURE, &problem) : SHEEN_EXIT_OK;
}
