/*
 * test_linux_bus.c - every kind of bus of hal/linux with every panel, down to simulated controllers.
 *
 * Below hal/linux the system calls and lines are this test's own, by the linker's --wrap and by replacing libgpiod's
 * side: spidev transfers with the level of D/C, bit-banged edges through the pin watcher, I2C messages through the
 * simulated bus. Each picture on the panel must be the one that was pushed; then each call fails in turn.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include <errno.h>
#include <linux/i2c-dev.h>
#include <linux/i2c.h>
#include <linux/spi/spidev.h>
#include <sys/ioctl.h>
#include <sys/types.h>
#include <time.h>
#include <unistd.h>

#include "pin_watcher.h"
#include "sheen_linux_bus.h"
#include "sheen_sender.h"
#include "test_panel_canvas.h"

#define SPI_FD 9001
#define I2C_FD 9002
#define ADAPTER_LONGEST 65u /* B: the longest I2C message of the adapter */

/* ---- the machine: lines by name, two devices, and a panel at their far end ---- */

static struct {
    struct sheen_sim_controller *controller;
    struct sheen_sim_bus i2c; /* to the same controller */
    struct sheen_pin_watcher watcher;
    struct sheen_bus far_end; /* of the pin watcher */
    int level[SHEEN_WIRE_COUNT];
    unsigned mode, own_cs;
    unsigned selected, selections; /* the kernel's own chip select of the panel */
    unsigned long calls, fail_at;  /* system calls and changes of lines; fail_at 0: none fails */
    int error;                     /* errno of the call that fails */
    unsigned address, functions;
    size_t longest; /* the longest transfer of spidev */
} machine;

static const char *const wire_names[SHEEN_WIRE_COUNT] = {"sclk", "mosi", "cs", "dc", "reset"};

/* 1 if this call is the one to fail; errno is set then. */
static int fails(void)
{
    if (++machine.calls != machine.fail_at)
        return 0;
    errno = machine.error;
    return 1;
}

/* The same for a change of a line, except that libgpiod and pins.c deal with EINTR themselves. */
static int line_fails(void)
{
    return fails() && machine.error != EINTR;
}

static int far_send(void *ctx, const uint8_t *command, size_t commands, const void *data, size_t count)
{
    sheen_sim_receive(ctx, SHEEN_SIM_COMMAND, command, commands);
    sheen_sim_receive(ctx, SHEEN_SIM_DATA, data, count);
    return 0;
}

static int far_reset(void *ctx, int level)
{
    sheen_sim_reset_line(ctx, level);
    return 0;
}

/* ---- replaces libgpiod: hal/linux/sheen_pins.h ---- */

static unsigned wire_of(const struct sheen_pin *pin)
{
    for (unsigned wire = 0; wire < SHEEN_WIRE_COUNT; wire++)
        if (strcmp(pin->name, wire_names[wire]) == 0)
            return wire;
    fail_msg("a line that is not there: %s", pin->name);
    return 0;
}

static int drive(struct sheen_pin *pin, int level)
{
    unsigned wire = wire_of(pin);

    machine.level[wire] = pin->level = level;
    /* If a change was made to fail, a byte may have been cut off. */
    if (sheen_pin_watcher_edge(&machine.watcher, (enum sheen_wire)wire, level) < 0 && !machine.error)
        fail_msg("%s", machine.watcher.complaint ? machine.watcher.complaint : "an edge is refused");
    return 0;
}

int sheen_pin_output(struct sheen_pin *pin, const char *line, int level, struct sheen_failure *why)
{
    *pin = (struct sheen_pin){0};
    if (line_fails())
        return sheen_failed(why, SHEEN_ERR_BUS, "line %s: %s", line, strerror(errno));
    pin->chip = (struct gpiod_chip *)(void *)&machine; /* anything but NULL, which means open */
    snprintf(pin->name, sizeof pin->name, "%s", line);
    return drive(pin, level);
}

int sheen_pin_set(struct sheen_pin *pin, int level, struct sheen_failure *why)
{
    if (pin->level == level)
        return 0;
    if (line_fails())
        return sheen_failed(why, SHEEN_ERR_BUS, "line %s: %s", pin->name, strerror(errno));
    return drive(pin, level);
}

int sheen_pin_rising(struct sheen_pin *pin, const char *line, struct sheen_failure *why)
{
    (void)why;
    *pin = (struct sheen_pin){.chip = (struct gpiod_chip *)(void *)&machine};
    snprintf(pin->name, sizeof pin->name, "%s", line);
    return 0;
}

