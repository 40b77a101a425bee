/*
 * host_mesh.h - a mesh ready to be drawn, in double precision: fitted, with normals, split into triangles.
 *
 *   name -> polygons -> host mesh -> quantise.h -> the core's struct sheen_mesh
 *
 * The rules, in the order in which they are applied:
 *   - points with bit-equal positions (as 32-bit floats, -0 counting as 0) are one vertex. On an axis on
 *     which the centre of the bounding box is farther from 0 than 16 times the box's longest side
 *     (georeferenced files) the distance from that centre is compared instead: different floats stay
 *     different, so a file of 32-bit floats welds the same either way, and doubles keep the digits that
 *     floats do not have;
 *   - a polygon's normal is Newell's, over the whole polygon; a polygon without area is
 *     dropped, though its points count for the fit;
 *   - fit, in double precision: the centre of the bounding box moves to 0, the farthest point to distance 1;
 *   - a corner's normal is the file's; without one, the average over the polygons around
 *     its vertex (unit normals weighted by the angle at the corner, once for each time a
 *     polygon lists the vertex); if that is zero, its polygon's;
 *   - uv and colours belong to the corner: vertices at the same place may differ in them;
 *   - polygons are split into triangles;
 *   - if there are more triangles than wanted, they are reduced (host_reduce.h).
 * Normals and triangles are the core's own (core/mesh/), as firmware gets them.
 */
#ifndef SHEEN_HOST_MESH_H
#define SHEEN_HOST_MESH_H

#include "textures.h"

#define SHEEN_HOST_MESH_MAX 65535u /* vertices, and triangles: what 16-bit indices hold */

enum sheen_up {
    SHEEN_UP_FORMAT, /* z if the file's format says so (struct sheen_polygons), else y */
    SHEEN_UP_Y,
    SHEEN_UP_Z /* (x, y, z) becomes (x, z, -y) */
};

struct sheen_host_options {
    int average;     /* 1: the file's normals are not used */
    int by_group;    /* 1: groups share no vertices; each becomes a mesh of its own */
    int use_crease;  /* 1: average only over polygons within `crease` of the corner's own */
    double crease;   /* degrees, 0..180 */
    int equal;       /* 1: polygons have equal weights in an average, not their angle at the corner */
    int up;          /* enum sheen_up; of a file's polygons, before anything else */
    unsigned reduce; /* to at most so many triangles (host_reduce.h), 1..SHEEN_HOST_MESH_MAX; 0: never */
    int colors;      /* 1: corners keep the file's colours */
    const struct sheen_texture_options *textures; /* borrowed; NULL: no textures are read */
    const char *morph;                            /* the name of another frame of the mesh, see below; NULL: none */
    unsigned morph_target;                        /* its morph target, if it is a glTF file with any */
};

struct sheen_host_vertex {
    double position[3]; /* after the fit: |position| <= 1 */
    double normal[3];   /* unit */
    double uv[2];       /* v downwards; 0 without */
    uint32_t weld;      /* equal for vertices at the same place, which differ in other fields */
    uint32_t group;     /* 0 unless by_group or a texture is shown */
    uint32_t has_uv;    /* 1: belongs to faces that show a texture */
    uint8_t color[4];   /* this corner's in the file, sRGB, and 255; white if it has none */
};

struct sheen_host_polygon {
    double normal[3];      /* Newell's, unit */
    uint32_t first, count; /* its corners */
    uint32_t group;        /* the file's, also without by_group */
    uint32_t part;
};

/* What is drawn at once: faces that show the same texture, with by_group of one material. In order of both. */
struct sheen_host_part {
    uint32_t group;   /* 0 unless by_group */
    uint32_t picture; /* 1 + its number; 0: no texture */
};

struct sheen_host_triangle {
    uint32_t vertex[3];
    uint32_t polygon;
};

/*
 * Another frame of a mesh: the same polygons with other positions. Both are fitted together. A polygon without area in
 * the first frame is dropped, one without area here has a normal of zero. Normals are made by the same rules, from this
 * frame alone.
 */
struct sheen_host_frame {
    double (*positions)[3], (*normals)[3]; /* per vertex; NULL: there is no other frame */
    double (*polygon_normals)[3];
};

struct sheen_host_mesh {
    struct sheen_host_vertex *vertices;
    size_t vertex_count; /* 3..SHEEN_HOST_MESH_MAX */
    struct sheen_host_polygon *polygons;
    size_t polygon_count;
    uint32_t *corners; /* per corner of the polygons: its vertex */
    size_t corner_count;
    struct sheen_host_triangle *triangles; /* in the polygons' order */
    size_t triangle_count;                 /* 1..SHEEN_HOST_MESH_MAX */
    struct sheen_group *group;             /* the file's materials */
    size_t group_count;
    struct sheen_picture *picture; /* the file's textures that are shown */
    size_t picture_count;
    int has_colors; /* 1: some vertex has a colour from the file */
    struct sheen_host_part *part;
    size_t part_count; /* 1 or more */
    struct sheen_host_frame second;
    double crease;            /* the options', degrees; 180 if none was used: no edge is sharp */
    double center[3], radius; /* fitted = (file - center) / radius */
    uint8_t z_up;             /* as in the polygons, and so are the notes */
    struct sheen_notes notes;
};

/*
 * Polygons to a host mesh; `name` is for *problem. 0, SHEEN_ERR_ARGUMENT (no faces,
 * no extent), SHEEN_ERR_CAPACITY (more vertices or triangles than 16 bits number) or
 * SHEEN_ERR_MEMORY. On error nothing is left to free.
 */
int sheen_host_mesh_build(struct sheen_host_mesh *mesh, const struct sheen_polygons *polygons,
                          const struct sheen_host_options *options, const char *name, struct sheen_problem *problem);
void sheen_host_mesh_free(struct sheen_host_mesh *mesh);

/* The same by name: "builtin:..." or a file. textures may be NULL. Errors as above, and the reader's. */
int sheen_polygons_load(struct sheen_polygons *polygons, const char *name, const struct sheen_texture_options *textures,
                        struct sheen_problem *problem);
int sheen_host_mesh_load(struct sheen_host_mesh *mesh, const char *name, const struct sheen_host_options *options,
                         struct sheen_problem *problem);

#endif
