/*
 * main.c - first light on a module of your own, wired to a Linux board.
 *
 *   own_module /dev/spidev0.0 GPIO25 GPIO27      SPI device, D/C line, reset line
 *
 * On a microcontroller only the bus is different (sheen_bus.h).
 */
#include "record.h"
#include "sheen_first_light.h"
#include "sheen_linux_bus.h"

#include <stdio.h>

int main(int argc, char **argv)
{
    static uint8_t band[240 * 16 * 2];
    struct sheen_failure why = {""};
    struct sheen_linux_bus bus;
    struct sheen_panel panel;
    struct sheen_target target;
    int error;

    if (argc != 4) {
        fprintf(stderr, "usage: own_module SPI-DEVICE DC-LINE RESET-LINE\n");
        return 2;
    }
    const struct sheen_wiring wiring = {
        .spi = argv[1], .dc = argv[2], .reset = argv[3], .clock_hz = 1000000, .spi_mode = own_module.spi_mode};
    error = sheen_linux_bus_open(&bus, &wiring, &why);
    if (error == 0) {
        error = sheen_panel_open(&panel, &own_module, &bus.bus, 0);
        if (error == 0)
            error = sheen_panel_target(&panel, &target);
        if (error == 0)
            error = sheen_first_light(&target, band, sizeof band);
        sheen_linux_bus_close(&bus);
    }
    if (error < 0)
        fprintf(stderr, "own_module: %s (%d)\n", why.text[0] != 0 ? why.text : sheen_strerror(error), error);
    return error < 0;
}
