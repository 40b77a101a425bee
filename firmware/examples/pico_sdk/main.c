/*
 * main.c - sheen with the pico-sdk: an ST7789 on SPI0. DMA sends a band while the next one is drawn (two buffers).
 *
 * The wiring is that of firmware/README.md. CMakeLists.txt beside this file builds the program.
 */
#include "example.h"
#include "hardware/dma.h"
#include "hardware/spi.h"
#include "pico/stdlib.h"
#include "sheen_panel.h"

enum {
    PIN_DC = 16,
    PIN_CS = 17,
    PIN_SCK = 18,
    PIN_TX = 19,
    PIN_LIGHT = 20,
    PIN_RESET = 21
};

static int channel;

/* When this returns, the command has left, and DMA is sending the pixels. */
static int send(void *ctx, const uint8_t *command, size_t commands, const void *data, size_t count)
{
    dma_channel_config config = dma_channel_get_default_config((uint)channel);

    (void)ctx;
    gpio_put(PIN_CS, 0);
    gpio_put(PIN_DC, 0);
    if (commands)
        spi_write_blocking(spi0, command, commands);
    gpio_put(PIN_DC, 1);
    if (count) {
        channel_config_set_transfer_data_size(&config, DMA_SIZE_8);
        channel_config_set_dreq(&config, spi_get_dreq(spi0, true));
        dma_channel_configure((uint)channel, &config, &spi_get_hw(spi0)->dr, data, (uint)count, true);
    }
    return SHEEN_OK;
}

static int wait(void *ctx)
{
    (void)ctx;
    dma_channel_wait_for_finish_blocking((uint)channel);
    while (spi_is_busy(spi0))
        tight_loop_contents();
    gpio_put(PIN_CS, 1);
    return SHEEN_OK;
}

static int reset(void *ctx, int level)
{
    (void)ctx;
    gpio_put(PIN_RESET, level != 0);
    return SHEEN_OK;
}

static int delay(void *ctx, uint32_t us)
{
    (void)ctx;
    sleep_us(us);
    return SHEEN_OK;
}

int main(void)
{
    static const uint outputs[] = {PIN_DC, PIN_CS, PIN_LIGHT, PIN_RESET};
    const struct sheen_bus bus = {.send = send, .delay = delay, .wait = wait, .reset = reset};
    const struct sheen_panel_record *record = &sheen_panel_st7789_240x240;
    struct sheen_panel panel;
    struct sheen_target target;
    int error;

    for (size_t i = 0; i < sizeof outputs / sizeof outputs[0]; i++) {
        gpio_init(outputs[i]);
        gpio_set_dir(outputs[i], GPIO_OUT);
        gpio_put(outputs[i], 1);
    }
    spi_init(spi0, record->clock_hz);
    spi_set_format(spi0, 8, (spi_cpol_t)(record->spi_mode >> 1), (spi_cpha_t)(record->spi_mode & 1), SPI_MSB_FIRST);
    gpio_set_function(PIN_SCK, GPIO_FUNC_SPI);
    gpio_set_function(PIN_TX, GPIO_FUNC_SPI);
    channel = dma_claim_unused_channel(true);

    error = sheen_panel_open(&panel, record, &bus, 0);
    if (!error)
        error = sheen_panel_target(&panel, &target);
    if (!error)
        error = example_run(&target, EXAMPLE_FRAMES);
    return error;
}
