/*
 * mesh_wire.c - sends polygons through a pipe. Both ends are the same program on the same machine.
 */
#include "mesh_wire.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "utf8.h"

/* The most bytes that are received; no mesh that can be drawn comes near this. */
#define MAX_BYTES ((uint64_t)512 << 20)

struct header {
    int32_t error;
    uint32_t with; /* SHEEN_WITH_... */
    uint32_t z_up;
    uint64_t points, polygons, corners, groups, pictures;
    struct sheen_problem problem;
    struct sheen_notes notes;
};

/* One array of the polygons and its size in bytes. */
struct part {
    void *bytes;
    size_t count;
};

enum {
    PARTS = 8
};

static void list_parts(const struct sheen_polygons *p, struct part parts[PARTS])
{
    parts[0] = (struct part){p->points, p->point_count * sizeof *p->points};
    parts[1] = (struct part){p->first, (p->polygon_count + 1) * sizeof *p->first};
    parts[2] = (struct part){p->corners, p->corner_count * sizeof *p->corners};
    parts[3] = (struct part){p->normals, p->normals ? p->corner_count * sizeof *p->normals : 0};
    parts[4] = (struct part){p->groups, p->polygon_count * sizeof *p->groups};
    parts[5] = (struct part){p->group, p->group_count * sizeof *p->group};
    parts[6] = (struct part){p->colors, p->colors ? p->corner_count * sizeof *p->colors : 0};
    parts[7] = (struct part){p->uvs, p->uvs ? p->corner_count * sizeof *p->uvs : 0};
}

static int send_all(int pipe, const void *bytes, size_t count)
{
    const char *at = bytes;

    while (count > 0) {
        ssize_t sent = write(pipe, at, count);
        if (sent < 0 && errno == EINTR)
            continue;
        if (sent < 0)
            return -1;
        at += sent;
        count -= (size_t)sent;
    }
    return 0;
}

/* Returns 1, or 0 if the pipe ends or fails first. */
static int receive_all(int pipe, void *bytes, size_t count)
{
    char *at = bytes;

    while (count > 0) {
        ssize_t got = read(pipe, at, count);
        if (got < 0 && errno == EINTR)
            continue;
        if (got <= 0)
            return 0;
        at += got;
        count -= (size_t)got;
    }
    return 1;
}

/* Sends a picture that has been read: its struct, then its texels. */
static int send_picture(int pipe, const struct sheen_picture *picture)
{
    int failed = send_all(pipe, picture, sizeof *picture);

    return failed ? failed : send_all(pipe, picture->rgba, 4 * (size_t)picture->size[0] * picture->size[1]);
}

int sheen_mesh_send(int pipe, int error, const struct sheen_polygons *polygons, const struct sheen_problem *problem)
{
    struct header header;
    struct part parts[PARTS];

    memset(&header, 0, sizeof header);
    header.error = error;
    if (error) {
        header.problem = *problem;
        return send_all(pipe, &header, sizeof header);
    }
    header.with = (polygons->normals ? SHEEN_WITH_NORMALS : 0) | (polygons->colors ? SHEEN_WITH_COLORS : 0) |
                  (polygons->uvs ? SHEEN_WITH_UVS : 0);
    header.z_up = polygons->z_up;
    header.notes = polygons->notes;
    header.points = polygons->point_count;
    header.polygons = polygons->polygon_count;
    header.corners = polygons->corner_count;
    header.groups = polygons->group_count;
    header.pictures = polygons->picture_count;
    int failed = send_all(pipe, &header, sizeof header);
    list_parts(polygons, parts);
    for (int i = 0; !failed && i < PARTS; i++)
        failed = send_all(pipe, parts[i].bytes, parts[i].count);
    for (size_t i = 0; !failed && i < polygons->picture_count; i++)
        failed = send_picture(pipe, &polygons->picture[i]);
    return failed;
}

/* Checks each count first, so that the sum of their bytes does not wrap. */
static int is_reasonable(const struct header *h)
{
    if (h->points > MAX_BYTES || h->polygons > MAX_BYTES || h->corners > MAX_BYTES || h->groups > UINT16_MAX + 1u ||
        h->pictures > h->groups)
        return 0;
    uint64_t bytes = h->points * 3 * sizeof(double) + h->polygons * 6 + h->groups * sizeof(struct sheen_group) +
                     h->corners * (4 + (h->with & SHEEN_WITH_NORMALS ? 3 * sizeof(double) : 0) + 3 +
                                   (h->with & SHEEN_WITH_UVS ? 2 * sizeof(double) : 0)) +
                     h->pictures * sizeof(struct sheen_picture);
    return bytes <= MAX_BYTES && h->groups > 0;
}

/* Keeps at most SHEEN_NOTES_MAX notes and terminates their text, whatever was sent. */
static void receive_notes(struct sheen_polygons *polygons, struct header *header)
{
    for (uint32_t i = 0; i < header->notes.count && i < SHEEN_NOTES_MAX; i++) {
        struct sheen_note *note = &header->notes.note[i];
        note->line.text[sizeof note->line.text - 1] = '\0';
        sheen_note(&polygons->notes, note->kind == SHEEN_NOTE_ON_COLORS ? SHEEN_NOTE_ON_COLORS : SHEEN_NOTE_WARNING,
                   "%s", note->line.text);
    }
}

/* Checks each picture's size before it is used. */
static int receive_pictures(int pipe, struct sheen_polygons *polygons, uint64_t count)
{
    uint64_t bytes = 0;

    polygons->picture = calloc(count + 1, sizeof *polygons->picture);
    for (; polygons->picture && polygons->picture_count < count; polygons->picture_count++) {
        struct sheen_picture *picture = &polygons->picture[polygons->picture_count];
        size_t texels = receive_all(pipe, picture, sizeof *picture) ? (size_t)picture->size[0] * picture->size[1] : 0;
        picture->name = NULL;
        picture->bytes = NULL;
        bytes += 4 * (uint64_t)texels;
        picture->rgba = texels && bytes <= MAX_BYTES ? malloc(4 * texels) : NULL;
        if (!picture->rgba || !receive_all(pipe, picture->rgba, 4 * texels)) {
            polygons->picture_count++; /* so that it is freed */
            return 0;
        }
    }
    return polygons->picture != NULL;
}

int sheen_mesh_receive(int pipe, int *error, struct sheen_polygons *polygons, struct sheen_problem *problem)
{
    struct header header;
    struct part parts[PARTS];

    memset(polygons, 0, sizeof *polygons);
    if (!receive_all(pipe, &header, sizeof header))
        return 0;
    *error = header.error;
    if (header.error) {
        header.problem.text[sizeof header.problem.text - 1] = '\0';
        sheen_problem(problem, 0, "%s", header.problem.text); /* one line, whatever was sent */
        return header.error < 0;
    }
    if (!is_reasonable(&header) || sheen_polygons_alloc(polygons, header.points, header.polygons, header.corners,
                                                        header.groups, (int)header.with) != 0)
        return 0;
    list_parts(polygons, parts);
    for (int i = 0; i < PARTS; i++) {
        if (!receive_all(pipe, parts[i].bytes, parts[i].count))
            return 0;
    }
    if (!receive_pictures(pipe, polygons, header.pictures))
        return 0;
    receive_notes(polygons, &header);
    polygons->z_up = header.z_up != 0;
    for (size_t g = 0; g < polygons->group_count; g++) {
        char *name = polygons->group[g].name;
        name[sizeof polygons->group[g].name - 1] = '\0';
        sheen_utf8_clean(name);
    }
    return 1;
}
