/*
 * sheen.h - shaded 3D for microcontroller displays, with integers only.
 *
 * "The lecture" is Ron Goldman, "Shading Algorithms", Rice University.
 *
 * Number formats. Qi.f is signed, UQi.f unsigned: value = raw / 2^f. The type names below carry f. Integer results are
 * rounded to nearest, halves up, unless a comment says otherwise. The same input gives the same bits on every machine.
 *
 * Spaces. Model, world and eye space are right-handed: x right, y up; the eye is at the origin of eye space and looks
 * along -z. Screen: x right, y down; pixel (i, j) has its centre at (i + 1/2, j + 1/2). m = -z is the depth in front of
 * the eye.
 *
 * Winding. A triangle is a front face if its projected corners run counter-clockwise on the screen. Vertices are
 * snapped to 1/64 px; from there coverage is exact: a pixel belongs to a triangle if its centre lies inside, on a top
 * edge or on a left edge. So two triangles that share an edge leave no gap and draw no pixel twice.
 *
 * Depth. Of several triangles at a pixel the one with the largest 1/m (16 bits) stays; of equal ones the first drawn.
 * The step of that depth at m is m^2 (1/z_near - 1/z_far) / 65020.
 *
 * Memory. The core allocates nothing and keeps nothing outside what the caller gives it: one arena per frame
 * (sheen_arena_size) and the tables that materials point to. There is nothing to release. Pointers MUST NOT be NULL
 * unless their comment allows it. Meshes and materials are borrowed from sheen_draw() until sheen_end() or
 * sheen_finish() returns.
 *
 * Order of calls. A frame is idle; sheen_begin() opens it; the first sheen_band() takes it to its bands, where it stays
 * until sheen_finish() (sheen_end() does all bands and finishes). A call out of order is refused with SHEEN_ERR_STATE
 * and changes nothing. The first negative code that a push or a wait of the target returns becomes the frame's error:
 * nothing more of that frame is sent. Whatever went wrong, the next frame sends everything.
 *
 * What is sent. One rectangle per band: the smallest around all that triangles and edges touch in this frame or touched
 * in the last one, and around this frame's marks, extended to the target's alignment; none if there is nothing of that.
 * Places are compared, not pixels: an object that does not move is drawn and sent again.
 *
 * Threads. Two frames share nothing. Calls on one frame MUST NOT overlap, except sheen_band() and sheen_bands() by
 * different workers if the configuration has a lock.
 *
 * Light (lecture, "Illumination Models"), with eye and lights at infinity:
 *   I_ad = ambient + sum over lights of diffuse * max(0, L.N)
 *   I_s  = sum over lights of specular * max(0, R.V)^n * min(1, 8 max(0, L.N));
 * colour = base * I_ad + highlight colour * I_s, clamped and rounded once per pixel. The last factor makes the
 * highlight end at L.N = 0 without a jump. In I_ad a material's ramp may replace max(0, L.N).
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
 * Constants in these formats, folded by the compiler. With a variable they would link soft floats, so GCC and clang
 * refuse that for processors without FPU. sheen_degrees() takes variables.
 */
#if defined(__GNUC__) && !defined(__cplusplus) && (defined(__SOFTFP__) || defined(__riscv_float_abi_soft))
#define SHEEN_CONSTANT(x) (0 * (int)sizeof(struct { int is_no_constant : __builtin_constant_p(x) ? 1 : -1; }))
#else
#define SHEEN_CONSTANT(x) 0
#endif
/* x in Q15.16. */
#define SHEEN_Q16(x) ((sheen_q16_t)((x)*65536.0 + ((x) < 0 ? -0.5 : 0.5)) + SHEEN_CONSTANT(x))
/* x in Q7.24. */
#define SHEEN_Q24(x) ((sheen_q24_t)((x)*16777216.0 + ((x) < 0 ? -0.5 : 0.5)) + SHEEN_CONSTANT(x))
/* x in Q1.30. */
#define SHEEN_Q30(x) ((sheen_q30_t)((x)*1073741824.0 + ((x) < 0 ? -0.5 : 0.5)) + SHEEN_CONSTANT(x))
/* x degrees as turns. */
#define SHEEN_DEGREES(x) ((sheen_angle_t)(int64_t)((x) / 360.0 * 4294967296.0) + (sheen_angle_t)SHEEN_CONSTANT(x))

/*
 * Any whole number of degrees, to the nearest step (8.4e-8 degrees); beyond +-1,000,000,000 to one of the two nearest.
 * 2^32 / 360 = 11930464 + 3054198966 / 2^32.
 */
static inline sheen_angle_t sheen_degrees(int32_t degrees)
{
    const uint64_t part = (uint64_t)((int64_t)degrees * 3054198966 + 2147483648);

    return (sheen_angle_t)degrees * 11930464u + (sheen_angle_t)(part >> 32);
}

/* ---- what is drawn ---- */

#define SHEEN_NO_TRIANGLE 0xffffu /* beyond a border */

/*
 * A triangle's three edges; edge k leads from corner k to the next one. An edge between two triangles is listed in
 * both, a border once.
 */
struct sheen_triangle_edges {
    uint16_t across[3]; /* the triangle beyond each edge; SHEEN_NO_TRIANGLE: none */
    uint8_t sharp;      /* bit k: border, or the two polygons' normals are farther apart than the crease angle */
    uint8_t inner;      /* bit k: both triangles belong to the same polygon */
};

/*
 * A mesh, usually const data in flash. Corners that differ in position or normal are different vertices. Triangles run
 * counter-clockwise seen from outside. Indices MUST be below `vertices` (sheen_mesh_check() verifies that).
 */
