/*
 * panels.c - the table of panels, and how a name finds its record.
 */
#include "panel.h"

/* The first record of a controller is what its plain name means. */
static const struct sheen_panel_record *const table[] = {
    &sheen_panel_ili9341,
};

const struct sheen_panel_record *sheen_panel_at(size_t index)
{
    return index < sizeof table / sizeof table[0] ? table[index] : NULL;
}

/* 2: name is the record's whole name; 1: the record's name goes on with a dash; 0: neither. */
static int matches(const char *record, const char *name)
{
    while (*name && *record == *name)
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
