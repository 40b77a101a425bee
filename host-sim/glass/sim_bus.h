/*
 * sim_bus.h - a bus with a simulated controller at its far end, with DMA, counters and faults.
 *
 * Data are read at the wait, as a slow DMA would read them: a buffer that was touched before the wait sends the wrong
 * pixels and is complained about.
 *
 * The bus is 4-wire SPI, or I2C. On I2C a call is a message to an address, as sheen_i2c.h makes it, and faults stand
 * for an address or a byte that nobody acknowledges (error, short write) and for a stuck bus (timeout).
 */
#ifndef SHEEN_SIM_BUS_H
#define SHEEN_SIM_BUS_H

#include "controller.h"
#include "sheen_bus.h"

/* Faults; each strikes at one operation (send, wait, reset, delay, acquire or tearing, counted from 1). */
enum sheen_sim_fault {
    SHEEN_FAULT_NONE = 0,
    SHEEN_FAULT_ERROR,      /* the operation does nothing: SHEEN_ERR_BUS */
    SHEEN_FAULT_SHORT,      /* half of the bytes under way arrive: SHEEN_ERR_BUS */
    SHEEN_FAULT_TIMEOUT,    /* the bytes under way are lost, a second passes: SHEEN_ERR_TIMEOUT */
    SHEEN_FAULT_BROWN_OUT,  /* the controller loses its power for a moment: SHEEN_ERR_BUS */
    SHEEN_FAULT_STUCK_RESET /* the reset line stays low until the fault is lifted: SHEEN_ERR_BUS at each release */
};
#define SHEEN_FAULT_COUNT 6

/* bytes = commands + data; transactions: calls of send. On I2C all bytes count as data, control bytes too. */
struct sheen_sim_counters {
    uint64_t bytes, commands, transactions, rectangles;
};

struct sheen_sim_bus {
    struct sheen_bus bus; /* what a driver is given; ctx is this struct */
    struct sheen_sim_controller *controller;
    uint8_t address;                            /* that I2C messages go to; 0: SPI */
    uint8_t locks, held;                        /* 1: the bus is shared; 1: it is acquired */
    uint8_t flying;                             /* 1: a call is under way */
    uint8_t flight_command[SHEEN_BUS_COMMANDS]; /* that call's commands */
    const uint8_t *flight;                      /* that call's data */
    size_t flight_commands, flight_bytes;
    uint32_t flight_sum;
    uint64_t operations; /* since the start */
    uint64_t bytes, commands, transactions;
    unsigned rectangles; /* the controller's count when the counters were reset */
    enum sheen_sim_fault fault;
    uint64_t fault_at; /* the operation that fails */
    uint8_t reset_stuck;
};

/* 4-wire SPI. reset_line: 0 for a board without one. */
void sheen_sim_bus_open(struct sheen_sim_bus *bus, struct sheen_sim_controller *controller, int reset_line);

/* Makes the bus I2C (0: SPI): each call is a message to this 7-bit address. Only the module's own is acknowledged. */
void sheen_sim_bus_i2c(struct sheen_sim_bus *bus, uint8_t address);

/* From now on the bus must be acquired before anything is sent. */
void sheen_sim_bus_share(struct sheen_sim_bus *bus);

/* Plans a fault at the operation that follows `after` more; SHEEN_FAULT_NONE lifts any fault. */
void sheen_sim_bus_fault(struct sheen_sim_bus *bus, enum sheen_sim_fault fault, uint64_t after);

/* The name of a fault, such as "short write". */
const char *sheen_sim_fault_name(enum sheen_sim_fault fault);

struct sheen_sim_counters sheen_sim_bus_counters(const struct sheen_sim_bus *bus);
void sheen_sim_bus_counters_reset(struct sheen_sim_bus *bus);

#endif
