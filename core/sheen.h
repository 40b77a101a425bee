/*
 * sheen.h - shaded 3D for microcontroller displays, with integers only.
 *
 * "The lecture" is Ron Goldman, "Shading Algorithms", Rice University.
 *
 * Number formats. Qi.f is signed, UQi.f unsigned: value = raw / 2^f. The type
 * names below carry f. Integer results round to nearest, halves up, unless said
 * otherwise; the same input gives the same bits on every machine.
 *
 * Spaces. Model and eye space are right-handed: x right, y up, the eye at the
 * origin looking along -z. Screen: x right, y down, pixel (i, j) has its centre
 * at (i + 1/2, j + 1/2). m = -z is the depth in front of the eye.
 *
 * Winding. A triangle is a front face when its projected corners run counter-
 * clockwise as seen on the screen. Vertices are snapped to 1/64 px; from there
 * coverage is exact: a pixel belongs to a triangle where its centre lies
 * inside, on a top edge or on a left edge, so two triangles that share an edge
 * leave no gap and draw no pixel twice.
 *
 * Depth. Of several triangles at a pixel the one with the largest 1/m (16 bits)
 * stays, on a tie the first drawn. Its step at m is m^2 (1/z_near - 1/z_far) /
 * 65020.
 *
 * Memory. The core allocates nothing and keeps nothing outside what the caller
 * gives: one arena a frame (sheen_arena_size) and the tables that materials point to.
 * There is nothing to release. Pointers MUST not be NULL unless it is said that
 * they may. Meshes and materials are borrowed from sheen_draw() until sheen_end()
 * or sheen_finish() returns.
 *
 * Order of calls. A frame is idle, then open from sheen_begin() on, then at its
 * bands from the first sheen_band() to sheen_finish(); sheen_end() is both. What
 * is out of order is refused with SHEEN_ERR_STATE and changes nothing. The first
 * negative code that a push or a wait returns is the frame's error: nothing more of
 * it is sent, and whatever went wrong, the next frame sends everything.
 *
 * What is sent. Of each band one rectangle, outwards to the target's alignment: around what triangles and edges touch,
 * those of this frame and of the last one, and this frame's marks; no rectangle where there is none of these. It is
 * places that are compared, not pixels: what stands still is drawn and sent again.
 *
 * Threads. Two frames share nothing. Calls on one frame MUST NOT overlap, but for
 * those of sheen_band() and sheen_bands() by different workers where the configuration has a lock.
 *
 * Light (lecture, "Illumination Models"): eye and lights at infinity,
 *   I_ad = ambient + sum over lights of diffuse * max(0, L.N)
 *   I_s  = sum over lights of specular * max(0, R.V)^n * min(1, 8 max(0, L.N));
 * colour = base * I_ad + highlight colour * I_s, clamped and rounded once a pixel.
 * The last factor lets the highlight end at L.N = 0 without a jump. In I_ad a material's ramp may take the place of
 * max(0, L.N).
 */
#ifndef SHEEN_H
#define SHEEN_H

#include <limits.h>

#include "sheen_arena.h"
#include "sheen_target.h"
#include "sheen_version.h"

#if INT_MAX < 2147483647
#error "sheen computes in int: a compiler whose int has fewer than 32 bits cannot build it"
#endif

