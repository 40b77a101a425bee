/*
 * sim_panel_ideal.c - the driver of the panel `ideal`: sends the window if it changed, then pixels.
 *
 * It sends what the DCS driver sends for a panel without gap, but shares no code with it, so that the two can be
 * compared.
 */
#include "sim_panel_ideal.h"

static int send_range(const struct sheen_bus *bus, uint8_t command, int first, int last)
{
    uint8_t data[4] = {(uint8_t)(first >> 8), (uint8_t)first, (uint8_t)(last >> 8), (uint8_t)last};
    int error = bus->send(bus->ctx, &command, 1, data, sizeof data);

    return error < 0 ? error : bus->wait(bus->ctx);
}

static int push(void *ctx, struct sheen_rect rect, const void *pixels)
{
    struct sheen_sim_ideal *ideal = ctx;
    struct sheen_rect held = ideal->window;
    const uint8_t write_memory = 0x2C;
    int error = SHEEN_OK;

    ideal->window = (struct sheen_rect){0}; /* unknown until all of this has been sent */
    if (rect.x0 != held.x0 || rect.x1 != held.x1)
        error = send_range(ideal->bus, 0x2A, rect.x0, rect.x1 - 1);
    if (error == SHEEN_OK && (rect.y0 != held.y0 || rect.y1 != held.y1))
        error = send_range(ideal->bus, 0x2B, rect.y0, rect.y1 - 1);
    if (error == SHEEN_OK)
        error = ideal->bus->send(ideal->bus->ctx, &write_memory, 1, pixels,
                                 (size_t)(rect.x1 - rect.x0) * (size_t)(rect.y1 - rect.y0) * 2);
    if (error == SHEEN_OK)
        ideal->window = rect;
    return error;
}

static int wait(void *ctx)
{
    struct sheen_sim_ideal *ideal = ctx;
    int error = ideal->bus->wait(ideal->bus->ctx);

    if (error < 0)
        ideal->window = (struct sheen_rect){0};
    return error;
}

void sheen_sim_ideal_target(struct sheen_sim_ideal *ideal, const struct sheen_bus *bus, uint16_t width, uint16_t height,
                            struct sheen_target *target)
{
    *ideal = (struct sheen_sim_ideal){.bus = bus};
    *target = (struct sheen_target){.ctx = ideal,
                                    .push = push,
                                    .wait = wait,
                                    .width = width,
                                    .height = height,
                                    .pixel = SHEEN_RGB565_BE,
                                    .align_x = 1,
                                    .align_y = 1};
}
