/*
 * cmd_panels.c - `sheen panels`: the table of panels that there are drivers and simulated controllers for.
 */
#include <stdio.h>

#include "commands.h"
#include "sim_panel.h"

static const char *colours_of(const struct sheen_panel_record *record)
{
    switch (record->pixel) {
    case SHEEN_GREY2:
        return "2 greys";
    case SHEEN_GREY16:
        return "16 greys";
    default:
        return record->bits_18 ? "RGB666" : "RGB565";
    }
}

/* Bytes and frames per second of whole frames: pixels only, no commands, at the rated clock and one bit per cycle. */
static void print_row(const struct sheen_panel_record *record)
{
    unsigned bytes = sheen_sim_frame_bytes(record);
    double mhz = record->clock_hz / 1e6, frames = record->clock_hz / (8.0 * bytes);
    char glass[16];

    snprintf(glass, sizeof glass, "%ux%u", record->glass_w, record->glass_h);
    printf("%-21s  %-10s  %-7s  %-8s  %6.4g  %4u  %7u  %8.1f", record->name, record->controller, glass,
           colours_of(record), mhz, record->spi_mode, bytes, frames);
    if (record->round)
        printf("  round%s", record->note ? ";" : "");
    if (record->note)
        printf("%s%s", record->round ? " " : "  ", record->note);
    putchar('\n');
}

enum sheen_exit sheen_cmd_panels(struct sheen_options *options)
{
    (void)options;
    printf("%-21s  %-10s  %-7s  %-8s  %6s  %4s  %7s  %8s  %s\n", "panel", "controller", "glass", "colours", "MHz",
           "mode", "B/frame", "frames/s", "notes");
    for (size_t i = 0; sheen_panel_at(i); i++)
        print_row(sheen_panel_at(i));
    printf("%-21s  %-10s  %-7s  %-8s  %6s  %4s  %7s  %8s  %s\n", "ideal", "-", "any", "RGB565", "-", "-", "-", "-",
           "plain memory from 8x8 to 640x480, to compare with");
    printf("\nMHz: the rated write clock; mode: of the SPI; frames/s: whole frames at that clock, pixels only.\n"
           "A shorter name means the first panel that begins with it: ili9341, st7789, st7735-128x160.\n");
    return SHEEN_EXIT_OK;
}
