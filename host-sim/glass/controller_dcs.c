/*
 * controller_dcs.c - the simulated MIPI-DCS controllers.
 *
 * MADCTL works as the ILI9341 and ST7789 data sheets tabulate it ("Memory to display address mapping"): MV maps the
 * host's columns to RAM rows; MX and MY then count RAM columns and rows from the last one.
 */
#include "controller.h"

#define MY 0x80
#define MX 0x40
#define MV 0x20
#define BGR 0x08

/*
 * Minimum waits, us: from sleep out or a reset to a command; from a reset in sleep-out mode to sleep out; from sleep
 * out to display on.
 */
#define AFTER_COMMAND_US 5000u
#define RESET_TO_SLEEP_OUT_US 120000u
#define SLEEP_OUT_TO_DISPLAY_ON_US 120000u

/* After power-on and after either kind of reset. The RAM keeps its content; the chip sleeps as after sleep in. */
static void defaults(struct sheen_sim_controller *controller)
{
    const struct sheen_sim_module *module = controller->module;

    controller->awake = controller->on = controller->inverted = controller->scan = 0;
    controller->tearing = controller->brightness = controller->lit_by_it = 0;
    controller->format =
        controller->module->chip->bits_18 ? 0x55 : 0x66; /* wrong, so that pixels before COLMOD are an error */
    controller->x0 = controller->y0 = 0;
    controller->x1 = (uint16_t)(module->ram_w - 1);
    controller->y1 = (uint16_t)(module->ram_h - 1);
    controller->sleep_out_from_us = controller->now_us + RESET_TO_SLEEP_OUT_US;
    sheen_sim_window_start(controller);
}

static void software_reset(struct sheen_sim_controller *controller)
{
    defaults(controller);
    controller->quiet_until_us = controller->now_us + AFTER_COMMAND_US;
}

static void sleep_in(struct sheen_sim_controller *controller)
{
    controller->awake = 0;
    controller->quiet_until_us = controller->now_us + AFTER_COMMAND_US;
    controller->sleep_out_from_us = controller->now_us + RESET_TO_SLEEP_OUT_US;
}

/* Both waits after sleep out are minima of the data sheets: 5 ms to any command, 120 ms to display on. */
static void sleep_out(struct sheen_sim_controller *controller)
{
    if (controller->now_us < controller->sleep_out_from_us)
        sheen_sim_complain(controller, "sleep out comes %u us too early",
                           (unsigned)(controller->sleep_out_from_us - controller->now_us));
    controller->awake = 1;
    controller->quiet_until_us = controller->now_us + AFTER_COMMAND_US;
    controller->display_on_from_us = controller->now_us + SLEEP_OUT_TO_DISPLAY_ON_US;
}

static void display_off(struct sheen_sim_controller *controller)
{
    controller->on = 0;
}

static void display_on(struct sheen_sim_controller *controller)
{
    if (!controller->awake)
        sheen_sim_complain(controller, "display on in sleep mode");
    else if (controller->now_us < controller->display_on_from_us)
        sheen_sim_complain(controller, "display on comes %u us too early after sleep out",
                           (unsigned)(controller->display_on_from_us - controller->now_us));
    controller->on = 1;
}

static void inversion(struct sheen_sim_controller *controller)
{
    controller->inverted = controller->command & 1;
}

static void madctl(struct sheen_sim_controller *controller)
{
    if (controller->params[0] & 3)
        sheen_sim_complain(controller, "MADCTL 0x%02X sets reserved bits", controller->params[0]);
    controller->scan = controller->params[0];
}

/* The pixel format that the chip accepts on SPI: 5 (16 bits), or 6 (18 bits in three bytes). */
static unsigned right_format(const struct sheen_sim_controller *controller)
{
    return controller->module->chip->bits_18 ? 6 : 5;
}

static void colmod(struct sheen_sim_controller *controller)
{
    controller->format = controller->params[0];
    if ((controller->format & 7u) != right_format(controller))
        sheen_sim_complain(controller, "COLMOD 0x%02X: only %u bits a pixel are simulated", controller->format,
                           right_format(controller) == 6 ? 18 : 16);
}

