# SPDX-License-Identifier: MIT
# The examples: programs of this computer, which write pictures, and firmware of the emulated boards. Included by the
# main Makefile, behind boards.mk, whose objects the firmware is linked of.

EXAMPLES := mesh gauge wireframe attitude terrain map shaders
# What each is for, and the board that has such a display: no emulated board has e-paper, the map is shown on the LCD
# there, and on the simulated controller of e-paper here.
example_display_mesh      := lcd
example_display_gauge     := lcd
example_display_terrain   := lcd
example_display_map       := lcd
example_display_shaders   := lcd
example_display_wireframe := oled
example_display_attitude  := oled
example_target_lcd  := versatilepb_arm926ej-s
example_target_oled := lm3s6965evb_cortex-m3
example_target       = $(example_target_$(example_display_$1))
example_sources      = $(wildcard port/examples/$1/*.c)

# A model for the example `mesh`: make examples MODEL=duck.glb [SKIN=duck.png] [MODEL_OPTIONS="--simplify 2000"]
MODEL         ?=
SKIN          ?=
MODEL_OPTIONS ?=
MODEL_ASKED    = $(MODEL) $(if $(SKIN),--texture $(SKIN)) $(MODEL_OPTIONS)

EXAMPLE_DIR := $(BUILD)/examples
EXAMPLE_RUN := $(foreach e,$(EXAMPLES),$(if $(filter $(call example_target,$e),$(DISPLAY_RUN)),$e))

define example_rules
$(EXAMPLE_DIR)/$1/host: $(call objects,$(call example_sources,$1) port/examples/host.c port/examples/display.c) $(HOST) $(LIBRARY)
	@mkdir -p $$(@D)
	$$(call run,link $$@)$$(CC) $$(CFLAGS) $$(LDFLAGS) -o $$@ $$^ -lm

$(EXAMPLE_DIR)/$1/firmware.elf: $(filter-out $(BOARD_DIR)/$2/tests/%,$($2_objects)) \
        $(patsubst %.c,$(BOARD_DIR)/$2/%.o,$(call example_sources,$1) port/examples/board.c) $($2_library)
	@mkdir -p $$(@D)
	$$(call run,link $$@)$(call core_cc,$(call core_of,$2)) $(BOARD_LINK) -T port/boards/$(call board_of,$2)/$(call board_of,$2).ld $$^ -lgcc -o $$@
endef
$(foreach e,$(EXAMPLES),$(eval $(call example_rules,$e,$(call example_target,$e))))

$(BUILD)/obj/port/examples/%.o: INCLUDES += -Ihost

mesh_host   := $(BUILD)/obj/port/examples/mesh/mesh.o
mesh_boards := $(patsubst %,$(BOARD_DIR)/%/port/examples/mesh/mesh.o,$(example_target_lcd) $(RP2040_TARGET))

# Eight frames are drawn: once all the way round.
ifneq ($(MODEL),)
MODEL_FLAGS := -DQTRI_EXAMPLE_MODEL -DQTRI_EXAMPLE_STEP=45 -I$(EXAMPLE_DIR)/mesh
$(mesh_host) $(mesh_boards): $(EXAMPLE_DIR)/mesh/model.h
$(mesh_host): INCLUDES += $(MODEL_FLAGS)
$(mesh_boards): private BOARD_EXTRA := $(MODEL_FLAGS)

$(EXAMPLE_DIR)/mesh/model.h: $(BUILD)/qtri $(wildcard $(MODEL) $(SKIN)) $(EXAMPLE_DIR)/mesh/asked
	$(BUILD)/qtri model $(MODEL_ASKED) -o $@
endif

# What the example's objects were made with.
$(mesh_host) $(mesh_boards): $(EXAMPLE_DIR)/mesh/asked
$(EXAMPLE_DIR)/mesh/asked: FORCE
	@mkdir -p $(@D)
	@echo '$(MODEL_ASKED)' | cmp -s - $@ || echo '$(MODEL_ASKED)' >$@

.PHONY: examples test-examples
examples: $(EXAMPLES:%=$(EXAMPLE_DIR)/%/host) ## Draw the frames of the examples into build/examples/NAME/frames
	@$(foreach e,$(EXAMPLES),mkdir -p $(EXAMPLE_DIR)/$e/frames && \
	    $(EXAMPLE_DIR)/$e/host $(example_display_$e) $(EXAMPLE_DIR)/$e/frames >$(EXAMPLE_DIR)/$e/frames.txt &&) true
	@mkdir -p $(EXAMPLE_DIR)/map/paper && $(EXAMPLE_DIR)/map/host paper $(EXAMPLE_DIR)/map/paper >$(EXAMPLE_DIR)/map/paper.txt
	@ls -d $(EXAMPLES:%=$(EXAMPLE_DIR)/%/frames) $(EXAMPLE_DIR)/map/paper

test-examples: examples $(EXAMPLE_RUN:%=$(EXAMPLE_DIR)/%/firmware.elf) ## Run the examples on emulated boards, whose displays must show the host's pixels
	@$(board_skips)
	@sh tests/test_examples.sh $(EXAMPLE_DIR) \
	    $(foreach e,$(EXAMPLE_RUN),'$e:$(example_display_$e):$(board_run_$(call example_target,$e))')

# The examples for an LCD on an RP2040, whose ILI9341 is a simulated controller of host/panels. rp2040js is slow, and so
# three frames are drawn in place of eight.
RP2040_EXAMPLES := $(foreach e,$(EXAMPLES),$(if $(filter lcd,$(example_display_$e)),$e))
RP2040_FRAMES   ?= 3
RP2040_DIR      := $(EXAMPLE_DIR)/rp2040

define rp2040_rules
$(RP2040_DIR)/$1/firmware.elf: $(filter-out $(BOARD_DIR)/$(RP2040_TARGET)/tests/%,$($(RP2040_TARGET)_objects)) \
        $(patsubst %.c,$(BOARD_DIR)/$(RP2040_TARGET)/%.o,$(call example_sources,$1) port/examples/board.c) $($(RP2040_TARGET)_library) port/boards/rp2040/rp2040.ld
	@mkdir -p $$(@D)
	$$(call run,link $$@)$(call core_cc,$(call core_of,$(RP2040_TARGET))) $(BOARD_LINK) -T $$(filter %.ld,$$^) $$(filter-out %.ld,$$^) -lgcc -o $$@
endef
$(foreach e,$(RP2040_EXAMPLES),$(eval $(call rp2040_rules,$e)))

$(RP2040_DIR)/display: $(call objects,tests/boards/rp2040_display.c) $(HOST)
	@mkdir -p $(@D)
	$(call run,link $@)$(CC) $(CFLAGS) $(LDFLAGS) -o $@ $^

.PHONY: test-rp2040 rp2040
rp2040: $(RP2040_EXAMPLES:%=$(RP2040_DIR)/%/firmware.elf)

# The version that setup.sh installs.
RP2040JS ?= build/npm/node_modules/rp2040js

ifneq ($(and $(wildcard $(RP2040JS)/package.json),$(shell command -v node),$(shell command -v $(firstword $(core_cc_cortex)))),)
test-rp2040: rp2040 $(RP2040_EXAMPLES:%=$(EXAMPLE_DIR)/%/host) $(RP2040_DIR)/display ## Run the examples on an emulated RP2040, whose ILI9341 must show the host's pixels, and print cycles
	@sh tests/test_rp2040.sh $(EXAMPLE_DIR) $(RP2040JS) $(RP2040_FRAMES) $(RP2040_EXAMPLES)
else
test-rp2040:
	@echo '$@: skipped: node, rp2040js or $(firstword $(core_cc_cortex)) not installed (make setup-all)'
	@mkdir -p build/results && echo 0 0 1 >build/results/rp2040
endif
