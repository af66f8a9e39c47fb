# SPDX-License-Identifier: MIT
# Emulated boards: firmware, and the check that a board draws the host's pixels.
#
# Included by the main Makefile. A target is <board>_<core>. To add one: a folder beside this file for a new board, a
# core_cc_ line for a new core, a word in BOARD_TARGETS or DISPLAY_TARGETS and a board_run_ line.

BUILD      ?= build
QEMU_ARM   ?= qemu-system-arm
QEMU_RISCV ?= qemu-system-riscv32

BOARD_DIR := $(BUILD)/boards

# These draw the scenes of tests/boards/board_scenes.c and print checksums. linux: a program of the emulated processor
# that runs on this system. The M0+ has no machine of its own with enough memory; Armv6-M is a subset of what the M3
# executes.
BOARD_TARGETS := mps2_cortex-m0plus mps2_cortex-m3 mps2_cortex-m4 mps2_cortex-m7 virt_rv32imc linux_arm64 linux_powerpc

# These have a display, and show on it what their board_show_ draws.
DISPLAY_TARGETS         := versatilepb_arm926ej-s lm3s6965evb_cortex-m3
board_show_versatilepb  := lcd
board_show_lm3s6965evb  := attitude
board_panel_versatilepb := PL110
board_panel_lm3s6965evb := SSD0323

# Runs the examples only (port/examples/examples.mk), in rp2040js.
RP2040_TARGET := rp2040_cortex-m0plus

core_cc_cortex     := arm-none-eabi-gcc -mthumb
core_cc_arm926ej-s := arm-none-eabi-gcc -marm -mcpu=arm926ej-s
core_cc_rv32imc   := riscv64-unknown-elf-gcc -march=rv32imc -mabi=ilp32 -idirafter port/boards/common/libc
core_cc_arm64     := aarch64-linux-gnu-gcc
core_cc_powerpc   := powerpc-linux-gnu-gcc
core_cc = $(if $(filter cortex-%,$1),$(core_cc_cortex) -mcpu=$1 $(BENCH_FPU_$1),$(core_cc_$1))

# An instruction takes 1 ns, so that they can be counted and repeat.
BOARD_QEMU    := -display none -icount shift=0,sleep=off
BOARD_CONSOLE := -monitor none -serial stdio
BOARD_MPS2    := $(BOARD_QEMU) -semihosting-config enable=on,target=native $(BOARD_CONSOLE) -kernel

board_run_mps2_cortex-m0plus    := $(QEMU_ARM) -M mps2-an385 $(BOARD_MPS2)
board_run_mps2_cortex-m3        := $(QEMU_ARM) -M mps2-an385 $(BOARD_MPS2)
board_run_mps2_cortex-m4        := $(QEMU_ARM) -M mps2-an386 $(BOARD_MPS2)
board_run_mps2_cortex-m7        := $(QEMU_ARM) -M mps2-an500 $(BOARD_MPS2)
board_run_virt_rv32imc          := $(QEMU_RISCV) -M virt -bios none $(BOARD_QEMU) $(BOARD_CONSOLE) -kernel
board_run_linux_arm64           := qemu-aarch64
board_run_linux_powerpc         := qemu-ppc
# run_display.sh connects console and monitor.
board_run_versatilepb_arm926ej-s := $(QEMU_ARM) -M versatilepb $(BOARD_QEMU) -semihosting-config enable=on,target=native -kernel
board_run_lm3s6965evb_cortex-m3  := $(QEMU_ARM) -M lm3s6965evb $(BOARD_QEMU) -semihosting-config enable=on,target=native -kernel

BOARD_WARNINGS := -Wall -Wextra -Wconversion -Wshadow -Wpedantic
BOARD_INCLUDES := -Icore/include -Iport/include
BOARD_FLAGS    := -std=c99 -O2 -g -fno-var-tracking $(BOARD_WARNINGS) $(BOARD_INCLUDES) -ffunction-sections -fdata-sections
BOARD_LINK     := -nostdlib -Wl,--gc-sections -Wl,--fatal-warnings