#ifdef __cplusplus
extern "C" {
#endif

typedef int32_t sheen_q16_t;    /* Q15.16: scales and intensities */
typedef int32_t sheen_q24_t;    /* Q7.24: lengths, +-128 units in steps of 6e-8 */
typedef int32_t sheen_q30_t;    /* Q1.30: unit vectors, rotation matrices, sines */
typedef uint32_t sheen_angle_t; /* UQ0.32 turns: 2^32 is 360 degrees */

/*
 * Constants in these formats; the compiler folds them. With a variable they would link soft floats: where a processor
 * has no FPU, GCC and clang refuse that. sheen_degrees() takes variables.
 */
#if defined(__GNUC__) && !defined(__cplusplus) && (defined(__SOFTFP__) || defined(__riscv_float_abi_soft))
#define SHEEN_CONSTANT(x) (0 * (int)sizeof(struct { int is_no_constant : __builtin_constant_p(x) ? 1 : -1; }))
#else
#define SHEEN_CONSTANT(x) 0
#endif
/* x in Q15.16, see above. */
#define SHEEN_Q16(x) ((sheen_q16_t)((x)*65536.0 + ((x) < 0 ? -0.5 : 0.5)) + SHEEN_CONSTANT(x))
/* x in Q7.24. */
#define SHEEN_Q24(x) ((sheen_q24_t)((x)*16777216.0 + ((x) < 0 ? -0.5 : 0.5)) + SHEEN_CONSTANT(x))
/* x in Q1.30. */
#define SHEEN_Q30(x) ((sheen_q30_t)((x)*1073741824.0 + ((x) < 0 ? -0.5 : 0.5)) + SHEEN_CONSTANT(x))
/* x degrees as turns. */
#define SHEEN_DEGREES(x) ((sheen_angle_t)(int64_t)((x) / 360.0 * 4294967296.0) + (sheen_angle_t)SHEEN_CONSTANT(x))

/* Any whole number of degrees, to the nearest step (8.4e-8 degrees): 2^32 / 360 is 11930464 and 3054198966 / 2^32. */
static inline sheen_angle_t sheen_degrees(int32_t degrees)
{
    const uint64_t part = (uint64_t)((int64_t)degrees * 3054198966 + 2147483648);

    return (sheen_angle_t)degrees * 11930464u + (sheen_angle_t)(part >> 32);
}

/* ---- what is drawn ---- */

#define SHEEN_NO_TRIANGLE 0xffffu /* beyond a border */

/*
 * A triangle's three edges; edge k leads from its corner k to the next. Each edge of a mesh stands twice, once in
 * either triangle, or once where it is a border.
 */
struct sheen_triangle_edges {
    uint16_t across[3]; /* the triangle beyond each edge; SHEEN_NO_TRIANGLE: none */
    uint8_t sharp;      /* bit k: the two polygons' normals lie farther apart than a crease, or there is one polygon */
    uint8_t inner;      /* bit k: both triangles are of one polygon */
};

/*
 * A mesh, usually const data in flash. Corners that differ in position or normal
 * are different vertices; triangles are counter-clockwise seen from outside.
 * The indices MUST be below `vertices` (sheen_mesh_check looks).
 */
struct sheen_mesh {
    const int16_t *positions;       /* 3 a vertex: model = offset + scale * raw / 32768 */
    const int16_t *normals;         /* 3 a vertex: unit vectors, 1.0 = 32767; NULL: flat shading only */
    const int16_t *polygon_normals; /* 3 a polygon, likewise, for flat; NULL: from each triangle's corners */
    const uint16_t *polygons;       /* a triangle's polygon; NULL: triangle t is polygon t */
    const uint8_t *warp;   /* 1 a polygon, of sheen_mesh_warp: those that face away are passed over, of plane ones two
                              triangles may be drawn as one; NULL: none are */
    const void *indices;   /* 3 a triangle */
    uint8_t index_bytes;   /* 1 or 2: uint8_t or uint16_t indices */
    uint16_t vertices;     /* 1..65535 */
    uint16_t triangles;    /* 1..65535 */
    sheen_q24_t scale;     /* units that raw 32768 stands for, > 0 */
    sheen_q24_t offset[3]; /* units */
    /*
     * For textures, (0, 0) the upper left corner of the picture, (1, 1) the lower right one: u to the right, v down.
     * Between corners they are linear in space; over a triangle u times the texture's width and v times its height
     * MUST change by less than 8192; where the texture clamps both MUST lie within -32767..32767.
     */
    const int16_t *uvs;       /* 2 a vertex: u = uv_offset[0] + raw / 2^uv_bits, v likewise; NULL: none */
    uint8_t uv_bits;          /* 0..15 */
    sheen_q16_t uv_offset[2]; /* of u and v */
    const uint8_t *colors;    /* 3 a vertex: r, g, b, 255 = 1.0, for shaders that are colored; NULL: white */
    const struct sheen_triangle_edges *edges; /* 1 a triangle, of sheen_mesh_edges; NULL: none to be drawn */
};

#define SHEEN_POWER_ENTRIES 256 /* steps of a power table */

/*
 * The table of s^n that highlights look up, of one shininess n: const data, shared by materials. Those below are
 * linked where they are named; `sheen bake shine:N` writes any other as a header, sheen_shine_make() makes it in RAM.
 */
struct sheen_shine {
    /* s^n over u = 1 - s in [0, 2^-shift]: UQ1.15 << 16 | what it falls by to the next entry; 1.0 once more in front */
    uint32_t power[SHEEN_POWER_ENTRIES + 1];
    uint8_t shininess; /* n, 1..128 */
    uint8_t shift;     /* 0..3 */
};

/* n as the name says. */
extern const struct sheen_shine sheen_shine_4, sheen_shine_8, sheen_shine_16, sheen_shine_32, sheen_shine_64,
    sheen_shine_128;

/* SHEEN_ERR_ARGUMENT where n is not 1..128; *shine is untouched then. */
int sheen_shine_make(struct sheen_shine *shine, unsigned shininess);

#define SHEEN_RAMP_STEPS 256 /* from L.N = -1 to 1 */

/*
 * D, what takes the place of max(0, L.N) in a material's diffuse light; a highlight's fade stays on L.N itself. D is
 * low + span * value, over L.N linear between the entries. Const data, shared by materials: those below are linked
 * where they are named, and with them what reads a ramp.
 */
struct sheen_ramp {
    const struct sheen_ramp_reader *reader; /* &sheen_ramp_reader */
    sheen_q16_t low, span;                  /* span 0: D is low; what diffuse makes of either is held at 4 */
    uint16_t value[SHEEN_RAMP_STEPS + 1];   /* at L.N = i / 128 - 1; UQ1.15, at most 1.0 */
    uint8_t steep;                          /* D changes by 2^steep a unit of L.N at most, jumps not counted; 0..15 */
};

/* What reads ramps. */
extern const struct sheen_ramp_reader sheen_ramp_reader;

/*
 * half: ((1 + L.N) / 2)^2, half-Lambert: the dark side keeps its shape. toon: 0, and a third more at each of 0, 1/4 and
 * 0.7 of L.N, from the next entry on.
 */
extern const struct sheen_ramp sheen_ramp_half, sheen_ramp_toon;

/*
 * Made in RAM: light on the panel's own curve, for one light of intensity 1.0 and a material of that ambient and
 * diffuse: ((ambient + diffuse max(0, L.N))^(1 / 2.2) - ambient) / diffuse. SHEEN_ERR_ARGUMENT where ambient is not
 * 0..4 or diffuse not 1/1024..4; *ramp is untouched then.
 */
int sheen_ramp_make_gamma(struct sheen_ramp *ramp, sheen_q16_t ambient, sheen_q16_t diffuse);

/*
 * A picture in flash or RAM, of 2^width_log2 by 2^height_log2 texels in rows from the top, without gaps. A texel is a
 * colour of 565, red in the high bits, in the machine's own byte order whatever the target's: red / 31, green / 63,
 * blue / 31. Of texel coordinates U = u * width, V = v * height, nearest takes texel (floor U, floor V), bilinear the
 * four around (U - 1/2, V - 1/2) by their shares. A pixel whose nearest texel is transparent is not drawn and leaves
 * depth as it was; to bilinear a transparent neighbour is as that nearest texel.
 * U is off by at most zu, 1/16 texel (of a mesh that spans more than 1024 of them 1/16384 of these) and what it changes
 * over 1/16 px; V likewise. Where all texels within that are alike nearest ones are exact. Bilinear colours are off by
 * at most one step and zu + zv times the largest difference of the texels there; of pixels some 4 % for each step of
 * the latter are another value.
 */
struct sheen_texture {
    const void *texels;              /* bits 16: uint16_t, 565; 8: a byte, 4: two of them a byte, the left one in its
                                          low half, numbers of the palette */
    const uint16_t *palette;         /* 565; MUST be there with bits 8 and 4, as long as the numbers in use */
    uint8_t bits;                    /* of a texel: 16, 8, 4; 0: 16 */
    uint8_t width_log2, height_log2; /* 0..9 */
    uint8_t clamp_u, clamp_v;        /* beyond 0..1: 1: the texel at the edge; 0: the picture repeats */
    uint8_t bilinear;                /* 1: bilinear; 0: nearest */
    uint8_t keyed;                   /* 1: texels of the colour `key` are transparent */
    uint16_t key;                    /* 565, of palettes too */
};

/* A surface, usually const data. All zero is black. */
struct sheen_material {
    uint8_t base[3];                     /* r, g, b, 255 = 1.0 */
    uint8_t highlight[3];                /* r, g, b of the specular part; all 0: white */
    uint8_t ambient_color[3];            /* r, g, b, for shaders that are colored; all 0: white */
    sheen_q16_t ambient;                 /* Ia ka, 0..4 */
    sheen_q16_t diffuse;                 /* Ip kd, 0..4 */
    sheen_q16_t specular;                /* Ip ks, 0..4 */
    const struct sheen_shine *shine;     /* MUST be there where specular is not 0 */
    const struct sheen_texture *texture; /* of textured and matcap: MUST be there; others do not read it */
    const struct sheen_ramp *ramp;       /* in place of max(0, L.N); NULL: that itself */
    uint8_t line[3];                     /* r, g, b of the lines that sheen_edges_outline and sheen_edges_wire draw */
};

struct sheen_points;

/* What point lights are made of. */
extern const struct sheen_points sheen_points;

/*
 * A light at infinity, or for flat and gouraud, textured or not, that are colored a point light. Of one at P, d from a
 * point p that it lights, L is (P - p) / d (d = 0: N), and both of its parts are multiplied by max(0, 1 - d^2 /
 * radius^2)^2; p is the corner, flat the mean of the polygon's vertices, whose triangles MUST follow each other.
 */
struct sheen_light {
    sheen_q30_t to[3];                 /* points to it, any length but zero, in the world; with_eye: in eye space */
    sheen_q24_t at[3];                 /* units, of a point light: where it is, likewise */
    sheen_q16_t radius;                /* units, 0..1024: how far a point light reaches; 0: at infinity */
    const struct sheen_points *points; /* &sheen_points: MUST be there where radius is not 0; linked where named */
    sheen_q16_t intensity;             /* white, 0..1, times the material's diffuse and specular; 0: 1.0 */
    uint8_t no_highlight;              /* 1: no specular part from this light */
    uint8_t with_eye;                  /* 1: it stays where it is before the eye when the view moves */
    uint8_t color[3];                  /* r, g, b, for shaders that are colored; all 0: white */
};

#define SHEEN_MAX_LIGHTS 4 /* of an object */

/* p -> scale * rotation * p + translation. All zero, and sheen_pose_identity's: nothing moves. */
struct sheen_pose {
    sheen_q30_t rotation[9];    /* row by row; unit rows at right angles, within 1/1024; all 0: none. One that mirrors
                                   makes front faces back ones: a mirrored twin needs its triangles turned around */
    sheen_q16_t scale;          /* > 0; 0: 1.0 */
    sheen_q24_t translation[3]; /* units */
};

struct sheen_shader;

/*
 * How light is brought over a triangle: name one, and that one is linked. slerp is a scan-line
 * method: it depends on the triangle's orientation on the screen.
 */
extern const struct sheen_shader sheen_flat, sheen_gouraud, sheen_phong, sheen_slerp;

/*
 * With the colours of the mesh, the lights and the ambient light, which the others do not read. At a corner, base times
 * the vertex's colour takes the place of base, and what that gives is linear in space between (affine: on the screen);
 * the highlight is not tinted by it. A light's diffuse and specular part are multiplied by its colour, ambient light by
 * its own; of a ramp's low what is not below 0 counts as the lights'. Light is one a polygon, as flat's, or of the
 * vertices, as gouraud's; where lights have colours it is computed for each triangle.
 */
extern const struct sheen_shader sheen_flat_colored, sheen_gouraud_colored;

/*
 * The same with light at the pixel, as phong's and slerp's: the vertices' colours, linear in space between (affine: on
 * the screen), multiply what is not the highlight there. No point lights. By several lights, white ones too, they are
 * quicker than phong and slerp, whose loops are for one.
 */
extern const struct sheen_shader sheen_phong_colored, sheen_slerp_colored;

/*
 * With the material's texture, for meshes with uvs: base times the texel takes the place of base; the highlight is as
 * without. sheen_textured is lit at the vertices as gouraud is, sheen_textured_flat a polygon, as flat is. Ambient 1,
 * diffuse 0, specular 0 and a white base show the texels as they are, and cost no light.
 */
extern const struct sheen_shader sheen_textured, sheen_textured_flat;

/*
 * The same with the colours of the mesh, the lights and the ambient light, as sheen_gouraud_colored and
 * sheen_flat_colored: the texel multiplies what these bring over the triangle, but for the highlight; point lights too.
 */
extern const struct sheen_shader sheen_textured_colored, sheen_textured_flat_colored;

/*
 * With a picture of a lit sphere, the material's texture, in place of lights: base times the texel at ((1 + x) / 2,
 * (1 - y) / 2) of the picture, x and y of the normal before the eye. sheen_matcap takes the normal of the pixel, as
 * phong, sheen_matcap_vertex the vertices', with coordinates linear in space between. The texture MUST clamp where it
 * is bilinear (clamp_u, clamp_v). Of the material base and texture alone are read.
 */
extern const struct sheen_shader sheen_matcap, sheen_matcap_vertex;

/* The same with the mesh's colours, linear in space (affine: on the screen), times base. There is no light to tint. */
extern const struct sheen_shader sheen_matcap_colored, sheen_matcap_vertex_colored;

/*
 * Matcaps of 64 by 64 texels, 8 KB each, linked where they are named: polished metal under a sky, glazed ware in a room
 * with windows, fired clay, polished jade. A copy of the struct with bilinear 1 shows them smooth.
 */
extern const struct sheen_texture sheen_matcap_chrome, sheen_matcap_glaze, sheen_matcap_clay, sheen_matcap_jade;

struct sheen_stipple;

/*
 * Opacity without sorting or blending: pixels that are left out, in an ordered pattern, so that what lies behind shows
 * between. B is the 8x8 Bayer matrix of dithering, B2n = [[4 Bn, 4 Bn + 2], [4 Bn + 3, 4 Bn + 1]], B1 = [0]. A pixel
 * (x, y) of the target is drawn where B(x + phase mod 8, y mod 8) < 64 - transparency; else neither colour nor depth is
 * written. Two draws of one phase cover each other, phase 1 interleaves them. Such a draw is dithered by B with its
 * digits to base 4 reversed, 16 (B mod 4) + 4 (floor(B / 4) mod 4) + floor(B / 16), for where B is low all of its
 * thresholds are. What does that is linked where it is named.
 */
extern const struct sheen_stipple sheen_stipple;
struct sheen_edges;

/*
 * What is drawn of a mesh's edges, over the triangles, where these do not hide them; what is named is linked. It takes
 * room (max_edges).
 * smooth: contours, where a triangle that faces the eye meets one that does not, or none, are smoothed: a pixel that
 *   one crosses is mixed with its neighbours across it, by how much of it lies on either side. On targets of 2 levels
 *   nothing is drawn. It needs config.smooth.
 * outline: contours and sharp edges, as lines 1 px wide in the material's `line`, not dithered.
 * wire: so are all edges but those within a polygon. What they hide is what the triangles hide, whatever their colour.
 */
extern const struct sheen_edges sheen_edges_smooth, sheen_edges_outline, sheen_edges_wire;

struct sheen_morpher;

/* What stands between two frames. */
extern const struct sheen_morpher sheen_morpher;

/*
 * Between two frames of a mesh that moves. With k = weight / 32768 a position is (1 - k) p0 + k p1 of the object's mesh
 * and this one, rounded to its grid; normals, of corners and polygons, are the two frames' own, mixed alike and of unit
 * length again (where they cancel, the first frame's). Indices, polygons, uvs, colors and edges are the object's
 * mesh's. No polygon is passed over by its warp, so that max_used has to be up to all vertices. Weight 0 gives the
 * mesh's own bits.
 */
struct sheen_morph {
    /*
     * The frame at k = 1; borrowed until sheen_end() or sheen_finish() returns. Vertices, triangles, scale and offset
     * MUST be the object's mesh's; normals and polygon normals MUST be there where that has them. What else it has is
     * not read.
     */
    const struct sheen_mesh *mesh;
    const struct sheen_morpher *morpher; /* &sheen_morpher: what is named is linked */
    uint16_t weight;                     /* k, UQ1.15: 0..32768 */
};

/* What is drawn. Mesh, material and shader MUST be there. */
struct sheen_object {
    const struct sheen_mesh *mesh;         /* borrowed */
    const struct sheen_material *material; /* borrowed */
    const struct sheen_shader *shader;     /* how it is shaded */
    const struct sheen_light *lights;      /* copied by sheen_draw */
    uint8_t light_count;                   /* 0..SHEEN_MAX_LIGHTS; 0: ambient light alone */
    uint8_t two_sided;                     /* 1: back faces are drawn too, with their normals negated */
    struct sheen_pose pose;                /* model to world */
    const struct sheen_stipple *stipple;   /* &sheen_stipple: MUST be there where transparency is not 0 */
    uint8_t transparency;                  /* 1/64 of triangles' pixels left out, 0..64 (64: all); lines are whole */
    uint8_t phase;                         /* of the pattern, 0..7 */
    /*
     * Steps of 16-bit depth added to what is tested and left, -4096..4095, larger is nearer: what lies in another's
     * plane (a decal, an outline) shows. At each corner, those of cuts too, the sum is held to the depths from z_far to
     * z_near, 257 and 65277 (struct sheen_canvas): a triangle of which one is held lies tilted in depth, and what is
     * held at z_far is not drawn. Where depth and bias stay between these all over an object it is moved as it is.
     */
    int16_t depth_bias;
    const struct sheen_morph *morph; /* borrowed likewise; NULL: the mesh as it is */
    const struct sheen_edges *edges; /* what is drawn of the mesh's edges, which then MUST be there; NULL: nothing */
};

/*
 * A rectangle of the target before it is sent. [0] is its top left; a row is pitch entries. Pixels: uint16_t in the
 * target's order, or for grey targets one byte a pixel, its level (packed afterwards). Depth: what the triangles left,
 * 257 + 65020 (1/m - 1/z_far) / (1/z_near - 1/z_far) rounded (orthographic: 257 + 65020 (z_far - m) / (z_far -
 * z_near); where the two are as near to each other as they may be, up to 16 steps off), 257 where there is none, so a
 * user can pick, fog and test depth; before them the triangles are tested against what an underlay leaves.
 */
struct sheen_canvas {
    struct sheen_rect rect; /* px on the target */
    unsigned pitch;         /* entries from a row to the next */
    void *pixels;           /* uint16_t, or uint8_t on greys */
    uint16_t *depth;        /* as many entries as pixels */
    enum sheen_pixel pixel; /* the target's */
};

struct sheen_fog_mixer;

/* What fogs. */
extern const struct sheen_fog_mixer sheen_fog_mixer;

/* What fogs edges' lines alone, and not the faces. */
extern const struct sheen_fog_mixer sheen_line_fog_mixer;

/*
 * Fog. At a pixel's own depth m it is f = (1/start - 1/m) / (1/start - 1/end), held at 0 and 1 (orthographic: linear in
 * m), which is linear in the depth that is left, and taken there: a depth bias moves a pixel in the fog too, as
 * whatever reads the depths afterwards sees it. The unrounded colour goes to colour + f (F - colour), F the fog's
 * colour rounded to the target's levels, and is rounded or dithered once. All that is drawn is fogged, edges' lines by
 * their own depth and from their own colour rounded likewise; the background is not: full fog of its colour meets it
 * without a seam. With sheen_line_fog_mixer faces are not fogged either: those of a wire drawing that have the
 * background's colour keep it.
 */
struct sheen_fog {
    sheen_q24_t start, end;              /* m, units, 0 < start < end, at least 256 steps of depth apart */
    uint8_t color[3];                    /* r, g, b */
    const struct sheen_fog_mixer *mixer; /* &sheen_fog_mixer or &sheen_line_fog_mixer: what is named is linked */
};

/* What the eye sees, a frame long. */
struct sheen_view {
    /*
     * px on the target, edges on its alignment; empty: all of it. Nothing outside is drawn or sent, marks neither. For
     * several views in a picture begin and end one after the other: each is sent whole then, or by a frame of its own,
     * with sheen_wait() before the next, what it touches.
     */
    struct sheen_rect viewport;
    struct sheen_pose pose;      /* world to eye (sheen_pose_look_at, sheen_pose_orbit) */
    sheen_angle_t fov;           /* vertical, 1..150 degrees (0.99..150.01 are taken); 0: 40 */
    sheen_q24_t z_near, z_far;   /* units, 0 < z_near < z_far, z_far - z_near >= z_far / 2^15: m outside is not drawn;
                                   z_far 0: 16, z_near 0: z_far / 16 */
    sheen_q24_t orthographic;    /* 0: perspective; else the depth, units > 0, at which fov measures: m moves nothing */
    uint8_t affine;              /* 1: shading linear on the screen (the distortion that Blinn's way repairs) */
    uint8_t dither;              /* 1: ordered 8x8 dithering, for panels of few levels */
    uint8_t background[3];       /* r, g, b; never dithered */
    const struct sheen_fog *fog; /* NULL: none; borrowed until sheen_end() or sheen_finish() returns */
    /*
     * A user's own 2D; each may be NULL, all get ctx. Called for each rectangle
     * of the target that this frame sends: underlay in place of clearing to the
     * background, overlay after drawing; by several workers at once where their
     * bands are. All three are part of the background: where one of them, the
     * colour or the viewport differs from the last frame's, everything is sent;
     * of what they draw otherwise, sheen_mark tells.
     */
    void *ctx;
    void (*underlay)(void *ctx, const struct sheen_canvas *canvas);
    void (*overlay)(void *ctx, const struct sheen_canvas *canvas);
};

/* ---- a frame ---- */

struct sheen_clipper;

/*
 * What cuts triangles that the near plane, the far plane or the guard band (511 px from the viewport's middle) crosses.
 * A program does without where each triangle lies inside all of these, or wholly beyond one of them. Else a draw ends
 * with SHEEN_ERR_CAPACITY, also where the triangle faces away, unless its polygon is passed over, or where nothing of
 * it is in the picture; with the clipper these need no piece.
 */
extern const struct sheen_clipper sheen_clipper;

/*
 * What draws two triangles of a plane polygon as one, where a mesh's warp tells of them and light is linear over both:
 * they take the time and the room of one. On the front of objects that do not morph; a fan's triangles, convex on the
 * screen and within the viewport; by sheen_flat, by sheen_gouraud on the lit side without a highlight, by sheen_phong
 * and sheen_slerp where the corners' normals are linear and near each other, as on globes, drums and the faces of
 * boxes. One light, no ramp, but for flat. Pictures are the same by flat without fog, else within a step, in fog within
 * three. How many triangles are listed then depends on the light and the view: max_triangles has to be what triangles
 * alone need, or be seen to do.
 */
extern const struct sheen_quads sheen_quads;

/* Capacities, fixed at init. Totals of a frame; 0 takes the default in brackets. */
struct sheen_config {
    const struct sheen_target *target; /* borrowed for the frame's life */
    uint16_t band_rows;                /* more than height is height; rounded up to align_y [16] */
    uint8_t buffers;                   /* 1, or 2: draw a band while the last one is sent [1] */
    uint8_t workers;                   /* 1..4 with buffers of their own, to call sheen_band at once [1] */
    uint16_t max_vertices;             /* of all meshes drawn in a frame; no default */
    uint16_t max_used;                 /* of them, those of polygons that may face the eye [max_vertices, the most] */
    uint16_t max_triangles;            /* listed: in front, not clipped away; no default */
    uint16_t max_draws;                /* [4] */
    uint16_t max_clipped;              /* listed pieces of triangles that the clipper cuts [0] */
    uint8_t max_shades;   /* on 565: colours of a frame with finished pixels at hand, 2.1 KB each, within a step [1] */
    uint8_t smooth;       /* 1: room for sheen_edges_smooth, a byte a pixel of a band and of 8 rows more [0] */
    uint16_t max_carried; /* set-ups kept across a band's edge, 1..254 [80]; full costs time only */
    /*
     * Edges drawn in a frame, and 1 for each 64 triangles of the mesh whose edges are listed [0: none]. With them bands
     * are drawn with a row more above and below, which edges look at and which is not sent; an underlay gets it too.
     * Ends that the view volume cuts count with max_vertices and max_used.
     */
    uint16_t max_edges;
    const struct sheen_clipper
        *clipper; /* &sheen_clipper: MUST be there where max_clipped is not 0; NULL: what it would cut is refused */
    const struct sheen_quads *quads; /* &sheen_quads: see there; NULL: by triangles */
    /*
     * For workers on several threads: one at a time is let through between lock and
     * unlock, both with lock_ctx. The core calls them in pairs, never one pair within
     * another, and calls the target's push and wait between them. Both NULL: workers
     * take turns on one thread.
     */
    void *lock_ctx;
    void (*lock)(void *ctx);
    void (*unlock)(void *ctx);
};

struct sheen_frame; /* lives in the arena */

/* Bytes of the arena that sheen_init needs, as SHEEN_ARENA_BYTES says; 0 where the configuration is invalid. */
size_t sheen_arena_size(const struct sheen_config *config);

/*
 * Set up a frame in the arena (aligned to 8). *size is its size; on
 * SHEEN_ERR_MEMORY *size becomes the size needed and nothing was written.
 * SHEEN_ERR_ARGUMENT: a NULL, an arena that is not aligned, or what
 * sheen_config_about() names.
 */
int sheen_init(struct sheen_frame **frame, void *arena, size_t *size, const struct sheen_config *config);

/*
 * Start a frame: waits for the last push of the one before and returns its error, if any: then begin again. On any
 * error the frame stays idle.
 */
int sheen_begin(struct sheen_frame *frame, const struct sheen_view *view);

/*
 * Transform, cull, clip and list a mesh, while the frame is open. On any error the frame is as it was before:
 * SHEEN_ERR_STATE, or SHEEN_ERR_ARGUMENT, SHEEN_ERR_DEGENERATE (a light without direction), SHEEN_ERR_CAPACITY,
 * of which sheen_frame_about() says more.
 */
int sheen_draw(struct sheen_frame *frame, const struct sheen_object *object);

/* Add a rectangle (px on the target) to what this frame clears, draws and sends; while the frame is open. */
int sheen_mark(struct sheen_frame *frame, struct sheen_rect rect);

/* Where a point comes to be on the target. */
struct sheen_spot {
    int32_t x, y;   /* 1/64 px on the target; held at 511 px from the viewport's middle */
    uint16_t depth; /* as struct sheen_canvas has it; 0, and so x and y: before z_near or beyond z_far */
    uint8_t inside; /* 1: between z_near and z_far and within the viewport, in pixel (x / 64, y / 64) */
};

/*
 * For labels, cursors, and finding what a finger touches, from sheen_begin() on to the frame's end. point: units, in
 * the model that `model` poses; NULL: in the world. It is where a vertex there is, within 1/64 px and a step of depth.
 * What is drawn there hides it where the depth at that pixel is larger, which the rectangle with that pixel alone
 * knows. SHEEN_ERR_STATE, or SHEEN_ERR_ARGUMENT where a pose is none or the point is more than 128 units away along an
 * axis of the eye; *spot is untouched then.
 */
int sheen_locate(const struct sheen_frame *frame, const struct sheen_pose *model, const sheen_q24_t point[3],
                 struct sheen_spot *spot);

/* Draw and send every band that is not done yet: sheen_band by worker 0 until an error, then sheen_finish. */
int sheen_end(struct sheen_frame *frame);

/*
 * A whole frame: sheen_begin, sheen_draw for each object, sheen_end. Where a draw fails nothing is sent, its error is
 * returned, and the next frame sends everything.
 */
int sheen_render(struct sheen_frame *frame, const struct sheen_view *view, const struct sheen_object *objects,
                 unsigned count);

/* What an error was about: fields, or capacities with how much would have done. */
enum sheen_subject {
    SHEEN_ABOUT_NOTHING = 0,
    SHEEN_ABOUT_TARGET, /* of the configuration: target, buffers, workers, lock and unlock */
    SHEEN_ABOUT_BUFFERS,
    SHEEN_ABOUT_WORKERS,
    SHEEN_ABOUT_LOCK,
    SHEEN_ABOUT_MAX_VERTICES, /* capacities: of the configuration, or exceeded by a draw */
    SHEEN_ABOUT_MAX_USED,
    SHEEN_ABOUT_MAX_TRIANGLES,
    SHEEN_ABOUT_MAX_DRAWS,
    SHEEN_ABOUT_MAX_CLIPPED,
    SHEEN_ABOUT_MAX_CARRIED,
    SHEEN_ABOUT_VIEWPORT, /* of the view */
    SHEEN_ABOUT_FOV,
    SHEEN_ABOUT_DEPTHS, /* z_near, z_far, orthographic */
    SHEEN_ABOUT_POSE,   /* of the view or an object: no rotation, or something moves out of range */
    SHEEN_ABOUT_MESH,   /* of an object */
    SHEEN_ABOUT_NORMALS,
    SHEEN_ABOUT_MATERIAL,
    SHEEN_ABOUT_SHINE,
    SHEEN_ABOUT_RAMP,
    SHEEN_ABOUT_SHADER,
    SHEEN_ABOUT_LIGHTS,
    SHEEN_ABOUT_UVS,          /* none, or uv_bits out of range */
    SHEEN_ABOUT_TEXTURE,      /* none, out of range, no palette, or a matcap's that is bilinear and does not clamp */
    SHEEN_ABOUT_TRANSPARENCY, /* or phase out of range, or no stipple */
    SHEEN_ABOUT_FOG,          /* of the view */
    SHEEN_ABOUT_DEPTH_BIAS,
    SHEEN_ABOUT_MORPH,     /* its mesh is not of the object's shape, weight out of range, or no morpher */
    SHEEN_ABOUT_EDGES,     /* of an object: its mesh has none */
    SHEEN_ABOUT_MAX_EDGES, /* a capacity */
    SHEEN_ABOUT_SMOOTH,    /* likewise */
    SHEEN_ABOUT_CLIPPER    /* of the configuration: none for max_clipped */
};

/*
 * Of the last sheen_begin, sheen_draw or sheen_render that ended with SHEEN_ERR_ARGUMENT, SHEEN_ERR_DEGENERATE or
 * SHEEN_ERR_CAPACITY. *needed: for a capacity, the least with which what was drawn so far and that object would have
 * passed (for triangles and pieces: exactly, though the other may be short then; for pieces without a clipper: what
 * suffices, 12 a triangle; for edges at first what the mesh alone takes: with that, ask again); else 0. It may be NULL.
 */
enum sheen_subject sheen_frame_about(const struct sheen_frame *frame, uint32_t *needed);

/* What sheen_init finds wrong with a configuration. */
enum sheen_subject sheen_config_about(const struct sheen_config *config);

/* A word for it: the field's name. Never NULL. */
const char *sheen_subject_name(enum sheen_subject subject);

/*
 * In place of sheen_end, by hand: each band once, in any order, by any worker, and sheen_finish when all are done.
 * Both return the frame's error once there is one. SHEEN_ERR_STATE for a band that is done already,
 * SHEEN_ERR_ARGUMENT for a band or worker that there is none of. Where a band was
 * left out the next frame sends everything. Bands are numbered from 0 at the top; their count is the last begun
 * frame's, 0 before.
 */
unsigned sheen_band_count(const struct sheen_frame *frame);
int sheen_band(struct sheen_frame *frame, unsigned worker, unsigned band);

/*
 * Worker's share of the bands: its part of the picture from the top, then what others have not begun of theirs, until
 * none is left. Each worker calls it, and sheen_finish comes when all have returned. 0, the frame's error, or
 * SHEEN_ERR_ARGUMENT where there is no such worker.
 */
int sheen_bands(struct sheen_frame *frame, unsigned worker);
int sheen_finish(struct sheen_frame *frame);

/* Wait for the push under way, if any; its result. A negative one is the frame's error, if it is not finished yet. */
int sheen_wait(struct sheen_frame *frame);

/* The next frame sends everything (the panel was written to by others, or lost power). */
void sheen_invalidate(struct sheen_frame *frame);

/* Counters of the frame since sheen_begin; those marked * count only in builds with SHEEN_STATS=1. */
struct sheen_stats {
    uint32_t triangles, front, drawn, clipped; /* given; facing the eye; listed, two of a plane polygon as one; cut */
    uint32_t used;                             /* vertices: what max_used holds */
    uint32_t edges;                            /* listed to be drawn */
    uint32_t setups, spans;   /* set-ups made, more than one for a triangle that was not carried; rows of triangles */
    uint32_t covered, shaded; /* px inside triangles; px that passed the depth test (*) */
    uint32_t rectangles, pixels; /* pushes and their area */
    /* B: all of it; of that max_vertices and max_used, max_triangles, and bands' pixels and depths */
    uint32_t ram_arena, ram_vertices, ram_lists, ram_bands;
};

/* Copies them; they stand until the next sheen_begin(). */
void sheen_frame_stats(const struct sheen_frame *frame, struct sheen_stats *stats);

/* ---- making what is drawn ---- */

/*
 * For a mesh that is made or moves at run time: its `warp`. Of a polygon's triangles the largest |unit normal - the
 * polygon's stored one|, plus the distance of its plane from the first corner of the polygon's first triangle, of
 * which 56,756 raw units (a corner's farthest from the origin) count as 1.0; UQ-2.10 rounded up, SHEEN_WARP_UNKNOWN
 * where that is too small. A plane polygon, off by 2/1024 at most, has up to SHEEN_WARP_PLANE in place of that, others
 * more: less than it where the vertices' normals are linear, within 6 steps, over two triangles that follow each other
 * as a fan, the less the nearer they are to each other, in 7 steps up to 15 degrees (core/math/bend.h). The mesh MUST
 * have polygon normals and have passed sheen_mesh_check.
 */
#define SHEEN_WARP_UNKNOWN 255
#define SHEEN_WARP_PLANE 9 /* up to here a polygon is plane, and two of its triangles may be drawn as one quad */
void sheen_mesh_warp(const struct sheen_mesh *mesh, uint32_t polygon_count, uint8_t *warp);

/*
 * For a mesh that is made at run time: its `edges`, one a triangle. Corners at one place are one; an edge joins two
 * triangles that run along it in opposite directions, where there are more of them the first ones. It is sharp where
 * the polygons' normals lie farther apart than the crease angle, the cosine of which is given (0.5 for 60 degrees).
 * Triangles of which two corners are at one place have borders only. The mesh MUST have polygon normals and have
 * passed sheen_mesh_check with `edges` NULL. scratch: SHEEN_EDGES_WORDS(vertices, triangles), the caller's.
 * Time: for each edge the triangles around one of its corners.
 */
#define SHEEN_EDGES_WORDS(vertices, triangles) (3 * (vertices) + 3 * (triangles))
void sheen_mesh_edges(const struct sheen_mesh *mesh, sheen_q30_t crease, uint32_t *scratch,
                      struct sheen_triangle_edges *edges);

/* SHEEN_OK, or SHEEN_ERR_ARGUMENT where a count, pointer, index, polygon id or edge is out of range. */
int sheen_mesh_check(const struct sheen_mesh *mesh, uint32_t polygon_count);

sheen_q30_t sheen_sin(sheen_angle_t angle); /* within 2 raw steps of exact */
sheen_q30_t sheen_cos(sheen_angle_t angle); /* likewise */

/* rotation = Rz(roll) * Rx(pitch) * Ry(yaw), scale 1, the model's origin at depth `distance`. */
void sheen_pose_orbit(struct sheen_pose *pose, sheen_angle_t yaw, sheen_angle_t pitch, sheen_angle_t roll,
                      sheen_q24_t distance);

/* An identity rotation, scale 1, no translation. */
void sheen_pose_identity(struct sheen_pose *pose);

/* What is posed is moved once more: turned about the world's axis 0, 1, 2 (x, y, z) counter-clockwise seen from its */
/* positive end, scaled about the origin, shifted. As sheen_pose_compose; on an error the pose is untouched. */
int sheen_pose_rotate(struct sheen_pose *pose, unsigned axis, sheen_angle_t angle);
int sheen_pose_scale(struct sheen_pose *pose, sheen_q16_t factor);
int sheen_pose_translate(struct sheen_pose *pose, sheen_q24_t x, sheen_q24_t y, sheen_q24_t z);

/*
 * out = outer * inner: the model is first moved by inner, then by outer. out may be either. Scale and translation are
 * rounded once; the rotation is made orthonormal again, entries within 12 raw steps of the product, so that any number
 * of compositions stays what sheen_draw takes. SHEEN_ERR_ARGUMENT where a rotation is none, or scale or translation
 * leave their range; out is untouched then.
 */
int sheen_pose_compose(const struct sheen_pose *outer, const struct sheen_pose *inner, struct sheen_pose *out);

/*
 * Repair a rotation that drifted, or was made from rounded numbers: the third row keeps its direction, the second one
 * is turned within their plane to a right angle, the first one follows; a mirror stays one. Rows of any length become
 * unit ones (squared lengths and right angles within 16 raw steps). SHEEN_ERR_DEGENERATE where the last two rows are
 * zero or parallel (within 1e-6); the pose is untouched then.
 */
int sheen_pose_orthonormalize(struct sheen_pose *pose);

/*
 * The pose of the world for an eye at `eye` that looks at `target` with `up` upwards: compose it with a
 * model's own pose. SHEEN_ERR_DEGENERATE where up points along the view or target is the eye,
 * SHEEN_ERR_ARGUMENT where along an axis of the eye the origin is more than 128 units away.
 */
int sheen_pose_look_at(struct sheen_pose *pose, const sheen_q24_t eye[3], const sheen_q24_t target[3],
                       const int32_t up[3]);

/* v to unit length in Q1.30, each part within 4 raw steps of exact. SHEEN_ERR_DEGENERATE: v = 0, out untouched. */
int sheen_normalize(const int32_t v[3], sheen_q30_t out[3]);

/*
 * Newell's normal of a polygon (lecture, "Polygon Normals"), unit length, each part within 4 raw steps of exact.
 * points: 3 a point, any common scale, |coordinate| <= 2^28; corners: count (>= 3) indices into points.
 * SHEEN_ERR_DEGENERATE where the area is zero.
 */
int sheen_polygon_normal(const int32_t *points, const uint32_t *corners, unsigned count, sheen_q30_t normal[3]);

/*
 * Polygons that share points, for meshes that are made or move at run time:
 *
 *     static uint32_t around[SHEEN_AROUND_WORDS(POINTS, CORNERS)];
 *     static sheen_q30_t facing[3 * POLYGONS], unit[3 * POINTS];
 *     static sheen_angle_t angles[CORNERS];
 *     int error = sheen_polygons_around(&list, around);      once: it depends on corners and sizes only
 *     ...                                                    each frame: move list.points, then
 *     sheen_polygon_normals(&list, facing);
 *     sheen_corner_angles(&list, facing, angles);            unless all polygons are to count alike (NULL below)
 *     sheen_vertex_normals(&list, around, facing, angles, unit);
 *     for (i = 0; i < 3 * POINTS; i++)
 *         mesh_normals[i] = (int16_t)((int64_t)unit[i] * 32767 / (1 << 30));
 */
struct sheen_polygon_list {
    const int32_t *points;   /* 3 a point, any common scale, |coordinate| <= 2^28 */
    const uint32_t *corners; /* indices into points, those of all polygons one after another */
    const uint32_t *sizes;   /* corners of each polygon, >= 3 */
    uint32_t point_count, corner_count, polygon_count; /* of what the three arrays hold */
};

/*
 * The polygons around each point, once for each time they list it; around: caller's, SHEEN_AROUND_WORDS of it.
 * Checks the list as well: SHEEN_ERR_ARGUMENT where an index or a size is out of range or the sizes do not add up
 * to corner_count. The functions below MUST have a list that passed.
 */
#define SHEEN_AROUND_WORDS(point_count, corner_count) ((point_count) + 1 + 2 * (corner_count))
int sheen_polygons_around(const struct sheen_polygon_list *list, uint32_t *around);

/* sheen_polygon_normal of each polygon, 3 parts each; zero for one without area. */
void sheen_polygon_normals(const struct sheen_polygon_list *list, sheen_q30_t *normals);

/*
 * The interior angle at each corner, within SHEEN_ANGLE_ROUNDING raw steps (4e-8 rad); beyond half a turn where
 * the polygon, seen along its normal, turns right; 0 where an edge has no length.
 */
#define SHEEN_ANGLE_ROUNDING 24
void sheen_corner_angles(const struct sheen_polygon_list *list, const sheen_q30_t *polygon_normals,
                         sheen_angle_t *angles);

/*
 * The normalised sum of the unit normals around each point, 3 parts each. Zero where they cancel, all of them are
 * zero, or no polygon lists the point.
 * weights: of each corner in its polygon's normal; with the corners' angles the sum does not depend on how polygons
 * were cut into triangles. NULL: all equal (lecture, "Vertex Normals").
 */
void sheen_vertex_normals(const struct sheen_polygon_list *list, const uint32_t *around,
                          const sheen_q30_t *polygon_normals, const uint32_t *weights, sheen_q30_t *normals);

/*
 * The same for each corner, 3 parts each, over the corner's own polygon and those whose normals lie within the
 * crease angle of its normal; crease: the angle's cosine, -1.0 averages all (a difference below 2e-8 counts as
 * within). Where the sum is zero it is the polygon's normal, for a polygon without area zero.
 * Time: for each corner the polygons around its point; of those around a point that face alike, the first only.
 */
void sheen_corner_normals(const struct sheen_polygon_list *list, const uint32_t *around,
                          const sheen_q30_t *polygon_normals, const uint32_t *weights, sheen_q30_t crease,
                          sheen_q30_t *normals);

/*
 * Cut a polygon into count - 2 triangles, 3 places in `corners` (0 .. count - 1) each, wound as the polygon.
 * normal: of sheen_polygon_normal. A polygon that is convex seen along its normal (a straight corner counts as
 * convex) becomes the fan (0, k, k + 1); any other loses its ears, each time the first valid one in the corners'
 * order. The tests are exact. A hole may be joined by a cut that is listed both ways. A polygon that crosses or
 * touches itself may run out of ears; then its first corner is cut: still count - 2 triangles whose signed areas
 * add up to the polygon's, but they may overlap, face backwards (seen along the normal) or have no area.
 * SHEEN_ERR_DEGENERATE where normal is zero; nothing is written then.
 * points, corners as above, count >= 3; scratch: SHEEN_TRIANGULATE_WORDS(count), the caller's.
 * Time: count for a convex polygon, count^2 for usual others, count^3 at worst.
 */
#define SHEEN_TRIANGULATE_WORDS(count) (3 * (count))
int sheen_triangulate(const int32_t *points, const uint32_t *corners, unsigned count, const sheen_q30_t normal[3],
                      uint32_t *scratch, uint32_t *triangles);

#ifdef __cplusplus
}
#endif
#endif
