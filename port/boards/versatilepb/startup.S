/* SPDX-License-Identifier: MIT */
/*
 * Start-up of an ARM926: vectors, stack, initial memory, main. The emulator, or a boot loader, has
 * put every segment where it runs, so there is no data to copy.
 */
    .arm
    .section .vectors, "ax"
vectors:
    b reset
    b fault /* undefined instruction */
    b fault /* supervisor call */
    b fault /* prefetch abort */
    b fault /* data abort */
    b fault
    b fault /* interrupts: none is enabled */
    b fault

    .globl reset
reset:
    mrc p15, 0, r0, c1, c0, 0
    orr r0, r0, #0x1000 /* instruction cache on */
    orr r0, r0, #0x0002 /* unaligned access faults */
    mcr p15, 0, r0, c1, c0, 0

    ldr r0, =bss_start
    ldr r1, =bss_end
    mov r2, #0
    bl fill
    ldr r0, =stack_low
    ldr r1, =stack_top
    ldr r2, =STACK_PAINT
    bl fill

    mov sp, r1
    bl board_init
    bl main
    b board_exit

fault: /* in a mode of its own, with a stack pointer of its own */
    ldr sp, =stack_top
    mov r0, #70 /* as on the other boards, the status of a fault */
    b board_exit

/* Words from r0 to r1 become r2. */
fill:
    cmp r0, r1
    strlo r2, [r0], #4
    blo fill
    bx lr

    .equ STACK_PAINT, 0xA5A5A5A5 /* board.c looks for it */
