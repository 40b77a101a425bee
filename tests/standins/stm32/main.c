/*
 * main.c - stands for a CubeMX project's main.c and for STM32Cube's HAL. A DMA transfer ends while the program waits
 * for it; the first one never ends, and the HAL is busy until it is aborted. DMA does not reach the stack, as on an H7,
 * whose linker scripts put it into the DTCM.
 */
#include <assert.h>

#include "main.h"
#include "sheen_target.h"

GPIO_TypeDef standin_port;
SPI_HandleTypeDef hspi1;

static GPIO_PinState selected = GPIO_PIN_SET;
static int transfers, stuck;
static uintptr_t stack_top;

int show_on_panel(void);

void HAL_GPIO_WritePin(GPIO_TypeDef *port, uint16_t pin, GPIO_PinState state)
{
    (void)port;
    if (pin == LCD_DC_Pin)
        wire_level = state;
    else if (pin == LCD_CS_Pin)
        selected = state;
    else if (pin == LCD_RST_Pin)
        wire_number('R', state);
}

HAL_StatusTypeDef HAL_SPI_Transmit(SPI_HandleTypeDef *spi, uint8_t *bytes, uint16_t count, uint32_t timeout)
{
    (void)spi;
    (void)timeout;
    if (stuck)
        return HAL_BUSY;
    wire_bytes(bytes, count);
    return HAL_OK;
}

HAL_StatusTypeDef HAL_SPI_Transmit_DMA(SPI_HandleTypeDef *spi, uint8_t *bytes, uint16_t count)
{
    (void)spi;
    assert((uintptr_t)bytes < (uintptr_t)__builtin_frame_address(0) || (uintptr_t)bytes > stack_top);
    if (stuck)
        return HAL_BUSY;
    wire_launch(bytes, count);
    stuck = ++transfers == 1;
    return HAL_OK;
}

HAL_StatusTypeDef HAL_SPI_Abort(SPI_HandleTypeDef *spi)
{
    (void)spi;
    stuck = 0;
    wire_flying = NULL;
    return HAL_OK;
}

uint32_t HAL_GetTick(void)
{
    static uint32_t ticks;
    static int calls;

    if (!stuck && ++calls % 3 == 0 && wire_flying) { /* not when it is first asked for */
        wire_land();
        HAL_SPI_TxCpltCallback(&hspi1);
    }
    return ticks++;
}

void HAL_Delay(uint32_t ms)
{
    wire_number('T', ms * 1000u);
}

int main(void)
{
    stack_top = (uintptr_t)__builtin_frame_address(0);
    int error = show_on_panel();

    assert(error == SHEEN_ERR_TIMEOUT && selected == GPIO_PIN_SET);
    error = show_on_panel();
    wire_number('F', 0);
    return error != 0 || fflush(stdout) != 0;
}
