/*
 * reference.h - the picture in double precision: what the integer core is measured against.
 *
 * Written from the definition of the picture alone (core/sheen.h says it); it
 * shares no code with the core. Plain and slow on purpose: every formula stands
 * here as it is printed, one pixel at a time.
 *
 *   ref_mesh.c     polygons -> fit, Newell normals, averages, triangles
 *   ref_between.c  a mesh between two frames of it
 *   ref_project.c  model -> eye -> near plane and guard band -> screen
 *   ref_light.c    ambient + diffuse and specular at a normal
 *   ref_raster.c   which triangle is seen at a pixel centre
 *   ref_shade.c    flat, Gouraud, Phong, slerp at a pixel centre
 *   ref_texture.c  texels at a pixel centre
 *   ref_pixel.c    colour -> 565 value or grey level
 *   ref_compare.c  which pixels may be compared, and how far they are apart
 *
 * Model and eye space are right-handed, the eye at the origin looking along -z;
 * m = -z. Screen: x right, y down, pixel (i, j) has its centre at (i + 1/2, j + 1/2).
 */
#ifndef REFERENCE_H
#define REFERENCE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* ---- mesh ---- */

/* Polygons as a file lists them. Polygon p has the corners first[p] .. first[p + 1] - 1. */
struct ref_polygons {
    const double (*points)[3];
    size_t point_count;
    const uint32_t *first; /* polygon_count + 1 entries */
    size_t polygon_count;
    const uint32_t *corners;    /* the point of each corner */
    const double (*normals)[3]; /* the file's normal of each corner, zero where it has none; or NULL */
    const double (*base)[3];    /* a base colour a polygon, or NULL: the scene's */
    const double (*uv)[2];      /* u, v of each corner, v downwards, or NULL */
    const double (*color)[3];   /* of each corner, or NULL */
};

struct ref_mesh_options {
    bool fit;             /* centre the bounding box, farthest used vertex at distance 1 */
    bool average_normals; /* ignore the file's normals */
    double crease;        /* degrees; < 0: off */
    bool equal_weights;   /* an average's polygons count alike, not by their angle at the corner */
};

struct ref_triangle {
    uint32_t corner[3]; /* into the mesh's corners */
    uint32_t polygon;
};

struct ref_mesh {
    size_t corner_count;
    double (*position)[3]; /* a corner */
    double (*normal)[3];   /* a corner: unit */
    uint32_t *weld;        /* a corner: equal where the positions are the same as 32-bit floats (ref_mesh.c) */
    size_t triangle_count;
    struct ref_triangle *triangles;
    size_t polygon_count;
    double (*polygon_normal)[3]; /* a polygon: unit, zero where it has no area */
    double (*base)[3];           /* a polygon, or NULL */
    double (*uv)[2];             /* a corner, or NULL */
    double (*color)[3];          /* a corner, or NULL */
    double (*center)[3];         /* a polygon: the mean of its corners */
};

/* 0, or -1 where memory is short or the polygons have no faces or no extent. Release with ref_mesh_free. */
int ref_mesh_build(struct ref_mesh *mesh, const struct ref_polygons *from, const struct ref_mesh_options *options);
void ref_mesh_free(struct ref_mesh *mesh);

/*
 * Between two frames of a mesh, equal but for positions and normals: (1 - k) first + k second, normals of unit length
 * again, where they cancel the first's. The rest is the first's. 0, or -1 where memory is short.
 */
int ref_mesh_between(struct ref_mesh *mesh, const struct ref_mesh *first, const struct ref_mesh *second, double k);

/* ---- scene ---- */

enum ref_shading {
    REF_FLAT = 0,
    REF_GOURAUD,
    REF_PHONG,
    REF_SLERP
};

/* Texels of 565, rows from the top. */
struct ref_texture {
    int width, height;
    const uint16_t *texels;
    bool clamp[2]; /* u, v; else they repeat */
    bool bilinear, keyed;
    uint16_t key;
    int bits; /* what the core is to keep a texel in: 16, 8, 4 */
};

/* What takes the place of max(0, L.N) in the diffuse light. */
enum ref_ramp {
    REF_LAMBERT = 0,
    REF_HALF,
    REF_GAMMA,
    REF_TOON
};
#define REF_RAMP_STEPS 256 /* of the table from L.N = -1 to 1, linear in between */

