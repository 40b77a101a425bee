/*
 * mesh_sink.h - where a reader puts what it finds: counted in a first pass, stored in a second.
 *
 * So no memory is allocated on a file's word: counts are those of the data. Both passes
 * make the same calls in the same order.
 */
#ifndef SHEEN_MESH_SINK_H
#define SHEEN_MESH_SINK_H

#include "polygons.h"

#define SHEEN_NONE SIZE_MAX /* no normal, no uv */

struct sheen_sink {
    struct sheen_polygons *out; /* its arrays exist in the second pass only, its notes in both */
    int keeping;                /* 1: the second pass */
    size_t points, normals, uvs, polygons, corners;
    size_t begun;            /* the first corner of the polygon under way */
    size_t groups;           /* 1, or more if the reader says so in the first pass */
    int has_colors;          /* 1: points or faces have colours */
    double (*normal)[3];     /* all normals */
    double (*uv)[2];         /* all texture coordinates */
    uint8_t (*color)[3];     /* of each point, or NULL */
    uint8_t has_point_color; /* 1: some point has a colour */
};

/* color: sRGB, or NULL. */
void sheen_sink_point(struct sheen_sink *sink, const double point[3], const uint8_t color[3]);
void sheen_sink_normal(struct sheen_sink *sink, const double normal[3]);
/* v upwards, as in OBJ and PLY. */
void sheen_sink_uv(struct sheen_sink *sink, const double uv[2]);
/* All indices count from 0 and may refer to what is yet to come; normal and uv may be SHEEN_NONE. */
void sheen_sink_corner(struct sheen_sink *sink, size_t point, size_t normal, size_t uv);
/* Replaces the uv of the corners since the last polygon, one for each, in order. */
void sheen_sink_corner_uvs(struct sheen_sink *sink, size_t first);
/* Makes a polygon of the corners since the last one. color: its own, in files without colours of points; or NULL. */
void sheen_sink_polygon(struct sheen_sink *sink, uint16_t group, const uint8_t color[3]);
/* Drops those corners instead. Returns how many there were. */
size_t sheen_sink_drop(struct sheen_sink *sink);

/* 0, or an error and its problem. context: the reader's own. */
typedef int sheen_sink_pass(void *context, struct sheen_sink *sink);

/*
 * Runs both passes into *out, which is zeroed or filled already. It is up to the reader that corners refer to existing
 * points, normals and uv. path: for messages. 0, or an error and *problem; a file without faces is an error.
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
