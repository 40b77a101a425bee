/*
 * main.c - stands for a CubeMX project's main.c and for STM32Cube's HAL. DMA ends while its end is waited for.
 */
#include "main.h"

GPIO_TypeDef standin_port;
SPI_HandleTypeDef hspi1;

int show_on_panel(void);

void HAL_GPIO_WritePin(GPIO_TypeDef *port, uint16_t pin, GPIO_PinState state)
{
    (void)port;
    if (pin == LCD_DC_Pin)
        wire_level = state;
    else if (pin == LCD_RST_Pin)
        wire_number('R', state);
}

HAL_StatusTypeDef HAL_SPI_Transmit(SPI_HandleTypeDef *spi, uint8_t *bytes, uint16_t count, uint32_t timeout)
{
    (void)spi;
    (void)timeout;
    wire_bytes(bytes, count);
    return HAL_OK;
}

HAL_StatusTypeDef HAL_SPI_Transmit_DMA(SPI_HandleTypeDef *spi, uint8_t *bytes, uint16_t count)
{
    (void)spi;
    wire_launch(bytes, count);
    return HAL_OK;
}

uint32_t HAL_GetTick(void)
{
    static uint32_t ticks;
    static int calls;

    if (++calls % 3 == 0 && wire_flying) { /* not at the first look */
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
    int error = show_on_panel();

    wire_number('F', 0);
    return error != 0 || fflush(stdout) != 0;
}
