/*
 * feature_list.h - what a frame's time is made of: what is counted exactly on the host and costs about the same each
 * time.
 *
 * A feature is a line here and a count: a SHEEN_TAP in the core, or a sum in count.c. A kind of rows is a line in
 * SHEEN_PLAN_KINDS and one in count.c's table; rows of texels are of a way, which features stand for, and of a kind in
 * SHEEN_PLAN_TEXELS. What each costs on which processor tests/bench/costs finds (costs.c).
 */
#ifndef SHEEN_PLAN_FEATURE_LIST_H
#define SHEEN_PLAN_FEATURE_LIST_H

/* The part of a frame's time that a feature belongs to. */
enum sheen_plan_stage {
    SHEEN_PLAN_TRANSFORM, /* polygons that face away, vertices, light at them, lists */
    SHEEN_PLAN_TRIANGLES, /* set-ups, and their way through the bands */
    SHEEN_PLAN_ROWS,
    SHEEN_PLAN_PIXELS, /* of triangles; cleared, packed, handed to the panel's driver */
    SHEEN_PLAN_STAGES
};

/* F(NAME, stage) */
#define SHEEN_PLAN_FEATURES(F)                                                                                         \
    F(FRAME, TRANSFORM)                                                                                                \
    F(OBJECT, TRANSFORM)                                                                                               \
    F(SHADES_MADE, TRANSFORM)                                                                                          \
    F(MESH_VERTEX, TRANSFORM)    /* of the objects' meshes, used or not */                                             \
    F(FACING, TRANSFORM)         /* polygons that were asked whether they face away */                                 \
    F(SKIPPED, TRANSFORM)        /* triangles of those that do */                                                      \
    F(LOOKED_AT, TRANSFORM)      /* triangles of the others */                                                         \
    F(QUAD_LOOKED_AT, TRANSFORM) /* pairs of triangles that may be a plane quad */                                     \
    F(QUAD_LISTED, TRANSFORM)    /* of them, or passed over: two triangles that are not looked at */                   \
    F(USED, TRANSFORM)           /* vertices transformed */                                                            \
    F(LIT, TRANSFORM)            /* normals lit, but for FACET_LIT's */                                                \
    F(LIGHT, TRANSFORM)          /* times their lights, facets' too */                                                 \
    F(COSINES, TRANSFORM)        /* vertices whose cosines are kept */                                                 \
    F(LISTED, TRANSFORM)         /* triangles */                                                                       \
    F(CLIPPED, TRANSFORM)        /* triangles cut */                                                                   \
    F(RAMP_LIGHT, TRANSFORM)     /* normals lit by a ramp, times their lights */                                       \
    F(TINTED, TRANSFORM)         /* normals lit by lights with colours */                                              \
    F(TINTED_LIGHT, TRANSFORM)   /* times these */                                                                     \
    F(MORPHED, TRANSFORM)        /* positions between two frames of a mesh */                                          \
    F(MORPHED_NORMAL, TRANSFORM)                                                                                       \
    F(EDGE_TRIANGLE, TRANSFORM)       /* triangles whose edges were looked for */                                      \
    F(EDGE, TRANSFORM)                /* edges listed */                                                               \
    F(BAND, TRIANGLES)                /* with or without triangles */                                                  \
    F(PENDING_WORD, TRIANGLES)        /* looked through for triangles that are not done, 32 a word and band */         \
    F(CARRIED, TRIANGLES)             /* triangles that go on from the band above */                                   \
    F(PARTIAL, TRIANGLES)             /* set-ups of triangles that go on below */                                      \
    F(LONG_EDGE, TRIANGLES)           /* of 32 px and more */                                                          \
    F(WIDE, TRIANGLES)                /* set-ups of triangles of 256 px and more */                                    \
    F(QUAD, TRIANGLES)                /* set-ups of quads */                                                           \
    F(FACET_LIT, TRIANGLES)           /* facets lit, at the first of their triangles */                                \
    F(CHANNELS, TRIANGLES)            /* set-ups of three planes of channels */                                        \
    F(COLORED, TRIANGLES)             /* corners whose channels are made of colours */                                 \
    F(TEXELS_STRAIGHT, TRIANGLES)     /* set-ups of texels: linear, */                                                 \
    F(TEXELS_SPHERE, TRIANGLES)       /* linear, of a matcap, */                                                       \
    F(TEXELS_SKEWED, TRIANGLES)       /* in perspective, */                                                            \
    F(TEXELS_CURVED, TRIANGLES)       /* quadratic: a matcap's, */                                                     \
    F(TEXELS_TURNED, TRIANGLES)       /* and by normals */                                                             \
    F(TEXELS_SHARED, TRIANGLES)       /* with colours */                                                               \
    F(TEXELS_LIGHT, TRIANGLES)        /* with light, linear, */                                                        \
    F(TEXELS_SKEWED_LIGHT, TRIANGLES) /* or in perspective */                                                          \
    F(TINTED_QUADRIC, TRIANGLES)      /* made of lights and colours, times bands */                                    \
    F(LINE_LOOKED_AT, TRIANGLES)      /* lines, times bands */                                                         \
    F(LINE_BAND, TRIANGLES)           /* lines drawn, times bands */                                                   \
    F(EMPTY_ROW, ROWS)                /* without a pixel */                                                            \
    F(STRIP, ROWS)                    /* parts of a triangle whose pattern was laid out at a time */                   \
    F(STRIP_ROW, ROWS)                /* of these */                                                                   \
    F(TEXEL_ROW, ROWS)                                                                                                 \
    F(SKEWED_BLOCK, ROWS)        /* of rows of texels in perspective */                                                \
    F(SKEWED_END, ROWS)          /* where one may end */                                                               \
    F(SKEWED_LIGHT_END, ROWS)    /* with light */                                                                      \
    F(CURVED_BLOCK, ROWS)        /* quadratic */                                                                       \
    F(TURNED_BLOCK, ROWS)        /* by normals */                                                                      \
    F(COLORED_END, ROWS)         /* where a part of one with colours may end */                                        \
    F(FOGGED_PART, ROWS)         /* of texels under fog */                                                             \
    F(FOGGED_TRY, ROWS)          /* ends of these that were tried */                                                   \
    F(PUSH, PIXELS)              /* rectangles handed to the driver */                                                 \
    F(CLEARED, PIXELS)           /* px of 565 */                                                                       \
    F(CLEARED_GREY, PIXELS)      /* px */                                                                              \
    F(PACKED_16, PIXELS)         /* px of 16 greys, by core and driver */                                              \
    F(PACKED_2, PIXELS)          /* px of 2 greys */                                                                   \
    F(PIXEL_18, PIXELS)          /* px that the driver makes 3 bytes of */                                             \
    F(POWER, PIXELS)             /* looked up in a power table */                                                      \
    F(HIGHLIGHT, PIXELS)         /* px of quadratic triangles in a highlight */                                        \
    F(CELL, PIXELS)              /* of Phong's cells */                                                                \
    F(CELL_ROW, PIXELS)          /* their rows */                                                                      \
    F(CELL_DULL, PIXELS)         /* px of those without highlight, not by squares */                                   \
    F(CELL_POWER, PIXELS)        /* px of those with one, not by squares */                                            \
    F(NODE, PIXELS)              /* of cells */                                                                        \
    F(SQUARE_CORNER, PIXELS)     /* within cells */                                                                    \
    F(SQUARE_ROW, PIXELS)        /* rows of cells by squares */                                                        \
    F(SQUARE_PART, PIXELS)       /* their squares that are cut or taken one by one */                                  \
    F(PIXEL_LIGHT, PIXELS)       /* px shaded by several lights, times these */                                        \
    F(TINTED_STEP, PIXELS)       /* px covered by TINTED_CURVED, times their quadrics */                               \
    F(ARC_PART, PIXELS)          /* of slerp's rows, quadratic */                                                      \
    F(ARC_ALONE, PIXELS)         /* those of one place on the arc */                                                   \
    F(SKEWED_PART, PIXELS)       /* parts of slerp's rows in perspective, of both kinds */                             \
    F(ARC_POWER, PIXELS)         /* px of both with a highlight */                                                     \
    F(NORMAL_PART, PIXELS)       /* of slerp's rows, whose normals are linear */                                       \
    F(GENERAL_565, PIXELS)       /* px of 565 shaded by loops that also take greys */                                  \
    F(FOG_HELD, PIXELS)          /* px covered in rows where fog begins or ends, or of greys */                        \
    F(FOG, PIXELS)               /* px shaded under fog by loops that also do without */                               \
    F(FOG_DITHERED, PIXELS)      /* px of quadratic intensities under fog that are dithered */                         \
    F(RAMP, PIXELS)              /* px shaded by a ramp, times lights */                                               \
    F(HIDDEN, PIXELS)            /* px left out by a pattern */                                                        \
    F(NARROW, PIXELS)            /* px of a pattern's narrow rows */                                                   \
    F(TEXEL_DITHERED, PIXELS)    /* px shaded of texels that are dithered */                                           \
    F(TEXEL_APART, PIXELS)       /* px covered by texels whose coordinates take two words */                           \
    F(TEXEL_MIXED_APART, PIXELS) /* px shaded of four such texels */                                                   \
    F(TEXEL_NIBBLE, PIXELS)      /* px covered by texels of 4 bits */                                                  \
    F(TEXEL_CELL, PIXELS)        /* times that four texels are read for pixels in a row */                             \
    F(TEXEL_MIXED, PIXELS)       /* px of four texels of any kind */                                                   \
    F(SMOOTH_STEP, PIXELS)       /* px that contours cross */                                                          \
    F(SMOOTH_ROW, PIXELS)        /* of bands, with marks or without */                                                 \
    F(LINE_STEP, PIXELS)         /* px that other lines cross, in bands where they are not too */                      \
    F(LINE_PIXEL, PIXELS)        /* of these, the band's own */                                                        \
    F(MIXED, PIXELS)             /* px smoothed */

