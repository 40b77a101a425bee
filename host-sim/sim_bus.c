/*
 * sim_bus.c - the simulated bus: DMA that reads late, counters, faults.
 *
 * Every call is an operation with a number. A planned fault strikes at one of
 * them, whatever it is; bytes under way then arrive in part or not at all.
 */
#include "sim_bus.h"

#include "sheen_target.h"

#define TIMEOUT_US 1000000u

/* FNV-1a, to see whether a buffer in flight was touched. */
static uint32_t sum_of(const uint8_t *bytes, size_t count)
{
    uint32_t sum = 2166136261u;

    for (size_t i = 0; i < count; i++)
        sum = (sum ^ bytes[i]) * 16777619u;
    return sum;
}

/* The write under way ends: its first `count` bytes arrive. */
static void land(struct sheen_sim_bus *bus, size_t count)
{
    if (!bus->flight)
        return;
    if (sum_of(bus->flight, bus->flight_bytes) != bus->flight_sum)
        sheen_sim_complain(bus->controller, "a buffer of %zu bytes was touched before wait", bus->flight_bytes);
    if (count)
        sheen_sim_receive(bus->controller, bus->flight_dc, bus->flight, count);
    bus->flight = NULL;
}

/* Counts an operation; the code that a planned fault makes of it, else 0. */
static int operate(struct sheen_sim_bus *bus)
{
    bus->operations++;
    if (bus->fault == SHEEN_FAULT_NONE || bus->operations != bus->fault_at)
        return SHEEN_OK;
    switch (bus->fault) {
    case SHEEN_FAULT_SHORT:
        land(bus, bus->flight_bytes / 2);
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

/* Notes the write; its bytes are read when it is waited for. */
static int sim_write(void *ctx, enum sheen_dc dc, const void *bytes, size_t count)
{
    struct sheen_sim_bus *bus = ctx;

    if (bus->flight) {
        sheen_sim_complain(bus->controller, "write before the last one was waited for");
        land(bus, bus->flight_bytes);
    }
    if (!bytes || count == 0) {
        sheen_sim_complain(bus->controller, "write of no bytes");
        return SHEEN_ERR_ARGUMENT;
    }
    bus->flight = bytes;
    bus->flight_bytes = count;
    bus->flight_dc = dc;
    bus->flight_sum = sum_of(bytes, count);

    int error = operate(bus);
    if (error < 0)
        return error;
    bus->transactions++;
    bus->bytes += count;
    bus->commands += dc == SHEEN_COMMAND ? count : 0;
    return SHEEN_OK;
}

static int sim_wait(void *ctx)
{
    struct sheen_sim_bus *bus = ctx;
    int error = operate(bus);

    if (error == SHEEN_OK)
        land(bus, bus->flight_bytes);
    return error;
}

/* A stuck line does not follow, which a board finds by reading it back. */
static int sim_reset(void *ctx, int level)
{
    struct sheen_sim_bus *bus = ctx;
    int error;

    if (bus->flight)
        sheen_sim_complain(bus->controller, "reset line moved before the last write was waited for");
    error = operate(bus);
    if (error < 0)
        return error;
    if (level && bus->reset_stuck)
        return SHEEN_ERR_BUS; /* the board reads the line back */
    sheen_sim_reset_line(bus->controller, level);
    return SHEEN_OK;
}

/* Time passes by delays alone: a bus faster than any. */
static int sim_delay(void *ctx, uint32_t us)
{
    struct sheen_sim_bus *bus = ctx;
    int error;

    if (bus->flight)
        sheen_sim_complain(bus->controller, "delay begun before the last write was waited for");
    error = operate(bus);
    if (error == SHEEN_OK)
        sheen_sim_advance(bus->controller, us);
    return error;
}

void sheen_sim_bus_open(struct sheen_sim_bus *bus, struct sheen_sim_controller *controller, int reset_line)
{
    *bus = (struct sheen_sim_bus){.controller = controller};
    bus->bus = (struct sheen_bus){
        .ctx = bus, .write = sim_write, .wait = sim_wait, .reset = reset_line ? sim_reset : NULL, .delay = sim_delay};
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
