/*
 * mesh_sink.h - where a reader puts what it finds: counted in a first pass, kept in a second.
 *
 * So no memory is taken on a file's word: its counts are what has come. Both passes
 * make the same calls in the same order.
 */
#ifndef SHEEN_MESH_SINK_H
#define SHEEN_MESH_SINK_H

#include "polygons.h"

#define SHEEN_NONE SIZE_MAX /* no normal, no uv */

struct sheen_sink {
    struct sheen_polygons *out; /* its arrays are there in the second pass; its notes in both */
    int keeping;                /* 1: the second pass */
    size_t points, normals, uvs, polygons, corners;
    size_t begun;            /* the corner that the polygon under way begins with */
    size_t groups;           /* 1, or more where the reader says so in the first pass */
    int has_colors;          /* of points or faces */
    double (*normal)[3];     /* all of them */
    double (*uv)[2];         /* likewise */
    uint8_t (*color)[3];     /* of each point, or NULL */
    uint8_t has_point_color; /* any */
};

/* color: sRGB, or NULL. */
void sheen_sink_point(struct sheen_sink *sink, const double point[3], const uint8_t color[3]);
void sheen_sink_normal(struct sheen_sink *sink, const double normal[3]);
/* v upwards, as in OBJ and PLY. */
void sheen_sink_uv(struct sheen_sink *sink, const double uv[2]);
/* All count from 0 and may be yet to come; normal and uv: or SHEEN_NONE. */
void sheen_sink_corner(struct sheen_sink *sink, size_t point, size_t normal, size_t uv);
/* The corners since the last polygon get these uv in place of what they have, one each, in order. */
void sheen_sink_corner_uvs(struct sheen_sink *sink, size_t first);
/* Ends the polygon of the corners since the last one. color: its own, for files without colours of points; or NULL. */
void sheen_sink_polygon(struct sheen_sink *sink, uint16_t group, const uint8_t color[3]);
/* Takes these corners back: they make no polygon. Returns how many there were. */
size_t sheen_sink_drop(struct sheen_sink *sink);

/* 0, or an error and its problem. context: the reader's own. */
typedef int sheen_sink_pass(void *context, struct sheen_sink *sink);

/*
 * Runs both passes into *out, zeroed or filled before; that corners name points, normals and uv that came is the
 * reader's to see. path: for messages. 0, or an error and *problem; a file without faces is one.
 */
int sheen_sink_run(struct sheen_polygons *out, sheen_sink_pass *pass, void *context, const char *path,
                   struct sheen_problem *problem);

/* A colour's part: 0..most to 0..255, rounded; no number is 0. */
uint8_t sheen_color_byte(double value, double most);

/*
 * What 1.0 is in a file that does not say so, from all its colours' parts: 255 where they are whole numbers of 0..255
 * and one is `least` or more, else 1: a part a little above 1 is just that.
 */
struct sheen_color_range {
    double largest; /* so far; 0 at first */
    int has_others; /* 1: a part is no byte's value */
};

void sheen_color_range_add(struct sheen_color_range *range, const double parts[3]);
double sheen_color_range_most(const struct sheen_color_range *range, double least);

#endif
