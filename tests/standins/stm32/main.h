/*
 * main.h - stands for what CubeMX generates, and for STM32Cube's HAL as far as SPI with DMA and GPIO need it.
 */
#ifndef MAIN_H
#define MAIN_H

#include "wire.h"

typedef enum {
    HAL_OK = 0,
    HAL_ERROR = 1,
    HAL_BUSY = 2
} HAL_StatusTypeDef;
typedef enum {
    GPIO_PIN_RESET = 0,
    GPIO_PIN_SET
} GPIO_PinState;
typedef struct {
    int unused;
} SPI_HandleTypeDef, GPIO_TypeDef;

extern GPIO_TypeDef standin_port;
#define LCD_DC_GPIO_Port (&standin_port)
#define LCD_CS_GPIO_Port (&standin_port)
#define LCD_RST_GPIO_Port (&standin_port)
#define LCD_DC_Pin 1u
#define LCD_CS_Pin 2u
#define LCD_RST_Pin 4u

void HAL_GPIO_WritePin(GPIO_TypeDef *port, uint16_t pin, GPIO_PinState state);
HAL_StatusTypeDef HAL_SPI_Transmit(SPI_HandleTypeDef *spi, uint8_t *bytes, uint16_t count, uint32_t timeout);
HAL_StatusTypeDef HAL_SPI_Transmit_DMA(SPI_HandleTypeDef *spi, uint8_t *bytes, uint16_t count);
void HAL_SPI_TxCpltCallback(SPI_HandleTypeDef *spi);
HAL_StatusTypeDef HAL_SPI_Abort(SPI_HandleTypeDef *spi);
uint32_t HAL_GetTick(void);
void HAL_Delay(uint32_t ms);

#endif
