/*
 * costs.h - what tests/bench/costs found with gcc: cycles or instructions per feature, and bytes of flash.
 */
#ifndef SHEEN_PLAN_COSTS_H
#define SHEEN_PLAN_COSTS_H

#include <stdint.h>

#include "feature_list.h"

/* The processors that have costs: the RP2040 cycles (rp2040js), the others instructions (QEMU). */
enum sheen_plan_cpu {
    SHEEN_CPU_RP2040,
    SHEEN_CPU_M0PLUS,
    SHEEN_CPU_M3,
    SHEEN_CPU_M4,
    SHEEN_CPU_M33,
    SHEEN_CPU_RV32IMC,
    SHEEN_CPU_LX106,
    SHEEN_PLAN_CPUS
};

/* Shaders, in the order of shader_index's table (memory.c) and of tests/bench/costs. */
enum sheen_plan_shader {
    SHEEN_PLAN_SHADER_FLAT,
    SHEEN_PLAN_SHADER_GOURAUD,
    SHEEN_PLAN_SHADER_PHONG,
    SHEEN_PLAN_SHADER_SLERP,
    SHEEN_PLAN_SHADER_FLAT_COLORED,
    SHEEN_PLAN_SHADER_GOURAUD_COLORED,
    SHEEN_PLAN_SHADER_TEXTURED_FLAT,
    SHEEN_PLAN_SHADER_TEXTURED,
    SHEEN_PLAN_SHADER_MATCAP,
    SHEEN_PLAN_SHADER_MATCAP_VERTEX,
    SHEEN_PLAN_SHADER_TEXTURED_FLAT_COLORED,
    SHEEN_PLAN_SHADER_TEXTURED_COLORED,
    SHEEN_PLAN_SHADER_MATCAP_COLORED,
    SHEEN_PLAN_SHADER_MATCAP_VERTEX_COLORED,
    SHEEN_PLAN_SHADER_PHONG_COLORED,
    SHEEN_PLAN_SHADER_SLERP_COLORED,
    SHEEN_PLAN_SHADERS
};

/* What a program may name besides shaders, in the order of tests/bench/costs. */
enum sheen_plan_extra {
    SHEEN_PLAN_EXTRA_FOG,
    SHEEN_PLAN_EXTRA_STIPPLE,
    SHEEN_PLAN_EXTRA_RAMP,
    SHEEN_PLAN_EXTRA_MORPH,
    SHEEN_PLAN_EXTRA_SMOOTH,
    SHEEN_PLAN_EXTRA_OUTLINE,
    SHEEN_PLAN_EXTRA_WIRE,
    SHEEN_PLAN_EXTRA_CLIPPER,
    SHEEN_PLAN_EXTRAS
};

/* Kinds of drivers, in the order of driver_kind's table (memory.c) and of tests/bench/costs. */
enum sheen_plan_driver {
    SHEEN_PLAN_DCS,
    SHEEN_PLAN_SSD1351,
    SHEEN_PLAN_GREY,
    SHEEN_PLAN_SSD1322,
    SHEEN_PLAN_SSD1306,
    SHEEN_PLAN_SH1106,
    SHEEN_PLAN_DRIVERS
};

extern const char sheen_plan_found[]; /* the day of the measurement, and the compilers */
extern const float sheen_plan_cost[SHEEN_PLAN_COUNTS][SHEEN_PLAN_CPUS];

/*
 * B of flash in a linked firmware, at -O2 and at -Os: the core with its tables and libgcc, for each shader; what each
 * extra adds to Gouraud; a panel's record with its driver.
 */
extern const uint32_t sheen_plan_core_flash[SHEEN_PLAN_CPUS][2][SHEEN_PLAN_SHADERS];
extern const uint32_t sheen_plan_extra_flash[SHEEN_PLAN_CPUS][2][SHEEN_PLAN_EXTRAS];
extern const uint32_t sheen_plan_panel_flash[SHEEN_PLAN_CPUS][2][SHEEN_PLAN_DRIVERS];

#endif
