/*
 * list.c - see list.h.
 */
#include "list.h"

#include "sheen_panel.h"
#include "sheen_pins.h"

#include <stdio.h>
#include <string.h>

static int print_line(void *ctx, const struct sheen_pin_info *info)
{
    char *chip = ctx;

    if (strcmp(chip, info->chip) != 0) {
        printf("%s [%s]\n", info->chip, info->label);
        snprintf(chip, 64, "%s", info->chip);
    }
    printf("  %s:%-3u %-16s %-6s %s%s\n", info->chip, info->offset, info->name[0] ? info->name : "-",
           info->output ? "output" : "input", info->used ? "used by " : "free",
           !info->used         ? ""
           : info->consumer[0] ? info->consumer
                               : "the kernel");
    return 0;
}

int list_lines(struct sheen_failure *why)
{
    char chip[64] = "";

    return sheen_pins_each(print_line, chip, why);
}

void list_panels(void)
{
    const struct sheen_panel_record *record;

    for (size_t i = 0; (record = sheen_panel_at(i)) != NULL; i++)
        printf("%-22s %-8s %5.1f MHz  %s\n", record->name, record->controller, record->clock_hz / 1e6,
               record->note ? record->note : "");
}
