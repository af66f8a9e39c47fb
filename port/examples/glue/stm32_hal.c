/* SPDX-License-Identifier: MIT */
/*
 * The examples on an STM32 (HAL of STM32CubeMX) with an ILI9341 on SPI, pixels by DMA. In CubeMX:
 *
 *   SPI 1     transmit only master, 8 bits, MSB first, mode 0 (CPOL low, 1st edge), NSS by
 *             software; as fast as the display stands, up to 40 MHz
 *   its DMA   a channel for SPI1_TX: memory to peripheral, normal, bytes; interrupt on
 *   pins      outputs with the user labels LCD_CS, LCD_DC and LCD_RESET, which main.h then has
 *
 * Core and panels, the example and this file are compiled with the project; in main(), after the
 * peripherals are initialised: `example_run();` behind `#include "example.h"`.
 */
#include "main.h"

#include "../example.h"
#include "qtri_port/ili9341.h"

extern SPI_HandleTypeDef hspi1;

enum { WAIT_MS = 100 };

static volatile bool is_sending, has_failed;
static uint8_t line_memory[QTRI_PANEL_LINE_BYTES(320)];

/* The HAL does not write to what it sends, though some of its versions do not say so. */
static uint8_t *unsaid(const uint8_t *bytes)
{
    return (uint8_t *)(uintptr_t)bytes;
}

/* Returns after the last bit: HAL_SPI_Transmit waits for it. */
static bool send(GPIO_PinState data_pin, const uint8_t *bytes, size_t count)
{
    HAL_GPIO_WritePin(LCD_DC_GPIO_Port, LCD_DC_Pin, data_pin);
    return HAL_SPI_Transmit(&hspi1, unsaid(bytes), (uint16_t)count, WAIT_MS) == HAL_OK;
}

static bool command(void *context, const uint8_t *bytes, size_t count)
{
    (void)context;
    return send(GPIO_PIN_RESET, bytes, count);
}

static bool data(void *context, const uint8_t *bytes, size_t count)
{
    (void)context;
    return send(GPIO_PIN_SET, bytes, count);
}

static bool data_start(void *context, const uint8_t *bytes, size_t count)
{
    (void)context;
    HAL_GPIO_WritePin(LCD_DC_GPIO_Port, LCD_DC_Pin, GPIO_PIN_SET);
    is_sending = true;
    has_failed = false;
    if (HAL_SPI_Transmit_DMA(&hspi1, unsaid(bytes), (uint16_t)count) != HAL_OK) {
        is_sending = false;
        return false;
    }
    return true; /* the interrupt may have been here already */
}

/* The HAL's interrupt calls these when the last bit is out. They serve all SPIs. */
void HAL_SPI_TxCpltCallback(SPI_HandleTypeDef *hspi)
{
    if (hspi == &hspi1) {
        is_sending = false;
    }
}

void HAL_SPI_ErrorCallback(SPI_HandleTypeDef *hspi)
{
    if (hspi == &hspi1) {
        has_failed = true;
        is_sending = false;
    }
}

static bool data_finish(void *context)
{
    (void)context;
    uint32_t start = HAL_GetTick();
    while (is_sending) {
        if (HAL_GetTick() - start > WAIT_MS) {
            (void)HAL_SPI_Abort(&hspi1);
            is_sending = false;
            has_failed = true;
        }
    }
    return !has_failed;
}

static void wait_ms(void *context, uint32_t ms)
{
    (void)context;
    HAL_Delay(ms);
}

static void reset(void *context, bool active)
{
    (void)context;
    HAL_GPIO_WritePin(LCD_RESET_GPIO_Port, LCD_RESET_Pin, active ? GPIO_PIN_RESET : GPIO_PIN_SET);
}

/* The HAL counts a transfer in 16 bits. */
static const qtri_bus bus = {.command = command,
                             .data = data,
                             .data_start = data_start,
                             .data_finish = data_finish,
                             .wait_ms = wait_ms,
                             .reset = reset,
                             .most_bytes = 65534};

enum qtri_error example_display(qtri_panel *panel)
{
    HAL_GPIO_WritePin(LCD_CS_GPIO_Port, LCD_CS_Pin, GPIO_PIN_RESET); /* alone on its bus */
    return qtri_panel_init(panel, &qtri_ili9341, &bus, QTRI_ROTATE_90, line_memory,
                           sizeof line_memory);
}

/* As fast as it goes: the last band may be on its way while the next frame begins. */
bool example_next_frame(qtri_panel *panel)
{
    (void)panel;
    return true;
}