/* CASET and RASET: parameters are start and end, high byte first, end inclusive. */
static void window(struct sheen_sim_controller *controller)
{
    const struct sheen_sim_module *module = controller->module;
    const uint8_t *p = controller->params;
    uint16_t start = (uint16_t)(p[0] << 8 | p[1]), end = (uint16_t)(p[2] << 8 | p[3]);
    int rows = controller->command == 0x2B, swap = (controller->scan & MV) != 0;
    uint16_t size = rows == swap ? module->ram_w : module->ram_h;

    if (start > end || end >= size)
        sheen_sim_complain(controller, "%s %u..%u of %u", rows ? "RASET" : "CASET", start, end, size);
    *(rows ? &controller->y0 : &controller->x0) = start;
    *(rows ? &controller->y1 : &controller->x1) = end;
}

/* 34 switches the TE output off, 35 on. */
static void tearing(struct sheen_sim_controller *controller)
{
    controller->tearing = controller->command & 1;
}

/* 51 sets the register, 53 whether the backlight follows it. */
static void brightness(struct sheen_sim_controller *controller)
{
    if (controller->command == 0x51)
        controller->brightness = controller->params[0];
    else
        controller->lit_by_it = (controller->params[0] & 0x24) == 0x24;
}

static void memory_continue(struct sheen_sim_controller *controller)
{
    if ((controller->format & 7u) != right_format(controller))
        sheen_sim_complain(controller, "pixels at COLMOD 0x%02X", controller->format);
    controller->streaming = 1;
}

static void memory_write(struct sheen_sim_controller *controller)
{
    memory_continue(controller);
    sheen_sim_window_start(controller);
    controller->rectangles++;
}

/* Stores a pixel at its place in the RAM by MADCTL, then goes on to the next place in the window. */
static void store(struct sheen_sim_controller *controller, uint16_t value)
{
    const struct sheen_sim_module *module = controller->module;
    uint8_t scan = controller->scan;
    unsigned column = scan & MV ? controller->y : controller->x;
    unsigned row = scan & MV ? controller->x : controller->y;

    if (controller->wrapped)
        sheen_sim_complain(controller, "pixel outside the window %u..%u, %u..%u", controller->x0, controller->x1,
                           controller->y0, controller->y1);
    /* A counter beyond the RAM becomes a huge number here if it counts from the last; the store reports it. */
    sheen_sim_store(controller, scan & MX ? module->ram_w - 1u - column : column,
                    scan & MY ? module->ram_h - 1u - row : row, value);
    if (controller->x++ < controller->x1)
        return;
    controller->x = controller->x0;
    if (controller->y++ < controller->y1)
        return;
    controller->y = controller->y0;
    controller->wrapped = 1;
}

/* Of three bytes the upper six bits count; of red and blue only five are kept, so that the RAM holds RGB565. */
static void pixels(struct sheen_sim_controller *controller, uint8_t byte)
{
    unsigned last = controller->module->chip->bits_18 ? 2 : 1;

    if (controller->half_set == last) {
        controller->half_set = 0;
        if (last == 1)
            store(controller, (uint16_t)(controller->half << 8 | byte));
        else
            store(controller, (uint16_t)(controller->red >> 3 << 11 | controller->half >> 2 << 5 | byte >> 3));
        return;
    }
    controller->red = controller->half_set ? controller->red : byte;
    controller->half = byte;
    controller->half_set++;
}

static void stream_end(struct sheen_sim_controller *controller)
{
    if (controller->half_set)
        sheen_sim_complain(controller, "half a pixel before command");
}

/* What the glass shows: dark unless the chip is awake and on, the complement if inversion is not as the glass needs. */
static uint16_t shown(const struct sheen_sim_controller *controller, unsigned column, unsigned row)
{
    const struct sheen_sim_module *module = controller->module;
    uint16_t v = controller->ram[(size_t)row * module->ram_w + column];

    if (!controller->awake || !controller->on)
        return 0;
    if (controller->inverted != module->inverted)
        v = (uint16_t)~v;
    if (((controller->scan & BGR) != 0) != module->bgr)
        v = (uint16_t)((v & 0x07E0) | v >> 11 | v << 11);
    return v;
}