struct sheen_mesh {
    const int16_t *positions;       /* 3 per vertex: model = offset + scale * raw / 32768 */
    const int16_t *normals;         /* 3 per vertex: unit vectors, 1.0 = 32767; NULL: flat shading only */
    const int16_t *polygon_normals; /* 3 per polygon, likewise, for flat; NULL: from each triangle's corners */
    const uint16_t *polygons;       /* 1 per triangle: its polygon; NULL: triangle t is polygon t */
    const uint8_t *warp;   /* 1 per polygon, by sheen_mesh_warp(): polygons that face away are skipped early, and two
                              triangles of a plane polygon may be drawn as one; NULL: neither */
    const void *indices;   /* 3 per triangle */
    uint8_t index_bytes;   /* 1 or 2: uint8_t or uint16_t indices */
    uint16_t vertices;     /* 1..65535 */
    uint16_t triangles;    /* 1..65535 */
    sheen_q24_t scale;     /* units that raw 32768 stands for, > 0 */
    sheen_q24_t offset[3]; /* units */
    /*
     * Texture coordinates: (0, 0) is the upper left corner of the picture, (1, 1) the lower right one. Between corners
     * they are linear in space. Over a triangle u times the texture's width and v times its height MUST change by less
     * than 8192; if the texture clamps, both products MUST lie within -32767..32767.
     */
    const int16_t *uvs;       /* 2 per vertex: u = uv_offset[0] + raw / 2^uv_bits, v likewise; NULL: none */
    uint8_t uv_bits;          /* 0..15 */
    sheen_q16_t uv_offset[2]; /* of u and v */
    const uint8_t *colors;    /* 3 per vertex: r, g, b, 255 = 1.0, read by the colored shaders; NULL: white */
    const struct sheen_triangle_edges *edges; /* 1 per triangle, by sheen_mesh_edges(); NULL: edges cannot be drawn */
};

#define SHEEN_POWER_ENTRIES 256 /* steps of a power table */

/*
 * The table of s^n that highlights look up, for one shininess n: const data that materials may share. Each table below
 * is linked only if it is named. `sheen bake shine:N` writes any other as a header; sheen_shine_make() makes it in RAM.
 */
struct sheen_shine {
    /* s^n over u = 1 - s in [0, 2^-shift]: UQ1.15 << 16 | its decrease to the next entry; entry 0 is 1.0 once more */
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
 * A function D of L.N that replaces max(0, L.N) in a material's diffuse light (the highlight's fade still depends on
 * L.N itself): D = low + span * value, interpolated linearly between the entries. Const data that materials may share.
 * A ramp is linked only if it is named, and so is the code that reads ramps.
 */
struct sheen_ramp {
    const struct sheen_ramp_reader *reader; /* &sheen_ramp_reader */
    sheen_q16_t low, span;                  /* span 0: D is low; either times diffuse is limited to 4 */
    uint16_t value[SHEEN_RAMP_STEPS + 1];   /* at L.N = i / 128 - 1; UQ1.15, at most 1.0 */
    uint8_t steep;                          /* the slope of D is at most 2^steep, jumps aside; 0..15 */
};

/* The code that reads ramps. */
extern const struct sheen_ramp_reader sheen_ramp_reader;

/*
 * half: ((1 + L.N) / 2)^2, half-Lambert, which keeps the shape of the dark side. toon: 0, rising by a third at L.N = 0,
 * 1/4 and 0.7 (each from the next entry on).
 */
extern const struct sheen_ramp sheen_ramp_half, sheen_ramp_toon;

/*
 * A ramp made in RAM that puts light on the panel's gamma curve, for one light of intensity 1.0 and a material with
 * this ambient and diffuse: D = ((ambient + diffuse max(0, L.N))^(1 / 2.2) - ambient) / diffuse. SHEEN_ERR_ARGUMENT,
 * with *ramp untouched, unless ambient is in 0..4 and diffuse in 1/1024..4.
 */
int sheen_ramp_make_gamma(struct sheen_ramp *ramp, sheen_q16_t ambient, sheen_q16_t diffuse);

/*
 * A picture in flash or RAM: 2^width_log2 by 2^height_log2 texels, row by row from the top, without gaps. A texel is a
 * 565 colour (red / 31 in the high bits, green / 63, blue / 31) in the machine's byte order, whatever the target's.
 * With texel coordinates U = u * width and V = v * height, nearest takes texel (floor U, floor V); bilinear weights the
 * four texels around (U - 1/2, V - 1/2). A pixel whose nearest texel is transparent is not drawn and keeps its depth;
 * bilinear filtering takes that nearest texel in place of a transparent neighbour.
 *
 * Errors. U is off by at most zu = 1/16 texel plus what U changes over 1/16 px (if the mesh spans more than 1024
 * texels, 1/16384 of that span in place of 1/16 texel); V by zv likewise. If all texels within that reach are alike, a
 * nearest texel is exact. Bilinear colours are off by at most one step plus zu + zv times the largest difference
 * between the texels there; each step of that second term changes some 4 % of the pixels.
 */
struct sheen_texture {
    const void *texels;              /* bits 16: uint16_t, 565; 8 and 4: indices into the palette, one or two per
                                          byte, the left one of two in the low half */
    const uint16_t *palette;         /* 565; required with bits 8 and 4; long enough for the indices in use */
    uint8_t bits;                    /* per texel: 16, 8 or 4; 0: 16 */
    uint8_t width_log2, height_log2; /* 0..9 */
    uint8_t clamp_u, clamp_v;        /* outside 0..1: 1: the texel at the edge; 0: the picture repeats */
    uint8_t bilinear;                /* 1: bilinear; 0: nearest */
    uint8_t keyed;                   /* 1: texels of the colour `key` are transparent */
    uint16_t key;                    /* a 565 colour, with palettes too */
};

/* A surface, usually const data. All zero is black. */
struct sheen_material {
    uint8_t base[3];                     /* r, g, b, 255 = 1.0 */
    uint8_t highlight[3];                /* r, g, b of the specular part; all 0: white */
    uint8_t ambient_color[3];            /* r, g, b, read by the colored shaders; all 0: white */
    sheen_q16_t ambient;                 /* Ia ka, 0..4 */
    sheen_q16_t diffuse;                 /* Ip kd, 0..4 */
    sheen_q16_t specular;                /* Ip ks, 0..4 */
    const struct sheen_shine *shine;     /* required unless specular is 0 */
    const struct sheen_texture *texture; /* required by the textured and matcap shaders, ignored by others */
    const struct sheen_ramp *ramp;       /* replaces max(0, L.N); NULL: max(0, L.N) itself */
    uint8_t line[3];                     /* r, g, b of the lines that sheen_edges_outline and sheen_edges_wire draw */
};