int sheen_pin_await(struct sheen_pin *pin, uint32_t timeout_us, struct sheen_failure *why)
{
    (void)timeout_us;
    if (line_fails())
        return sheen_failed(why, SHEEN_ERR_BUS, "line %s: %s", pin->name, strerror(errno));
    return sheen_sim_tearing(machine.controller);
}

void sheen_pin_close(struct sheen_pin *pin)
{
    *pin = (struct sheen_pin){0};
}

/* ---- replaces the kernel ---- */

int __real_open(const char *path, int flags, ...);
int __real_close(int fd);
int __wrap_open(const char *path, int flags, ...);
int __wrap_close(int fd);
int __wrap_ioctl(int fd, unsigned long request, ...);
int __wrap_clock_nanosleep(clockid_t clock, int flags, const struct timespec *until, struct timespec *rest);

int __wrap_open(const char *path, int flags, ...)
{
    int fd = strcmp(path, "/dev/spidev0.0") == 0 ? SPI_FD : strcmp(path, "/dev/i2c-1") == 0 ? I2C_FD : -1;

    if (fd < 0)
        return __real_open(path, flags);
    return fails() ? -1 : fd;
}

int __wrap_close(int fd)
{
    return fd == SPI_FD || fd == I2C_FD ? 0 : __real_close(fd);
}

/* Sleeping advances the controller's time. */
int __wrap_clock_nanosleep(clockid_t clock, int flags, const struct timespec *until, struct timespec *rest)
{
    struct timespec now;

    (void)flags;
    (void)rest;
    clock_gettime(clock, &now);
    int64_t us = (until->tv_sec - now.tv_sec) * 1000000ll + (until->tv_nsec - now.tv_nsec) / 1000;
    sheen_sim_advance(machine.controller, us > 0 ? (uint32_t)us + 1000u : 1000u);
    return 0;
}

/*
 * A device with another chip select on the same SPI, a touch controller, is asked between any two messages to the
 * panel. The kernel does not deselect the panel before, if cs_change left it selected (spi.c, spi_set_cs).
 */
static void other_device(void)
{
    static const uint8_t read_x[3] = {0xD0};

    if (machine.selected)
        sheen_sim_receive(machine.controller, machine.level[SHEEN_WIRE_DC] ? SHEEN_SIM_DATA : SHEEN_SIM_COMMAND, read_x,
                          sizeof read_x);
}

/* One transfer, with D/C at its line's level; the kernel's chip select falls, and rises again unless cs_change. */
static int transfer(const struct spi_ioc_transfer *one)
{
    int own = machine.mode & SPI_NO_CS;

    if (machine.own_cs && machine.level[SHEEN_WIRE_CS])
        fail_msg("bytes leave while the panel is not selected");
    machine.selections += !own && !machine.selected;
    machine.selected = !own && one->cs_change;
    if (one->len > 4096) {
        errno = EMSGSIZE;
        return -1;
    }
    machine.longest = one->len > machine.longest ? one->len : machine.longest;
    sheen_sim_receive(machine.controller, machine.level[SHEEN_WIRE_DC] ? SHEEN_SIM_DATA : SHEEN_SIM_COMMAND,
                      (const uint8_t *)(uintptr_t)one->tx_buf, one->len);
    other_device();
    return (int)one->len;
}

/* An I2C message that writes to the panel. */
static int message(const struct i2c_rdwr_ioctl_data *messages)
{
    const struct i2c_msg *one = messages->msgs;

    assert_int_equal(messages->nmsgs, 1);
    assert_int_equal(one->flags, 0);
    sheen_sim_bus_i2c(&machine.i2c, (uint8_t)one->addr);
    if (one->len > ADAPTER_LONGEST) {
        errno = EOPNOTSUPP;
        return -1;
    }
    if (machine.i2c.bus.send(&machine.i2c, NULL, 0, one->buf, one->len) < 0) {
        errno = EREMOTEIO;
        return -1;
    }
    machine.i2c.bus.wait(&machine.i2c);
    return 1;
}

