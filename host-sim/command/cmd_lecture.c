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
    {"light-terms", sheen_lecture_terms},
    {"mach-bands", sheen_lecture_mach},
    {"highlights", sheen_lecture_highlight},
    {"barycentric", sheen_lecture_barycentric},
    {"orientation", sheen_lecture_orientation},
    {"newell", sheen_lecture_newell},
    {"drift", sheen_lecture_drift},
    {"length", sheen_lecture_length},
    {"newton", sheen_lecture_newton},
    {"specular", sheen_lecture_specular},
    {"normals", sheen_lecture_arc},
    {"increments", sheen_lecture_increments},
    {"distortion", sheen_lecture_distortion},
    {"cost", sheen_lecture_cost},
};

enum {
    FIGURES = sizeof figures / sizeof figures[0],
    PAGES = 2 * FIGURES + 1
};

/* "DIR/NAME.png", or .svg. */
static int write_page(struct sheen_page *page, const char *folder, struct sheen_problem *problem)
{
    char path[4096];
    int length = snprintf(path, sizeof path, "%s/%s.%s", folder, page->name, page->form == SHEEN_SVG ? "svg" : "png");

    if (length < 0 || (size_t)length >= sizeof path)
        return sheen_problem(problem, SHEEN_ERR_ARGUMENT, "%s: %s", folder, strerror(ENAMETOOLONG));
    return sheen_page_write(page, path, problem);
}

/* A folder that exists already is no error. */
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

static int draw_pages(struct sheen_page *pages, enum sheen_form form, int *open, struct sheen_problem *problem)
{
    for (int i = 0; i < FIGURES; i++) {
        struct sheen_page *page = &pages[(*open)++];
        int error = sheen_page_open(page, figures[i].name, form, SHEEN_PAGE_WIDTH, SHEEN_PAGE_HEIGHT);
        if (!error)
            error = figures[i].draw(page);
        if (error)
            return sheen_problem(problem, error, "%s: %s", figures[i].name, sheen_strerror(error));
    }
    return SHEEN_OK;
}

/*
 * Draws all records, all SVGs, and the contact sheet. Text that does not fit its page is only a warning, because its
 * cause is a font wider than the one that the figures were laid out for.
 */
static int draw_all(struct sheen_page *pages, int *open, struct sheen_problem *problem)
{
    int error = draw_pages(pages, SHEEN_RECORD, open, problem);

    if (!error)
        error = draw_pages(pages, SHEEN_SVG, open, problem);
    if (error)
        return error;
    error = sheen_page_sheet(&pages[(*open)++], pages, FIGURES);
    if (error)
        return sheen_problem(problem, error, "contact sheet: %s", sheen_strerror(error));
    for (int i = 0; i < PAGES; i++)
        if (pages[i].form != SHEEN_SVG && sheen_page_check(&pages[i], problem))
            fprintf(stderr, "sheen: warning: %s\n", problem->text);
    return SHEEN_OK;
}

enum sheen_exit sheen_cmd_lecture(struct sheen_options *options)
{
    static struct sheen_page pages[PAGES];
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
        error = draw_all(pages, &open, &problem);
    for (int i = 0; !error && i < open; i++) /* all are drawn before the first file is written */
        error = write_page(&pages[i], options->out, &problem);
    while (open > 0)
        sheen_page_close(&pages[--open]);
    cairo_debug_reset_static_data(); /* what cairo and fontconfig keep for a next page would be reported as leaked */
    FcFini();
    return error ? sheen_fail(SHEEN_EXIT_FAILURE, &problem) : SHEEN_EXIT_OK;
}
