/*
 * main.c - sheen with ESP-IDF: a bus on top of esp_lcd's panel IO. DMA sends pixels; a callback says when they left.
 *
 * ESP-IDF takes care of clock, chip select, DMA and D/C. Wire the panel to the pins below, or change them.
 */
#include "driver/gpio.h"
#include "driver/spi_master.h"
#include "esp_lcd_panel_io.h"
#include "esp_log.h"
#include "esp_rom_sys.h"
#include "example.h"
#include "freertos/FreeRTOS.h"
#include "freertos/semphr.h"
#include "freertos/task.h"
#include "sdkconfig.h"
#include "sheen_panel.h"

struct pins {
    gpio_num_t sclk, mosi, cs, dc, reset, light;
};

/* On all but the ESP32, SPI2 reaches sclk, mosi and cs directly, not through the GPIO matrix. */
#if CONFIG_IDF_TARGET_ESP32
static const struct pins pins = {.sclk = 18, .mosi = 23, .cs = 5, .dc = 21, .reset = 22, .light = 4};
#elif CONFIG_IDF_TARGET_ESP32S2 || CONFIG_IDF_TARGET_ESP32S3
static const struct pins pins = {.sclk = 12, .mosi = 11, .cs = 10, .dc = 9, .reset = 8, .light = 7};
#elif CONFIG_IDF_TARGET_ESP32C3
static const struct pins pins = {.sclk = 6, .mosi = 7, .cs = 10, .dc = 4, .reset = 5, .light = 3};
#else
#error "give this chip's pins here"
#endif

#define PARAMETERS 16 /* more data than this are sent by DMA */
#define BUS_ERROR(code) ((code) == ESP_OK ? SHEEN_OK : SHEEN_ERR_BUS)

struct lcd {
    esp_lcd_panel_io_handle_t io;
    SemaphoreHandle_t done;
    int in_flight;
};

static bool colors_done(esp_lcd_panel_io_handle_t io, esp_lcd_panel_io_event_data_t *event, void *ctx)
{
    BaseType_t woken = pdFALSE;

    (void)io;
    (void)event;
    xSemaphoreGiveFromISR(((struct lcd *)ctx)->done, &woken);
    return woken == pdTRUE;
}

static int send(void *ctx, const uint8_t *command, size_t commands, const void *data, size_t count)
{
    struct lcd *lcd = ctx;
    int lcd_command = commands ? command[0] : -1;

    if (commands > 1) /* black and white, and most greys: for these, set dc_low_on_param of the IO */
        return BUS_ERROR(esp_lcd_panel_io_tx_param(lcd->io, lcd_command, command + 1, commands - 1));
    if (commands && count <= PARAMETERS) /* data without a command are pixels, however few */
        return BUS_ERROR(esp_lcd_panel_io_tx_param(lcd->io, lcd_command, data, count));
    lcd->in_flight = esp_lcd_panel_io_tx_color(lcd->io, lcd_command, data, count) == ESP_OK;
    return lcd->in_flight ? SHEEN_OK : SHEEN_ERR_BUS;
}

static int wait(void *ctx)
{
    struct lcd *lcd = ctx;

    if (lcd->in_flight && xSemaphoreTake(lcd->done, pdMS_TO_TICKS(200)) != pdTRUE)
        return SHEEN_ERR_TIMEOUT;
    lcd->in_flight = 0;
    return SHEEN_OK;
}

static int reset(void *ctx, int level)
{
    (void)ctx;
    return BUS_ERROR(gpio_set_level(pins.reset, level != 0));
}

static int delay(void *ctx, uint32_t us)
{
    (void)ctx;
    if (us >= 10000) /* + 2: the first tick may come at once, and the division rounds down */
        vTaskDelay(pdMS_TO_TICKS(us / 1000) + 2);
    else
        esp_rom_delay_us(us);
    return SHEEN_OK;
}

void app_main(void)
{
    static struct lcd lcd;
    const struct sheen_panel_record *record = &sheen_panel_st7789_240x240;
    const spi_bus_config_t wires = {.mosi_io_num = pins.mosi,
                                    .miso_io_num = -1,
                                    .sclk_io_num = pins.sclk,
                                    .quadwp_io_num = -1,
                                    .quadhd_io_num = -1,
                                    .max_transfer_sz = 240 * 16 * 2};
    const esp_lcd_panel_io_spi_config_t settings = {.cs_gpio_num = pins.cs,
                                                    .dc_gpio_num = pins.dc,
                                                    .spi_mode = record->spi_mode,
                                                    .pclk_hz = 40000000,
                                                    .trans_queue_depth = 2,
                                                    .on_color_trans_done = colors_done,
                                                    .user_ctx = &lcd,
                                                    .lcd_cmd_bits = 8,
                                                    .lcd_param_bits = 8};
    const struct sheen_bus bus = {.ctx = &lcd, .send = send, .delay = delay, .wait = wait, .reset = reset};
    const gpio_config_t outputs = {.pin_bit_mask = 1ull << pins.reset | 1ull << pins.light, .mode = GPIO_MODE_OUTPUT};
    struct sheen_panel panel;
    struct sheen_target target;
    struct sheen_frame *frame;
    int error;

    lcd.done = xSemaphoreCreateBinary();
    ESP_ERROR_CHECK(gpio_config(&outputs));
    ESP_ERROR_CHECK(gpio_set_level(pins.light, 1));
    ESP_ERROR_CHECK(spi_bus_initialize(SPI2_HOST, &wires, SPI_DMA_CH_AUTO));
    ESP_ERROR_CHECK(esp_lcd_new_panel_io_spi((esp_lcd_spi_bus_handle_t)SPI2_HOST, &settings, &lcd.io));
    error = sheen_panel_open(&panel, record, &bus, 0);
    if (!error)
        error = sheen_panel_target(&panel, &target);
    if (!error)
        error = example_init(&frame, &target);
    for (unsigned i = 0; !error && i < EXAMPLE_FRAMES; i++) {
        error = example_draw(frame, i);
        if (i % 16 == 0)
            vTaskDelay(1); /* lets the idle task run, which feeds the watchdog */
    }
    if (!error)
        error = sheen_wait(frame);
    ESP_LOGI("sheen", "%s", sheen_strerror(error));
}
