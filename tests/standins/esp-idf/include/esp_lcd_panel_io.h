/*
 * esp_lcd_panel_io.h - stands for ESP-IDF's esp_lcd over SPI: a command with parameters, or with colours that are sent
 * while the program goes on.
 */
#ifndef ESP_LCD_PANEL_IO_H
#define ESP_LCD_PANEL_IO_H

#include <assert.h>
#include <stdbool.h>
#include <stdint.h>

#include "wire.h"

typedef int esp_err_t;
#define ESP_OK 0

typedef struct esp_lcd_panel_io_t *esp_lcd_panel_io_handle_t;
typedef int esp_lcd_spi_bus_handle_t; /* a pointer in older ESP-IDF */
typedef struct {
    int unused;
} esp_lcd_panel_io_event_data_t;

typedef struct {
    int cs_gpio_num, dc_gpio_num, spi_mode;
    unsigned int pclk_hz;
    size_t trans_queue_depth;
    bool (*on_color_trans_done)(esp_lcd_panel_io_handle_t io, esp_lcd_panel_io_event_data_t *event, void *ctx);
    void *user_ctx;
    int lcd_cmd_bits, lcd_param_bits;
} esp_lcd_panel_io_spi_config_t;

static esp_lcd_panel_io_spi_config_t standin_io;

static inline esp_err_t esp_lcd_new_panel_io_spi(esp_lcd_spi_bus_handle_t bus,
                                                 const esp_lcd_panel_io_spi_config_t *settings,
                                                 esp_lcd_panel_io_handle_t *io)
{
    (void)bus;
    standin_io = *settings;
    *io = NULL;
    return ESP_OK;
}

static inline void standin_command(int command)
{
    uint8_t byte = (uint8_t)command;

    wire_level = 0;
    wire_bytes(&byte, command >= 0);
    wire_level = 1;
}

static inline esp_err_t esp_lcd_panel_io_tx_param(esp_lcd_panel_io_handle_t io, int command, const void *bytes,
                                                  size_t count)
{
    (void)io;
    assert(command >= 0); /* without a command the bytes are parameters, which dc_low_on_param sends as commands */
    standin_command(command);
    wire_bytes(bytes, count);
    return ESP_OK;
}

static inline esp_err_t esp_lcd_panel_io_tx_color(esp_lcd_panel_io_handle_t io, int command, const void *bytes,
                                                  size_t count)
{
    (void)io;
    standin_command(command);
    wire_launch(bytes, count);
    return ESP_OK;
}

#endif
