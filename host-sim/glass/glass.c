/*
 * glass.c - from controller memory to what an observer sees.
 */
#include "glass.h"

int sheen_sim_glass_has(const struct sheen_sim_module *module, unsigned column, unsigned row)
{
    /* Twice the distance of the pixel's centre from the glass's centre, compared with twice the radius. */
    int dx = 2 * (int)column + 1 - module->glass_w, dy = 2 * (int)row + 1 - module->glass_h;

    return !module->round || dx * dx + dy * dy <= module->glass_w * module->glass_w;
}

uint16_t sheen_sim_glass(const struct sheen_sim_controller *controller, unsigned column, unsigned row)
{
    const struct sheen_sim_module *module = controller->module;

    if (!sheen_sim_glass_has(module, column, row))
        return 0;
    if (module->mirror_x)
        column = module->glass_w - 1u - column;
    if (module->mirror_y)
        row = module->glass_h - 1u - row;
    return module->chip->shown(controller, column + module->gap_x, row + module->gap_y);
}

void sheen_sim_glass_place(const struct sheen_sim_module *module, unsigned orientation, unsigned x, unsigned y,
                           unsigned *column, unsigned *row)
{
    unsigned w = module->glass_w, h = module->glass_h;

    if (orientation & 4)
        x = (orientation & 1 ? h : w) - 1 - x;
    switch (orientation & 3) {
    case 0:
        *column = x, *row = y;
        break;
    case 1: /* the viewer's top left is the glass's top right */
        *column = w - 1 - y, *row = x;
        break;
    case 2:
        *column = w - 1 - x, *row = h - 1 - y;
        break;
    default: /* the viewer's top left is the glass's bottom left */
        *column = y, *row = h - 1 - x;
        break;
    }
}

void sheen_sim_expand(uint16_t value, unsigned max_level, uint8_t rgb[3])
{
    if (max_level) {
        rgb[0] = rgb[1] = rgb[2] = (uint8_t)((510u * value + max_level) / (2 * max_level));
        return;
    }
    unsigned r = value >> 11, g = value >> 5 & 63, b = value & 31;

    rgb[0] = (uint8_t)(r << 3 | r >> 2);
    rgb[1] = (uint8_t)(g << 2 | g >> 4);
    rgb[2] = (uint8_t)(b << 3 | b >> 2);
}
