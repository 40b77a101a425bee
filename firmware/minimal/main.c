/*
 * main.c - the smallest complete program: a cube that turns on an OLED of 16 greys.
 */
#include "sheen.h"
#include "sheen_panel.h"

/*
 * The bus is the part that you write: three short functions. Here it is a PL022 SPI and a pin for
 * D/C; the board's start-up code has set up clocks, pins and SPI.
 */
#define SPI ((volatile uint32_t *)0x40008000)
#define SPI_DATA SPI[2]
#define SPI_STATUS SPI[3]
#define SPI_BUSY_OR_RECEIVED 0x14u
#define DC_PIN *(volatile uint32_t *)0x40006200 /* port C bit 7 */
#define DC_LOW 0x00u
#define DC_HIGH 0x80u

static void put(uint32_t dc, const void *bytes, size_t count)
{
    DC_PIN = dc;
    for (size_t i = 0; i < count; i++)
        for (SPI_DATA = ((const uint8_t *)bytes)[i]; SPI_STATUS & SPI_BUSY_OR_RECEIVED;)
            (void)SPI_DATA;
}

static int send(void *ctx, const uint8_t *command, size_t commands, const void *data, size_t count)
{
    (void)ctx;
    put(DC_LOW, command, commands);
    put(DC_HIGH, data, count);
    return SHEEN_OK;
}

static int delay(void *ctx, uint32_t us)
{
    (void)ctx;
    for (uint32_t turns = us * 10; turns; turns--) /* each turn takes at least 5 clocks at 50 MHz */
        (void)SPI_STATUS;
    return SHEEN_OK;
}

enum {
    WIDTH = 128, /* of the panel */
    HEIGHT = 64,
    VERTICES = 8, /* of the cube */
    TRIANGLES = 12
};

/* The cube's corners are at distance 1 from its centre, so each coordinate is +-32767 / sqrt(3). */
#define C 18918
static const int16_t corners[] = {-C, -C, -C, C, -C, -C, -C, C, -C, C, C, -C, -C, -C, C, C, -C, C, -C, C, C, C, C, C};
static const uint8_t triangles[] = {0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 4, 6, 0, 6, 2,
                                    1, 3, 7, 1, 7, 5, 0, 1, 5, 0, 5, 4, 2, 6, 7, 2, 7, 3};
static const struct sheen_mesh cube = {.positions = corners,
                                       .indices = triangles,
                                       .index_bytes = 1,
                                       .vertices = VERTICES,
                                       .triangles = TRIANGLES,
                                       .scale = SHEEN_Q24(1)};
static const struct sheen_material gold = {.base = {240, 208, 128}, .ambient = SHEEN_Q16(.2), .diffuse = SHEEN_Q16(.8)};
static const struct sheen_light lamp = {.to = {-3, 5, 6}};
static const struct sheen_view view = {.z_near = SHEEN_Q24(1.95), .z_far = SHEEN_Q24(4.05), .dither = 1};

int main(void)
{
    static uint64_t arena[SHEEN_ARENA_DEFAULT_BYTES(WIDTH, HEIGHT, 1, VERTICES, TRIANGLES) / 8]; /* 1 B a pixel */
    size_t size = sizeof arena;
    struct sheen_bus bus = {.send = send, .delay = delay};
    struct sheen_panel panel;
    struct sheen_target target;
    struct sheen_frame *frame;
    struct sheen_config config = {.target = &target, .max_vertices = VERTICES, .max_triangles = TRIANGLES};
    struct sheen_object object = {
        .mesh = &cube, .material = &gold, .shader = &sheen_flat, .lights = &lamp, .light_count = 1};
    int error = sheen_panel_open(&panel, &sheen_panel_ssd0323, &bus, 0) || sheen_panel_target(&panel, &target) ||
                sheen_init(&frame, arena, &size, &config);

    for (int32_t yaw = 30; !error; yaw += 6) {
        sheen_pose_orbit(&object.pose, sheen_degrees(yaw), sheen_degrees(20), 0, SHEEN_Q24(3));
        error = sheen_render(frame, &view, &object, 1);
    }
    return error;
}
