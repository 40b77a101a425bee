/*
 * mesh_assimp_io.c - opens files for assimp in the same way as for our own readers (mesh_bytes.h), so that their sizes
 * raise the memory limit and no pipe is waited for.
 */
#include "mesh_assimp_io.h"

#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "mesh_bytes.h"

struct opened {
    struct aiFile file; /* first member: assimp passes a pointer to it back */
    struct sheen_bytes bytes;
    size_t at;
};

static struct opened *opened_of(struct aiFile *file)
{
    return (struct opened *)(void *)file;
}

static size_t read_items(struct aiFile *file, char *to, size_t size, size_t count)
{
    struct opened *opened = opened_of(file);
    size_t left = size ? (opened->bytes.count - opened->at) / size : 0;

    count = count < left ? count : left;
    memcpy(to, opened->bytes.bytes + opened->at, count * size);
    opened->at += count * size;
    return count;
}

static size_t write_nothing(struct aiFile *file, const char *from, size_t size, size_t count)
{
    (void)file, (void)from, (void)size, (void)count;
    return 0;
}

static size_t tell(struct aiFile *file)
{
    return opened_of(file)->at;
}

static size_t size_of(struct aiFile *file)
{
    return opened_of(file)->bytes.count;
}

/* A backward offset has wrapped around; so does the sum, which is therefore right. */
static enum aiReturn seek(struct aiFile *file, size_t offset, enum aiOrigin origin)
{
    struct opened *opened = opened_of(file);
    size_t from = origin == aiOrigin_SET ? 0 : origin == aiOrigin_CUR ? opened->at : opened->bytes.count;

    if (from + offset > opened->bytes.count)
        return aiReturn_FAILURE;
    opened->at = from + offset;
    return aiReturn_SUCCESS;
}

static void flush(struct aiFile *file)
{
    (void)file;
}

/*
 * COLLADA's convex_mesh, a body for collisions, has the contents of a mesh, but assimp leaves it out. Renamed to mesh
 * it is read; blanks after the new name, which XML allows, keep the length.
 */
static void rename_convex_meshes(struct sheen_bytes *bytes)
{
    static const char *const names[] = {"<convex_mesh", "</convex_mesh"};
    static const char *const as[] = {"<mesh       ", "</mesh       "};

    for (int i = 0; i < 2; i++) {
        size_t length = strlen(names[i]);
        char *at = (char *)bytes->bytes, *end = at + bytes->count;
        while ((at = memmem(at, (size_t)(end - at), names[i], length)) != NULL) {
            memcpy(at, as[i], length);
            at += length;
        }
    }
}

static struct aiFile *open_file(struct aiFileIO *io, const char *path, const char *mode)
{
    struct opened *opened = strchr(mode, 'w') || strchr(mode, 'a') ? NULL : calloc(1, sizeof *opened);
    struct sheen_problem problem;
    size_t length = strlen(path);

    (void)io;
    if (!opened || sheen_bytes_load(&opened->bytes, path, &problem) != 0) {
        free(opened);
        return NULL;
    }
    (void)sheen_bytes_to_utf8(&opened->bytes); /* not all readers of assimp know UTF-16 */
    if (length > 4 && strcasecmp(path + length - 4, ".dae") == 0)
        rename_convex_meshes(&opened->bytes);
    opened->file = (struct aiFile){.ReadProc = read_items,
                                   .WriteProc = write_nothing,
                                   .TellProc = tell,
                                   .FileSizeProc = size_of,
                                   .SeekProc = seek,
                                   .FlushProc = flush};
    return &opened->file;
}

static void close_file(struct aiFileIO *io, struct aiFile *file)
{
    (void)io;
    sheen_bytes_free(&opened_of(file)->bytes);
    free(opened_of(file));
}

struct aiFileIO sheen_assimp_io = {.OpenProc = open_file, .CloseProc = close_file};
