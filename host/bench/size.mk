# Code, constants, static memory and deepest stack of three applications. Included by bench.mk, whose compilers, boards and
# emulators these rules use.

SIZE_DIR      := $(BENCH_DIR)/size
SIZE_APPS     := textured flat bands
SIZE_VARIANTS := $(foreach core,$(filter cortex-m0plus cortex-m3 cortex-m4,$(BENCH_PRESENT)),$(core)-Os $(core)-O2)
SIZE_SOURCES  := $(wildcard core/*/*.c) host/bench/size_board.c port/boards/common/memory.c
SIZE_FLAGS    := -std=c99 -ffreestanding -ffunction-sections -fdata-sections -Icore/include -fstack-usage -fcallgraph-info=su

# $1: core-optimization; $2: core; $3: optimization; $4: the start-up code's board.
define size_rules
$(SIZE_DIR)/$1/%.elf: $(addprefix $(SIZE_DIR)/$1/,$(SIZE_SOURCES:.c=.o) $(patsubst %.c,%.o,$(wildcard port/boards/$4/*.c))) \
                      $(SIZE_DIR)/$1/host/bench/app_%.o port/boards/$4/$4.ld
	@$(call bench_cc,$2) $(BENCH_FPU_$2) $(BENCH_LINK) -Wl,-Map=$$(@:.elf=.map) -T port/boards/$4/$4.ld -o $$@ \
	    $$(filter %.o,$$^) -lgcc

$(SIZE_DIR)/$1/port/boards/common/memory.o: private SIZE_EXTRA := -fno-tree-loop-distribute-patterns

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

.PHONY: size size-lines
size: ## Bytes of code, constants, static RAM and stack of three applications, all RAM of one in bands: build/size.tsv
	@$(MAKE) -s $(PARALLEL) size-lines
	@sh host/bench/size.sh $(SIZE_DIR) $(BUILD)/size.tsv "$(SIZE_APPS)" $(SIZE_VARIANTS)

size-lines: $(foreach variant,$(SIZE_VARIANTS),$(SIZE_APPS:%=$(SIZE_DIR)/$(variant)/%.txt))

SIZE_VARIANT ?= cortex-m0plus-Os
SIZE_APP     ?= textured

.PHONY: size-functions
size-functions: $(if $(SIZE_VARIANTS),$(SIZE_DIR)/$(SIZE_VARIANT)/$(SIZE_APP).elf) ## Files, functions and call chains behind `make size`; SIZE_VARIANT=cortex-m3-O2 SIZE_APP=flat
	@$(if $(SIZE_VARIANTS),sh host/bench/size_functions.sh $(SIZE_DIR)/$(SIZE_VARIANT) $(SIZE_APP),\
	    echo "size-functions: skipped: no compiler or emulator (make setup)")

# Budgets: what `make check-budgets` compares with.

.PHONY: budgets
budgets: ## Write host/bench/budgets.tsv anew: the figures of bench and size that `make check` holds on to
	@$(MAKE) -s bench size BENCH_SCENES=
	@sh host/bench/budgets.sh $(BUILD) >$(BENCH_DIR)/budgets.tsv
	@mv $(BENCH_DIR)/budgets.tsv host/bench/budgets.tsv
	@echo "budgets: host/bench/budgets.tsv has $$(grep -vc '^#' host/bench/budgets.tsv) lines"
