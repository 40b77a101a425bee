/*
 * ply_check.c - the header of a PLY file.
 */
#include "ply_check.h"

#include <ctype.h>
#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <strings.h>

/* A header line of a longer file is refused rather than searched: real ones are below 100 bytes. */
#define MAX_LINE 4096

/* `word` alone on the line, in any case, as assimp takes it. */
static int is_word(const char *line, const char *word)
{
    size_t length = strlen(word);

    line += strspn(line, " \t");
    return strncasecmp(line, word, length) == 0 && (line[length] == '\0' || isspace((unsigned char)line[length]));
}

int sheen_ply_check(const char *path, struct sheen_problem *problem)
{
    char line[MAX_LINE];
    FILE *file = fopen(path, "rb");

    if (!file)
        return sheen_problem(problem, SHEEN_ERR_ARGUMENT, "%s: %s", path, strerror(errno));
    int is_ply = fgets(line, sizeof line, file) && is_word(line, "ply");
    int found = 0;
    unsigned long number = 1;
    while (is_ply && !found && fgets(line, sizeof line, file) && strchr(line, '\n')) {
        found = is_word(line, "end_header");
        number++;
    }
    fclose(file);
    if (!is_ply || found)
        return SHEEN_OK;
    return sheen_problem(problem, SHEEN_ERR_ARGUMENT, "%s:%lu: the header has no end_header", path, number);
}
