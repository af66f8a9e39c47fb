/* SPDX-License-Identifier: MIT */
/*
 * Start-up of a Cortex-M: vector table, initial memory, main. No C library.
 */
#include "../board.h"

int main(void);
void reset(void);

/* From the linker script; only their addresses mean anything. */
extern uint32_t data_start[], data_end[], bss_start[], bss_end[], stack_low[], stack_top[];
extern const uint32_t data_load[];

static size_t words(const uint32_t *from, const uint32_t *to)
{
    return ((uintptr_t)to - (uintptr_t)from) / sizeof *from;
}

#define PAINT 0xA5A5A5A5u

/*
 * Armv7-M B3.2.8: unaligned access faults, as on a Cortex-M0+, unless the compiler may use it, and
 * so does division by zero.
 */
#define SCB_CCR         (*(volatile uint32_t *)0xE000ED14u)
#define CCR_UNALIGN_TRP (1u << 3)
#define CCR_DIV_0_TRP   (1u << 4)
#ifdef __ARM_FEATURE_UNALIGNED
#define CCR_TRAPS CCR_DIV_0_TRP
#else
#define CCR_TRAPS (CCR_UNALIGN_TRP | CCR_DIV_0_TRP)
#endif
/* Armv7-M B3.2.20: coprocessors 10 and 11, whose registers the compiler uses on an M4F. */
#define SCB_CPACR         (*(volatile uint32_t *)0xE000ED88u)
#define CPACR_FPU         (0xFu << 20)
#define FAULT_EXIT_STATUS 70

static void fault(void)
{
    board_write("# fault\n");
    board_exit(FAULT_EXIT_STATUS);
}

/* Exceptions 1 to 15; the linker script puts the initial stack pointer in front, as word 0. */
typedef void (*handler)(void);
__attribute__((section(".vectors"), used)) static const handler handlers[15] = {
    reset, fault, fault, fault, fault, fault, /* reset, NMI, HardFault, memory, bus, usage */
    NULL,  NULL,  NULL,  NULL,                /* reserved */
    fault, fault, NULL,  fault, fault,        /* SVCall, debug, reserved, PendSV, SysTick */
};

/* Paints what lies below the stack pointer: all of it that is free. */
static void paint_stack(void)
{
    const uint32_t *stack_pointer;
    __asm__ volatile("mov %0, sp" : "=r"(stack_pointer));
    size_t free_words = words(stack_low, stack_pointer);
    for (size_t i = 0; i < free_words; i++) {
        ((volatile uint32_t *)stack_low)[i] = PAINT;
    }
}

size_t board_stack_used(void)
{
    size_t size = words(stack_low, stack_top);
    size_t untouched = 0;
    while (untouched < size && stack_low[untouched] == PAINT) {
        untouched++;
    }
    return (size - untouched) * sizeof stack_low[0];
}

void reset(void)
{
    for (size_t i = 0; i < words(data_start, data_end); i++) {
        data_start[i] = data_load[i];
    }
    for (size_t i = 0; i < words(bss_start, bss_end); i++) {
        bss_start[i] = 0;
    }
    paint_stack();
    SCB_CCR |= CCR_TRAPS;
#ifdef __ARM_FP
    SCB_CPACR |= CPACR_FPU;
#endif
    board_init();
    board_exit(main());
}
