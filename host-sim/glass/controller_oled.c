/*
 * controller_oled.c - what the simulated OLED controllers share: COM lines, address counters.
 *
 * The glass is wired to outputs (segments and COM lines), so a module's gap and mirror are given in these; which RAM
 * row a COM line shows depends on registers.
 */
#include "controller.h"

/*
 * The RAM row that COM line `com` shows; -1 if the line is not driven. With COM remap on, lines are counted from `top`
 * downwards. The display offset is added before the multiplex ratio is applied and the start line after it, which
 * agrees with the published settings of glasses that use only some of the lines, upright and turned.
 */
int sheen_sim_com_row(const struct sheen_sim_controller *controller, unsigned com, unsigned top)
{
    unsigned height = controller->module->ram_h;
    unsigned line = ((controller->com_remap ? top + height - com : com) + controller->row_offset) % height;

    return line > controller->multiplex ? -1 : (int)((line + controller->start_line) % height);
}

/* Goes on to the next address in the window: along x first, or if `vertical`, along y first. */
void sheen_sim_next_address(struct sheen_sim_controller *controller, int vertical)
{
    uint16_t *fast = vertical ? &controller->y : &controller->x, *slow = vertical ? &controller->x : &controller->y;
    uint16_t fast_start = vertical ? controller->y0 : controller->x0,
             fast_end = vertical ? controller->y1 : controller->x1;
    uint16_t slow_start = vertical ? controller->x0 : controller->y0,
             slow_end = vertical ? controller->x1 : controller->y1;

    if ((*fast)++ < fast_end)
        return;
    *fast = fast_start;
    if ((*slow)++ >= slow_end)
        *slow = slow_start;
}

/*
 * Call it when picture data arrive for an address: counts rectangles and reports an impossible window. width, height:
 * the RAM's, in units of the address.
 */
void sheen_sim_check_window(struct sheen_sim_controller *controller, unsigned width, unsigned height)
{
    if (controller->x == controller->x0 && controller->y == controller->y0)
        controller->rectangles++;
    if (controller->x0 > controller->x1 || controller->x1 >= width || controller->y0 > controller->y1 ||
        controller->y1 >= height)
        sheen_sim_complain(controller, "window %u..%u, %u..%u of %ux%u", controller->x0, controller->x1, controller->y0,
                           controller->y1, width, height);
}

void sheen_sim_set_brightness(struct sheen_sim_controller *controller)
{
    controller->brightness = controller->params[0];
}

/* AE and AF. */
void sheen_sim_set_on(struct sheen_sim_controller *controller)
{
    controller->on = controller->command & 1;
}

/* A4 to A7, whose meanings differ from chip to chip. */
void sheen_sim_set_mode(struct sheen_sim_controller *controller)
{
    controller->mode = controller->command & 3;
}

/* Setting a range also sets its address counter to the range's start. */
void sheen_sim_set_columns(struct sheen_sim_controller *controller)
{
    controller->x = controller->x0 = controller->params[0];
    controller->x1 = controller->params[1];
}

void sheen_sim_set_rows(struct sheen_sim_controller *controller)
{
    controller->y = controller->y0 = controller->params[0];
    controller->y1 = controller->params[1];
}
