/*
 * glass.c - what a board's glass must show, and what the bytes from a board make it show.
 *
 *   board_glass demo PANEL KEYS OUT      runs the demo on a simulated panel, with keys as in demo.h
 *   board_glass replay PANEL WIRE OUT    sends what left a board's SPI to a simulated controller
 *
 * OUT gets the pictures one after another: width x height values of 16 bits, low byte first, RGB565 or grey levels.
 * demo writes one for each key that draws (held from the start; f: first light), replay one for each F.
 *
 * WIRE: records of a letter, a count of 32 bits, low byte first, and that many bytes. C holds commands, D data. The
 * others hold a number of 4 bytes: R the reset line's level, T the microseconds that passed, F that a picture is
 * complete.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "demo.h"
#include "glass.h"
#include "sheen_first_light.h"
#include "sim_panel.h"

#define ARENA_BYTES (256u * 1024u)

static int write_values(FILE *out, const uint16_t *values, size_t count)
{
    for (size_t i = 0; i < count; i++)
        if (putc(values[i] & 255, out) == EOF || putc(values[i] >> 8, out) == EOF)
            return -1;
    return 0;
}

static int complain(const char *what, const char *why)
{
    fprintf(stderr, "board_glass: %s: %s\n", what, why);
    return -1;
}

/* ---- demo ---- */

/* Draws what the key asks for; 1 if that made a picture. */
static int play(struct demo *demo, int key)
{
    static uint8_t line[4096];

    if (key == 'f') {
        int error = sheen_first_light(demo->target, line, sizeof line);
        sheen_invalidate(demo->frame);
        return error < 0 ? error : 1;
    }
    demo_key(demo, key);
    if (!demo_due(demo))
        return 0;
    int error = demo_frame(demo, 0);
    return error < 0 ? error : 1;
}

static int run_demo(const struct sheen_sim_choice *choice, const char *keys, FILE *out)
{
    size_t count = (size_t)choice->width * choice->height, size = ARENA_BYTES;
    uint16_t *values = malloc(count * sizeof *values);
    struct sheen_sim_panel *panel = NULL;
    void *arena = malloc(size);
    struct demo demo;
    int status = values && arena ? sheen_sim_panel_open(&panel, choice) : SHEEN_ERR_MEMORY;

    if (status == SHEEN_OK)
        status = demo_open(&demo, sheen_sim_panel_target(panel), arena, &size, 1, NULL);
    if (status == SHEEN_OK)
        demo_key(&demo, 'h');
    for (; status >= 0 && *keys; keys++) {
        status = play(&demo, *keys);
        if (status == 1 && (sheen_sim_panel_picture(panel, values) < 0 || write_values(out, values, count) < 0))
            status = SHEEN_ERR_STATE;
    }
    if (status < 0)
        complain("demo", sheen_strerror(status));
    else if (sheen_sim_panel_complaints(panel))
        status = complain("demo", sheen_sim_panel_complaint(panel));
    sheen_sim_panel_close(panel);
    free(arena);
    free(values);
    return status;
}

/* ---- replay ---- */

/* Writes what a viewer sees of the controller's memory. */
static int show(struct sheen_sim_controller *controller, const struct sheen_sim_choice *choice, FILE *out)
{
    for (unsigned y = 0; y < choice->height; y++) {
        for (unsigned x = 0; x < choice->width; x++) {
            unsigned column, row;

            sheen_sim_glass_place(controller->module, choice->orientation, x, y, &column, &row);
            uint16_t value = sheen_sim_glass(controller, column, row);
            if (write_values(out, &value, 1) < 0)
                return -1;
        }
    }
    return 0;
}

static uint32_t number(const uint8_t bytes[4])
{
    return bytes[0] | (uint32_t)bytes[1] << 8 | (uint32_t)bytes[2] << 16 | (uint32_t)bytes[3] << 24;
}

static int event(struct sheen_sim_controller *controller, const struct sheen_sim_choice *choice, int kind,
                 const uint8_t *bytes, uint32_t count, FILE *out)
{
    if (count == 0 || (strchr("RTF", kind) && count != 4))
        return complain("replay", "a count that cannot be");
    switch (kind) {
    case 'C':
    case 'D':
        sheen_sim_receive(controller, kind == 'D' ? SHEEN_SIM_DATA : SHEEN_SIM_COMMAND, bytes, count);
        return 0;
    case 'R':
        sheen_sim_reset_line(controller, (int)number(bytes));
        return 0;
    case 'T':
        sheen_sim_advance(controller, number(bytes));
        return 0;
    case 'F':
        return show(controller, choice, out);
    default:
        return complain("replay", "a letter that is none of C, D, R, T, F");
    }
}

static int run_replay(const struct sheen_sim_choice *choice, FILE *wire, FILE *out)
{
    static uint8_t bytes[1 << 20];
    struct sheen_sim_controller controller;
    int status = sheen_sim_controller_open(&controller, sheen_sim_module_find(choice->record->name));
    uint8_t head[5];

    while (status == 0 && fread(head, 1, sizeof head, wire) == sizeof head) {
        uint32_t count = number(head + 1);

        if (count > sizeof bytes || fread(bytes, 1, count, wire) != count)
            status = complain("replay", "the file ends too soon");
        else
            status = event(&controller, choice, head[0], bytes, count, out);
    }
    if (status == 0 && controller.complaints)
        status = complain("the controller complains", controller.first_complaint);
    sheen_sim_controller_close(&controller);
    return status;
}

int main(int argc, char **argv)
{
    struct sheen_sim_choice choice;
    char why[200];
    FILE *out, *wire = NULL;
    int status;

    if (argc != 5 || (strcmp(argv[1], "demo") != 0 && strcmp(argv[1], "replay") != 0)) {
        fprintf(stderr, "usage: board_glass demo PANEL KEYS OUT | board_glass replay PANEL WIRE OUT\n");
        return 2;
    }
    if (sheen_sim_choose(&choice, argv[2], -1, 0, 0, why, sizeof why) < 0 || !choice.record)
        return -2 * complain(argv[2], why);
    if (strcmp(argv[1], "replay") == 0 && !(wire = fopen(argv[3], "rb")))
        return -complain(argv[3], "cannot be read");
    if (!(out = fopen(argv[4], "wb")))
        return -complain(argv[4], "cannot be written");
    status = wire ? run_replay(&choice, wire, out) : run_demo(&choice, argv[3], out);
    if (fclose(out) != 0)
        status = complain(argv[4], "cannot be written");
    return status < 0 ? 1 : 0;
}
