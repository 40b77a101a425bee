/*
 * flash.c - the smallest firmware: one shading SHADER and, if they are defined, a panel PANEL, the mesh and power table
 * of the header MESH, TEXTURE, FOG, STIPPLE, RAMP, MORPH, EDGES, CLIPPER. What the linker keeps of it is the flash that
 * `sheen plan` reports.
 */
#include "sheen.h"
#ifdef PANEL
#include "sheen_panel.h"
extern const struct sheen_bus bus;
#endif
#ifdef MESH
#include MESH
#define SHINE .shine = &sheen_shine_32
#else
extern const struct sheen_mesh mesh;
#define SHINE .shine = NULL
#endif

#ifndef TEXTURE
#define TEXTURE NULL
#endif
#ifdef RAMP
extern struct sheen_ramp curve;
#define CURVE &curve
#else
#define CURVE NULL
#endif
#ifndef EDGES
#define EDGES NULL
#endif

extern const struct sheen_light light;
extern uint64_t arena[];
extern size_t arena_bytes;
extern volatile unsigned yaw;

int main(void)
{
    static const struct sheen_material material = {
        .base = {200, 160, 80}, .diffuse = 50000, .specular = 20000, SHINE, .texture = TEXTURE, .ramp = CURVE};
    struct sheen_view view = {.z_near = SHEEN_Q24(1.95), .z_far = SHEEN_Q24(4.05), .dither = 1};
    struct sheen_frame *frame;
    struct sheen_object object = {
        .mesh = &mesh, .material = &material, .shader = &SHADER, .lights = &light, .light_count = 1, .edges = EDGES};
    int error = 0;

#ifdef FOG
    const struct sheen_fog fog = {SHEEN_Q24(2), SHEEN_Q24(4), {90, 100, 110}, &sheen_fog_mixer};
    view.fog = &fog;
#endif
#ifdef RAMP
    curve.reader = &sheen_ramp_reader;
#endif
#ifdef STIPPLE
    object.stipple = &sheen_stipple;
    object.transparency = 32;
#endif
#ifdef MORPH
    const struct sheen_morph morph = {&mesh, &sheen_morpher, 16384};
    object.morph = &morph;
#endif
    sheen_pose_orbit(&object.pose, sheen_degrees((int32_t)yaw), 0, 0, SHEEN_Q24(3));
#ifdef PANEL
    struct sheen_panel panel;
    struct sheen_target target;
    error = sheen_panel_open(&panel, &PANEL, &bus, 0) || sheen_panel_target(&panel, &target);
#else
    extern const struct sheen_target target;
#endif
    struct sheen_config config = {.target = &target, .max_vertices = 530, .max_triangles = 512};
#ifdef CLIPPER
    config.max_clipped = 32;
    config.clipper = &sheen_clipper;
#endif
    return error || sheen_init(&frame, arena, &arena_bytes, &config) || sheen_render(frame, &view, &object, 1);
}
