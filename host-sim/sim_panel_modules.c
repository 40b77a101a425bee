/*
 * sim_panel_modules.c - the hardware that can be simulated: what stands behind which glass.
 *
 * Written from data sheets and module drawings, not from hal's records: where the
 * two differ, the tests see it. Mirrored: the upright picture needs MX (MY) there.
 */
#include <string.h>

#include "controller.h"

static const struct sheen_sim_module modules[] = {
    {.name = "ili9341-240x320",
     .chip = &sheen_sim_chip_ili9341,
     .ram_w = 240,
     .ram_h = 320,
     .glass_w = 240,
     .glass_h = 320,
     .mirror_x = 1,
     .bgr = 1},
};

const struct sheen_sim_module *sheen_sim_module_find(const char *name)
{
    for (size_t i = 0; i < sizeof modules / sizeof modules[0]; i++)
        if (strcmp(modules[i].name, name) == 0)
            return &modules[i];
    return NULL;
}
