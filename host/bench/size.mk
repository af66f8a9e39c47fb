# SPDX-License-Identifier: MIT
# Code, constants, static memory and deepest stack of four applications. Included by bench.mk, whose compilers, boards and
# emulators these rules use.

SIZE_DIR      := $(BENCH_DIR)/size
SIZE_APPS     := textured flat bands default
SIZE_ABSENT   := $(filter cortex-m0plus cortex-m3 cortex-m4,$(BENCH_ABSENT))
SIZE_SOURCES  := host/bench/size_board.c host/bench/bench_print.c
SIZE_FLAGS    := $(SCENE_FLAGS)

# Applications once more, with the library in one file (`make dist`): a row `flat-single` for `flat`, at -Os.
SIZE_SINGLE_VARIANTS := $(filter cortex-m0plus-Os cortex-m3-Os,$(SIZE_VARIANTS))
SIZE_SINGLE          := $(SIZE_DIR)/dist/single/qtri.c

$(SIZE_SINGLE): $(wildcard core/*/*.[ch] core/*/*.inc core/include/*.h core/include/qtri/*.h core/include/qtri/body/*.h port/panels/*.[ch] port/include/qtri_port/*.h \
                port/packages/dist.sh port/packages/amalgamate.awk)
	@sh port/packages/dist.sh $(SIZE_DIR)/dist >/dev/null

$(SIZE_DIR)/%/qtri.o: $(SIZE_SINGLE) host/bench/bench.mk host/bench/size.mk
	$(folder)
	@$(call scene_compile,$*,core/qtri.c) -c -o $@ $<

# What the compiler calls, compiled as the library is.
$(SIZE_DIR)/%/port/boards/common/memory.o: port/boards/common/memory.c host/bench/bench.mk host/bench/size.mk
	$(folder)
	@$(call scene_compile,$*,core/memory.c) -fno-tree-loop-distribute-patterns -c -o $@ $<

# Other objects are those of the benchmarks. $1: the folder of the programs; $2: the core as the benchmarks name it; $3: the library.
define size_rules
$(SIZE_DIR)/$1/%.elf: $3 $(filter-out %/memory.o,$(call scene_objects,$2,$(SIZE_SOURCES))) $(SIZE_DIR)/$2/port/boards/common/memory.o \
                      $(SCENE_DIR)/$2/host/bench/app_%.o
	$$(folder)
	@$(call scene_link,$2) -Wl,-Map=$$(@:.elf=.map) -T port/boards/$(call scene_board,$2)/$(call scene_board,$2).ld -o $$@ $$^ -lgcc

$(SIZE_DIR)/$1/%.txt: $(SIZE_DIR)/$1/%.elf
	@timeout 300 $(call bench_emulator,$2) -display none -monitor none -serial stdio -kernel $$< </dev/null >$$@.part
	@grep -q '^pixels' $$@.part && mv $$@.part $$@
endef
$(foreach variant,$(SIZE_VARIANTS),$(eval $(call size_rules,$(variant),$(variant:%-O2=%),$(addprefix \
    $(SCENE_DIR)/$(variant:%-O2=%)/,$(patsubst %.c,%.o,$(wildcard core/*/*.c))))))
$(foreach variant,$(SIZE_SINGLE_VARIANTS),$(eval $(call size_rules,$(variant)-single,$(variant),$(SIZE_DIR)/$(variant)/qtri.o)))

.PHONY: size size-lines
size: ## Bytes of code, constants, static RAM and stack of four applications, all RAM of one in bands: build/size.tsv
	@$(call bench_skip,size,$(SIZE_ABSENT))
	@$(ALIVE) size $(MAKE) -s $(PARALLEL) size-lines
	@sh host/bench/size.sh $(SIZE_DIR) $(SCENE_DIR) $(BUILD)/size.tsv "$(SIZE_APPS:%=%-single) $(SIZE_APPS)" $(SIZE_VARIANTS)

size-lines: $(foreach variant,$(SIZE_VARIANTS),$(SIZE_APPS:%=$(SIZE_DIR)/$(variant)/%.txt)) \
            $(foreach variant,$(SIZE_SINGLE_VARIANTS),$(SIZE_APPS:%=$(SIZE_DIR)/$(variant)-single/%.txt))

SIZE_VARIANT ?= cortex-m0plus-Os
SIZE_APP     ?= textured
size_folder   = $(SIZE_DIR)/$(SIZE_VARIANT)

.PHONY: size-functions
size-functions: $(if $(SIZE_VARIANTS),$(size_folder)/$(SIZE_APP).elf) ## Files, functions and call chains behind `make size`; SIZE_VARIANT=cortex-m3-O2 SIZE_APP=flat
	@$(call bench_skip,size-functions,$(SIZE_ABSENT))
	@$(if $(SIZE_VARIANTS),sh host/bench/size_functions.sh $(size_folder) $(SCENE_DIR)/$(SIZE_VARIANT:%-O2=%) $(SIZE_APP),:)

.PHONY: size-options
size-options: ## Bytes that each option of qtri/config.h saves alone, on a Cortex-M0+ at -Os
ifeq ($(filter arm-none-eabi-gcc,$(BENCH_TOOLS)),)
	@echo "size-options: skipped: arm-none-eabi-gcc not installed (make setup-all)"
else
	@rm -rf $(SIZE_DIR)/options; mkdir -p $(SIZE_DIR)/options
	@sh host/bench/size_options.sh $(SIZE_DIR)/options "$(SIZE_APPS)" $(call bench_cc,cortex-m0plus) -Os $(filter-out -fstack% -fcallgraph%,$(SIZE_FLAGS)) \
	    -fno-tree-loop-distribute-patterns
endif

# Budgets: what `make check-budgets` compares with.

.PHONY: budgets
budgets: ## Write host/bench/budgets.tsv anew: the figures of bench and size that `make check` holds on to
	@$(MAKE) -s bench size BENCH_SCENES=
	@sh host/bench/budgets.sh budgets $(BUILD) >$(BENCH_DIR)/budgets.tsv
	@mv $(BENCH_DIR)/budgets.tsv host/bench/budgets.tsv
	@echo "budgets: host/bench/budgets.tsv has $$(grep -vc '^#' host/bench/budgets.tsv) lines"