struct sheen_points;

/* The code for point lights. */
extern const struct sheen_points sheen_points;

/*
 * A light at infinity or, for the colored flat and Gouraud shaders, textured or not, a point light. A point light at P
 * lights a point p at distance d with L = (P - p) / d (for d = 0, L = N); its diffuse and specular parts are multiplied
 * by max(0, 1 - d^2 / radius^2)^2. p is the corner or, for flat, the mean of the polygon's vertices; there a polygon's
 * triangles MUST follow each other.
 */
struct sheen_light {
    sheen_q30_t to[3];  /* direction to the light, any length but zero; world, or eye space if with_eye */
    sheen_q24_t at[3];  /* units: where a point light is, in the same space */
    sheen_q16_t radius; /* units, 0..1024: how far a point light reaches; 0: the light is at infinity */
    const struct sheen_points *points; /* &sheen_points: required unless radius is 0; linked only if named */
    sheen_q16_t intensity;             /* 0..1, multiplies the material's diffuse and specular; 0: 1.0 */
    uint8_t no_highlight;              /* 1: no specular part from this light */
    uint8_t with_eye;                  /* 1: the light moves with the eye */
    uint8_t color[3];                  /* r, g, b, read by the colored shaders; all 0: white */
};

#define SHEEN_MAX_LIGHTS 4 /* per object */

/* p -> scale * rotation * p + translation. A pose of zeros moves nothing, like sheen_pose_identity()'s. */
struct sheen_pose {
    sheen_q30_t rotation[9];    /* row by row: orthonormal rows, within 1/1024; all 0: no rotation. A matrix that
                                   mirrors turns front faces into back faces: reverse the triangles' winding then */
    sheen_q16_t scale;          /* >= 0; 0: 1.0 */
    sheen_q24_t translation[3]; /* units */
};

struct sheen_shader;

/*
 * How a triangle is shaded. A shader is linked only if it is named. slerp is a scan-line method: its result depends on
 * the triangle's orientation on the screen.
 */
extern const struct sheen_shader sheen_flat, sheen_gouraud, sheen_phong, sheen_slerp;

/*
 * With the colours of vertices, lights and ambient light, which the shaders above ignore. At a corner, base times the
 * vertex's colour replaces base, and the result is interpolated linearly in space (with view.affine on the screen); the
 * highlight is not tinted by it. A light's colour multiplies its diffuse and specular parts, ambient_color the ambient
 * light; a ramp's `low`, if it is positive, counts as light of the lights. As in flat and Gouraud, light is computed
 * per polygon or per vertex; if lights have colours it is computed again for each triangle.
 */
extern const struct sheen_shader sheen_flat_colored, sheen_gouraud_colored;

/*
 * The same with light per pixel, as in Phong and slerp: there the interpolated colours of the vertices multiply all but
 * the highlight. No point lights. With several lights, white ones included, these are faster than sheen_phong and
 * sheen_slerp, whose loops are made for one light.
 */
extern const struct sheen_shader sheen_phong_colored, sheen_slerp_colored;

/*
 * With the material's texture, for meshes with uvs: base times the texel replaces base; the highlight is not tinted.
 * sheen_textured is lit per vertex like Gouraud, sheen_textured_flat per polygon like flat. A white base with ambient
 * 1, diffuse 0 and specular 0 shows the texels as they are, and no time is spent on light.
 */
extern const struct sheen_shader sheen_textured, sheen_textured_flat;

/*
 * The same with the colours of vertices, lights and ambient light, as in sheen_gouraud_colored and sheen_flat_colored:
 * the texel multiplies their interpolated colour, except the highlight. Point lights too.
 */
extern const struct sheen_shader sheen_textured_colored, sheen_textured_flat_colored;

/*
 * With a picture of a lit sphere (the material's texture) instead of lights: base times the texel at ((1 + x) / 2, (1 -
 * y) / 2), where x and y are the normal's components in eye space. sheen_matcap interpolates the normal per pixel like
 * Phong; sheen_matcap_vertex interpolates the coordinates between the vertices, linearly in space. A bilinear texture
 * MUST clamp (clamp_u and clamp_v). Of the material only base and texture are read.
 */
extern const struct sheen_shader sheen_matcap, sheen_matcap_vertex;

/* The same, with base multiplied by the vertices' colours, linear in space (with view.affine on the screen). */
extern const struct sheen_shader sheen_matcap_colored, sheen_matcap_vertex_colored;

/*
 * Matcaps of 64 by 64 texels, 8 KB each, linked only if named: polished metal under a sky, glazed ware in a room with
 * windows, fired clay, polished jade. For bilinear filtering copy the struct and set bilinear to 1.
 */
extern const struct sheen_texture sheen_matcap_chrome, sheen_matcap_glaze, sheen_matcap_clay, sheen_matcap_jade;

struct sheen_stipple;

/*
 * Transparency without sorting or blending: pixels are left out in an ordered pattern, and what lies behind shows
 * between them. B is the 8x8 Bayer matrix, B2n = [[4 Bn, 4 Bn + 2], [4 Bn + 3, 4 Bn + 1]], B1 = [0]. A pixel (x, y) of
 * the target is drawn if B((x + phase) mod 8, y mod 8) < 64 - transparency; otherwise neither colour nor depth is
 * written. Two draws of the same phase cover the same pixels; with phases 0 and 1 they interleave. The pixels that are
 * left have low B only, so B itself cannot dither them: such a draw is dithered by B with its base-4 digits reversed,
 * 16 (B mod 4) + 4 (floor(B / 4) mod 4) + floor(B / 16). Linked only if named.
 */
