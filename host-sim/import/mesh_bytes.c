/*
 * mesh_bytes.c - a whole file in memory.
 */
#include "mesh_bytes.h"

#include <errno.h>
#include <fcntl.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "confine.h"

/* Returns the bytes read, fewer than `count` if the file has shrunk meanwhile, or -1 and errno. */
static ssize_t read_all(int file, unsigned char *bytes, size_t count)
{
    size_t got = 0;

    while (got < count) {
        ssize_t more = read(file, bytes + got, count - got);
        if (more < 0 && errno == EINTR)
            continue;
        if (more < 0)
            return -1;
        if (more == 0)
            break;
        got += (size_t)more;
    }
    return (ssize_t)got;
}

int sheen_bytes_load(struct sheen_bytes *bytes, const char *path, struct sheen_problem *problem)
{
    struct stat status;
    int file = open(path, O_RDONLY | O_NONBLOCK | O_CLOEXEC); /* O_NONBLOCK: does not wait for the writer of a pipe */

    *bytes = (struct sheen_bytes){NULL, 0};
    if (file < 0)
        return sheen_problem(problem, SHEEN_ERR_ARGUMENT, "%s: %s", path, strerror(errno));
    int error = fstat(file, &status) ? errno : S_ISREG(status.st_mode) ? 0 : S_ISDIR(status.st_mode) ? EISDIR : ENODEV;
    if (!error) {
        sheen_confine_file(file);
        bytes->bytes = malloc((size_t)status.st_size + 1);
        ssize_t got = bytes->bytes ? read_all(file, bytes->bytes, (size_t)status.st_size) : -1;
        error = got < 0 ? errno : 0;
        bytes->count = got < 0 ? 0 : (size_t)got;
        if (bytes->bytes)
            bytes->bytes[bytes->count] = 0;
    }
    close(file);
    return error ? sheen_problem(problem, SHEEN_ERR_ARGUMENT, "%s: %s", path,
                                 error == ENODEV ? "not a regular file" : strerror(error))
                 : SHEEN_OK;
}

void sheen_bytes_free(struct sheen_bytes *bytes)
{
    free(bytes->bytes);
    *bytes = (struct sheen_bytes){NULL, 0};
}

/* Returns the number of bytes written. */
static size_t put_utf8(unsigned char *out, uint32_t code)
{
    if (code < 0x80) {
        out[0] = (unsigned char)code;
        return 1;
    }
    size_t more = code < 0x800 ? 1 : code < 0x10000 ? 2 : 3;
    for (size_t i = more; i > 0; i--, code >>= 6)
        out[i] = (unsigned char)(0x80 | (code & 0x3f));
    out[0] = (unsigned char)(0xf0 << (3 - more) | code); /* 110x, 1110, 1111 0xxx */
    return more + 1;
}

/* A unit of 2 bytes becomes at most 3 bytes of UTF-8; a surrogate pair of 4 bytes becomes 4. */
static int from_utf16(struct sheen_bytes *bytes, int big)
{
    unsigned char *out = malloc(bytes->count / 2 * 3 + 1);
    size_t made = 0;
    uint32_t high = 0; /* a high surrogate whose low half is still to come */

    if (!out)
        return SHEEN_ERR_MEMORY;
    for (size_t i = 2; i + 1 < bytes->count; i += 2) {
        uint32_t unit = (uint32_t)bytes->bytes[i + !big] << 8 | bytes->bytes[i + (size_t)big];
        if (high && unit >> 10 == 0x37)
            made += put_utf8(out + made, 0x10000 + ((high & 0x3ff) << 10) + (unit & 0x3ff));
        else if (unit >> 10 != 0x36)
            made += put_utf8(out + made, unit >> 10 == 0x37 ? '?' : unit);
        high = unit >> 10 == 0x36 ? unit : 0;
    }
    out[made] = 0;
    free(bytes->bytes);
    *bytes = (struct sheen_bytes){out, made};
    return SHEEN_OK;
}

int sheen_bytes_to_utf8(struct sheen_bytes *bytes)
{
    const unsigned char *b = bytes->bytes;

    if (bytes->count >= 2 && (memcmp(b, "\xff\xfe", 2) == 0 || memcmp(b, "\xfe\xff", 2) == 0))
        return from_utf16(bytes, b[0] == 0xfe);
    if (bytes->count >= 3 && memcmp(b, "\xef\xbb\xbf", 3) == 0) {
        memmove(bytes->bytes, b + 3, bytes->count - 2); /* with the final zero */
        bytes->count -= 3;
    }
    return SHEEN_OK;
}

int sheen_beside(char *out, size_t room, const char *path, const char *name, size_t length)
{
    const char *slash = strrchr(path, '/');
    size_t folder = slash && name[0] != '/' ? (size_t)(slash + 1 - path) : 0;

    if (folder + length + 1 > room)
        return -1;
    memcpy(out, path, folder);
    memcpy(out + folder, name, length);
    out[folder + length] = '\0';
    for (char *c = out + folder; *c; c++)
        *c = *c == '\\' ? '/' : *c; /* the path was written on Windows */
    return 0;
}

char *sheen_picture_beside(const char *path, const char *name, size_t length)
{
    char found[4096], beside[4096];

    if (sheen_beside(found, sizeof found, path, name, length) != 0)
        return strndup(name, length);
    const char *bare = strrchr(found, '/');
    if (access(found, F_OK) != 0 && bare &&
        sheen_beside(beside, sizeof beside, path, bare + 1, strlen(bare + 1)) == 0 && access(beside, F_OK) == 0)
        return strdup(beside);
    return strdup(found);
}
