/* SPDX-License-Identifier: MIT */
/* A stand-in for Arduino's core: what a sketch of ours calls, declared as the reference says. */
#ifndef QTRI_TESTS_ARDUINO_H
#define QTRI_TESTS_ARDUINO_H

#include <stddef.h>
#include <stdint.h>

#define LOW      0x0
#define HIGH     0x1
#define OUTPUT   0x1
#define MSBFIRST 1
#define A0       14

void pinMode(uint8_t pin, uint8_t mode);
void digitalWrite(uint8_t pin, uint8_t value);
void delay(unsigned long ms);
unsigned long millis();
int analogRead(uint8_t pin);

void setup();
void loop();

#endif