/* K(NAME): kinds of rows, each with its set-ups, rows, px covered and px shaded. */
#define SHEEN_PLAN_KINDS(K)                                                                                            \
    K(CONSTANT) /* one colour */                                                                                       \
    K(CONSTANT_GREY)                                                                                                   \
    K(CONSTANT_DITHERED)                                                                                               \
    K(CONSTANT_GREY_DITHERED)                                                                                          \
    K(SHADES)      /* one intensity, finished pixels from its shades */                                                \
    K(SHADES_WIDE) /* of triangles over 32 px */                                                                       \
    K(SHADES_DITHERED)                                                                                                 \
    K(PACKED) /* channels in two words */                                                                              \
    K(PACKED_DITHERED)                                                                                                 \
    K(COLUMNS) /* channels in two words, packed anew every 32 px */                                                    \
    K(COLUMNS_DITHERED)                                                                                                \
    K(CLAMPED) /* channels, clamped */                                                                                 \
    K(CLAMPED_GREY)                                                                                                    \
    K(CURVED_SHADES) /* one quadratic intensity, its shades */                                                         \
    K(CURVED_SHADES_DITHERED)                                                                                          \
    K(CURVED_DITHERED) /* one, dithered */                                                                             \
    K(CURVED_POWER)    /* two, a power table */                                                                        \
    K(CURVED_POWER_DITHERED)                                                                                           \
    K(CURVED_SPECULAR) /* two, both intensities */                                                                     \
    K(CURVED_SPECULAR_DITHERED)                                                                                        \
    K(CURVED_GENERAL)     /* one: greys, and what is clamped */                                                        \
    K(CURVED_GENERAL_TWO) /* two */                                                                                    \
    K(QUOTIENT)           /* Blinn's I/m over 1/m */                                                                   \
    K(QUOTIENT_GREY)                                                                                                   \
    K(CELLS)                                                                                                           \
    K(CELLS_DITHERED)                                                                                                  \
    K(CELLS_GENERAL) /* greys, and what is clamped */                                                                  \
    K(ROOT)          /* one light, a root a pixel */                                                                   \
    K(LIGHTS)        /* several */                                                                                     \
    K(NEEDLE)        /* one light and the way of several: what the others do not take */                               \
    K(TINTED)        /* normals and colours of the pixels: Phong, and slerp by NORMAL_PART too */                      \
    K(TINTED_CURVED) /* the same by quadrics */                                                                        \
    K(SLERP)         /* great arcs; and what is not in count.c's table */                                              \
    K(SLERP_DITHERED)                                                                                                  \
    K(SLERP_GENERAL) /* greys, and what is clamped */                                                                  \
    K(SLERP_NORMALS) /* of several lights, or wider than a right angle */                                              \
    K(FOGGED)        /* channels under fog */                                                                          \
    K(FOGGED_DITHERED)                                                                                                 \
    K(FOGGED_CONSTANT)                                                                                                 \
    K(FOGGED_CURVED) /* quadratic intensities under fog, on 565: of triangles, */                                      \
    K(FOGGED_CELLS)  /* of Phong's cells, */                                                                           \
    K(FOGGED_ARCS)   /* of slerp's arcs */

