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
    FIGURES = sizeof figures / sizeof figures[0]
};

/* "DIR/NAME.ENDING". */
static int write_page(const struct sheen_page *page, const char *folder, const char *ending,
                      struct sheen_problem *problem)
{
    char path[4096];
    int length = snprintf(path, sizeof path, "%s/%s.%s", folder, page->name, ending);

    if (length < 0 || (size_t)length >= sizeof path)
        return sheen_problem(problem, SHEEN_ERR_ARGUMENT, "%s: %s", folder, strerror(ENAMETOOLONG));
    return sheen_page_write(page, path, problem);
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

/*
 * The last page is the contact sheet. What does not fit its page is a warning: it comes with a font that is wider
 * than what the figures were laid out for.
 */
static int draw_pages(struct sheen_page *pages, int *open, struct sheen_problem *problem)
{
    for (int i = 0; i < FIGURES; i++) {
        int error = sheen_page_open(&pages[(*open)++], figures[i].name, SHEEN_PAGE_WIDTH, SHEEN_PAGE_HEIGHT);
        if (!error)
            error = figures[i].draw(&pages[i]);
        if (error)
            return sheen_problem(problem, error, "%s: %s", figures[i].name, sheen_strerror(error));
    }
    int error = sheen_page_sheet(&pages[(*open)++], pages, FIGURES);
    if (error)
        return sheen_problem(problem, error, "contact sheet: %s", sheen_strerror(error));
    for (int i = 0; i <= FIGURES; i++)
        if (sheen_page_check(&pages[i], problem))
            fprintf(stderr, "sheen: warning: %s\n", problem->text);
    return SHEEN_OK;
}

/* All pages are drawn before the first file is written. */
static int write_pages(const struct sheen_page *pages, const char *folder, struct sheen_problem *problem)
{
    int error = SHEEN_OK;

    for (int i = 0; !error && i <= FIGURES; i++) {
        error = write_page(&pages[i], folder, "png", problem);
        if (!error && i < FIGURES) /* the sheet would hold each page whole */
            error = write_page(&pages[i], folder, "svg", problem);
    }
    return error;
}

enum sheen_exit sheen_cmd_lecture(struct sheen_options *options)
{
    static struct sheen_page pages[FIGURES + 1];
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
