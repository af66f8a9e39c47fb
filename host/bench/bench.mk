# SPDX-License-Identifier: MIT
# Counting instructions on emulated cores, and bytes of code. Included by the main Makefile.

BENCH_DIR   := $(BUILD)/bench
BENCH_CORES := cortex-m0plus cortex-m3 cortex-m4 cortex-m7 rv32imc

BENCH_MATH   := $(wildcard core/bits/*.c core/math/*.c)
BENCH_CORE   := $(BENCH_MATH) $(wildcard core/geometry/*.c)
BENCH_INPUTS := $(wildcard core/*/*.[ch] core/*/*.inc core/include/qtri/*.h host/bench/bench_math*.[ch] host/bench/*.inc) host/bench/bench.mk
BENCH_FLAGS  := -std=c99 -O2 -ffreestanding -ffunction-sections -fdata-sections -Icore/include -idirafter port/boards/common/libc
BENCH_LINK   := -nostdlib -Wl,--gc-sections

# A core may be named with -Os behind it: where the library is counted, it is compiled so then, and else at -O2. With -hot
# what makes pixels is at -O2, the rest at -Os, as a CMake build of the type MinSizeRel has it (port/packages/sources.cmake).
BENCH_HOT     := $(subst *,%,$(shell sed -n 's/^set.QTRI_HOT \(.*\).$$/\1/p' port/packages/sources.cmake))
bench_core     = $(patsubst %-hot,%,$(1:%-Os=%))
bench_optimize = $(if $(filter %-Os,$1)$(and $(filter %-hot,$1),$(filter-out $(BENCH_HOT),$2)),-Os,-O2)

# How a core's code is compiled, whose start-up and console it has, and what executes it. -icount: one instruction
# takes 1 ns. The M0+ has no machine of its own with enough memory; the M3's executes its instructions.
bench_cc       = $(if $(filter rv32%,$1),riscv64-unknown-elf-gcc -march=$(bench_core) -mabi=ilp32,arm-none-eabi-gcc -mcpu=$(bench_core) -mthumb)
bench_board    = port/boards/$(if $(filter rv32%,$1),virt,mps2)
bench_emulator = $(if $(filter rv32%,$1),qemu-system-riscv32 -M virt -bios none,qemu-system-arm -M $(BENCH_MACHINE_$(bench_core)) \
                 -semihosting-config enable=on$(comma)target=native) -icount shift=0$(comma)sleep=off
comma := ,

BENCH_MACHINE_cortex-m0plus := mps2-an385
BENCH_MACHINE_cortex-m3     := mps2-an385
BENCH_MACHINE_cortex-m4     := mps2-an386
BENCH_MACHINE_cortex-m7     := mps2-an500

# The cores whose tools are here. A $(shell) whose last command is not found gives nothing at all: hence `if`.
BENCH_TOOLS   := arm-none-eabi-gcc qemu-system-arm riscv64-unknown-elf-gcc qemu-system-riscv32
BENCH_TOOLS   := $(shell for tool in $(BENCH_TOOLS); do if command -v $$tool >/dev/null 2>&1; then echo $$tool; fi; done)
bench_has      = $(filter $(firstword $1),$(BENCH_TOOLS))
bench_present  = $(strip $(foreach core,$1,$(if $(and $(call bench_has,$(call bench_cc,$(core))),\
                 $(call bench_has,$(call bench_emulator,$(core)))),$(core))))
BENCH_PRESENT := $(call bench_present,$(filter-out %-Os,$(BENCH_CORES)))
BENCH_ABSENT  := $(filter-out $(BENCH_PRESENT),$(filter-out %-Os,$(BENCH_CORES)))

# Says which tools the cores that are absent lack, if any are. $1: the target, $2: these cores.
bench_lacks = $(sort $(filter-out $(BENCH_TOOLS),$(foreach core,$1,$(firstword $(call bench_cc,$(core))) $(firstword $(call bench_emulator,$(core))))))
bench_skip  = $(if $2,echo "$1: skipped: $2: $(call bench_lacks,$2) not installed (make setup-all)",:)

# One program for each core. $1: core, $2: its board. Only memory.c must be kept from becoming a memcpy itself.
define bench_rules
$(BENCH_DIR)/$1/bench_math: $(BENCH_INPUTS) $(wildcard port/boards/$2/* port/boards/common/*)
	@mkdir -p $$(@D)
	$(call bench_cc,$1) $(BENCH_FLAGS) -fno-tree-loop-distribute-patterns -c -o $$(@D)/memory.o port/boards/common/memory.c
	$(call bench_cc,$1) $(BENCH_FLAGS) $(BENCH_LINK) -T port/boards/$2/$2.ld -o $$@ $(BENCH_CORE) \
	    $(wildcard host/bench/bench_math*.c port/boards/$2/*.[cS]) $$(@D)/memory.o -lgcc

$(BENCH_DIR)/$1/math.txt: $(BENCH_DIR)/$1/bench_math
	@timeout 300 $(call bench_emulator,$1) -display none -monitor none -serial stdio -kernel $$< </dev/null >$$@.part
	@grep -q '^end$$$$' $$@.part && mv $$@.part $$@
endef
$(foreach core,$(filter-out %-Os,$(BENCH_CORES)),$(eval $(call bench_rules,$(core),$(notdir $(call bench_board,$(core))))))

.PHONY: bench-math
bench-math: $(BENCH_PRESENT:%=$(BENCH_DIR)/%/math.txt) ## Count the instructions of every function of the mathematics on emulated cores
	@$(call bench_skip,bench-math,$(BENCH_ABSENT))
	@$(if $(BENCH_PRESENT),sh host/bench/bench_math.sh $(BENCH_DIR) $(BUILD)/bench-math.tsv $(BENCH_PRESENT),:)

# Code size -----------------------------------------------------------------------------------------

SIZE_CORES := cortex-m3 cortex-m0plus
SIZE_OPTIMIZE_cortex-m3     := -O2
SIZE_OPTIMIZE_cortex-m0plus := -Os

.PHONY: size-math
size-math: ## Bytes of code of the mathematics: each object, everything, and a program of q16_mul and q16_sin
ifeq ($(filter arm-none-eabi-gcc,$(BENCH_TOOLS)),)
	@echo "size-math: skipped: arm-none-eabi-gcc not installed (make setup-all)"
else
	@$(foreach core,$(SIZE_CORES),rm -rf $(BENCH_DIR)/size-$(core); mkdir -p $(BENCH_DIR)/size-$(core); \
	    for file in $(BENCH_MATH); do \
	        $(call bench_cc,$(core)) $(BENCH_FLAGS) $(SIZE_OPTIMIZE_$(core)) -c $$file \
	            -o $(BENCH_DIR)/size-$(core)/$$(basename $$file .c).o || exit 1; \
	    done;) \
	sh host/bench/size_math.sh $(BENCH_DIR) $(BUILD)/size-math.tsv $(SIZE_CORES)
endif

include host/bench/scenes.mk
include host/bench/matrix.mk
include host/bench/size.mk