/* T(NAME): what pixels of texels take (triangle/textured.h), each with px covered and px shaded. */
#define SHEEN_PLAN_TEXELS(T)                                                                                           \
    T(ANY)                                                                                                             \
    T(ANY_GREY)                                                                                                        \
    T(UNLIT)                                                                                                           \
    T(LIT)                                                                                                             \
    T(GLOSSY)                                                                                                          \
    T(OTHER) /* of a palette or with a key, unlit */                                                                   \
    T(OTHER_LIT)                                                                                                       \
    T(BILINEAR)       /* unlit, of 565, not dithered */                                                                \
    T(BILINEAR_OTHER) /* unlit */                                                                                      \
    T(BILINEAR_LIT)                                                                                                    \
    T(FOGGED)                                                                                                          \
    T(FOGGED_APART) /* whose coordinates take two words */                                                             \
    T(FOGGED_OTHER) /* of a palette, with a key, or bilinear */                                                        \
    T(COLORED)      /* of any kind, with colours */

#define SHEEN_PLAN_FEATURE_NUMBER(name, stage) SHEEN_PLAN_##name,
#define SHEEN_PLAN_KIND_NUMBERS(name)                                                                                  \
    SHEEN_PLAN_##name##_SETUP, SHEEN_PLAN_##name##_ROW, SHEEN_PLAN_##name##_COVERED, SHEEN_PLAN_##name##_SHADED,
#define SHEEN_PLAN_TEXELS_NUMBERS(name) SHEEN_PLAN_TEXELS_##name##_COVERED, SHEEN_PLAN_TEXELS_##name##_SHADED,

enum sheen_plan_feature {
    SHEEN_PLAN_FEATURES(SHEEN_PLAN_FEATURE_NUMBER)
    SHEEN_PLAN_KINDS(SHEEN_PLAN_KIND_NUMBERS) SHEEN_PLAN_TEXELS(SHEEN_PLAN_TEXELS_NUMBERS) SHEEN_PLAN_COUNTS
};

#endif