extern const struct sheen_stipple sheen_stipple;

struct sheen_edges;

/*
 * What is drawn of a mesh's visible edges, over the triangles. Linked only if named; needs room (config.max_edges).
 * smooth: smooths contours, the edges between a triangle that faces the eye and one that does not, or none. A pixel
 *   that a contour crosses is mixed with its neighbour across the contour, by how much of it lies on either side.
 *   Needs config.smooth. On targets of 2 levels it draws nothing.
 * outline: draws contours and sharp edges as lines 1 px wide in the material's `line` colour, not dithered.
 * wire: draws all edges so, except those within a polygon. The triangles hide what lies behind them, whatever their
 *   colour.
 */
extern const struct sheen_edges sheen_edges_smooth, sheen_edges_outline, sheen_edges_wire;

struct sheen_morpher;

/* The code that mixes two frames of a mesh. */
extern const struct sheen_morpher sheen_morpher;

/*
 * A state between two frames of a moving mesh. With k = weight / 32768 a position is (1 - k) p0 + k p1, p0 from the
 * object's mesh and p1 from this one, rounded to the mesh's grid. Normals of corners and polygons are mixed likewise
 * and made unit length again (if they cancel, the first frame's is taken). Indices, polygons, uvs, colors and edges are
 * the object's mesh's. `warp` is ignored, so max_used may have to hold all vertices. Weight 0 gives exactly the mesh's
 * own picture.
 */
struct sheen_morph {
    /*
     * The frame at k = 1; borrowed until sheen_end() or sheen_finish() returns. Vertices, triangles, scale and offset
     * MUST equal the object's mesh's; it MUST have normals and polygon normals if that has them. Nothing else of it is
     * read.
     */
    const struct sheen_mesh *mesh;
    const struct sheen_morpher *morpher; /* &sheen_morpher: linked only if named */
    uint16_t weight;                     /* k, UQ1.15: 0..32768 */
};

/* What is drawn. Mesh, material and shader are required. */
struct sheen_object {
    const struct sheen_mesh *mesh;         /* borrowed */
    const struct sheen_material *material; /* borrowed */
    const struct sheen_shader *shader;     /* how it is shaded */
    const struct sheen_light *lights;      /* copied by sheen_draw() */
    uint8_t light_count;                   /* 0..SHEEN_MAX_LIGHTS; 0: ambient light alone */
    uint8_t two_sided;                     /* 1: back faces are drawn too, with their normals negated */
    struct sheen_pose pose;                /* model to world */
    const struct sheen_stipple *stipple;   /* &sheen_stipple: required unless transparency is 0 */
    uint8_t transparency;                  /* how many of 64 pixels are left out, 0..64; lines of edges are not */
    uint8_t phase;                         /* of the pattern, 0..7 */
    /*
     * Steps of 16-bit depth added to the depth that is tested and stored, -4096..4095, larger is nearer. It makes what
     * lies in another object's plane (a decal, an outline) visible. At each corner, cut corners included, the sum is
     * clamped to the depths of z_far and z_near, 257 and 65277 (struct sheen_canvas); what is clamped to z_far is not
     * drawn. A triangle with only some of its corners clamped is tilted in depth; an object far enough from both planes
     * is shifted as a whole.
     */
    int16_t depth_bias;
    const struct sheen_morph *morph; /* borrowed like the mesh; NULL: the mesh as it is */
    const struct sheen_edges *edges; /* what is drawn of mesh->edges, required then; NULL: nothing */
};

/*
 * A rectangle of the target before it is sent. Entry [0] is its top left pixel; rows are `pitch` entries apart. Pixels:
 * uint16_t in the target's byte order; on grey targets one byte per pixel, its level (packed afterwards). Depth: 257 +
 * 65020 (1/m - 1/z_far) / (1/z_near - 1/z_far), rounded; for an orthographic view 257 + 65020 (z_far - m) / (z_far -
 * z_near); up to 16 steps off if z_near and z_far are as close to each other as allowed; 257 where nothing was drawn.
 * An overlay can use it to pick, fog and test depth. What an underlay writes there, the triangles are tested against.
 */
struct sheen_canvas {
    struct sheen_rect rect; /* px on the target */
    unsigned pitch;         /* entries from one row to the next */
    void *pixels;           /* uint16_t, or uint8_t on greys */
    uint16_t *depth;        /* as many entries as pixels has */
    enum sheen_pixel pixel; /* the target's */
};

struct sheen_fog_mixer;

/* The code for fog on everything that is drawn. */
extern const struct sheen_fog_mixer sheen_fog_mixer;

/* The code for fog on the lines of edges alone. */
extern const struct sheen_fog_mixer sheen_line_fog_mixer;

/*
 * Fog. Its share at a pixel of depth m is f = (1/start - 1/m) / (1/start - 1/end), clamped to 0..1 (orthographic:
 * linear in m). That is linear in the 16-bit depth and computed from the depth that is stored, so a depth bias moves a
 * pixel in the fog too. The unrounded colour becomes colour + f (F - colour), F being the fog's colour rounded to the
 * target's levels, and is then rounded or dithered once. Everything that is drawn is fogged; lines of edges by their
 * own depth, from their own colour rounded likewise. The background is not fogged: full fog of the same colour meets it
 * without a seam. With sheen_line_fog_mixer faces are not fogged: those of a wire drawing keep the background's colour.
 */
struct sheen_fog {
    sheen_q24_t start, end;              /* m, units, 0 < start < end, at least 256 steps of depth apart */
    uint8_t color[3];                    /* r, g, b */
    const struct sheen_fog_mixer *mixer; /* &sheen_fog_mixer or &sheen_line_fog_mixer: linked only if named */
};

