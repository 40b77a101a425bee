/*
 * main.c - a firmware that names the shadings SHADERS, the clipper if CLIPPER is defined, quads if QUADS is defined,
 * one panel, and otherwise only what a frame needs.
 */
#include "sheen.h"
#include "sheen_panel.h"

#ifdef CLIPPER
#define PIECES 32
#define CUTS (&sheen_clipper)
#else
#define PIECES 0
#define CUTS NULL
#endif
#ifdef QUADS
#define BY_QUADS (&sheen_quads)
#else
#define BY_QUADS NULL
#endif

extern const struct sheen_mesh mesh;
extern const struct sheen_material material;
extern const struct sheen_light light;
extern const struct sheen_bus bus;
extern uint64_t arena[];
extern size_t arena_bytes;
extern volatile unsigned which;

int main(void)
{
    static const struct sheen_shader *const shaders[] = {SHADERS};
    const struct sheen_view view = {.z_near = SHEEN_Q24(1.95), .z_far = SHEEN_Q24(4.05), .dither = 1};
    struct sheen_panel panel;
    struct sheen_target target;
    struct sheen_frame *frame;
    const struct sheen_config config = {.target = &target,
                                        .max_vertices = 530,
                                        .max_triangles = 512,
                                        .max_clipped = PIECES,
                                        .clipper = CUTS,
                                        .quads = BY_QUADS};
    struct sheen_object object = {
        .mesh = &mesh, .material = &material, .shader = shaders[which], .lights = &light, .light_count = 1};

    sheen_pose_orbit(&object.pose, sheen_degrees((int32_t)which), 0, 0, SHEEN_Q24(3));
    return sheen_panel_open(&panel, &sheen_panel_st7789_240x240, &bus, 0) || sheen_panel_target(&panel, &target) ||
           sheen_init(&frame, arena, &arena_bytes, &config) || sheen_render(frame, &view, &object, 1);
}
