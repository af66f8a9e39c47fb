/* SPDX-License-Identifier: MIT */
/* The stand-ins of the STM32's HAL at work: the interrupt comes when time is asked for or waited.
 */
#include "main.h"

#include "../glue/display.h"

#include "../../../port/examples/example.h"

GPIO_TypeDef gpio_a;
SPI_HandleTypeDef hspi1;

static uint32_t now, due;

void HAL_GPIO_WritePin(GPIO_TypeDef *GPIOx, uint16_t GPIO_Pin, GPIO_PinState PinState)
{
    (void)GPIOx;
    if (GPIO_Pin == LCD_DC_Pin) {
        glue_data_pin(PinState == GPIO_PIN_SET);
    } else if (GPIO_Pin == LCD_RESET_Pin) {
        glue_reset_pin(PinState == GPIO_PIN_RESET);
    }
}

HAL_StatusTypeDef HAL_SPI_Transmit(SPI_HandleTypeDef *hspi, uint8_t *pData, uint16_t Size,
                                   uint32_t Timeout)
{
    (void)hspi;
    (void)Timeout;
    glue_send(pData, Size);
    return HAL_OK;
}

HAL_StatusTypeDef HAL_SPI_Transmit_DMA(SPI_HandleTypeDef *hspi, uint8_t *pData, uint16_t Size)
{
    (void)hspi;
    glue_start(pData, Size);
    due = now + 3;
    return HAL_OK;
}

HAL_StatusTypeDef HAL_SPI_Abort(SPI_HandleTypeDef *hspi)
{
    (void)hspi;
    glue_stop(1, "a transfer took too long");
    return HAL_OK;
}

void HAL_Delay(uint32_t Delay)
{
    now += Delay;
    glue_wait(Delay);
}

uint32_t HAL_GetTick(void)
{
    now++;
    if (glue_is_sending() && now >= due) {
        glue_finish();
        HAL_SPI_TxCpltCallback(&hspi1);
    }
    return now;
}

int main(void)
{
    (void)example_run();
    return 1; /* frames end it */
}