/* What the eye sees in one frame. */
struct sheen_view {
    /*
     * px on the target, edges on its alignment; empty: all of the target. Nothing outside it is drawn or sent, not even
     * marks. For several views in one picture begin and end them one after the other. If they share a frame, each view
     * is sent whole; with a frame per view, and sheen_wait() before the next one, only what the view touches is sent.
     */
    struct sheen_rect viewport;
    struct sheen_pose pose;      /* world to eye (sheen_pose_look_at, sheen_pose_orbit) */
    sheen_angle_t fov;           /* vertical field of view, 1..150 degrees (0.99..150.01 pass); 0: 40 */
    sheen_q24_t z_near, z_far;   /* units, 0 < z_near < z_far, z_far - z_near >= z_far / 2^15; what lies outside is not
                                   drawn; z_far 0: 16, z_near 0: z_far / 16 */
    sheen_q24_t orthographic;    /* 0: perspective; else the depth, units > 0, at which the picture is as high as fov
                                   says: sizes do not depend on depth then */
    uint8_t affine;              /* 1: shading linear on the screen (the distortion that Blinn's method corrects) */
    uint8_t dither;              /* 1: ordered 8x8 dithering, for panels of few levels */
    uint8_t background[3];       /* r, g, b; never dithered */
    const struct sheen_fog *fog; /* NULL: none; borrowed until sheen_end() or sheen_finish() returns */
    /*
     * 2D of your own: both callbacks may be NULL and get ctx. They are called for each rectangle of the target that
     * this frame sends: underlay instead of clearing to the background, overlay after drawing. Workers call them at
     * once, each for its own bands. Pointers and ctx count as background: if one of them, the colour or the viewport
     * differs from the last frame's, everything is sent. If only what they draw changes, call sheen_mark().
     */
    void *ctx;
    void (*underlay)(void *ctx, const struct sheen_canvas *canvas);
    void (*overlay)(void *ctx, const struct sheen_canvas *canvas);
};

/* ---- a frame ---- */

struct sheen_clipper;

/*
 * The code that cuts triangles which cross the near plane, the far plane or the guard band (511 px from the viewport's
 * centre). A program can do without it if each triangle lies inside all of these or wholly beyond one of them. Without
 * it a draw with a triangle that crosses one ends with SHEEN_ERR_CAPACITY, even if the triangle faces away (unless
 * `warp` lets its polygon be skipped) or nothing of it is in the picture; with the clipper such triangles need no
 * piece.
 */
extern const struct sheen_clipper sheen_clipper;

/*
 * The code that draws two triangles of a plane polygon as one quad, in the time and room of one triangle, if the mesh's
 * warp says that the polygon is plane and light is linear over both. That applies to front faces of objects that do not
 * morph, to triangles that follow each other as a fan and form a convex quad within the viewport; with sheen_flat; with
 * sheen_gouraud on the lit side without a highlight; with sheen_phong and sheen_slerp if the corners' normals are
 * linear and close to each other, as on globes, drums and the faces of boxes; except for flat, with one light and no
 * ramp. Flat pictures without fog are the same, others within one step, in fog within three. The number of listed
 * triangles then depends on light and view: set max_triangles to what single triangles would need, or to what you
 * measured to suffice.
 */
extern const struct sheen_quads sheen_quads;

/* Capacities, fixed by sheen_init(). They are totals of a frame; 0 takes the default in brackets. */
struct sheen_config {
    const struct sheen_target *target; /* borrowed for the frame's life */
    uint16_t band_rows;                /* rounded up to align_y; above the height: the height [16] */
    uint8_t buffers;                   /* 1, or 2: draw a band while the last one is sent [1] */
    uint8_t workers;                   /* 1..4, with buffers of their own, that may call sheen_band() at once [1] */
    uint16_t max_vertices;             /* of all meshes drawn in a frame; no default */
    uint16_t max_used;      /* of these, vertices of polygons that may face the eye [max_vertices, the most] */
    uint16_t max_triangles; /* listed: facing the eye and in view; no default */
    uint16_t max_draws;     /* [4] */
    uint16_t max_clipped;   /* listed pieces of triangles that the clipper cut [0] */
    uint8_t max_shades; /* on 565: how many colours get a table of finished pixels, 2.1 KB each, within a step [1] */
    uint8_t smooth;     /* 1: room for sheen_edges_smooth, a byte per pixel of a band and of 8 more rows [0] */
    /* Set-ups of triangles kept from band to band, 1..254 [max_triangles, at most 80]; too few cost time only. */
    uint16_t max_carried;
    /*
     * Edges drawn in a frame, plus 1 for each 64 triangles of the largest mesh whose edges are drawn [0: none]. With
     * them each band is drawn with one more row above and below, which edges look at and which is not sent; an underlay
     * gets these rows too. Ends of edges that the view volume cuts count towards max_vertices and max_used.
     */
    uint16_t max_edges;
    const struct sheen_clipper
        *clipper; /* &sheen_clipper: required unless max_clipped is 0; NULL: what it would cut is refused */
    const struct sheen_quads *quads; /* &sheen_quads, see above; NULL: triangles only */
    /*
     * For workers on several threads: lock and unlock, both called with lock_ctx, let one worker at a time through. The
     * core calls them in pairs, never nested, and calls the target's push and wait between them. Both NULL: workers
     * take turns on one thread.
     */
    void *lock_ctx;
    void (*lock)(void *ctx);
    void (*unlock)(void *ctx);
};

struct sheen_frame; /* lives in the arena */

/* Bytes of arena that sheen_init() needs, the same as SHEEN_ARENA_BYTES() gives; 0 if the configuration is invalid. */
size_t sheen_arena_size(const struct sheen_config *config);

/*
 * Set up a frame in the arena, which MUST be aligned to 8 bytes. *size is the arena's size. SHEEN_ERR_MEMORY: it is too
 * small; *size becomes the size needed, and nothing was written. SHEEN_ERR_ARGUMENT: a NULL, an unaligned arena, or
 * what sheen_config_about() names.
 */
int sheen_init(struct sheen_frame **frame, void *arena, size_t *size, const struct sheen_config *config);

