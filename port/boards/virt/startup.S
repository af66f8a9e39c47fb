/* SPDX-License-Identifier: MIT */
/*
 * Start-up of a 32-bit RISC-V core: stack, initial memory, main; and the instruction counter, which
 * C cannot read. QEMU loads every segment to where it runs, so there is no data to copy.
 */
    .option arch, +zicsr
    .section .text.start, "ax"
    .globl start
start:
    la sp, stack_top
    la t0, trap
    csrw mtvec, t0
    la t0, bss_start
    la t1, bss_end
1:  bgeu t0, t1, 2f
    sw zero, 0(t0)
    addi t0, t0, 4
    j 1b
2:  la t1, stack_top /* bss_end is stack_low */
    li t2, 0xA5A5A5A5 /* board.c looks for it */
3:  bgeu t0, t1, 4f
    sw t2, 0(t0)
    addi t0, t0, 4
    j 3b
4:  call board_init
    call main
    tail board_exit

    .balign 4
trap:
    li a0, 70 /* as on the other boards, the status of a fault */
    tail board_exit

    .section .text.board_ticks, "ax"
    .globl board_ticks
board_ticks:
    csrr a0, minstret
    ret
