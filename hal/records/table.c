/*
 * table.c - the table of panels, and how a name finds its record.
 */
#include "sheen_panel.h"

/* The plain name of a controller, such as "st7789", means its first record here. */
static const struct sheen_panel_record *const table[] = {
    &sheen_panel_ili9341,
    &sheen_panel_st7789_240x320,
    &sheen_panel_st7789_240x240,
    &sheen_panel_st7789_240x240_round,
    &sheen_panel_st7789_240x280,
    &sheen_panel_st7789_135x240,
    &sheen_panel_st7789_170x320,
    &sheen_panel_st7789_172x320,
    &sheen_panel_st7789_76x284,
    &sheen_panel_st7789_128x128,
    &sheen_panel_st7735_128x160,
    &sheen_panel_st7735_128x160_red,
    &sheen_panel_st7735_128x160_green,
    &sheen_panel_st7735_128x128,
    &sheen_panel_st7735_128x128_green,
    &sheen_panel_st7735_80x160_green,
    &sheen_panel_st7735_80x160_red,
    &sheen_panel_st7796,
    &sheen_panel_ili9488,
    &sheen_panel_gc9a01,
    &sheen_panel_ssd1351_128x128,
    &sheen_panel_ssd1351_128x96,
    &sheen_panel_ssd0323,
    &sheen_panel_ssd1325,
    &sheen_panel_ssd1322,
    &sheen_panel_ssd1327_128x128,
    &sheen_panel_ssd1327_96x96,
    &sheen_panel_ssd1306_128x64,
    &sheen_panel_ssd1306_128x32,
    &sheen_panel_ssd1306_72x40,
    &sheen_panel_ssd1306_64x48,
    &sheen_panel_sh1106,
    &sheen_panel_sh1106_nogap,
};

const struct sheen_panel_record *sheen_panel_at(size_t index)
{
    return index < sizeof table / sizeof table[0] ? table[index] : NULL;
}

/* ASCII upper case to lower case, which all names in the table are in. */
static char small(char c)
{
    return c >= 'A' && c <= 'Z' ? (char)(c - 'A' + 'a') : c;
}

/* 2: name is the record's whole name; 1: the record's name continues after it with a dash; 0: neither. */
static int matches(const char *record, const char *name)
{
    while (*name && *record == small(*name))
        record++, name++;
    return *name ? 0 : *record == '\0' ? 2 : *record == '-';
}

const struct sheen_panel_record *sheen_panel_find(const char *name)
{
    const struct sheen_panel_record *first = NULL;

    if (!name)
        return NULL;
    for (size_t i = 0; i < sizeof table / sizeof table[0]; i++) {
        int match = matches(table[i]->name, name);

        if (match == 2)
            return table[i];
        if (match == 1 && !first)
            first = table[i];
    }
    return first;
}
