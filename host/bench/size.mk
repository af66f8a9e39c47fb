# SPDX-License-Identifier: MIT
# Code, constants, static memory and deepest stack of four applications. Included by bench.mk, whose compilers, boards and
# emulators these rules use.

SIZE_DIR      := $(BENCH_DIR)/size
SIZE_APPS     := textured flat bands default
SIZE_VARIANTS := $(foreach core,$(filter cortex-m0plus cortex-m3 cortex-m4,$(BENCH_PRESENT)),$(core)-Os $(core)-O2)
SIZE_ABSENT   := $(filter cortex-m0plus cortex-m3 cortex-m4,$(BENCH_ABSENT))
SIZE_LIBRARY  := $(wildcard core/*/*.c)
SIZE_SOURCES  := host/bench/size_board.c host/bench/bench_print.c port/boards/common/memory.c
SIZE_FLAGS    := -std=c99 -ffreestanding -ffunction-sections -fdata-sections -Icore/include -fstack-usage -fcallgraph-info=su

# Applications once more, with the library in one file (`make dist`): a row `flat-single` for `flat`, at -Os.
SIZE_SINGLE_VARIANTS := $(filter cortex-m0plus-Os cortex-m3-Os,$(SIZE_VARIANTS))
SIZE_SINGLE          := $(SIZE_DIR)/dist/single/qtri.c

$(SIZE_SINGLE): $(wildcard core/*/*.[ch] core/*/*.inc core/include/*.h core/include/qtri/*.h port/panels/*.[ch] port/include/qtri_port/*.h \
                port/packages/dist.sh port/packages/amalgamate.awk)
	@sh port/packages/dist.sh $(SIZE_DIR)/dist >/dev/null

# $1: core-optimization-single; $2: core; $3: optimization.
define size_single
$(SIZE_DIR)/$1/single/qtri.o: $(SIZE_SINGLE) host/bench/bench.mk host/bench/size.mk
	@mkdir -p $$(@D)
	@$(call bench_cc,$2) $(BENCH_FPU_$2) $3 $(SIZE_FLAGS) -c -o $$@ $$<
endef

# The library's objects are those of the benchmarks where these are built, which takes a minute less. $1: core-optimization;
# $2: the benchmarks' name for it.
define size_shared
$(SIZE_DIR)/$1/core/%.o: $(SCENE_DIR)/$2/core/%.o
	@mkdir -p $$(@D)
	@cp -p $$< $$(<:.o=.su) $$(<:.o=.ci) $$(@D)/
endef

# The library's objects. $1: core-optimization.
size_library = $(addprefix $(SIZE_DIR)/$1/,$(if $(filter %-single,$1),single/qtri.o,$(SIZE_LIBRARY:.c=.o)))

# $1: core-optimization; $2: core; $3: optimization; $4: the start-up code's board.
define size_rules
$(SIZE_DIR)/$1/%.elf: $(call size_library,$1) $(addprefix $(SIZE_DIR)/$1/,$(SIZE_SOURCES:.c=.o) $(patsubst %.c,%.o,$(wildcard port/boards/$4/*.c))) \
                      $(SIZE_DIR)/$1/host/bench/app_%.o port/boards/$4/$4.ld
	@$(call bench_cc,$2) $(BENCH_FPU_$2) $(BENCH_LINK) -Wl,-Map=$$(@:.elf=.map) -T port/boards/$4/$4.ld -o $$@ \
	    $$(filter %.o,$$^) -lgcc

$(SIZE_DIR)/$1/port/boards/common/memory.o: private SIZE_EXTRA := -fno-tree-loop-distribute-patterns

$(if $(filter $(1:%-O2=%),$(SCENE_CORES)),$(call size_shared,$1,$(1:%-O2=%)))
$(SIZE_DIR)/$1/%.o: %.c host/bench/bench.mk host/bench/size.mk
	@mkdir -p $$(@D)
	@$(call bench_cc,$2) $(BENCH_FPU_$2) $3 $(SIZE_FLAGS) $$(SIZE_EXTRA) -MMD -MP -c -o $$@ $$<

$(SIZE_DIR)/$1/%.txt: $(SIZE_DIR)/$1/%.elf
	@timeout 300 $(call bench_emulator,$2) -display none -monitor none -serial stdio -kernel $$< </dev/null >$$@.part
	@grep -q '^pixels' $$@.part && mv $$@.part $$@

-include $$(shell find $(SIZE_DIR)/$1 -name '*.d' 2>/dev/null)
endef
size_core     = $(patsubst %-O$(lastword $(subst -O, ,$1)),%,$1)
size_optimize = -O$(lastword $(subst -O, ,$1))
$(foreach variant,$(SIZE_VARIANTS),$(eval $(call size_rules,$(variant),$(call size_core,$(variant)),$(call \
    size_optimize,$(variant)),$(notdir $(call bench_board,$(call size_core,$(variant)))))))
$(foreach variant,$(SIZE_SINGLE_VARIANTS),$(eval $(call size_single,$(variant)-single,$(call size_core,$(variant)),$(call size_optimize,$(variant)))))
$(foreach variant,$(SIZE_SINGLE_VARIANTS),$(eval $(call size_rules,$(variant)-single,$(call size_core,$(variant)),$(call \
    size_optimize,$(variant)),$(notdir $(call bench_board,$(call size_core,$(variant)))))))

.PHONY: size size-lines
size: ## Bytes of code, constants, static RAM and stack of four applications, all RAM of one in bands: build/size.tsv
	@$(call bench_skip,size,$(SIZE_ABSENT))
	@$(ALIVE) size $(MAKE) -s $(PARALLEL) size-lines
	@sh host/bench/size.sh $(SIZE_DIR) $(BUILD)/size.tsv "$(SIZE_APPS:%=%-single) $(SIZE_APPS)" $(SIZE_VARIANTS)

size-lines: $(foreach variant,$(SIZE_VARIANTS),$(SIZE_APPS:%=$(SIZE_DIR)/$(variant)/%.txt)) \
            $(foreach variant,$(SIZE_SINGLE_VARIANTS),$(SIZE_APPS:%=$(SIZE_DIR)/$(variant)-single/%.txt))

SIZE_VARIANT ?= cortex-m0plus-Os
SIZE_APP     ?= textured
size_folder   = $(SIZE_DIR)/$(SIZE_VARIANT)

.PHONY: size-functions
size-functions: $(if $(SIZE_VARIANTS),$(size_folder)/$(SIZE_APP).elf) ## Files, functions and call chains behind `make size`; SIZE_VARIANT=cortex-m3-O2 SIZE_APP=flat
	@$(call bench_skip,size-functions,$(SIZE_ABSENT))
	@$(if $(SIZE_VARIANTS),sh host/bench/size_functions.sh $(size_folder) $(SIZE_APP),:)

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
