/*
 * feature_list.h - the features that a frame's time is made of: they are counted exactly on the host, and each costs
 * about the same every time.
 *
 * A feature is a line here and a count: a SHEEN_TAP in the core, or a sum in count.c. A kind of rows is a line in
 * SHEEN_PLAN_KINDS and one in count.c's table. Rows of texels have a way, counted by features, and a kind in
 * SHEEN_PLAN_TEXELS. tests/bench/costs finds what each feature costs on each processor (costs.c).
 */
#ifndef SHEEN_PLAN_FEATURE_LIST_H
#define SHEEN_PLAN_FEATURE_LIST_H

/* The part of a frame's time that a feature belongs to. */
enum sheen_plan_stage {
    SHEEN_PLAN_TRANSFORM, /* back-face culling, vertices and their light, lists */
    SHEEN_PLAN_TRIANGLES, /* set-ups, and carrying them through the bands */
    SHEEN_PLAN_ROWS,
    SHEEN_PLAN_PIXELS, /* of triangles; also clearing, packing and handing over to the panel's driver */
    SHEEN_PLAN_STAGES
};

/* F(NAME, stage) */
#define SHEEN_PLAN_FEATURES(F)                                                                                         \
    F(FRAME, TRANSFORM)                                                                                                \
    F(OBJECT, TRANSFORM)                                                                                               \
    F(SHADES_MADE, TRANSFORM)                                                                                          \
    F(MESH_VERTEX, TRANSFORM)    /* vertices of the objects' meshes, used or not */                                    \
    F(FACING, TRANSFORM)         /* polygons tested for facing away */                                                 \
    F(SKIPPED, TRANSFORM)        /* triangles of polygons that face away */                                            \
    F(LOOKED_AT, TRANSFORM)      /* triangles of other polygons */                                                     \
    F(QUAD_LOOKED_AT, TRANSFORM) /* pairs of triangles that may be a plane quad */                                     \
    F(QUAD_LISTED, TRANSFORM)    /* quads listed or passed over: their triangles are not LOOKED_AT */                  \
    F(USED, TRANSFORM)           /* vertices transformed */                                                            \
    F(LIT, TRANSFORM)            /* normals lit, except FACET_LIT's */                                                 \
    F(LIGHT, TRANSFORM)          /* normals lit, facets' too, times their lights */                                    \
    F(COSINES, TRANSFORM)        /* vertices whose normal's cosines are kept, for a matcap */                          \
    F(LISTED, TRANSFORM)         /* triangles listed */                                                                \
    F(CLIPPED, TRANSFORM)        /* triangles clipped */                                                               \
    F(RAMP_LIGHT, TRANSFORM)     /* normals lit by a ramp, times their lights */                                       \
    F(TINTED, TRANSFORM)         /* normals lit by lights with colours */                                              \
    F(TINTED_LIGHT, TRANSFORM)   /* these normals, times the lights */                                                 \
    F(MORPHED, TRANSFORM)        /* positions between two frames of a mesh */                                          \
    F(MORPHED_NORMAL, TRANSFORM)                                                                                       \
    F(EDGE_TRIANGLE, TRANSFORM)       /* triangles of meshes whose edges are looked for */                             \
    F(EDGE, TRANSFORM)                /* edges listed */                                                               \
    F(BAND, TRIANGLES)                /* bands, with or without triangles */                                           \
    F(PENDING_WORD, TRIANGLES)        /* words searched for triangles not done yet, 32 per word, times bands */        \
    F(CARRIED, TRIANGLES)             /* triangles carried from the band above */                                      \
    F(PARTIAL, TRIANGLES)             /* set-ups of triangles that go on in the band below */                          \
    F(LONG_EDGE, TRIANGLES)           /* edges of 32 px and more */                                                    \
    F(WIDE, TRIANGLES)                /* set-ups of triangles of 256 px and more */                                    \
    F(QUAD, TRIANGLES)                /* set-ups of quads */                                                           \
    F(FACET_LIT, TRIANGLES)           /* facets lit, each at the first of its triangles */                             \
    F(CHANNELS, TRIANGLES)            /* set-ups of three planes, one per colour channel */                            \
    F(COLORED, TRIANGLES)             /* corners whose channels include a vertex colour */                             \
    F(TEXELS_STRAIGHT, TRIANGLES)     /* set-ups of texels, linear on the screen */                                    \
    F(TEXELS_SPHERE, TRIANGLES)       /* the same for a matcap */                                                      \
    F(TEXELS_SKEWED, TRIANGLES)       /* set-ups of texels in perspective */                                           \
    F(TEXELS_CURVED, TRIANGLES)       /* set-ups of a matcap's texels, quadratic */                                    \
    F(TEXELS_TURNED, TRIANGLES)       /* set-ups of a matcap's texels, by normals */                                   \
    F(TEXELS_SHARED, TRIANGLES)       /* set-ups of texels with colours */                                             \
    F(TEXELS_LIGHT, TRIANGLES)        /* TEXELS_STRAIGHT with light */                                                 \
    F(TEXELS_SKEWED_LIGHT, TRIANGLES) /* TEXELS_SKEWED with light */                                                   \
    F(TINTED_QUADRIC, TRIANGLES)      /* quadrics made of lights and colours, times bands */                           \
    F(LINE_LOOKED_AT, TRIANGLES)      /* lines, times bands */                                                         \
    F(LINE_BAND, TRIANGLES)           /* lines drawn, times bands */                                                   \
    F(EMPTY_ROW, ROWS)                /* rows of a triangle that have no pixel in the tile */                          \
    F(STRIP, ROWS)                    /* strips of a triangle whose stipple pattern is laid out at once */             \
    F(STRIP_ROW, ROWS)                /* rows of these strips */                                                       \
    F(TEXEL_ROW, ROWS)                                                                                                 \
    F(SKEWED_BLOCK, ROWS)        /* blocks of rows of texels in perspective */                                         \
    F(SKEWED_END, ROWS)          /* pixels where such a block may end */                                               \
    F(SKEWED_LIGHT_END, ROWS)    /* such pixels with light */                                                          \
    F(CURVED_BLOCK, ROWS)        /* blocks of a matcap's rows, quadratic */                                            \
    F(TURNED_BLOCK, ROWS)        /* blocks of a matcap's rows, by normals */                                           \
    F(COLORED_END, ROWS)         /* pixels where a part of a row of texels with colours may end */                     \
    F(FOGGED_PART, ROWS)         /* parts of rows of texels under fog */                                               \
    F(FOGGED_TRY, ROWS)          /* ends of such parts that are tried */                                               \
    F(PUSH, PIXELS)              /* rectangles handed to the driver */                                                 \
    F(CLEARED, PIXELS)           /* px of 565 pushed; as many are cleared */                                           \
    F(CLEARED_GREY, PIXELS)      /* px of greys pushed, likewise */                                                    \
    F(PACKED_16, PIXELS)         /* px of 16 greys packed, by core and driver */                                       \
    F(PACKED_2, PIXELS)          /* px of 2 greys packed */                                                            \
    F(PIXEL_18, PIXELS)          /* px that the driver expands to 3 bytes */                                           \
    F(POWER, PIXELS)             /* look-ups in a power table */                                                       \
    F(HIGHLIGHT, PIXELS)         /* px of quadratic triangles in a highlight */                                        \
    F(CELL, PIXELS)              /* Phong's cells */                                                                   \
    F(CELL_ROW, PIXELS)          /* rows of cells */                                                                   \
    F(CELL_DULL, PIXELS)         /* px of cells without highlight, not drawn by squares */                             \
    F(CELL_POWER, PIXELS)        /* px of cells with a highlight, not drawn by squares */                              \
    F(NODE, PIXELS)              /* nodes of cells */                                                                  \
    F(SQUARE_CORNER, PIXELS)     /* corners of squares within cells */                                                 \
    F(SQUARE_ROW, PIXELS)        /* rows of cells drawn by squares */                                                  \
    F(SQUARE_PART, PIXELS)       /* parts of squares that are cut or drawn one by one */                               \
    F(PIXEL_LIGHT, PIXELS)       /* px shaded by their normal, times lights */                                         \
    F(TINTED_STEP, PIXELS)       /* px covered by TINTED_CURVED, times their quadrics */                               \
    F(ARC_PART, PIXELS)          /* parts of slerp's rows, quadratic */                                                \
    F(ARC_ALONE, PIXELS)         /* such parts at a single place on the arc */                                         \
    F(SKEWED_PART, PIXELS)       /* parts of slerp's rows in perspective, NORMAL_PART too */                           \
    F(ARC_POWER, PIXELS)         /* px of ARC_PART and ARC_ALONE with a highlight */                                   \
    F(NORMAL_PART, PIXELS)       /* parts of slerp's rows whose normals are linear */                                  \
    F(GENERAL_565, PIXELS)       /* px of 565 shaded by loops that also draw greys */                                  \
    F(FOG_HELD, PIXELS)          /* px covered in rows where fog begins or ends, or of greys */                        \
    F(FOG, PIXELS)               /* px shaded under fog by loops that also draw without fog */                         \
    F(FOG_DITHERED, PIXELS)      /* px of quadratic intensities under fog that are dithered */                         \
    F(RAMP, PIXELS)              /* px shaded by a ramp, times lights */                                               \
    F(HIDDEN, PIXELS)            /* px left out by a stipple pattern */                                                \
    F(NARROW, PIXELS)            /* px of narrow rows of a stipple pattern */                                          \
    F(TEXEL_DITHERED, PIXELS)    /* px shaded of texels that are dithered */                                           \
    F(TEXEL_APART, PIXELS)       /* px covered by texels whose coordinates take two words */                           \
    F(TEXEL_MIXED_APART, PIXELS) /* px shaded of four such texels */                                                   \
    F(TEXEL_NIBBLE, PIXELS)      /* px covered by texels of 4 bits */                                                  \
    F(TEXEL_CELL, PIXELS)        /* how often four texels are read for pixels in a row */                              \
    F(TEXEL_MIXED, PIXELS)       /* px mixed of four texels of any kind */                                             \
    F(SMOOTH_STEP, PIXELS)       /* px that contours cross */                                                          \
    F(SMOOTH_ROW, PIXELS)        /* rows of bands, with marks or without */                                            \
    F(LINE_STEP, PIXELS)         /* px that other lines cross, outside the band too */                                 \
    F(LINE_PIXEL, PIXELS)        /* such px within the band */                                                         \
    F(MIXED, PIXELS)             /* px smoothed */

