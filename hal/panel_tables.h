/*
 * panel_tables.h - private to hal/: how the records are written down.
 */
#ifndef SHEEN_PANEL_TABLES_H
#define SHEEN_PANEL_TABLES_H

/* The last two fields of a step: no parameters, or these. */
#define NONE 0, NULL
#define BYTES(...) sizeof((const uint8_t[]){__VA_ARGS__}), ((const uint8_t[]){__VA_ARGS__})

#define INIT(table) .init = table, .steps = sizeof table / sizeof table[0]
#define GLASS(w, h) .glass_w = w, .glass_h = h
#define RAM(w, h) .ram_w = w, .ram_h = h

#endif
