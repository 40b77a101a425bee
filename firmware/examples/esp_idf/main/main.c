/*
 * main.c - sheen with ESP-IDF: a bus on top of esp_lcd's panel IO. DMA sends pixels; a callback says when they left.
 *
 * The pins are those of a common ESP32 wiring. ESP-IDF takes care of clock, chip select, DMA and D/C.
 */
#include "driver/spi_master.h"
#include "esp_lcd_panel_io.h"
#include "esp_rom_sys.h"
#include "example.h"
#include "freertos/FreeRTOS.h"
#include "freertos/semphr.h"
#include "sheen_panel.h"

#define PARAMETERS 16 /* more data than this are sent by DMA */
#define BUS_ERROR(code) ((code) == ESP_OK ? SHEEN_OK : SHEEN_ERR_BUS)

struct lcd {
    esp_lcd_panel_io_handle_t io;
    SemaphoreHandle_t done;
    int flying;
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
    lcd->flying = esp_lcd_panel_io_tx_color(lcd->io, lcd_command, data, count) == ESP_OK;
    return lcd->flying ? SHEEN_OK : SHEEN_ERR_BUS;
}

static int wait(void *ctx)
{
    struct lcd *lcd = ctx;

    if (lcd->flying && xSemaphoreTake(lcd->done, pdMS_TO_TICKS(200)) != pdTRUE)
        return SHEEN_ERR_TIMEOUT;
    lcd->flying = 0;
    return SHEEN_OK;
}

static int delay(void *ctx, uint32_t us)
{
    (void)ctx;
    if (us >= 10000)
        vTaskDelay(pdMS_TO_TICKS(us / 1000) +
                   2); /* +2: the first tick may come at once, and the division rounds down */
    else
        esp_rom_delay_us(us);
    return SHEEN_OK;
}

void app_main(void)
{
    static struct lcd lcd;
    const struct sheen_panel_record *record = &sheen_panel_st7789_240x240;
    const spi_bus_config_t wires = {.mosi_io_num = 23,
                                    .miso_io_num = -1,
                                    .sclk_io_num = 18,
                                    .quadwp_io_num = -1,
                                    .quadhd_io_num = -1,
                                    .max_transfer_sz = 240 * 16 * 2};
    const esp_lcd_panel_io_spi_config_t settings = {.cs_gpio_num = 5,
                                                    .dc_gpio_num = 16,
                                                    .spi_mode = record->spi_mode,
                                                    .pclk_hz = 40000000,
                                                    .trans_queue_depth = 2,
                                                    .on_color_trans_done = colors_done,
                                                    .user_ctx = &lcd,
                                                    .lcd_cmd_bits = 8,
                                                    .lcd_param_bits = 8};
    const struct sheen_bus bus = {.ctx = &lcd, .send = send, .delay = delay, .wait = wait};
    struct sheen_panel panel;
    struct sheen_target target;

    lcd.done = xSemaphoreCreateBinary();
    ESP_ERROR_CHECK(spi_bus_initialize(SPI2_HOST, &wires, SPI_DMA_CH_AUTO));
    ESP_ERROR_CHECK(esp_lcd_new_panel_io_spi((esp_lcd_spi_bus_handle_t)SPI2_HOST, &settings, &lcd.io));
    if (sheen_panel_open(&panel, record, &bus, 0) == SHEEN_OK && sheen_panel_target(&panel, &target) == SHEEN_OK)
        example(&target, 3);
}
