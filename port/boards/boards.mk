# Emulated boards: firmware, and the check that a board draws the host's pixels.
#
# Included by the main Makefile, which provides BUILD and CC. To add a board: a folder beside this
# file and, for each core that it is built for, a word in BOARD_TARGETS and a board_machine_ line.

BUILD    ?= build
BOARD_CC ?= arm-none-eabi-gcc
QEMU_ARM ?= qemu-system-arm

BOARD_DIR := $(BUILD)/boards

# <board>_<core>: how it is compiled, and which QEMU machine runs it. The M0+ has no machine of its
# own with enough memory; Armv6-M is a subset of what the M3 executes.
BOARD_TARGETS := mps2_cortex-m0plus mps2_cortex-m3 mps2_cortex-m4 mps2_cortex-m7

board_machine_mps2_cortex-m0plus := mps2-an385
board_machine_mps2_cortex-m3     := mps2-an385
board_machine_mps2_cortex-m4     := mps2-an386
board_machine_mps2_cortex-m7     := mps2-an500

# -mno-unaligned-access: the start-up code makes unaligned access a fault, as on an M0+.
BOARD_WARNINGS := -Wall -Wextra -Wconversion -Wshadow -Wpedantic
BOARD_FLAGS    := -std=c99 -O2 -g -ffreestanding -ffunction-sections -fdata-sections \
                  -mthumb -mno-unaligned-access $(BOARD_WARNINGS)
BOARD_INCLUDES := -Icore/include
BOARD_LINK     := -nostdlib -Wl,--gc-sections -Wl,--fatal-warnings

BOARD_SOURCES := $(wildcard core/*/*.c) tests/boards/board_scenes.c tests/boards/board_report.c
BOARD_HOST    := $(BOARD_DIR)/host/board_host
BOARD_ELFS    := $(BOARD_TARGETS:%=$(BOARD_DIR)/%/firmware.elf)

# One firmware. $1: <board>_<core>, $2: board, $3: core.
define board_rules
$1_objects := $$(patsubst %.c,$(BOARD_DIR)/$1/%.o,$(BOARD_SOURCES) \
              $$(wildcard port/boards/common/*.c port/boards/$2/*.c))

$(BOARD_DIR)/$1/firmware.elf: $$($1_objects) port/boards/$2/$2.ld
	@echo "link $$@"
	@$(BOARD_CC) -mcpu=$3 -mthumb $(BOARD_LINK) -Wl,-Map=$$(@:.elf=.map) -T port/boards/$2/$2.ld \
	    $$($1_objects) -lgcc -o $$@

$(BOARD_DIR)/$1/port/boards/common/memory.o: BOARD_EXTRA := -fno-tree-loop-distribute-patterns

$(BOARD_DIR)/$1/%.o: %.c port/boards/boards.mk
	@mkdir -p $$(@D)
	$(BOARD_CC) -mcpu=$3 $(BOARD_FLAGS) $$(BOARD_EXTRA) $(BOARD_INCLUDES) -MMD -MP -c $$< -o $$@

-include $$($1_objects:.o=.d)
endef
$(foreach t,$(BOARD_TARGETS),$(eval $(call \
    board_rules,$t,$(firstword $(subst _, ,$t)),$(lastword $(subst _, ,$t)))))

BOARD_HOST_OBJECTS := $(patsubst %.c,$(BOARD_DIR)/host/%.o,$(BOARD_SOURCES) tests/boards/board_host.c)

$(BOARD_HOST): $(BOARD_HOST_OBJECTS)
	@echo "link $@"
	@$(CC) $^ -o $@

$(BOARD_DIR)/host/%.o: %.c port/boards/boards.mk
	@mkdir -p $(@D)
	$(CC) -std=c99 -O2 -g $(BOARD_WARNINGS) $(BOARD_INCLUDES) -MMD -MP -c $< -o $@

-include $(BOARD_HOST_OBJECTS:.o=.d)

BOARD_MISSING := $(foreach tool,$(BOARD_CC) $(QEMU_ARM),\
                 $(if $(shell command -v $(tool) 2>/dev/null),,$(tool)))

.PHONY: boards test-boards
ifneq ($(strip $(BOARD_MISSING)),)
boards test-boards:
	@echo "$@: skipped: $(strip $(BOARD_MISSING)) not installed (make setup)"
test-boards: skipped-boards
.PHONY: skipped-boards
skipped-boards:
	@mkdir -p build/results && echo "0 0 $(words $(BOARD_TARGETS))" >build/results/boards
else
boards: $(BOARD_ELFS) ## Build the firmware of every emulated board into build/boards
	@$(BOARD_CC:gcc=size) $(BOARD_ELFS)

test-boards: $(BOARD_ELFS) $(BOARD_HOST) ## Run the firmware in QEMU and compare its pixels with the host's
	@QEMU=$(QEMU_ARM) tests/test_boards.sh $(BOARD_HOST) $(BUILD)/boards.tsv \
	    $(foreach t,$(BOARD_TARGETS),$t:$(board_machine_$t):$(BOARD_DIR)/$t/firmware.elf)
endif
