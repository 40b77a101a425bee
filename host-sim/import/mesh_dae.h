/*
 * mesh_dae.h - what mesh_dae_check.c keeps while it parses a file. Private to mesh_dae_*.c.
 */
#ifndef SHEEN_MESH_DAE_H
#define SHEEN_MESH_DAE_H

#include <expat.h>

#include "mesh_text.h"

enum {
    OFFSETS = 16, /* most inputs of a primitive */
    NAME = 128    /* bytes of an id; a longer one is refused */
};

/* A <source> with the numbers of its array, or a <vertices>, which refers to one. */
struct source {
    char id[NAME], same_as[NAME];
    long long accessor, stride, offset; /* its accessor's count, and its stride and offset in the array */
    long long numbers, promised;
};

/* An input's indices, which have to be in the source's range. */
struct use {
    char source[NAME];
    const char *what; /* "vertex", "normal" */
    long long highest;
    unsigned long line; /* of the highest index */
};

struct list {
    void *items;
    size_t count, room;
};

struct dae {
    XML_Parser parser;
    const char *path;
    struct sheen_problem *problem;
    int error;
    struct list sources, uses;
    struct source *source;    /* the one being parsed */
    char primitive[16];       /* <triangles> and the like, "" outside */
    long long count;          /* its attribute `count` */
    long long lists;          /* number of its <p> */
    long long corners, faces; /* as <vcount> says */
    long long stride;         /* indices per corner: the highest offset plus 1 */
    size_t use_at[OFFSETS];   /* by offset: 1 + the number in uses; 0: what it indexes is not used */
    int in_node;
    int shown;  /* instances, in nodes, of shapes and of other nodes */
    char *text; /* text of an element that holds numbers */
    size_t text_count, text_room;
    int keeps_text;
    unsigned long text_line;
};

static inline unsigned long line_of(const struct dae *dae)
{
    return (unsigned long)XML_GetCurrentLineNumber(dae->parser);
}

/* Reports the first fault, which ends the parsing. */
__attribute__((format(printf, 3, 4))) void sheen_dae_refuse(struct dae *dae, unsigned long line, const char *format,
                                                            ...);
void sheen_dae_no_memory(struct dae *dae);

/* Collects the text of an element that holds numbers; then what is done at that element's end. */
void XMLCALL sheen_dae_text(void *dae, const char *text, int length);
void sheen_dae_array(struct dae *dae);
void sheen_dae_vcount(struct dae *dae);
void sheen_dae_indices(struct dae *dae);

/* At the end of the file: checks what its primitives use. */
void sheen_dae_check_uses(struct dae *dae);

#endif
