/*
 * pins_find.c - lists the GPIO chips of this machine, and finds a line by what people call it.
 */
#include "pins_gpiod.h"
#include "sheen_target.h"

#include <ctype.h>
#include <errno.h>
#include <glob.h>
#include <gpiod.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

int sheen_chip_fail(struct sheen_failure *why, const char *path, int error)
{
    switch (error) {
    case EACCES:
    case EPERM:
        return sheen_failed(why, SHEEN_ERR_BUS,
                            "%s: no permission; become a member of its group (usually gpio) and log in again", path);
    case ENOENT:
        return sheen_failed(why, SHEEN_ERR_ARGUMENT, "%s: no such chip; " SHEEN_LIST_THEM, path);
    case ENODEV:
    case ENOTTY:
    case EINVAL:
        return sheen_failed(why, SHEEN_ERR_ARGUMENT, "%s is not a GPIO chip; " SHEEN_LIST_THEM, path);
    default:
        return sheen_failed(why, SHEEN_ERR_BUS, "%s: %s", path, strerror(error));
    }
}

int sheen_chip_open(struct gpiod_chip **chip, const char *path, struct sheen_failure *why)
{
    int tries = SHEEN_TRIES;

    do
        *chip = gpiod_chip_open(path);
    while (!*chip && sheen_again(errno, &tries));
    if (*chip)
        return 0;
    int kept = errno, code = sheen_chip_fail(why, path, kept);

    errno = kept;
    return code;
}

/* Does for one chip what sheen_pins_each does for all. */
static int chip_each(struct gpiod_chip *chip, const char *path,
                     int (*each)(void *ctx, const struct sheen_pin_info *info), void *ctx, struct sheen_failure *why)
{
    struct sheen_pin_info info = {.chip = strrchr(path, '/') + 1};
    char label[64] = "";
    unsigned lines = 0;
    int result = 0;

    if (sheen_gpiod_describe(chip, label, sizeof label, &lines))
        return sheen_chip_fail(why, path, errno);
    info.label = label;
    for (unsigned i = 0; i < lines && result == 0; i++) {
        info.offset = i;
        if (sheen_gpiod_info(chip, i, &info))
            result = sheen_failed(why, SHEEN_ERR_BUS, "line %s:%u: %s", info.chip, i, strerror(errno));
        else
            result = each(ctx, &info);
    }
    return result;
}

int sheen_pins_each(int (*each)(void *ctx, const struct sheen_pin_info *info), void *ctx, struct sheen_failure *why)
{
    glob_t paths = {0};
    size_t chips = 0, opened = 0;
    int result = 0;

    if (glob("/dev/gpiochip*", 0, NULL, &paths))
        paths.gl_pathc = 0;
    for (size_t i = 0; i < paths.gl_pathc && result == 0; i++) {
        struct gpiod_chip *chip;
        struct stat about;

        /* Some systems keep a link from a chip's old number to its new one; its lines would be listed twice. */
        if (lstat(paths.gl_pathv[i], &about) == 0 && S_ISLNK(about.st_mode))
            continue;
        chips++;
        if (sheen_chip_open(&chip, paths.gl_pathv[i], opened ? NULL : why) < 0) {
            /* Skip chips that this user may not open; any other reason is an error. */
            if (errno != EACCES && errno != EPERM)
                result = sheen_chip_fail(why, paths.gl_pathv[i], errno);
            continue;
        }
        opened++;
        result = chip_each(chip, paths.gl_pathv[i], each, ctx, why);
        gpiod_chip_close(chip);
    }
    globfree(&paths);
    if (chips == 0)
        return sheen_failed(why, SHEEN_ERR_BUS, "this machine has no GPIO chip (/dev/gpiochip*)");
    return result == 0 && opened == 0 ? SHEEN_ERR_BUS : result;
}

/* A search for a line by its name, or by a chip's label and the line's offset in that chip. */
struct search {
    const char *name;
    char label[64];
    struct sheen_pin_place place; /* of the first hit */
    unsigned hits;
    char places[96]; /* text: where all hits are */
};

static int compare(void *ctx, const struct sheen_pin_info *info)
{
    struct search *search = ctx;
    size_t used = strlen(search->places);

    if (search->label[0] ? strcmp(search->label, info->label) != 0 || search->place.offset != info->offset
                         : strcmp(search->name, info->name) != 0)
        return 0;
    if (search->hits++ == 0) {
        snprintf(search->place.path, sizeof search->place.path, "/dev/%s", info->chip);
        search->place.offset = info->offset;
    }
    snprintf(search->places + used, sizeof search->places - used, "%s%s:%u", used ? ", " : "", info->chip,
             info->offset);
    return 0;
}

/* "GPIO25" remains a name. "chip:25" is split: the chip goes to search->label or, if it is a device, to place.path. */
static void split(struct search *search, const char *line)
{
    const char *colon = strrchr(line, ':');
    char *end = NULL;
    unsigned long offset = colon ? strtoul(colon + 1, &end, 10) : 0;
    size_t length = colon ? (size_t)(colon - line) : 0;

    search->name = line;
    if (length == 0 || length >= sizeof search->label - 5 || !isdigit((unsigned char)colon[1]) || *end != '\0')
        return;
    search->place.offset = offset < INT_MAX ? (unsigned)offset : INT_MAX;
    if (line[0] == '/')
        snprintf(search->place.path, sizeof search->place.path, "%.*s", (int)length, line);
    else if (strncmp(line, "gpiochip", 8) == 0)
        snprintf(search->place.path, sizeof search->place.path, "/dev/%.*s", (int)length, line);
    else if (strspn(line, "0123456789") == length)
        snprintf(search->place.path, sizeof search->place.path, "/dev/gpiochip%.*s", (int)length, line);
    else
        snprintf(search->label, sizeof search->label, "%.*s", (int)length, line);
}

int sheen_pin_find(struct sheen_pin_place *place, const char *line, struct sheen_failure *why)
{
    struct search search = {0};
    int error = 0;

    split(&search, line);
    if (!search.place.path[0])
        error = sheen_pins_each(compare, &search, why);
    if (error < 0)
        return error;
    *place = search.place;
    place->by_name = search.hits == 1;
    if (search.hits > 1)
        return sheen_failed(why, SHEEN_ERR_ARGUMENT, "several lines are called '%s': %s; name one of these", line,
                            search.places);
    if (place->path[0])
        return 0;
    return sheen_failed(why, SHEEN_ERR_ARGUMENT, "no line is called '%s'; " SHEEN_LIST_THEM, line);
}