static const struct sheen_sim_command commands[] = {
    {0x01, 0x01, 0, software_reset}, {0x10, 0x10, 0, sleep_in},        {0x11, 0x11, 0, sleep_out},
    {0x13, 0x13, 0, NULL},           {0x20, 0x21, 0, inversion},       {0x28, 0x28, 0, display_off},
    {0x29, 0x29, 0, display_on},     {0x2A, 0x2B, 4, window},          {0x2C, 0x2C, 0, memory_write},
    {0x34, 0x34, 0, tearing},        {0x35, 0x35, 1, tearing},         {0x36, 0x36, 1, madctl},
    {0x3A, 0x3A, 1, colmod},         {0x3C, 0x3C, 0, memory_continue},
};

/* Brightness, for chips whose data sheets have it. */
static const struct sheen_sim_command vendor_brightness[] = {{0x51, 0x51, 1, brightness}, {0x53, 0x53, 1, brightness}};

/* The chips' own registers that drivers set; the data sheets list them under "System function command list 2". */
static const struct sheen_sim_command vendor_st7789[] = {{0xB0, 0xB0, 2, NULL},
                                                         {0xB2, 0xB2, 5, NULL},
                                                         {0xC6, 0xC6, 1, NULL},
                                                         {0x51, 0x51, 1, brightness},
                                                         {0x53, 0x53, 1, brightness}};
static const struct sheen_sim_command vendor_st7735[] = {
    {0xB1, 0xB2, 3, NULL}, {0xB3, 0xB3, 6, NULL}, {0xB4, 0xB4, 1, NULL}, {0xC0, 0xC0, 3, NULL},
    {0xC1, 0xC1, 1, NULL}, {0xC2, 0xC4, 2, NULL}, {0xC5, 0xC5, 1, NULL}, {0xE0, 0xE1, 16, NULL},
};

/* Undocumented except for the registers' lengths. NOP (00) is left out, because the chip must not get it. */
static const struct sheen_sim_command vendor_gc9a01[] = {
    {0x51, 0x51, 1, brightness}, {0x53, 0x53, 1, brightness}, {0xFE, 0xFE, 0, NULL},  {0xEF, 0xEF, 0, NULL},
    {0xEB, 0xEB, 1, NULL},       {0x84, 0x8F, 1, NULL},       {0xB6, 0xB6, 2, NULL},  {0x90, 0x90, 4, NULL},
    {0xBC, 0xBE, 1, NULL},       {0xFF, 0xFF, 3, NULL},       {0xC3, 0xC4, 1, NULL},  {0xC9, 0xC9, 1, NULL},
    {0xE1, 0xE1, 2, NULL},       {0xDF, 0xDF, 3, NULL},       {0xF0, 0xF3, 6, NULL},  {0xED, 0xED, 2, NULL},
    {0xAE, 0xAE, 1, NULL},       {0xCD, 0xCD, 1, NULL},       {0x70, 0x70, 9, NULL},  {0xE8, 0xE8, 1, NULL},
    {0x62, 0x63, 12, NULL},      {0x64, 0x64, 7, NULL},       {0x66, 0x67, 10, NULL}, {0x74, 0x74, 7, NULL},
    {0x98, 0x98, 2, NULL},
};

#define DCS(label)                                                                                                     \
    .name = label, .commands = commands, .command_count = sizeof commands / sizeof commands[0], .defaults = defaults,  \
    .pixels = pixels, .stream_end = stream_end, .shown = shown, .reset_command = 0x01, .reset_low_us = 10,             \
    .reset_us = AFTER_COMMAND_US
#define VENDOR(list) .vendor = list, .vendor_count = sizeof list / sizeof list[0]

const struct sheen_sim_chip sheen_sim_chip_ili9341 = {DCS("ILI9341"), VENDOR(vendor_brightness)};
const struct sheen_sim_chip sheen_sim_chip_ili9488 = {DCS("ILI9488"), VENDOR(vendor_brightness), .bits_18 = 1};
const struct sheen_sim_chip sheen_sim_chip_st7789 = {DCS("ST7789"), VENDOR(vendor_st7789)};
const struct sheen_sim_chip sheen_sim_chip_st7735 = {DCS("ST7735"), VENDOR(vendor_st7735)};
const struct sheen_sim_chip sheen_sim_chip_st7796 = {DCS("ST7796"), VENDOR(vendor_brightness)};
const struct sheen_sim_chip sheen_sim_chip_gc9a01 = {DCS("GC9A01"), VENDOR(vendor_gc9a01)};
