/*
 * panel_name.c - a use of the panel drivers, so that a consumer without them does not link.
 */
#include "sheen_panel.h"

__attribute__((constructor)) static void require_panels(void)
{
    if (!sheen_panel_find("ili9341"))
        __builtin_trap();
}
