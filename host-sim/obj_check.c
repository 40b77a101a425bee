/*
 * obj_check.c - an OBJ file's indices and numbers, line by line.
 */
#include "obj_check.h"

#include <ctype.h>
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

/* Vertices or normals: how many there are so far, and the highest index that a face names (it may come first). */
struct counted {
    const char *what;
    long long count, highest;
    unsigned long line; /* of the highest */
};

struct check {
    const char *path;
    unsigned long line;
    struct counted vertices, normals;
    struct sheen_problem *problem;
};

/* After `v` or `vn`. What is no number is left to assimp. */
static int check_numbers(struct check *check, const char *text)
{
    char *end;

    for (int k = 0; k < 3; k++, text = end) {
        double value = strtod(text, &end);
        if (end == text)
            return SHEEN_OK;
        if (!isfinite((float)value))
            return sheen_problem(check->problem, SHEEN_ERR_ARGUMENT, "%s:%lu: '%.*s' is not a finite number",
                                 check->path, check->line, (int)strcspn(text + strspn(text, " \t"), " \t\r\n"),
                                 text + strspn(text, " \t"));
    }
    return SHEEN_OK;
}

/* An index of a face: from 1, or backwards from -1. */
static int check_index(struct check *check, struct counted *counted, long long index)
{
    if (index == 0 || -index > counted->count)
        return sheen_problem(check->problem, SHEEN_ERR_ARGUMENT, "%s:%lu: a face names %s %lld of %lld", check->path,
                             check->line, counted->what, index, counted->count);
    if (index > counted->highest) {
        counted->highest = index;
        counted->line = check->line;
    }
    return SHEEN_OK;
}

/* After `f`: corners v, v/vt, v//vn or v/vt/vn. */
static int check_face(struct check *check, const char *text)
{
    int error = SHEEN_OK;

    while (!error) {
        char *end;
        long long vertex = strtoll(text, &end, 10);
        if (end == text)
            return SHEEN_OK;
        error = check_index(check, &check->vertices, vertex);
        text = end;
        if (*text != '/')
            continue;
        strtoll(text + 1, &end, 10);
        text = end + (end == text); /* nothing between the slashes: the end is the beginning */
        if (*text == '/' && !error) {
            long long normal = strtoll(text + 1, &end, 10);
            if (end > text + 1)
                error = check_index(check, &check->normals, normal);
            text = end > text ? end : text + 1;
        }
    }
    return error;
}

static int check_line(struct check *check, const char *text)
{
    text += strspn(text, " \t");
    if (text[0] == 'v' && isspace((unsigned char)text[1])) {
        check->vertices.count++;
        return check_numbers(check, text + 1);
    }
    if (text[0] == 'v' && text[1] == 'n' && isspace((unsigned char)text[2])) {
        check->normals.count++;
        return check_numbers(check, text + 2);
    }
    return text[0] == 'f' && isspace((unsigned char)text[1]) ? check_face(check, text + 1) : SHEEN_OK;
}

/* A line, with those that a backslash at the end joins to it. The lines it took, or 0 at the end of the file. */
static unsigned long read_line(FILE *file, char **line, size_t *room)
{
    ssize_t length = getline(line, room, file);
    unsigned long lines = length >= 0;

    while (length >= 2 && (*line)[length - 1] == '\n' && (*line)[length - 2] == '\\') {
        char *more = NULL;
        size_t more_room = 0;
        ssize_t more_length = getline(&more, &more_room, file);
        char *joined = more_length > 0 ? realloc(*line, (size_t)(length + more_length)) : NULL;
        if (joined) {
            memcpy(joined + length - 2, more, (size_t)more_length + 1);
            *line = joined;
            *room = (size_t)(length + more_length);
            lines++;
        }
        length = joined ? length - 2 + more_length : 0;
        free(more);
    }
    return lines;
}

static int check_highest(struct check *check, const struct counted *counted)
{
    if (counted->highest <= counted->count)
        return SHEEN_OK;
    return sheen_problem(check->problem, SHEEN_ERR_ARGUMENT, "%s:%lu: a face names %s %lld of %lld", check->path,
                         counted->line, counted->what, counted->highest, counted->count);
}

int sheen_obj_check(const char *path, struct sheen_problem *problem)
{
    struct check check = {path, 1, {"vertex", 0, 0, 0}, {"normal", 0, 0, 0}, problem};
    size_t length = strlen(path), room = 0;
    char *line = NULL;
    int error = SHEEN_OK;

    if (length < 4 || strcasecmp(path + length - 4, ".obj") != 0)
        return SHEEN_OK;
    FILE *file = fopen(path, "rb");
    if (!file)
        return sheen_problem(problem, SHEEN_ERR_ARGUMENT, "%s: %s", path, strerror(errno));
    for (unsigned long took; !error && (took = read_line(file, &line, &room)) > 0; check.line += took)
        error = check_line(&check, line);
    fclose(file);
    free(line);
    if (!error)
        error = check_highest(&check, &check.vertices);
    return error ? error : check_highest(&check, &check.normals);
}