board_of = $(firstword $(subst _, ,$1))
core_of  = $(lastword $(subst _, ,$1))

# The library is that of the benchmarks where they have the core. $1: core
board_library = $(if $(filter cortex-% rv32%,$1),$(SCENE_DIR)/$1/libqtri.a)

# Programs: what runs on boards of each kind, and beside it the sources of the board itself. $1: board, $2: core
ATTITUDE       := tests/boards/attitude_samples.c
board_program   = $(if $(board_show_$1),$(wildcard port/panels/*.c) tests/boards/display_program.c \
                  tests/boards/show_$(board_show_$1).c $(ATTITUDE),tests/boards/board_report.c) \
                  tests/boards/board_print.c
board_folder    = $(wildcard port/boards/$1/*.[cS])
board_folder_linux       := tests/boards/board_host.c
board_folder_lm3s6965evb := $(wildcard port/boards/lm3s6965evb/*.c) port/boards/mps2/startup.c
board_folder_rp2040      := $(wildcard port/boards/rp2040/*.c port/panels/*.c) port/boards/mps2/startup.c
board_sources   = $(if $(call board_library,$2),,$(wildcard core/*/*.c)) tests/boards/board_scenes.c $(call board_program,$1) $(or $(board_folder_$1),$(call board_folder,$1)) \
                  $(if $(filter linux,$1),,$(wildcard port/boards/common/*.c))

# One firmware. $1: target, $2: board, $3: compiler.
define board_rules
$1_objects := $(addprefix $(BOARD_DIR)/$1/,$(addsuffix .o,$(basename $(call board_sources,$2,$(call core_of,$1)))))
$1_library := $(call board_library,$(call core_of,$1))

$(BOARD_DIR)/$1/firmware.elf: $$($1_objects) $$($1_library) $(wildcard port/boards/$2/$2.ld)
	$$(call run,link $$@)$3 $(if $(filter linux,$2),-static,$(BOARD_LINK) -Wl,-Map=$$(@:.elf=.map) -T port/boards/$2/$2.ld) \
	    $$($1_objects) $$($1_library) $(if $(filter linux,$2),,-lgcc) -o $$@
	@$(patsubst %gcc,%size,$(firstword $3)) $$@ >$$(@:.elf=.size)

$(BOARD_DIR)/$1/port/boards/common/memory.o: private BOARD_EXTRA := -fno-tree-loop-distribute-patterns

$(BOARD_DIR)/$1/%.o: %.c port/boards/boards.mk
	$$(folder)
	$$(call run,compile $$< for $1)$3 $(BOARD_FLAGS) $(if $(filter linux,$2),,-ffreestanding) $$(BOARD_EXTRA) -MMD -MP -c -o $$@ $$<

$(BOARD_DIR)/$1/%.o: %.S port/boards/boards.mk
	$$(folder)
	$$(call run,compile $$< for $1)$3 -c -o $$@ $$<

-include $$(wildcard $$($1_objects:.o=.d))
endef
$(foreach t,$(BOARD_TARGETS) $(DISPLAY_TARGETS) $(RP2040_TARGET),$(eval $(call \
    board_rules,$t,$(call board_of,$t),$(call core_cc,$(call core_of,$t)))))

# What this one adds, pointers of 64 bits, needs no optimizer.
$(BOARD_DIR)/linux_arm64/%.o: private BOARD_EXTRA := -O0

# The host's programs: board_host prints the checksums, show_BOARD draws what a display must show.
BOARD_HOST := $(BOARD_DIR)/host/board_host
SHOW_HOSTS := $(foreach t,$(DISPLAY_TARGETS),$(BOARD_DIR)/host/show_$(call board_of,$t))

board_host_objects = $(patsubst %.c,$(BOARD_DIR)/host/%.o,tests/boards/board_scenes.c $1) $(LIBRARY)
$(BOARD_HOST): $(call board_host_objects,tests/boards/board_report.c tests/boards/board_print.c tests/boards/board_host.c)
$(foreach t,$(DISPLAY_TARGETS),$(eval $(BOARD_DIR)/host/show_$(call board_of,$t): $(call \
    board_host_objects,tests/boards/display_host.c tests/boards/show_$(board_show_$(call board_of,$t)).c $(ATTITUDE))))

$(BOARD_HOST) $(SHOW_HOSTS):
	$(call run,link $@)$(CC) $(CFLAGS) $(LDFLAGS) $^ -o $@

$(BOARD_DIR)/host/%.o: %.c port/boards/boards.mk
	$(folder)
	$(call run,compile $<)$(CC) $(BOARD_FLAGS) -MMD -MP -c $< -o $@

-include $(shell find $(BOARD_DIR)/host -name '*.d' 2>/dev/null)

# A test runs the attitude filter on the recorded flight.
$(HELPERS): $(call objects,$(ATTITUDE))

# A target whose compiler or emulator is missing is skipped and named.
board_tools   = $(firstword $(call core_cc,$(call core_of,$1))) $(firstword $(board_run_$1))
BOARD_MISSING := $(strip $(foreach tool,$(sort $(foreach t,$(BOARD_TARGETS) $(DISPLAY_TARGETS),$(call board_tools,$t))),\
                 $(if $(shell command -v $(tool) 2>/dev/null),,$(tool))))
BOARD_SKIPPED := $(strip $(foreach t,$(BOARD_TARGETS) $(DISPLAY_TARGETS),\
                 $(if $(filter $(BOARD_MISSING),$(call board_tools,$t)),$t)))
BOARD_RUN     := $(filter-out $(BOARD_SKIPPED),$(BOARD_TARGETS))
DISPLAY_RUN   := $(filter-out $(BOARD_SKIPPED),$(DISPLAY_TARGETS))
BOARD_ELFS    := $(patsubst %,$(BOARD_DIR)/%/firmware.elf,$(BOARD_RUN) $(DISPLAY_RUN))
board_skips    = $(if $(BOARD_SKIPPED),echo "$@: skipped: $(BOARD_SKIPPED): $(BOARD_MISSING) not installed (make setup-all)",:)

# A target's argument to the scripts: <board>:<core>:<display or ->:<emulator>.
board_argument = '$(call board_of,$1):$(call core_of,$1):$(or $(board_panel_$(call board_of,$1)),-):$(board_run_$1)'

.PHONY: boards test-boards screenshot attitude-samples
boards: $(BOARD_ELFS) ## Build the firmware of every emulated board into build/boards
	@$(board_skips)
	@for elf in $(BOARD_ELFS); do cat "$${elf%.elf}.size"; done | awk 'NR == 1 || $$1 != "text"'

test-boards: $(BOARD_ELFS) $(BOARD_HOST) $(SHOW_HOSTS) ## Run the firmware in QEMU and compare its pixels with the host's
	@$(board_skips)
	@SKIPPED=$(words $(BOARD_SKIPPED)) sh tests/test_boards.sh $(BUILD) \
	    $(foreach t,$(BOARD_RUN) $(DISPLAY_RUN),$(call board_argument,$t))

screenshot: $(patsubst %,$(BOARD_DIR)/%/firmware.elf,$(DISPLAY_RUN)) ## Keep what the emulated displays show: build/screenshots; FORMAT=ppm
	@$(board_skips)
	@$(foreach t,$(DISPLAY_RUN),sh tests/boards/run_display.sh '$(board_run_$t)' $(BOARD_DIR)/$t/firmware.elf \
	    $(BUILD)/screenshots/$(call board_of,$t) $(or $(FORMAT),png) >$(BOARD_DIR)/$t/screenshots.log &&) true
	@ls $(BUILD)/screenshots/*/*

attitude-samples: ## Write tests/boards/attitude_samples.c anew: the flight of the attitude scene
	@mkdir -p $(BOARD_DIR)/host
	$(CC) -std=c99 -o $(BOARD_DIR)/host/attitude_generate tests/boards/attitude_generate.c -lm
	$(BOARD_DIR)/host/attitude_generate >$(BOARD_DIR)/host/attitude_samples.c
	mv $(BOARD_DIR)/host/attitude_samples.c tests/boards/attitude_samples.c