/*
 * Start a frame. Waits for the last push of the frame before; if that failed its error is returned, and sheen_begin()
 * has to be called again. On any error the frame stays idle.
 */
int sheen_begin(struct sheen_frame *frame, const struct sheen_view *view);

/*
 * Transform, cull, clip and list a mesh; while the frame is open. On any error the frame is as it was before:
 * SHEEN_ERR_STATE, SHEEN_ERR_ARGUMENT, SHEEN_ERR_DEGENERATE (a light without direction) or SHEEN_ERR_CAPACITY.
 * sheen_frame_about() says more about the last three. An object that is far away is refused, not left out: along each
 * axis of eye space the distance of its origin plus twice its scale, mesh's times pose's, MUST stay below 128 units.
 */
int sheen_draw(struct sheen_frame *frame, const struct sheen_object *object);

/* Add a rectangle (px on the target) to what this frame clears, draws and sends; while the frame is open. */
int sheen_mark(struct sheen_frame *frame, struct sheen_rect rect);

/* Where a point appears on the target. */
struct sheen_spot {
    int32_t x, y;   /* 1/64 px on the target; at most 511 px from the viewport's centre */
    uint16_t depth; /* as in struct sheen_canvas; in front of z_near or beyond z_far depth, x and y are 0 */
    uint8_t inside; /* 1: between z_near and z_far and within the viewport, in pixel (x / 64, y / 64) */
};

/*
 * Project a point: for labels, cursors and picking; from sheen_begin() to the end of the frame. point: units, in the
 * space of a model with pose *model, or in the world if model is NULL. The result is within 1/64 px and one step of
 * depth of a vertex at that point. Something hides the point if the depth buffer at its pixel is larger than
 * spot->depth; an overlay can compare them when it gets the rectangle with that pixel. SHEEN_ERR_STATE, or
 * SHEEN_ERR_ARGUMENT if a pose is invalid or the point is more than 128 units from the eye along one of its axes; *spot
 * is untouched then.
 */
int sheen_locate(const struct sheen_frame *frame, const struct sheen_pose *model, const sheen_q24_t point[3],
                 struct sheen_spot *spot);

/* Draw and send every band that is not done yet: sheen_band() by worker 0 until an error, then sheen_finish(). */
int sheen_end(struct sheen_frame *frame);

/*
 * A whole frame: sheen_begin(), sheen_draw() for each object, sheen_end(). If a draw fails nothing is sent, its error
 * is returned, and the next frame sends everything; sheen_frame_about() says what was wrong, sheen_frame_stats() with
 * which object.
 */
int sheen_render(struct sheen_frame *frame, const struct sheen_view *view, const struct sheen_object *objects,
                 unsigned count);

/* What an error was about: a field, or a capacity. */
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
    SHEEN_ABOUT_DEPTHS,    /* z_near, z_far, orthographic */
    SHEEN_ABOUT_VIEW_POSE, /* its matrix is no rotation, or its scale is negative */
    SHEEN_ABOUT_POSE,      /* of an object: likewise, or the object is too far away (sheen_draw) */
    SHEEN_ABOUT_MESH,      /* of an object */
    SHEEN_ABOUT_NORMALS,
    SHEEN_ABOUT_MATERIAL,
    SHEEN_ABOUT_SHINE,
    SHEEN_ABOUT_RAMP,
    SHEEN_ABOUT_SHADER,
    SHEEN_ABOUT_LIGHTS,       /* missing, too many, out of range; point lights without points or with another shader */
    SHEEN_ABOUT_UVS,          /* missing, or uv_bits out of range */
    SHEEN_ABOUT_TEXTURE,      /* missing, out of range, without palette, or a bilinear matcap that does not clamp */
    SHEEN_ABOUT_TRANSPARENCY, /* transparency or phase out of range, or no stipple */
    SHEEN_ABOUT_FOG,          /* of the view */
    SHEEN_ABOUT_DEPTH_BIAS,
    SHEEN_ABOUT_MORPH,     /* its mesh does not match the object's, weight out of range, or no morpher */
    SHEEN_ABOUT_EDGES,     /* of an object: its mesh has none */
    SHEEN_ABOUT_MAX_EDGES, /* a capacity */
    SHEEN_ABOUT_SMOOTH,    /* likewise */
    SHEEN_ABOUT_CLIPPER    /* of the configuration: missing although max_clipped is not 0 */
};

/*
 * What the last sheen_begin(), sheen_draw() or sheen_render() that ended with SHEEN_ERR_ARGUMENT, SHEEN_ERR_DEGENERATE
 * or SHEEN_ERR_CAPACITY was about. *needed (which may be NULL): for a capacity, the least value with which everything
 * drawn so far and that object would have passed, else 0. For triangles and pieces it is exact, but the other of the
 * two may be too small then; for pieces without a clipper it is enough, 12 per triangle; for edges it is at first what
 * the mesh alone needs: try that and ask again.
 */
enum sheen_subject sheen_frame_about(const struct sheen_frame *frame, uint32_t *needed);

/* What sheen_init() would find wrong with a configuration. */
enum sheen_subject sheen_config_about(const struct sheen_config *config);

/* The name of the field. Never NULL. */
const char *sheen_subject_name(enum sheen_subject subject);

/*
 * Instead of sheen_end(), by hand: sheen_band() once for each band, in any order, by any worker, then sheen_finish().
 * Both return the frame's error once there is one. sheen_band() returns SHEEN_ERR_STATE for a band that is done
 * already, SHEEN_ERR_ARGUMENT for a band or worker that does not exist. If a band is left out the next frame sends
 * everything. Bands are numbered from 0 at the top; sheen_band_count() is that of the frame begun last, 0 before the
 * first.
 */
unsigned sheen_band_count(const struct sheen_frame *frame);
int sheen_band(struct sheen_frame *frame, unsigned worker, unsigned band);

/*
 * A worker's share of the bands: first its own part of the picture from the top down, then bands of other workers that
 * nobody has begun, until none is left. Each worker calls it; when all have returned call sheen_finish(). 0, the
 * frame's error, or SHEEN_ERR_ARGUMENT if there is no such worker.
 */
