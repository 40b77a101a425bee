/*
 * sim_bus.c - the simulated bus: DMA that reads late, I2C, counters, faults.
 *
 * Every call is an operation with a number. A planned fault strikes at one of them, of whatever kind; bytes under way
 * then arrive in part or not at all.
 */
#include "sim_bus.h"

#include "sheen_target.h"

#include <string.h>

#define TIMEOUT_US 1000000u

/* FNV-1a, to see whether a buffer in flight was touched. */
static uint32_t sum_of(const uint8_t *bytes, size_t count)
{
    uint32_t sum = 2166136261u;

    for (size_t i = 0; i < count; i++)
        sum = (sum ^ bytes[i]) * 16777619u;
    return sum;
}

/*
 * Receives an I2C message: control bytes say what follows them. Bit 80: one byte, then another control byte; bit 40:
 * data, not commands (SSD1306 data sheet, 8.1.5.2). whole: 1 unless the message was cut short on its way.
 */
static void take_message(struct sheen_sim_controller *controller, const uint8_t *bytes, size_t count, int whole)
{
    size_t at = 0;

    while (at < count) {
        uint8_t control = bytes[at++];
        size_t part = control & 0x80 ? 1 : count - at;

        if (control & 0x3F)
            sheen_sim_complain(controller, "control byte 0x%02X", control);
        if (at + part > count || part == 0) {
            if (whole)
                sheen_sim_complain(controller, "a message ends after control byte 0x%02X", control);
            return;
        }
        sheen_sim_receive(controller, control & 0x40 ? SHEEN_SIM_DATA : SHEEN_SIM_COMMAND, bytes + at, part);
        at += part;
    }
}

static size_t smaller(size_t a, size_t b)
{
    return a < b ? a : b;
}

/* Ends the call under way: the first `count` of its bytes arrive, commands before data. */
static void land(struct sheen_sim_bus *bus, size_t count)
{
    size_t commands = smaller(count, bus->flight_commands), data = smaller(count - commands, bus->flight_bytes);

    if (!bus->flying)
        return;
    if (sum_of(bus->flight, bus->flight_bytes) != bus->flight_sum)
        sheen_sim_complain(bus->controller, "a buffer of %zu bytes was touched before wait", bus->flight_bytes);
    if (bus->address && data)
        take_message(bus->controller, bus->flight, data, data == bus->flight_bytes);
    if (!bus->address && commands)
        sheen_sim_receive(bus->controller, SHEEN_SIM_COMMAND, bus->flight_command, commands);
    if (!bus->address && data)
        sheen_sim_receive(bus->controller, SHEEN_SIM_DATA, bus->flight, data);
    bus->flight = NULL;
    bus->flying = 0;
}

/* Counts an operation. Returns the code of the fault that is planned for it, else 0. */
static int operate(struct sheen_sim_bus *bus)
{
    bus->operations++;
    if (bus->fault == SHEEN_FAULT_NONE || bus->operations != bus->fault_at)
        return SHEEN_OK;
    switch (bus->fault) {
    case SHEEN_FAULT_SHORT:
        land(bus, (bus->flight_commands + bus->flight_bytes) / 2);
        return SHEEN_ERR_BUS;
    case SHEEN_FAULT_TIMEOUT:
        land(bus, 0);
        sheen_sim_advance(bus->controller, TIMEOUT_US);
        return SHEEN_ERR_TIMEOUT;
    case SHEEN_FAULT_BROWN_OUT:
        land(bus, 0);
        sheen_sim_power_cycle(bus->controller);
        return SHEEN_ERR_BUS;
    case SHEEN_FAULT_STUCK_RESET:
        land(bus, 0);
        bus->reset_stuck = 1;
        sheen_sim_reset_line(bus->controller, 0);
        return SHEEN_ERR_BUS;
    default:
        land(bus, 0);
        return SHEEN_ERR_BUS;
    }
}

/* Complains about a send that a caller must not make. 0, or SHEEN_ERR_ARGUMENT if it cannot be made. */
static int refuse(struct sheen_sim_bus *bus, const void *command, size_t commands, const void *data, size_t count)
{
    const char *what = NULL;

    if (bus->locks && !bus->held)
        sheen_sim_complain(bus->controller, "send on a bus that was not acquired");
    if (commands + count == 0 || (commands && !command) || (count && !data))
        what = "send of no bytes";
    else if (commands > SHEEN_BUS_COMMANDS)
        what = "a command of more bytes than a bus takes";
    else if (bus->address && commands)
        what = "an I2C message beside its bytes";
    if (!what)
        return SHEEN_OK;
    sheen_sim_complain(bus->controller, "%s", what);
    return SHEEN_ERR_ARGUMENT;
}

