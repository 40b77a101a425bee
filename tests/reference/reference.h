/*
 * reference.h - the picture in double precision: what the integer core is measured against.
 *
 * Written only from the definition of the picture in core/sheen.h; it shares no code with the core. It is plain and
 * slow on purpose: every formula is written as it is printed, one pixel at a time.
 *
 *   ref_mesh.c     polygons -> fit, Newell normals, averages, triangles
 *   ref_between.c  two frames of a mesh -> a mesh between them
 *   ref_project.c  model -> eye -> near plane and guard band -> screen
 *   ref_light.c    ambient + diffuse and specular at a normal
 *   ref_raster.c   which triangle is seen at a pixel centre
 *   ref_shade.c    flat, Gouraud, Phong, slerp at a pixel centre
 *   ref_texture.c  texels at a pixel centre
 *   ref_pixel.c    colour -> 565 value or grey level
 *   ref_compare.c  which pixels may be compared, and how far apart they are
 *
 * Model and eye space are right-handed; the eye is at the origin and looks along -z; m = -z is the depth in front of
 * it. Screen: x right, y down; pixel (i, j) has its centre at (i + 1/2, j + 1/2).
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
    const double (*normals)[3]; /* the file's normal of each corner, zero if the corner has none; or NULL */
    const double (*base)[3];    /* base colour of each polygon; NULL: the scene's for all */
    const double (*uv)[2];      /* u, v of each corner, v downwards, or NULL */
    const double (*color)[3];   /* of each corner, or NULL */
};

struct ref_mesh_options {
    bool fit;             /* move the bounding box's centre to 0, scale the farthest corner to distance 1 */
    bool average_normals; /* ignore the file's normals */
    double crease;        /* degrees; < 0: off */
    bool equal_weights;   /* average polygon normals with equal weights, not by the polygon's angle at the corner */
};

struct ref_triangle {
    uint32_t corner[3]; /* into the mesh's corners */
    uint32_t polygon;
};

struct ref_mesh {
    size_t corner_count;
    double (*position)[3]; /* per corner */
    double (*normal)[3];   /* per corner, unit length */
    uint32_t *weld;        /* per corner: equal if the positions are the same as 32-bit floats (ref_mesh.c) */
    size_t triangle_count;
    struct ref_triangle *triangles;
    size_t polygon_count;
    double (*polygon_normal)[3]; /* per polygon: unit length, zero if it has no area */
    double (*base)[3];           /* per polygon, or NULL */
    double (*uv)[2];             /* per corner, or NULL */
    double (*color)[3];          /* per corner, or NULL */
    double (*center)[3];         /* per polygon: the mean of its corners */
};

/* 0, or -1 if memory is short or the polygons have no faces or no extent. Release with ref_mesh_free. */
int ref_mesh_build(struct ref_mesh *mesh, const struct ref_polygons *from, const struct ref_mesh_options *options);
void ref_mesh_free(struct ref_mesh *mesh);

/*
 * A mesh between two frames that differ in positions and normals only: (1 - k) first + k second. Normals are made unit
 * length again; if they cancel, the first frame's is taken. The rest is copied from `first`. 0, or -1 if memory is
 * short.
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
    bool clamp[2]; /* in u, v; false: the texture repeats */
    bool bilinear, keyed;
    uint16_t key;
    int bits; /* per texel in the core's copy of the texture: 16, 8, 4 */
};

/* The function that replaces max(0, L.N) in the diffuse light. */
enum ref_ramp {
    REF_LAMBERT = 0,
    REF_HALF,
    REF_GAMMA,
    REF_TOON
};
#define REF_RAMP_STEPS 256 /* of the table from L.N = -1 to 1; linear between its entries */

/* Where a pixel's texel is. */
enum ref_texels {
    REF_TEXELS_UV = 0,        /* at the mesh's uv */
    REF_TEXELS_NORMAL,        /* matcap: at ((1 + x) / 2, (1 - y) / 2), (x, y, z) being the pixel's normal; no light */
    REF_TEXELS_CORNER_NORMALS /* likewise, with coordinates of the corners' normals, interpolated linearly */
};

