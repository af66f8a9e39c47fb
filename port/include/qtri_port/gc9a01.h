/* SPDX-License-Identifier: MIT */
/*
 * GC9A01: round TFT of 240x240 pixels, RGB565 over SPI. What lies outside the circle is sent and
 * not seen. Modules that show a mirrored picture want a qtri_module with mirror_columns.
 */
#ifndef QTRI_PORT_GC9A01_H
#define QTRI_PORT_GC9A01_H

#include "panel.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The round panel of 240x240. */
extern const qtri_panel_description qtri_gc9a01;

#ifdef __cplusplus
}
#endif

#endif
