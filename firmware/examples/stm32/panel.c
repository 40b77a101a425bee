/*
 * panel.c - sheen with STM32Cube's HAL: DMA sends the pixels by SPI, and its callback says when they have left.
 *
 * In CubeMX set up hspi1 (transmit only, 8 bits, high bit first, CPOL high and CPHA 2nd edge, which modules without CS
 * need, at most 62.5 MHz, with a DMA stream and the SPI's global interrupt, by which newer chips such as the H7 report
 * the end of a DMA transfer) and the pins LCD_DC, LCD_CS, LCD_RST as outputs (main.h).
 * DMA does not see the data cache of an F7 or H7, nor reach the H7's DTCM or the F4's CCM: there the arena belongs into
 * RAM that DMA reaches and the MPU keeps uncached; so does `panel` below where the driver rearranges pixels (all but
 * 16-bit colours), for it sends them from there. Parameters may be on the stack, so DMA has nothing to do with them.
 * Call show_on_panel() from main(), after the MX_..._Init() calls.
 */
#include "example.h"
#include "main.h"
#include "sheen_panel.h"

#define PARAMETERS 16u     /* more data than this are sent by DMA */
#define LONGEST_DMA 65535u /* the DMA counter has 16 bits; a band of 240 x 16 px has 7680 bytes */
#define TIMEOUT_MS 200u

extern SPI_HandleTypeDef hspi1;

static volatile int in_flight;

void HAL_SPI_TxCpltCallback(SPI_HandleTypeDef *spi)
{
    if (spi == &hspi1)
        in_flight = 0;
}

/* Stops the transfer and deselects the panel, so that the next transfer finds the bus free. */
static int give_up(int error)
{
    HAL_SPI_Abort(&hspi1);
    in_flight = 0;
    HAL_GPIO_WritePin(LCD_CS_GPIO_Port, LCD_CS_Pin, GPIO_PIN_SET);
    return error;
}

/* Sends parameters, or starts DMA on pixels. */
static HAL_StatusTypeDef start_data(uint8_t *data, uint16_t count)
{
    if (count <= PARAMETERS)
        return HAL_SPI_Transmit(&hspi1, data, count, TIMEOUT_MS);
    in_flight = 1;
    return HAL_SPI_Transmit_DMA(&hspi1, data, count);
}

static int send(void *ctx, const uint8_t *command, size_t commands, const void *data, size_t count)
{
    (void)ctx;
    if (count > LONGEST_DMA)
        return SHEEN_ERR_ARGUMENT;
    HAL_GPIO_WritePin(LCD_CS_GPIO_Port, LCD_CS_Pin, GPIO_PIN_RESET);
    HAL_GPIO_WritePin(LCD_DC_GPIO_Port, LCD_DC_Pin, GPIO_PIN_RESET);
    if (commands && HAL_SPI_Transmit(&hspi1, (uint8_t *)command, (uint16_t)commands, TIMEOUT_MS) != HAL_OK)
        return give_up(SHEEN_ERR_BUS);
    HAL_GPIO_WritePin(LCD_DC_GPIO_Port, LCD_DC_Pin, GPIO_PIN_SET);
    return count && start_data((uint8_t *)data, (uint16_t)count) != HAL_OK ? give_up(SHEEN_ERR_BUS) : SHEEN_OK;
}

static int wait(void *ctx)
{
    uint32_t start = HAL_GetTick();

    (void)ctx;
    while (in_flight)
        if (HAL_GetTick() - start > TIMEOUT_MS)
            return give_up(SHEEN_ERR_TIMEOUT);
    HAL_GPIO_WritePin(LCD_CS_GPIO_Port, LCD_CS_Pin, GPIO_PIN_SET);
    return SHEEN_OK;
}

static int reset(void *ctx, int level)
{
    (void)ctx;
    HAL_GPIO_WritePin(LCD_RST_GPIO_Port, LCD_RST_Pin, level ? GPIO_PIN_SET : GPIO_PIN_RESET);
    return SHEEN_OK;
}

static int delay(void *ctx, uint32_t us)
{
    (void)ctx;
    HAL_Delay(us / 1000u + 1u);
    return SHEEN_OK;
}

int show_on_panel(void)
{
    static const struct sheen_bus bus = {.send = send, .delay = delay, .wait = wait, .reset = reset};
    static struct sheen_panel panel;
    static struct sheen_target target;
    int error = sheen_panel_open(&panel, &sheen_panel_st7789_240x240, &bus, 0);

    if (!error)
        error = sheen_panel_target(&panel, &target);
    return error ? error : example_run(&target, EXAMPLE_FRAMES);
}
