// Teapot: a teapot turns on a panel on hardware SPI. Fill in your panel's record, pins and orientation below.
#include <sheen_arduino.h>
#include "teapot.h" // made by: sheen bake builtin:teapot

SheenSPI display(9, 10, 8); // D/C, CS, reset; -1: not wired
const sheen_panel_record &record = sheen_panel_ssd0323;
const unsigned orientation = 0;
const sheen_shader &shading = sheen_phong;

// For this panel's width, height and bytes per pixel (1: greys, 2: colours), and for this mesh.
uint64_t arena[SHEEN_ARENA_DEFAULT_BYTES(128, 64, 1, teapot_vertices, teapot_triangles) / 8];
sheen_frame *frame;
sheen_material gold;
sheen_light lamp;
sheen_view view;
sheen_object teapot_object;
int error;

void setup()
{
    size_t size = sizeof arena;
    sheen_config config = sheen_config();

    Serial.begin(115200);
    error = display.begin(record, orientation);
    config.target = &display.target;
    config.max_vertices = teapot_vertices;
    config.max_triangles = teapot_triangles;
    if (!error)
        error = sheen_init(&frame, arena, &size, &config);

    gold.base[0] = 200;
    gold.base[1] = 160;
    gold.base[2] = 80;
    gold.ambient = SHEEN_Q16(.1);
    gold.diffuse = SHEEN_Q16(.6);
    gold.specular = SHEEN_Q16(.3);
    gold.shine = &sheen_shine_32;
    lamp.to[0] = -5;
    lamp.to[1] = 7;
    lamp.to[2] = 5;
    view.z_near = SHEEN_Q24(1.95);
    view.z_far = SHEEN_Q24(4.05);
    view.dither = 1;
    teapot_object.mesh = &teapot;
    teapot_object.material = &gold;
    teapot_object.shader = &shading;
    teapot_object.lights = &lamp;
    teapot_object.light_count = 1;
    teapot_object.two_sided = 1; // because one can see into it
    Serial.println(sheen_strerror(error));
}

void loop()
{
    static int32_t yaw = 30;

    if (error)
        return;
    sheen_pose_orbit(&teapot_object.pose, sheen_degrees(yaw), sheen_degrees(20), 0, SHEEN_Q24(3));
    error = sheen_render(frame, &view, &teapot_object, 1);
    yaw += 6;
    Serial.println(sheen_strerror(error));
}