/* Where a pixel's texel is. */
enum ref_texels {
    REF_TEXELS_UV = 0,        /* at the mesh's uv */
    REF_TEXELS_NORMAL,        /* matcap: at ((1 + x) / 2, (1 - y) / 2) of the pixel's normal, in place of light */
    REF_TEXELS_CORNER_NORMALS /* likewise of the corners' normals, linear between */
};

#define REF_MAX_LIGHTS 4
#define REF_STEPS 65020
#define REF_GUARD_PX 511.0 /* the guard band: pixels from the picture's centre */

struct ref_scene {
    const struct ref_mesh *mesh;
    double rotation[9], scale, translation[3]; /* eye = scale * rotation * model + translation */
    int width, height;
    double fov;       /* vertical, degrees */
    double near, far; /* m of both planes */
    bool ortho;       /* project with `distance` in place of m */
    double distance;
    enum ref_shading shading;
    bool affine;
    bool two_sided;
    int light_count;
    double light[REF_MAX_LIGHTS][3]; /* to the light, eye space, any length but zero; of a point light: where it is, */
    double radius[REF_MAX_LIGHTS];   /* from the model's origin; how far it reaches, flat and Gouraud; 0: at infinity */
    double light_color[REF_MAX_LIGHTS][3], ambient_color[3];
    bool colored; /* by the mesh's colours, where it has some */
    double ambient, diffuse, specular, shininess;
    enum ref_ramp ramp;
    double base[3], highlight[3], background[3];
    int left_out, phase; /* of 64 pixels, by the matrix moved by phase columns; 0: all are drawn */
    bool fog;            /* from m = fog_from to fog_to */
    bool fog_in_m;       /* a fault: linear in m where it has to be in 1/m */
    double fog_from, fog_to, fog_color[3];
    int bias;   /* steps, REF_STEPS from far to near, that corners lie nearer, held to far and near */
    int levels; /* 0: RGB565; 2, 16, 256: grey */
    bool dither;
    const struct ref_texture *texture; /* NULL: none; by uv: flat or Gouraud, the mesh has uv; else Phong */
    enum ref_texels texels;
};

/* The defaults of the command line: 320x240, yaw 30, pitch 20, Phong, 565 without dither. */
void ref_scene_default(struct ref_scene *scene, const struct ref_mesh *mesh);

/* rotation = Rz(roll) * Rx(pitch) * Ry(yaw) in degrees; translation, near and far for an eye at (0, 0, distance). */
void ref_scene_orbit(struct ref_scene *scene, double yaw, double pitch, double roll, double distance);

/* ---- picture ---- */

struct ref_pixel {
    bool covered;
    bool back;         /* a back face, its normals negated */
    uint32_t triangle; /* of the mesh */
    uint32_t polygon;
    uint32_t piece;  /* of ref_picture.pieces */
    double m;        /* depth in front of the eye */
    double z;        /* what is left in depth: 0 far, 1 near */
    double color[3]; /* 0..1, unrounded */
    int tread;       /* ref_tread at its centre */
    double specular; /* I_specular, the largest channel's */
    uint16_t value;  /* 565 value or grey level */
    bool dropped;    /* a transparent texel lies here, */
    bool unsettled;  /* or may lie, in front of what is seen */
};

/* Light, by channel: what the base colour and what the highlight's is multiplied by. */
struct ref_lit {
    double diffuse[3], specular[3];
};

/* A triangle, or what the planes left of it, on the screen. */
struct ref_piece {
    double x[3], y[3], w[3]; /* px; w: the weight 1/m (1 under ortho) */
    double depth[3];         /* linear on the screen, larger is nearer: 1/m, under ortho -m */
    double z[3];             /* likewise: 0 far, 1 near, biased; what hides and what is fogged */
    double normal[3][3];     /* eye space, turned to the eye's side on a drawn back face */
    struct ref_lit lit[3];   /* flat, Gouraud: at the corners, the vertices' colours in it */
    double uv[3][2], color[3][3];
    uint32_t triangle, polygon;
    bool back;
};

struct ref_picture {
    int width, height;
    struct ref_pixel *pixels;
    struct ref_piece *pieces;
    size_t piece_count;
    double uv_span[2]; /* largest less smallest u, v of the mesh */
};

/* 0, or -1 where memory is short. Release with ref_picture_free. */
int ref_render(struct ref_picture *picture, const struct ref_scene *scene);
void ref_picture_free(struct ref_picture *picture);

/* ---- stages, open to the reference's own tests ---- */

