/* Made by `sheen bake builtin:cube`. */
/* clang-format off */
#ifndef cube_MESH_H_81ac4c24
#define cube_MESH_H_81ac4c24

#include "sheen.h"

#if defined(__cplusplus) && defined(__GNUC__)
#pragma GCC system_header /* fields by name */
#endif

static const int16_t cube_positions[72] = {
    -18918, -18918, 18918, 18918, -18918, 18918, 18918, 18918, 18918, -18918, 18918, 18918, 18918, -18918, -18918,
    -18918, -18918, -18918, -18918, 18918, -18918, 18918, 18918, -18918, 18918, -18918, 18918, 18918, -18918,
    -18918, 18918, 18918, -18918, 18918, 18918, 18918, -18918, -18918, -18918, -18918, -18918, 18918, -18918, 18918,
    18918, -18918, 18918, -18918, -18918, 18918, 18918, 18918, 18918, 18918, 18918, 18918, -18918, -18918, 18918,
    -18918, -18918, -18918, -18918, 18918, -18918, -18918, 18918, -18918, 18918, -18918, -18918, 18918,
};
static const int16_t cube_normals[72] = {
    0, 0, 32767, 0, 0, 32767, 0, 0, 32767, 0, 0, 32767, 0, 0, -32767, 0, 0, -32767, 0, 0, -32767, 0, 0, -32767,
    32767, 0, 0, 32767, 0, 0, 32767, 0, 0, 32767, 0, 0, -32767, 0, 0, -32767, 0, 0, -32767, 0, 0, -32767, 0, 0, 0,
    32767, 0, 0, 32767, 0, 0, 32767, 0, 0, 32767, 0, 0, -32767, 0, 0, -32767, 0, 0, -32767, 0, 0, -32767, 0,
};
static const int16_t cube_polygon_normals[18] = {
    0, 0, 32767, 0, 0, -32767, 32767, 0, 0, -32767, 0, 0, 0, 32767, 0, 0, -32767, 0,
};
static const uint16_t cube_polygons[12] = {
    0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 5, 5,
};
static const uint8_t cube_warp[6] = {
    1, 1, 1, 1, 1, 1,
};
static const uint8_t cube_indices[36] = {
    0, 1, 2, 0, 2, 3, 4, 5, 6, 4, 6, 7, 8, 9, 10, 8, 10, 11, 12, 13, 14, 12, 14, 15, 16, 17, 18, 16, 18, 19, 20, 21,
    22, 20, 22, 23,
};
static const struct sheen_mesh cube = {
    .positions = cube_positions,
    .normals = cube_normals,
    .polygon_normals = cube_polygon_normals,
    .polygons = cube_polygons,
    .warp = cube_warp,
    .indices = cube_indices,
    .index_bytes = 1,
    .vertices = 24,
    .triangles = 12,
    .scale = 16777728,
    .offset = {0, 0, 0},
};

#define cube_vertices 24
#define cube_triangles 12

#endif
