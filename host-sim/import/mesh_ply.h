/*
 * mesh_ply.h - a PLY file's header. Private to mesh_ply*.c.
 */
#ifndef SHEEN_MESH_PLY_H
#define SHEEN_MESH_PLY_H

#include "mesh_text.h"

enum {
    PLY_ELEMENTS = 16,  /* more than any known file has */
    PLY_PROPERTIES = 64 /* per element */
};

enum sheen_ply_type {
    PLY_NONE = 0,
    PLY_INT8,
    PLY_UINT8,
    PLY_INT16,
    PLY_UINT16,
    PLY_INT32,
    PLY_UINT32,
    PLY_FLOAT,
    PLY_DOUBLE
};

struct sheen_ply_property {
    struct sheen_word name;
    enum sheen_ply_type type, count_type; /* count_type: a list's; PLY_NONE if it is no list */
};

struct sheen_ply_element {
    struct sheen_word name;
    int64_t count;
    struct sheen_ply_property property[PLY_PROPERTIES];
    int properties;
};

struct sheen_ply {
    struct sheen_bytes bytes;
    struct sheen_text text;
    enum {
        PLY_ASCII,
        PLY_LITTLE,
        PLY_BIG
    } format;
    struct sheen_ply_element element[PLY_ELEMENTS];
    int elements;
    const char *body;
    unsigned long body_line;
    size_t vertices;           /* as the header says */
    struct sheen_word picture; /* the first one that a comment names; length 0: none */
    int ended;                 /* 1: a number was missing because the file had ended */
};

/* Reads the header; the body begins at ply->body. 0, or an error with the line. */
int sheen_ply_header(struct sheen_ply *ply);

/* Size in bytes of a number in a binary file. */
size_t sheen_ply_size(enum sheen_ply_type type);

/* The body's next number. 0, or an error: ply->ended, or *problem says what is there instead. */
int sheen_ply_number(struct sheen_ply *ply, enum sheen_ply_type type, double *value);

/* The same for a whole number; messages call it `what`. */
int sheen_ply_whole(struct sheen_ply *ply, enum sheen_ply_type type, const char *what, double *value);

/* "PATH:LINE: ..." or "PATH: byte N: ..." */
__attribute__((format(printf, 2, 3))) int sheen_ply_problem(const struct sheen_ply *ply, const char *format, ...);

#endif