int ref_project(struct ref_picture *picture, const struct ref_scene *scene);
void ref_raster(struct ref_picture *picture, const struct ref_scene *scene);
/* At a point and its normal, both in eye space. */
void ref_light(const struct ref_scene *scene, const double at[3], const double normal[3], struct ref_lit *lit);
/* The ramp at L.N = x, -1..1. */
double ref_ramp(const struct ref_scene *scene, double x);
/* Light of a piece at the point (x, y) of the screen, which for slerp lies on the scan line of a row. */
void ref_shade(const struct ref_scene *scene, const struct ref_piece *piece, double x, double y, struct ref_lit *lit);
/* The vertices' colours there, white where the scene has none: what of light at the pixel, or a matcap, they leave. */
void ref_color(const struct ref_scene *scene, const struct ref_piece *piece, double x, double y, double color[3]);
/* The corners' weights at a point of the screen, in space or, under affine, on the screen. */
void ref_weights(const struct ref_scene *scene, const struct ref_piece *piece, double x, double y, double b[3]);
/* U and V, in texels, there. */
void ref_texture_point(const struct ref_scene *scene, const struct ref_piece *piece, double x, double y,
                       double texels[2]);
uint16_t ref_texel(const struct ref_texture *texture, int i, int j);
/* False where the nearest texel is transparent. */
bool ref_texture_color(const struct ref_texture *texture, const double texels[2], double color[3]);
/*
 * Whether what is seen there does not hang on 1/16 texel, 1/16 px or the coordinates' rounding; *bound: steps that a
 * channel may be off by.
 */
bool ref_settled(const struct ref_scene *scene, const struct ref_picture *picture, const struct ref_piece *piece,
                 double x, double y, double *bound);
/*
 * A toon ramp's steps are jumps; where light is computed at the pixel (phong, slerp), these lie on the picture as edges
 * do. Which tread of the stairs each light falls on there, as one number >= 0; -1: one falls on a riser. 0 where there
 * are no jumps.
 */
int ref_tread(const struct ref_scene *scene, const struct ref_piece *piece, double x, double y);
/* Great arc between unit vectors; equal ends: a; opposite ends: a while t < 1/2, else b. */
void ref_slerp(const double a[3], const double b[3], double t, double out[3]);
bool ref_inside(const struct ref_piece *piece, double x, double y);
/* Distance of a point of the screen from side k of a piece, between its corners k and k + 1; px. */
double ref_side_distance(const struct ref_piece *piece, int side, double x, double y);
uint16_t ref_565(const double color[3]);
int ref_bayer8(int x, int y);
/* At a pixel's z. */
double ref_fog_share(const struct ref_scene *scene, double z);
/* 0 far, 1 near, of what is m before the eye; not biased. */
double ref_nearness(const struct ref_scene *scene, double m);
/* Of a colour that is drawn, under so much fog; of any without. */
uint16_t ref_fogged_value(const struct ref_scene *scene, const double color[3], double share, int x, int y);
uint16_t ref_value(const struct ref_scene *scene, const double color[3], int x, int y, bool background);

/* ---- comparison ---- */

/*
 * Bilinear texels turn an error of 1/16 texel and 1/16 px into as large a part of their difference. Of what rounds to
 * another value for that, some 4 % come with each step: up to here a share of equal pixels is owed.
 */
#define REF_CALM 2.0

struct ref_score {
    long covered, compared, equal, within_one;
    long comparable;                 /* compared, or with a texture not settled */
    long beyond;                     /* of the compared: off by more than the texels there allow */
    long calm, calm_equal;           /* of the compared: where texels allow no more than REF_CALM steps besides 1 */
    long dropped, dropped_drawn;     /* settled transparent pixels with nothing behind; those that are not background */
    int worst;                       /* steps of a channel, or grey levels */
    int worst_x, worst_y;            /* where */
    long highlight, highlight_equal; /* of the compared: I_specular > 1/63 */
    uint32_t cause;                  /* the triangle at the worst pixel */
};

/*
 * Compare 565 values or grey levels (width * height, row by row) at the pixels whose 3x3
 * neighbourhood belongs to triangles joined through shared edges with equal
 * corner normals and uv (flat: one polygon), without a jump in depth above 2 %
 * and without one of a toon ramp (ref_tread), and whose texels, if any, are settled.
 * Adds to *score. 0, or -1 where memory is short.
 */
int ref_compare(struct ref_score *score, const struct ref_scene *scene, const struct ref_picture *picture,
                const uint16_t *values);

#endif