int sheen_bands(struct sheen_frame *frame, unsigned worker);
int sheen_finish(struct sheen_frame *frame);

/* Wait for the push under way, if any; returns its result. If negative, it is the error of a frame not yet finished. */
int sheen_wait(struct sheen_frame *frame);

/* Make the next frame send everything (because the panel was written to by others, or lost power). */
void sheen_invalidate(struct sheen_frame *frame);

/*
 * Counters of the frame since the last sheen_begin() that succeeded; those marked * count only in builds with
 * SHEEN_STATS=1.
 */
struct sheen_stats {
    uint32_t objects; /* drawn; after a sheen_render() that failed at an object, the index of that object */
    uint32_t triangles, front, clipped; /* given; facing the eye; cut */
    uint32_t drawn;                     /* listed, a quad counts once: what max_triangles has to hold */
    uint32_t used;                      /* vertices transformed: what max_used has to hold */
    uint32_t pieces;                    /* listed of cut triangles, also in drawn: what max_clipped has to hold */
    uint32_t carried;         /* what max_carried has to hold, at least 1; if it holds less: one more than it holds */
    uint32_t edges;           /* listed to be drawn */
    uint32_t setups, spans;   /* set-ups of triangles, again for each band if not carried; rows of triangles */
    uint32_t covered, shaded; /* px inside triangles; px that passed the depth test (*) */
    uint32_t rectangles, pixels; /* pushes and their area in px */
    /* B: the whole arena; its parts for max_vertices and max_used, for max_triangles, for pixels and depths of bands */
    uint32_t ram_arena, ram_vertices, ram_lists, ram_bands;
};

/* Copy the counters, which are kept until the next sheen_begin(). */
void sheen_frame_stats(const struct sheen_frame *frame, struct sheen_stats *stats);

/* ---- making what is drawn ---- */

/*
 * For a mesh that is made or moves at run time: its `warp`, which says how far a polygon is from plane. Measured over
 * the polygon's triangles: the largest |unit normal - the polygon's stored normal|, plus the distance of the triangle's
 * plane from the first corner of the polygon's first triangle, where 56,756 raw units (the farthest that a corner can
 * be from the origin) count as 1.0; UQ-2.10, rounded up, SHEEN_WARP_UNKNOWN if it does not fit. A polygon that is
 * plane, off by 2/1024 at most, gets a value up to SHEEN_WARP_PLANE instead, any other a larger one. Values below
 * SHEEN_WARP_PLANE say that the vertices' normals are linear, within 6 steps, over two triangles that follow each other
 * as a fan: the lower, the closer these normals are to each other, in 7 steps up to 15 degrees (core/math/bend.h). The
 * mesh MUST have polygon normals and have passed sheen_mesh_check().
 */
#define SHEEN_WARP_UNKNOWN 255
#define SHEEN_WARP_PLANE 9 /* up to this value a polygon is plane; two of its triangles may be drawn as one quad */
void sheen_mesh_warp(const struct sheen_mesh *mesh, uint32_t polygon_count, uint8_t *warp);

/*
 * For a mesh that is made at run time: its `edges`, one entry per triangle. Corners at the same place are the same
 * point; an edge joins two triangles that run along it in opposite directions (if there are more than two, the first
 * ones). It is sharp if the polygons' normals are farther apart than the crease angle. crease: the cosine of that angle
 * (0.5 for 60 degrees). A triangle with two corners at the same place has borders only. The mesh MUST have polygon
 * normals and have passed sheen_mesh_check() with `edges` NULL. scratch: SHEEN_EDGES_WORDS(vertices, triangles) words
 * of the caller's. Time: for each edge the triangles around one of its corners.
 */
#define SHEEN_EDGES_WORDS(vertices, triangles) (3 * (vertices) + 3 * (triangles))
void sheen_mesh_edges(const struct sheen_mesh *mesh, sheen_q30_t crease, uint32_t *scratch,
                      struct sheen_triangle_edges *edges);

/*
 * SHEEN_OK, or SHEEN_ERR_ARGUMENT if a count, pointer, index, polygon number or edge is out of range. polygon_count: of
 * polygon_normals; without these it is not read.
 */
int sheen_mesh_check(const struct sheen_mesh *mesh, uint32_t polygon_count);

sheen_q30_t sheen_sin(sheen_angle_t angle); /* within 2 raw steps of exact */
sheen_q30_t sheen_cos(sheen_angle_t angle); /* likewise */

/* rotation = Rz(roll) * Rx(pitch) * Ry(yaw), scale 1, the model's origin at depth `distance` (units). */
void sheen_pose_orbit(struct sheen_pose *pose, sheen_angle_t yaw, sheen_angle_t pitch, sheen_angle_t roll,
                      sheen_q24_t distance);

/* An identity rotation, scale 1, no translation. */
void sheen_pose_identity(struct sheen_pose *pose);

/*
 * Move once more what is posed already: turn it about the world's axis 0, 1 or 2 (x, y, z), counter-clockwise seen from
 * the axis's positive end; scale it about the origin; shift it. Errors as of sheen_pose_compose(); the pose is
 * untouched then.
 */
int sheen_pose_rotate(struct sheen_pose *pose, unsigned axis, sheen_angle_t angle);
int sheen_pose_scale(struct sheen_pose *pose, sheen_q16_t factor);
int sheen_pose_translate(struct sheen_pose *pose, sheen_q24_t x, sheen_q24_t y, sheen_q24_t z);

/*
 * out = outer * inner: the model is moved by inner, then by outer. out may be one of the two. Scale and translation are
 * rounded once; the rotation is made orthonormal again (if both are so, its entries are within 12 raw steps of the
 * product), so that sheen_draw() accepts the result of any number of compositions. SHEEN_ERR_ARGUMENT if a matrix is no
 * rotation, or scale or translation leave their range; out is untouched then.
 */
