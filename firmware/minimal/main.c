/*
 * main.c - the smallest complete program: a cube, Phong shaded, on an OLED of 16 greys.
 *
 * The bus is three functions, here for an SPI of the kind PL022 (ctx: its registers)
 * and a pin for D/C. The board's start-up code has set up clocks, pins and SPI.
 */
#include "sheen.h"
#include "sheen_panel.h"

#define K 18918 /* 32767 / sqrt(3): a corner at distance 1, and its unit normal */
static const int16_t corners[] = {-K, -K, -K, K, -K, -K, -K, K, -K, K, K, -K, -K, -K, K, K, -K, K, -K, K, K, K, K, K};
static const char triangles[] = "\0\2\3\0\3\1\4\5\7\4\7\6\0\4\6\0\6\2\1\3\7\1\7\5\0\1\5\0\5\4\2\6\7\2\7\3";
static const struct sheen_mesh cube = {corners, corners, NULL, NULL, triangles, 1, 8, 12, SHEEN_Q24(1), {0}};

/* Bytes with D/C, port C bit 7, low or high; each has left before the next. */
static void put(volatile uint32_t *spi, uint32_t dc, const uint8_t *bytes, size_t count)
{
    for (*(volatile uint32_t *)0x40006200 = dc; count; count--)
        for (spi[2] = *bytes++; spi[3] & 0x14;) /* data; status: busy, or something received */
            (void)spi[2];
}

static int send(void *ctx, const uint8_t *command, size_t commands, const void *data, size_t count)
{
    put(ctx, 0, command, commands);
    put(ctx, 0x80, data, count);
    return SHEEN_OK;
}

static int delay(void *ctx, uint32_t us)
{
    for (volatile uint32_t turns = us * 10; turns; turns--) /* of at least 5 clocks of 50 MHz */
        (void)ctx;
    return SHEEN_OK;
}

int main(void)
{
    static uint64_t arena[2000];
    struct sheen_bus bus = {.ctx = (void *)0x40008000, .send = send, .delay = delay};
    struct sheen_panel panel;
    struct sheen_target target;
    struct sheen_frame *frame;
    struct sheen_config config = {.target = &target, .max_vertices = 8, .max_triangles = 12, .max_carried = 12};
    struct sheen_view view = {.fov = SHEEN_DEGREES(40), .near = SHEEN_Q24(1.95), .far = SHEEN_Q24(4.05), .dither = 1};
    struct sheen_material gold = {{200, 160, 80}, {255, 255, 255}, SHEEN_Q16(.1), SHEEN_Q16(.6), SHEEN_Q16(.3), 32};
    struct sheen_draw draw = {&cube, &gold, &(struct sheen_light){{-5, 7, 5}, SHEEN_Q16(1), 1}, 1, &sheen_phong};

    sheen_pose_orbit(&draw.pose, SHEEN_DEGREES(30), SHEEN_DEGREES(20), 0, SHEEN_Q24(3));
    return sheen_material_prepare(&gold) || sheen_panel_open(&panel, &sheen_panel_ssd0323, &bus, 0) ||
           sheen_panel_target(&panel, &target) || sheen_init(&frame, arena, &(size_t){sizeof arena}, &config) ||
           sheen_begin(frame, &view) || sheen_draw(frame, &draw) || sheen_end(frame) || sheen_wait(frame);
}
