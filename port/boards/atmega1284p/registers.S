/* SPDX-License-Identifier: MIT */
/*
 * What C cannot say: where the registers are (data sheet 8272, 35: register summary), and how to stop.
 */
    .macro register name, address
    .global \name
    .set \name, \address
    .endm
    register UCSR0A, 0xC0
    register UCSR0B, 0xC1
    register UDR0, 0xC6

/* simavr ends when the processor sleeps and no interrupt can wake it. */
    .section .text.atmega_stop, "ax"
    .global atmega_stop
atmega_stop:
    cli
    ldi r24, 1
    out 0x33, r24 /* SMCR: sleep enable, mode idle */
    sleep
    rjmp atmega_stop
