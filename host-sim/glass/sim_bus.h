/*
 * sim_bus.h - a bus with a simulated controller at its far end, with DMA, counters and faults.
 *
 * Data are read at the wait, as a slow DMA would: a buffer that was touched in
 * between sends the wrong pixels, and is complained about.
 *
 * 4-wire SPI, or I2C: then a call is a message to an address, as sheen_i2c.h makes
 * them. On I2C the faults are an address or a byte that nobody acknowledges (error,
 * short write) and a bus that is stuck (timeout).
 */
#ifndef SHEEN_SIM_BUS_H
#define SHEEN_SIM_BUS_H

#include "controller.h"
#include "sheen_bus.h"

/* Faults, at one operation (send, wait, reset, delay, acquire or tearing, counted from 1). */
enum sheen_sim_fault {
    SHEEN_FAULT_NONE = 0,
    SHEEN_FAULT_ERROR,      /* the operation does nothing: SHEEN_ERR_BUS */
    SHEEN_FAULT_SHORT,      /* half of the bytes under way arrive: SHEEN_ERR_BUS */
    SHEEN_FAULT_TIMEOUT,    /* the bytes under way are lost, a second passes: SHEEN_ERR_TIMEOUT */
    SHEEN_FAULT_BROWN_OUT,  /* the controller loses its power for a moment: SHEEN_ERR_BUS */
    SHEEN_FAULT_STUCK_RESET /* the reset line stays low until the fault is lifted: SHEEN_ERR_BUS at each release */
};
#define SHEEN_FAULT_COUNT 6

/* bytes = commands + data; transactions are calls of send. On I2C all bytes are data, control bytes too. */
struct sheen_sim_counters {
    uint64_t bytes, commands, transactions, rectangles;
};

struct sheen_sim_bus {
    struct sheen_bus bus; /* what a driver is given; ctx is this struct */
    struct sheen_sim_controller *controller;
    uint8_t address;                            /* of the I2C messages; 0: SPI */
    uint8_t locks, held;                        /* 1: others use it too; it is acquired */
    uint8_t flying;                             /* a call is under way: */
    uint8_t flight_command[SHEEN_BUS_COMMANDS]; /* its command, */
    const uint8_t *flight;                      /* its data */
    size_t flight_commands, flight_bytes;
    uint32_t flight_sum;
    uint64_t operations; /* since the start */
    uint64_t bytes, commands, transactions;
    unsigned rectangles; /* of the controller's, when the counters were set to 0 */
    enum sheen_sim_fault fault;
    uint64_t fault_at; /* the operation that fails */
    uint8_t reset_stuck;
};

/* 4-wire SPI. reset_line: 0 for a board without one. */
void sheen_sim_bus_open(struct sheen_sim_bus *bus, struct sheen_sim_controller *controller, int reset_line);

/* From now on I2C, each call a message to a 7-bit address; nobody answers but at the module's. */
void sheen_sim_bus_i2c(struct sheen_sim_bus *bus, uint8_t address);

/* From now on the bus must be acquired before anything is sent. */
void sheen_sim_bus_share(struct sheen_sim_bus *bus);

/* Plans a fault at the operation that comes after `after` more; SHEEN_FAULT_NONE lifts any. */
void sheen_sim_bus_fault(struct sheen_sim_bus *bus, enum sheen_sim_fault fault, uint64_t after);

/* The name of a fault: "short write". */
const char *sheen_sim_fault_name(enum sheen_sim_fault fault);

struct sheen_sim_counters sheen_sim_bus_counters(const struct sheen_sim_bus *bus);
void sheen_sim_bus_counters_reset(struct sheen_sim_bus *bus);

#endif
