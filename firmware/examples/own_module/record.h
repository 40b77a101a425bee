/*
 * record.h - the module's record (record.c).
 */
#ifndef RECORD_H
#define RECORD_H

#include "sheen_panel.h"

extern const struct sheen_panel_record own_module;

#endif