/* K(NAME): kinds of rows, each with its set-ups, rows, px covered and px shaded. */
#define SHEEN_PLAN_KINDS(K)                                                                                            \
    K(CONSTANT) /* one colour */                                                                                       \
    K(CONSTANT_GREY)                                                                                                   \
    K(CONSTANT_DITHERED)                                                                                               \
    K(CONSTANT_GREY_DITHERED)                                                                                          \
    K(SHADES)      /* one linear intensity, finished pixels from the shades */                                         \
    K(SHADES_WIDE) /* the same on triangles larger than 32 px */                                                       \
    K(SHADES_DITHERED)                                                                                                 \
    K(PACKED) /* channels in two words */                                                                              \
    K(PACKED_DITHERED)                                                                                                 \
    K(COLUMNS) /* channels in two words, packed anew every 32 px */                                                    \
    K(COLUMNS_DITHERED)                                                                                                \
    K(CLAMPED) /* channels, clamped at each pixel */                                                                   \
    K(CLAMPED_GREY)                                                                                                    \
    K(CURVED_SHADES) /* one quadratic, finished pixels from the shades */                                              \
    K(CURVED_SHADES_DITHERED)                                                                                          \
    K(CURVED_DITHERED) /* one quadratic, dithered */                                                                   \
    K(CURVED_POWER)    /* two quadratics, the second into a power table */                                             \
    K(CURVED_POWER_DITHERED)                                                                                           \
    K(CURVED_SPECULAR) /* two quadratics, both intensities */                                                          \
    K(CURVED_SPECULAR_DITHERED)                                                                                        \
    K(CURVED_GENERAL)     /* one quadratic: greys, and what is clamped */                                              \
    K(CURVED_GENERAL_TWO) /* two quadratics: likewise */                                                               \
    K(QUOTIENT)           /* Blinn's I/m over 1/m */                                                                   \
    K(QUOTIENT_GREY)                                                                                                   \
    K(CELLS)                                                                                                           \
    K(CELLS_DITHERED)                                                                                                  \
    K(CELLS_GENERAL) /* greys, and what is clamped */                                                                  \
    K(ROOT)          /* one light, a root per pixel */                                                                 \
    K(LIGHTS)        /* several lights, a root per pixel */                                                            \
    K(NEEDLE)        /* one light by the way of several, for triangles that other ways do not draw */                  \
    K(TINTED)        /* normals and colours at pixels: Phong, and slerp by NORMAL_PART too */                          \
    K(TINTED_CURVED) /* the same, by quadrics */                                                                       \
    K(SLERP)         /* great arcs; also rows that are not in count.c's table */                                       \
    K(SLERP_DITHERED)                                                                                                  \
    K(SLERP_GENERAL) /* greys, and what is clamped */                                                                  \
    K(SLERP_NORMALS) /* several lights, or arcs wider than a right angle */                                            \
    K(FOGGED)        /* channels under fog */                                                                          \
    K(FOGGED_DITHERED)                                                                                                 \
    K(FOGGED_CONSTANT)                                                                                                 \
    K(FOGGED_CURVED) /* quadratic intensities under fog, on 565, over triangles */                                     \
    K(FOGGED_CELLS)  /* the same, over Phong's cells */                                                                \
    K(FOGGED_ARCS)   /* the same, along slerp's arcs */

/* T(NAME): kinds of pixels of texels (triangle/textured.h), each with px covered and px shaded. */
#define SHEEN_PLAN_TEXELS(T)                                                                                           \
    T(ANY)                                                                                                             \
    T(ANY_GREY)                                                                                                        \
    T(UNLIT)                                                                                                           \
    T(LIT)                                                                                                             \
    T(GLOSSY)                                                                                                          \
    T(OTHER) /* with a palette or a key, unlit */                                                                      \
    T(OTHER_LIT)                                                                                                       \
    T(BILINEAR)       /* unlit, of 565, not dithered */                                                                \
    T(BILINEAR_OTHER) /* unlit */                                                                                      \
    T(BILINEAR_LIT)                                                                                                    \
    T(FOGGED)                                                                                                          \
    T(FOGGED_APART) /* texels whose coordinates take two words */                                                      \
    T(FOGGED_OTHER) /* with a palette or a key, or bilinear */                                                         \
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