int sheen_pose_compose(const struct sheen_pose *outer, const struct sheen_pose *inner, struct sheen_pose *out);

/*
 * Repair a rotation that drifted or was made from rounded numbers: the third row keeps its direction, the second is
 * turned to a right angle within the plane of the two, the first follows; a mirroring matrix stays one. Rows of any
 * length become unit rows (squared lengths and dot products within 16 raw steps). SHEEN_ERR_DEGENERATE if one of the
 * last two rows is zero or they are parallel (within 1e-6); the pose is untouched then.
 */
int sheen_pose_orthonormalize(struct sheen_pose *pose);

/*
 * A view's pose (world to eye) for an eye at `eye` that looks at `target`, with `up` upwards. SHEEN_ERR_DEGENERATE if
 * up is parallel to the line of sight or target is the eye, SHEEN_ERR_ARGUMENT if the world's origin is more than 128
 * units from the eye along one of its axes.
 */
int sheen_pose_look_at(struct sheen_pose *pose, const sheen_q24_t eye[3], const sheen_q24_t target[3],
                       const int32_t up[3]);

/* v scaled to unit length, each part within 4 raw steps of exact. SHEEN_ERR_DEGENERATE: v is zero; out is untouched. */
int sheen_normalize(const int32_t v[3], sheen_q30_t out[3]);

/*
 * Newell's normal of a polygon (lecture, "Polygon Normals"), unit length, each part within 4 raw steps of exact.
 * points: 3 per point, in any common scale, |coordinate| <= 2^28; corners: count (>= 3) indices into points.
 * SHEEN_ERR_DEGENERATE if the area is zero.
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
 *     sheen_corner_angles(&list, facing, angles);            not needed if all polygons count alike (NULL below)
 *     sheen_vertex_normals(&list, around, facing, angles, unit);
 *     for (i = 0; i < 3 * POINTS; i++)
 *         mesh_normals[i] = (int16_t)((int64_t)unit[i] * 32767 / (1 << 30));
 */
struct sheen_polygon_list {
    const int32_t *points;   /* 3 per point, in any common scale, |coordinate| <= 2^28 */
    const uint32_t *corners; /* indices into points, those of all polygons one after another */
    const uint32_t *sizes;   /* corners of each polygon, >= 3 */
    uint32_t point_count, corner_count, polygon_count; /* lengths of the three arrays */
};

/*
 * Lists the polygons around each point, one entry for each corner there, in `around`: SHEEN_AROUND_WORDS words of the
 * caller's. Checks the polygon list as well: SHEEN_ERR_ARGUMENT if an index or a size is out of range or the sizes do
 * not add up to corner_count. The functions below MUST only get a list that passed.
 */
#define SHEEN_AROUND_WORDS(point_count, corner_count) ((point_count) + 1 + 2 * (corner_count))
int sheen_polygons_around(const struct sheen_polygon_list *list, uint32_t *around);

/* sheen_polygon_normal() of each polygon, 3 parts each; zero for a polygon without area. */
void sheen_polygon_normals(const struct sheen_polygon_list *list, sheen_q30_t *normals);

/*
 * The interior angle at each corner, within SHEEN_ANGLE_ROUNDING raw steps (4e-8 rad): more than half a turn if the
 * polygon turns right there, seen from the side that its normal points to; 0 if an edge at the corner has no length.
 */
#define SHEEN_ANGLE_ROUNDING 24
void sheen_corner_angles(const struct sheen_polygon_list *list, const sheen_q30_t *polygon_normals,
                         sheen_angle_t *angles);

/*
 * Vertex normals: the normalised sum of the unit normals around each point, 3 parts each. Zero if they cancel, if all
 * of them are zero, or if no polygon has the point.
 * weights: for each corner, the weight of its polygon's normal; with the corners' angles the result does not depend on
 * how polygons are cut into triangles. NULL: all equal (lecture, "Vertex Normals").
 */
void sheen_vertex_normals(const struct sheen_polygon_list *list, const uint32_t *around,
                          const sheen_q30_t *polygon_normals, const uint32_t *weights, sheen_q30_t *normals);

/*
 * The same for each corner, 3 parts each: the sum over the corner's own polygon and those around its point whose
 * normals are within the crease angle of that polygon's normal. crease: the cosine of the angle; -1.0 takes all (a
 * difference below 2e-8 counts as within). If the sum is zero the result is the polygon's normal, which is zero if it
 * has no area. Time: for each corner the polygons around its point; polygons around a point that face alike are
 * computed once.
 */
void sheen_corner_normals(const struct sheen_polygon_list *list, const uint32_t *around,
                          const sheen_q30_t *polygon_normals, const uint32_t *weights, sheen_q30_t crease,
                          sheen_q30_t *normals);

/*
 * Cut a polygon into count - 2 triangles, 3 places in `corners` (0 .. count - 1) each, wound like the polygon. normal:
 * from sheen_polygon_normal(). A polygon that is convex in projection along its normal (a straight corner counts as
 * convex) becomes the fan (0, k, k + 1); from any other ears are cut, each time the first valid one in the order of the
 * corners. The tests are exact. A hole may be joined by a cut that is listed in both directions. A polygon that crosses
 * or touches itself may run out of ears; then its first corner is cut: there are still count - 2 triangles whose signed
 * areas add up to the polygon's, but they may overlap, face backwards or have no area. SHEEN_ERR_DEGENERATE if normal
 * is zero; nothing is written then.
 * points and corners as above, count >= 3; scratch: SHEEN_TRIANGULATE_WORDS(count) words of the caller's.
 * Time: proportional to count for a convex polygon, usually to count^2 for others, to count^3 at worst.
 */
#define SHEEN_TRIANGULATE_WORDS(count) (3 * (count))
int sheen_triangulate(const int32_t *points, const uint32_t *corners, unsigned count, const sheen_q30_t normal[3],
                      uint32_t *scratch, uint32_t *triangles);

#ifdef __cplusplus
}
#endif
#endif