int __wrap_ioctl(int fd, unsigned long request, ...)
{
    va_list values;
    void *value;

    va_start(values, request);
    value = va_arg(values, void *);
    va_end(values);
    if (fails())
        return -1;
    if (fd == SPI_FD && request == SPI_IOC_MESSAGE(1))
        return transfer(value);
    if (fd == I2C_FD && request == I2C_RDWR)
        return message(value);
    if (fd == SPI_FD && request == SPI_IOC_WR_MODE)
        machine.mode = *(uint8_t *)value;
    else if (fd == I2C_FD && request == I2C_FUNCS)
        *(unsigned long *)value = machine.functions;
    else if (fd == I2C_FD && request == I2C_SLAVE)
        machine.address = (unsigned)(uintptr_t)value;
    else if (fd != SPI_FD) {
        errno = ENOTTY;
        return -1;
    }
    return 0;
}

/* ---- a panel at the far end of a wiring ---- */

struct rig {
    struct canvas canvas; /* only its controller is used, not its bus */
    struct sheen_failure why;
    struct sheen_linux_bus bus;
    struct sheen_sender sender;
    struct sheen_panel panel;
    struct sheen_target target;
};

static const struct {
    const char *name;
    struct sheen_wiring wiring;
    int thread;
} kinds[] = {
    {"spidev", {.spi = "/dev/spidev0.0", .dc = "dc", .reset = "reset"}, 0},
    {"spidev, own chip select", {.spi = "/dev/spidev0.0", .cs = "cs", .dc = "dc", .reset = "reset"}, 0},
    {"spidev, no reset line", {.spi = "/dev/spidev0.0", .dc = "dc"}, 0},
    {"spidev, thread", {.spi = "/dev/spidev0.0", .dc = "dc", .reset = "reset"}, 1},
    {"bit-bang", {.sclk = "sclk", .mosi = "mosi", .cs = "cs", .dc = "dc", .reset = "reset"}, 0},
    {"bit-bang, mode 3", {.sclk = "sclk", .mosi = "mosi", .cs = "cs", .dc = "dc", .reset = "reset", .spi_mode = 3}, 0},
    {"bit-bang, no chip select, thread", {.sclk = "sclk", .mosi = "mosi", .dc = "dc", .reset = "reset"}, 1},
    {"i2c", {.i2c = "/dev/i2c-1", .reset = "reset"}, 0},
    {"i2c, no reset line, thread", {.i2c = "/dev/i2c-1"}, 1},
};
#define KINDS (sizeof kinds / sizeof kinds[0])

/* Connects the panel to a machine without faults. */
static void power_up(struct rig *rig, const struct sheen_panel_record *record, unsigned orientation,
                     const struct sheen_wiring *wiring)
{
    const uint8_t idle[SHEEN_WIRE_COUNT] = {(uint8_t)(wiring->spi_mode >> 1), 0, wiring->cs != NULL, 0, 1};

    canvas_open(&rig->canvas, record->name, (int)orientation, 0, 0);
    memset(&machine, 0, sizeof machine);
    machine.controller = sheen_sim_panel_bus(rig->canvas.panel)->controller;
    machine.functions = I2C_FUNC_I2C;
    machine.own_cs = wiring->cs != NULL;
    machine.far_end = (struct sheen_bus){.ctx = machine.controller, .send = far_send, .reset = far_reset};
    sheen_sim_bus_open(&machine.i2c, machine.controller, 1);
    sheen_pin_watcher_init(&machine.watcher, &machine.far_end, wiring->spi_mode, idle);
    for (unsigned wire = 0; wire < SHEEN_WIRE_COUNT; wire++)
        machine.level[wire] = idle[wire];
    rig->bus = (struct sheen_linux_bus){.fd = -1};
}

static int rig_open(struct rig *rig, const struct sheen_panel_record *record, unsigned orientation,
                    const struct sheen_wiring *wiring, int thread)
{
    int error = sheen_linux_bus_open(&rig->bus, wiring, &rig->why);

    if (error < 0)
        return error;
    assert_int_equal(sheen_sender_open(&rig->sender, &rig->bus.bus), 0);
    assert_int_equal(
        sheen_panel_open(&rig->panel, record, thread ? &rig->sender.layer.bus : &rig->bus.bus, orientation), 0);
    assert_int_equal(sheen_panel_target(&rig->panel, &rig->target), 0);
    rig->canvas.target = &rig->target;
    return 0;
}

static void rig_close(struct rig *rig)
{
    if (rig->bus.wire.send) {
        sheen_sender_close(&rig->sender);
        sheen_linux_bus_close(&rig->bus);
    }
    canvas_close(&rig->canvas);
}

/* 1 if the panel has this kind of bus. */
static int reachable(const struct sheen_panel_record *record, const struct sheen_wiring *wiring)
{
    return !wiring->i2c || record->i2c_address;
}