/* Notes the call; its data are read when it is waited for. */
static int sim_send(void *ctx, const uint8_t *command, size_t commands, const void *data, size_t count)
{
    struct sheen_sim_bus *bus = ctx;
    int error;

    if (bus->flying) {
        sheen_sim_complain(bus->controller, "send before the last one was waited for");
        land(bus, SIZE_MAX);
    }
    error = refuse(bus, command, commands, data, count);
    if (error < 0)
        return error;
    if (commands)
        memcpy(bus->flight_command, command, commands);
    bus->flight_commands = commands;
    bus->flight = data;
    bus->flight_bytes = count;
    bus->flight_sum = sum_of(data, count);
    bus->flying = 1;
    error = operate(bus);
    if (error == SHEEN_OK && bus->address && bus->address != bus->controller->module->i2c_address) {
        land(bus, 0);
        error = SHEEN_ERR_BUS; /* nobody acknowledges */
    }
    if (error < 0)
        return error;
    bus->transactions++;
    bus->bytes += commands + count;
    bus->commands += commands;
    return SHEEN_OK;
}

static int sim_wait(void *ctx)
{
    struct sheen_sim_bus *bus = ctx;
    int error = operate(bus);

    if (error == SHEEN_OK)
        land(bus, SIZE_MAX);
    return error;
}

/* A stuck line does not follow. */
static int sim_reset(void *ctx, int level)
{
    struct sheen_sim_bus *bus = ctx;
    int error;

    if (bus->flying)
        sheen_sim_complain(bus->controller, "reset line moved before the last send was waited for");
    error = operate(bus);
    if (error < 0)
        return error;
    if (level && bus->reset_stuck)
        return SHEEN_ERR_BUS; /* the board reads the line back */
    sheen_sim_reset_line(bus->controller, level);
    return SHEEN_OK;
}

/* Delays let time pass; bytes take none, as on a bus faster than any real one. */
static int sim_delay(void *ctx, uint32_t us)
{
    struct sheen_sim_bus *bus = ctx;
    int error;

    if (bus->flying)
        sheen_sim_complain(bus->controller, "delay begun before the last send was waited for");
    error = operate(bus);
    if (error == SHEEN_OK)
        sheen_sim_advance(bus->controller, us);
    return error;
}

static int sim_acquire(void *ctx)
{
    struct sheen_sim_bus *bus = ctx;
    int error = operate(bus);

    if (bus->held)
        sheen_sim_complain(bus->controller, "acquired twice");
    bus->held = error == SHEEN_OK;
    return error;
}

static void sim_release(void *ctx)
{
    struct sheen_sim_bus *bus = ctx;

    if (!bus->held)
        sheen_sim_complain(bus->controller, "released without being held");
    if (bus->flying)
        sheen_sim_complain(bus->controller, "released before the last send was waited for");
    bus->held = 0;
}

static int sim_tearing(void *ctx)
{
    struct sheen_sim_bus *bus = ctx;
    int error = operate(bus);

    if (error == SHEEN_OK)
        error = sheen_sim_tearing(bus->controller);
    return error;
}

/* Many modules have a capacitor of 100 nF on the line; a pin of 4 mA discharges it from 3.3 V in 83 us. */
#define RESET_FALL_US 100u

void sheen_sim_bus_open(struct sheen_sim_bus *bus, struct sheen_sim_controller *controller, int reset_line)
{
    *bus = (struct sheen_sim_bus){.controller = controller};
    controller->reset_fall_us = RESET_FALL_US;
    bus->bus = (struct sheen_bus){.ctx = bus,
                                  .send = sim_send,
                                  .delay = sim_delay,
                                  .wait = sim_wait,
                                  .reset = reset_line ? sim_reset : NULL,
                                  .tearing = sim_tearing};
}

void sheen_sim_bus_i2c(struct sheen_sim_bus *bus, uint8_t address)
{
    bus->address = address;
}

void sheen_sim_bus_share(struct sheen_sim_bus *bus)
{
    bus->locks = 1;
    bus->bus.acquire = sim_acquire;
    bus->bus.release = sim_release;
}

void sheen_sim_bus_fault(struct sheen_sim_bus *bus, enum sheen_sim_fault fault, uint64_t after)
{
    bus->fault = fault;
    bus->fault_at = bus->operations + after + 1;
    if (fault == SHEEN_FAULT_NONE)
        bus->reset_stuck = 0;
}

const char *sheen_sim_fault_name(enum sheen_sim_fault fault)
{
    static const char *const names[SHEEN_FAULT_COUNT] = {"none",    "error",     "short write",
                                                         "timeout", "brown-out", "stuck reset"};

    return (unsigned)fault < SHEEN_FAULT_COUNT ? names[fault] : "?";
}

struct sheen_sim_counters sheen_sim_bus_counters(const struct sheen_sim_bus *bus)
{
    return (struct sheen_sim_counters){bus->bytes, bus->commands, bus->transactions,
                                       bus->controller->rectangles - bus->rectangles};
}

void sheen_sim_bus_counters_reset(struct sheen_sim_bus *bus)
{
    bus->bytes = bus->commands = bus->transactions = 0;
    bus->rectangles = bus->controller->rectangles;
}