#define REF_MAX_LIGHTS 4
#define REF_STEPS 65020
#define REF_GUARD_PX 511.0 /* the guard band: px from the picture's centre */

struct ref_scene {
    const struct ref_mesh *mesh;
    double rotation[9], scale, translation[3]; /* eye = scale * rotation * model + translation */
    int width, height;
    double fov;       /* vertical, degrees */
    double near, far; /* m of both planes */
    bool ortho;       /* project with the constant `distance` instead of m */
    double distance;
    enum ref_shading shading;
    bool affine;
    bool two_sided;
    int light_count;
    /* Eye space: the direction to a light, any length but zero; for a point light its place less the model's origin. */
    double light[REF_MAX_LIGHTS][3];
    double radius[REF_MAX_LIGHTS]; /* how far a point light reaches (flat and Gouraud only); 0: light at infinity */
    double light_color[REF_MAX_LIGHTS][3], ambient_color[3];
    bool colored; /* use the mesh's colours, if it has any */
    double ambient, diffuse, specular, shininess;
    enum ref_ramp ramp;
    double base[3], highlight[3], background[3];
    int left_out, phase; /* stipple: left_out of 64 pixels are not drawn, by the matrix moved by phase columns */
    bool fog;            /* from m = fog_from to fog_to */
    bool fog_in_m;       /* a deliberate fault: fog linear in m instead of 1/m */
    double fog_from, fog_to, fog_color[3];
    int bias;   /* steps (REF_STEPS from far to near) by which corners are moved nearer, clamped to far and near */
    int levels; /* 0: RGB565; 2, 16, 256: grey */
    bool dither;
    /* NULL: none. With REF_TEXELS_UV shading is flat or Gouraud and the mesh has uv; otherwise shading is Phong. */
    const struct ref_texture *texture;
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
    uint32_t piece;  /* index into ref_picture.pieces */
    double m;        /* depth in front of the eye */
    double z;        /* depth with the bias, as in the depth buffer: 0 far, 1 near */
    double color[3]; /* 0..1, unrounded */
    int tread;       /* ref_tread() at the pixel's centre */
    double specular; /* the largest channel of I_specular */
    uint16_t value;  /* 565 value or grey level */
    bool dropped;    /* a transparent texel lies in front of what is seen */
    bool unsettled;  /* the reference cannot be sure whether a texel in front is transparent */
};

/* Light per channel: the factors of the base colour and of the highlight colour. */
struct ref_lit {
    double diffuse[3], specular[3];
};