static void every_kind_and_panel(void **state)
{
    const struct sheen_panel_record *record;
    unsigned pairs = 0;

    (void)state;
    for (size_t i = 0; (record = sheen_panel_at(i)); i++) {
        for (size_t kind = 0; kind < KINDS; kind++) {
            static struct rig rig;
            unsigned orientation = (unsigned)(i + kind) % 8;

            if (!reachable(record, &kinds[kind].wiring))
                continue;
            power_up(&rig, record, orientation, &kinds[kind].wiring);
            assert_int_equal(rig_open(&rig, record, orientation, &kinds[kind].wiring, kinds[kind].thread), 0);
            assert_int_equal(canvas_push_all(&rig.canvas, 64), 0);
            for (unsigned n = 0; n < 5; n++)
                assert_int_equal(canvas_push(&rig.canvas, canvas_rect(&rig.canvas)), 0);
            if (canvas_differences(&rig.canvas))
                fail_msg("%s by %s: %u pixels differ", record->name, kinds[kind].name, canvas_differences(&rig.canvas));
            canvas_quiet(&rig.canvas);
            assert_true(machine.longest <= 4096);
            rig_close(&rig);
            pairs++;
        }
    }
    print_message("%u pairs of a bus and a panel\n", pairs);
    assert_true(pairs >= 33 * 7 + 8 * 2);
}

/*
 * A line as chip select stays low from a command to the end of its data and then rises. The kernel's rises after each
 * message, because other devices' messages may come between.
 */
static void selections_of_a_push(void **state)
{
    const struct sheen_panel_record *record = sheen_panel_find("ili9341");

    (void)state;
    for (size_t kind = 0; kind < KINDS; kind++) {
        const struct sheen_wiring *wiring = &kinds[kind].wiring;
        static struct rig rig;
        unsigned before;

        if (wiring->i2c || (!wiring->spi && !wiring->cs))
            continue;
        power_up(&rig, record, 0, wiring);
        assert_int_equal(rig_open(&rig, record, 0, wiring, kinds[kind].thread), 0);
        assert_int_equal(sheen_panel_init(&rig.panel), 0);
        before = wiring->cs ? (unsigned)machine.watcher.selections : machine.selections;
        assert_int_equal(canvas_push(&rig.canvas, (struct sheen_rect){0, 0, 240, 20}), 0); /* 9,600 B: 3 transfers */
        unsigned after = wiring->cs ? (unsigned)machine.watcher.selections : machine.selections;
        /* CASET, RASET and RAMWR; or these, the parameters of two and three transfers of pixels. */
        assert_int_equal(after - before, wiring->cs ? 3 : 8);
        assert_int_equal(machine.selected, 0);
        assert_int_equal(machine.level[SHEEN_WIRE_CS], wiring->cs != NULL);
        rig_close(&rig);
    }
}

/* Opens and pushes a picture while call n fails; afterwards everything must work again. 0 once there is no call n. */
static int fail_at(const struct sheen_panel_record *record, size_t kind, unsigned long n, int code)
{
    static struct rig rig;
    const struct sheen_wiring *wiring = &kinds[kind].wiring;
    int error;

    power_up(&rig, record, 0, wiring);
    machine.fail_at = n;
    machine.error = code;
    rig.why.text[0] = '\0';
    error = rig_open(&rig, record, 0, wiring, kinds[kind].thread);
    if (error == 0)
        error = canvas_push_all(&rig.canvas, 64);
    if (code == EINTR && error < 0)
        fail_msg("%s, call %lu: EINTR is not made again: %s", kinds[kind].name, n, rig.why.text);
    if (error < 0 && !strstr(rig.why.text, strerror(code)) && code != ETIMEDOUT)
        fail_msg("%s, call %lu: '%s' does not say why", kinds[kind].name, n, rig.why.text);
    if (error < 0 && error != (code == ETIMEDOUT && !strstr(rig.why.text, "line ") ? SHEEN_ERR_TIMEOUT : SHEEN_ERR_BUS))
        fail_msg("%s, call %lu: code %d", kinds[kind].name, n, error);
    if (machine.selected)
        fail_msg("%s by %s, call %lu: the panel stays selected", record->name, kinds[kind].name, n);
    machine.fail_at = 0;
    if (rig.bus.wire.send == NULL)
        assert_int_equal(rig_open(&rig, record, 0, wiring, kinds[kind].thread), 0);
    assert_int_equal(canvas_push_all(&rig.canvas, 64), 0);
    if (canvas_differences(&rig.canvas))
        fail_msg("%s by %s, call %lu: the next picture is wrong", record->name, kinds[kind].name, n);
    rig_close(&rig);
    return machine.calls < n ? 0 : error;
}

