/*
 * boards.c - boards, and how many cycles an instruction takes on each.
 *
 * Cycles per instruction, for processors whose cycles no emulator counts. The Cortex-M0+ needs 1.4 on these frames
 * (cycles in rp2040js over instructions in QEMU): loads, stores and taken branches make the part above 1. A Cortex-M3
 * or M4 pipelines loads and pays more for a branch (Arm, Cortex-M3 TRM r2p1, table 3-1; Cortex-M4 TRM r0p1, table 3-1):
 * 1.4 again. Others follow from this by CoreMark per MHz, x, as 1.4 * 3.42 / x: M4 3.42, M33 4.02, M7 5.01 (Arm's pages
 * of the processors), nRF52833 3.3 from flash with its cache (Nordic, product specification). Flash with two wait
 * states behind a prefetch buffer costs a quarter more (STM32F103 at 72 MHz; ST, RM0008, FLASH_ACR); an STM32F411's
 * wait states count as none (its data sheet, ART accelerator). ESP32-C3: 2.55 CoreMark per MHz and about 300,000 rv32
 * instructions per iteration make 1.3 (Espressif, data sheet). ESP32: 2.1 CoreMark per MHz and core (data sheet) make
 * 1.6. An ESP8266 is assumed to need 1.6 too, and an ESP32 to execute as many instructions as the ESP8266's LX106,
 * because of the two only the LX106 can be counted here.
 *
 * RAM: what a program can have as static data; under ESP-IDF and the ESP8266's Arduino core that is less than the chip
 * has. Bus: SPI's highest clock on the pins that a display is usually wired to.
 */
#include "boards.h"

#include <string.h>
#include <strings.h>

#include "nearest.h"

#define KB 1024u
#define MHZ 1000000u

static const struct sheen_plan_board boards[] = {
    {"pico", "Raspberry Pi Pico", "Cortex-M0+", 125 * MHZ, 62500000, 264 * KB, 2048 * KB, 2, SHEEN_CPU_RP2040, 1, 0, 1,
     "cycles in rp2040js", 1},
    {"pico2", "Raspberry Pi Pico 2", "Cortex-M33", 150 * MHZ, 75 * MHZ, 520 * KB, 4096 * KB, 2, SHEEN_CPU_M33, 0, 0,
     1.2, "M33 instructions in QEMU x 1.2", 1},
    {"stm32f103", "STM32F103 (Blue Pill)", "Cortex-M3", 72 * MHZ, 18 * MHZ, 20 * KB, 64 * KB, 1, SHEEN_CPU_M3, 0, 0,
     1.75, "M3 instructions in QEMU x 1.75, two wait states", 0},
    {"stm32f411", "STM32F411 (Black Pill)", "Cortex-M4", 100 * MHZ, 50 * MHZ, 128 * KB, 512 * KB, 1, SHEEN_CPU_M4, 0, 0,
     1.4, "M4 instructions in QEMU x 1.4", 0},
    {"esp32-c3", "ESP32-C3", "rv32imc", 160 * MHZ, 80 * MHZ, 300 * KB, 4096 * KB, 1, SHEEN_CPU_RV32IMC, 0, 0, 1.3,
     "rv32imc instructions in QEMU x 1.3", 0},
    {"esp32", "ESP32", "LX6", 240 * MHZ, 80 * MHZ, 160 * KB, 4096 * KB, 2, SHEEN_CPU_LX106, 0, 1, 1.6,
     "nearest there is: LX106 instructions in QEMU x 1.6", 0},
    {"esp8266", "ESP8266", "LX106", 160 * MHZ, 40 * MHZ, 48 * KB, 1024 * KB, 1, SHEEN_CPU_LX106, 0, 0, 1.6,
     "LX106 instructions in QEMU x 1.6", 0},
    {"microbit-v2", "micro:bit v2", "Cortex-M4", 64 * MHZ, 32 * MHZ, 128 * KB, 512 * KB, 1, SHEEN_CPU_M4, 0, 0, 1.45,
     "M4 instructions in QEMU x 1.45", 0},
    {"teensy4", "Teensy 4", "Cortex-M7", 600 * MHZ, 30 * MHZ, 512 * KB, 1984 * KB, 1, SHEEN_CPU_M4, 0, 1, 0.95,
     "nearest there is: M4 instructions in QEMU x 0.95", 0},
};

const struct sheen_plan_board *sheen_plan_board_at(unsigned index)
{
    return index < sizeof boards / sizeof boards[0] ? &boards[index] : NULL;
}

int sheen_plan_board_find(const char *name, struct sheen_problem *problem)
{
    struct sheen_nearest nearest = {.word = name};
    const struct sheen_plan_board *board;

    for (unsigned i = 0; (board = sheen_plan_board_at(i)) != NULL; i++) {
        if (strcasecmp(board->name, name) == 0)
            return (int)i;
        sheen_nearest_try(&nearest, board->name, strlen(board->name));
        sheen_nearest_try(&nearest, board->title, strlen(board->title));
    }
    for (unsigned i = 0; (board = sheen_plan_board_at(i)) != NULL; i++)
        if (strcmp(board->title, nearest.name) == 0)
            nearest.name = board->name;
    return sheen_problem(problem, SHEEN_ERR_ARGUMENT, "no board '%s'; the nearest is %s", name, nearest.name);
}
