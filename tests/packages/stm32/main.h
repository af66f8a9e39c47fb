/* SPDX-License-Identifier: MIT */
/*
 * Stand-ins for what port/examples/glue/stm32_hal.c calls, declared as ST's UM1725 "Description of
 * STM32F4 HAL and low-layer drivers" describes it (HAL GPIO, HAL SPI and HAL generic driver), and
 * what CubeMX writes into main.h for pins with labels.
 */
#ifndef QTRI_TESTS_STM32_MAIN_H
#define QTRI_TESTS_STM32_MAIN_H

#include <stdint.h>

typedef enum { HAL_OK = 0, HAL_ERROR = 1, HAL_BUSY = 2, HAL_TIMEOUT = 3 } HAL_StatusTypeDef;
typedef enum { GPIO_PIN_RESET = 0, GPIO_PIN_SET } GPIO_PinState;
typedef struct {
    volatile uint32_t MODER, ODR;
} GPIO_TypeDef;
typedef struct {
    void *Instance;
} SPI_HandleTypeDef;

extern GPIO_TypeDef gpio_a;
#define LCD_CS_Pin          ((uint16_t)0x0010)
#define LCD_CS_GPIO_Port    (&gpio_a)
#define LCD_DC_Pin          ((uint16_t)0x0020)
#define LCD_DC_GPIO_Port    (&gpio_a)
#define LCD_RESET_Pin       ((uint16_t)0x0040)
#define LCD_RESET_GPIO_Port (&gpio_a)

void HAL_GPIO_WritePin(GPIO_TypeDef *GPIOx, uint16_t GPIO_Pin, GPIO_PinState PinState);
HAL_StatusTypeDef HAL_SPI_Transmit(SPI_HandleTypeDef *hspi, uint8_t *pData, uint16_t Size,
                                   uint32_t Timeout);
HAL_StatusTypeDef HAL_SPI_Transmit_DMA(SPI_HandleTypeDef *hspi, uint8_t *pData, uint16_t Size);
HAL_StatusTypeDef HAL_SPI_Abort(SPI_HandleTypeDef *hspi);
void HAL_SPI_TxCpltCallback(SPI_HandleTypeDef *hspi);
void HAL_SPI_ErrorCallback(SPI_HandleTypeDef *hspi);
void HAL_Delay(uint32_t Delay);
uint32_t HAL_GetTick(void);

#endif