static void every_call_fails_once(void **state)
{
    static const char *const panels[] = {"ssd1306-72x40", "ssd1327-96x96", "st7735-80x160"};

    (void)state;
    for (size_t p = 0; p < 3; p++) {
        for (size_t kind = 0; kind < KINDS; kind++) {
            unsigned long n = 1, last = 0, step = kinds[kind].wiring.sclk ? 97 : 1;
            if (p == 2 && !kinds[kind].wiring.spi)
                continue; /* many pixels, and no I2C */

            /* A bit-banged picture changes lines some 10,000 times: the first 100 fail in turn, then some others. */
            for (; last == 0; n += n < 100 ? 1 : step)
                if (fail_at(sheen_panel_find(panels[p]), kind, n, EIO) == 0)
                    last = n;
            assert_true(last > 30);
        }
        fail_at(sheen_panel_find(panels[p]), 0, 20, EINTR);
        if (p == 2)
            continue;
        fail_at(sheen_panel_find(panels[p]), 7, 20, ETIMEDOUT);
        fail_at(sheen_panel_find(panels[p]), 7, 20, EINTR);
    }
}

static void i2c_words(void **state)
{
    static struct rig rig;
    const struct sheen_panel_record *record = sheen_panel_find("sh1106");
    struct sheen_wiring wiring = {.i2c = "/dev/i2c-1", .address = 0x3D};

    (void)state;
    power_up(&rig, record, 0, &wiring);
    assert_int_equal(rig_open(&rig, record, 0, &wiring, 0), 0);
    assert_int_equal(machine.address, 0x3D);
    assert_int_equal(canvas_push_all(&rig.canvas, 64), SHEEN_ERR_BUS);
    assert_non_null(strstr(rig.why.text, "/dev/i2c-1: "));
    assert_non_null(strstr(rig.why.text, "no device answers at address 0x3d"));
    rig_close(&rig);

    power_up(&rig, record, 0, &wiring);
    machine.functions = 0;
    assert_int_equal(rig_open(&rig, record, 0, &wiring, 0), SHEEN_ERR_UNSUPPORTED);
    assert_non_null(strstr(rig.why.text, "SMBus only"));
    machine.functions = I2C_FUNC_I2C;
    machine.calls = 0;
    machine.fail_at = 3; /* after open and I2C_FUNCS: I2C_SLAVE */
    machine.error = EBUSY;
    assert_int_equal(rig_open(&rig, record, 0, &wiring, 0), SHEEN_ERR_BUS);
    assert_non_null(strstr(rig.why.text, "a driver of the kernel has address 0x3d"));
    wiring.address = 0x78;
    machine.fail_at = 0;
    assert_int_equal(rig_open(&rig, record, 0, &wiring, 0), SHEEN_ERR_ARGUMENT);
    assert_non_null(strstr(rig.why.text, "0x78 is not in 0x08..0x77"));
    rig_close(&rig);
}

/* TE is waited for once per frame, and an error of that wait becomes the frame's error. */
static void te_line(void **state)
{
    static struct rig rig;
    const struct sheen_panel_record *record = sheen_panel_find("st7789-240x240");
    const struct sheen_wiring wiring = {.spi = "/dev/spidev0.0", .dc = "dc", .reset = "reset", .te = "te"};

    (void)state;
    power_up(&rig, record, 0, &wiring);
    assert_int_equal(rig_open(&rig, record, 0, &wiring, 1), 0);
    assert_int_equal(sheen_panel_sync(&rig.panel), 0);
    assert_int_equal(canvas_push_all(&rig.canvas, 64), 0);
    assert_int_equal(canvas_differences(&rig.canvas), 0);
    machine.controller->tearing = 0; /* no more pulses on TE */
    assert_int_equal(sheen_panel_sync(&rig.panel), 0);
    assert_int_equal(canvas_push_all(&rig.canvas, 64), SHEEN_ERR_TIMEOUT);
    assert_non_null(strstr(rig.why.text, "line te: no pulse in 1000 ms"));
    rig_close(&rig);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_kind_and_panel),
        cmocka_unit_test(selections_of_a_push),
        cmocka_unit_test(every_call_fails_once),
        cmocka_unit_test(i2c_words),
        cmocka_unit_test(te_line),
    };

    return cmocka_run_group_tests_name("linux bus", tests, NULL, NULL);
}