/* A triangle on the screen, or a triangle of the part of it that clipping left. */
struct ref_piece {
    double x[3], y[3], w[3]; /* px; w: the weight 1/m (1 under ortho) */
    double depth[3];         /* linear on the screen, larger is nearer: 1/m, under ortho -m */
    double z[3];             /* likewise, but 0 far, 1 near, with the bias; depth test and fog use it */
    double normal[3][3];     /* eye space, turned to the eye's side on a drawn back face */
    struct ref_lit lit[3];   /* flat, Gouraud: light at the corners, multiplied by the vertices' colours */
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

/* 0, or -1 if memory is short. Release with ref_picture_free. */
int ref_render(struct ref_picture *picture, const struct ref_scene *scene);
void ref_picture_free(struct ref_picture *picture);

/* ---- stages, public for the reference's own tests ---- */

int ref_project(struct ref_picture *picture, const struct ref_scene *scene);
void ref_raster(struct ref_picture *picture, const struct ref_scene *scene);
/* Light at a point with a unit normal (or zero: ambient only), both in eye space. */
void ref_light(const struct ref_scene *scene, const double at[3], const double normal[3], struct ref_lit *lit);
/* The ramp at L.N = x, -1..1. */
double ref_ramp(const struct ref_scene *scene, double x);
/* Light of a piece at a point of the screen; slerp's second arc runs along the row through that point. */
void ref_shade(const struct ref_scene *scene, const struct ref_piece *piece, double x, double y, struct ref_lit *lit);
/* The vertices' colours at a point of the screen, which multiply light per pixel or a matcap; white if not colored. */
void ref_color(const struct ref_scene *scene, const struct ref_piece *piece, double x, double y, double color[3]);
/* Barycentric coordinates of a point of the screen: perspective-correct or, with scene.affine, on the screen. */
void ref_weights(const struct ref_scene *scene, const struct ref_piece *piece, double x, double y, double b[3]);
/* U and V, in texels, at a point of the screen. */
void ref_texture_point(const struct ref_scene *scene, const struct ref_piece *piece, double x, double y,
                       double texels[2]);
uint16_t ref_texel(const struct ref_texture *texture, int i, int j);
/* False if the nearest texel is transparent. */
bool ref_texture_color(const struct ref_texture *texture, const double texels[2], double color[3]);
/*
 * Whether the core has to find the same nearest texel (bilinear: the same transparency) at a point of the screen,
 * although its U and V may be off by 1/16 texel or the coordinates' rounding, and by 1/16 px. *bound: how many steps a
 * channel may be off by.
 */
bool ref_settled(const struct ref_scene *scene, const struct ref_picture *picture, const struct ref_piece *piece,
                 double x, double y, double *bound);
/*
 * If light is computed per pixel (Phong, slerp), the jumps of a toon ramp appear in the picture like edges. Returns
 * which tread of the ramp's stairs each light falls on at a point of the screen, all lights in one number >= 0; -1 if a
 * light falls on a riser between treads; 0 if there are no jumps.
 */
int ref_tread(const struct ref_scene *scene, const struct ref_piece *piece, double x, double y);
/* Along the great arc between unit vectors. Equal ends: a. Opposite ends: a while t < 1/2, else b. */
void ref_slerp(const double a[3], const double b[3], double t, double out[3]);
bool ref_inside(const struct ref_piece *piece, double x, double y);
/* Distance of a point of the screen from side k of a piece, between its corners k and k + 1; px. */
double ref_side_distance(const struct ref_piece *piece, int side, double x, double y);
uint16_t ref_565(const double color[3]);
int ref_bayer8(int x, int y);
/* The fog's share at a pixel's z. */
double ref_fog_share(const struct ref_scene *scene, double z);
/* z of a point at the depth m in front of the eye: 0 far, 1 near, without the bias. */
double ref_nearness(const struct ref_scene *scene, double m);
/* The target's value of a drawn colour under this share of fog; the second: of any colour without fog. */
uint16_t ref_fogged_value(const struct ref_scene *scene, const double color[3], double share, int x, int y);
uint16_t ref_value(const struct ref_scene *scene, const double color[3], int x, int y, bool background);

/* ---- comparison ---- */

/*
 * In steps. Bilinear filtering turns an error in U and V into an error of the colour, in proportion to the difference
 * between the texels. Each step of that error makes some 4 % of the pixels round to another value. Up to this bound
 * tests demand a share of equal pixels.
 */
#define REF_CALM 2.0

struct ref_score {
    long covered, compared, equal, within_one;
    long comparable;                 /* compared, or not compared only because the texture is not settled */
    long beyond;                     /* of the compared: off by more than ref_settled()'s bound */
    long calm, calm_equal;           /* of the compared: those with a bound of at most 1 + REF_CALM steps */
    long dropped, dropped_drawn;     /* stippled out, or surely transparent before nothing; those not background */
    int worst;                       /* largest difference: steps of a channel, or grey levels */
    int worst_x, worst_y;            /* where it is */
    long highlight, highlight_equal; /* of the compared: I_specular > 1/63 */
    uint32_t cause;                  /* the triangle at the worst pixel */
};

/*
 * Compare 565 values or grey levels (width * height, row by row) and add to *score. A pixel is compared if its 3x3
 * neighbourhood belongs to triangles joined through shared edges with equal corner normals, uv and colours (flat: to
 * one polygon), has no jump in depth above 2 %, no texture seam and no jump of a toon ramp (ref_tread), and if its
 * texel, if it has one, is settled. 0, or -1 if memory is short.
 */
int ref_compare(struct ref_score *score, const struct ref_scene *scene, const struct ref_picture *picture,
                const uint16_t *values);

#endif
