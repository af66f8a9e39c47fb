# SPDX-License-Identifier: MIT
# The matrix: instructions of every product of formats, tests, sources and geometries (matrix.h), and whether all cores draw
# the host's pixels. Included by bench.mk; compilers, objects and emulators are those of scenes.mk.
#
#   make bench-matrix BENCH_CORES=cortex-m3 MATRIX_CASES="*/turned rgb565/less/replace/*"     some of it
#   make bench-matrix MATRIX_PRODUCT=full                                                     the whole product
#
# MATRIX_CASES picks from the product: names as build/matrix.tsv has them, `*` for any text.

MATRIX_CASES   ?=
MATRIX_PRODUCT ?= named

# Without cores on the command line, two of them at -O2.
MATRIX_CORES   := $(if $(filter command,$(origin BENCH_CORES)),$(SCENE_CORES),$(filter cortex-m0plus cortex-m3,$(SCENE_CORES)))
MATRIX_PRESENT := $(call bench_present,$(MATRIX_CORES))
MATRIX_ABSENT  := $(filter-out $(MATRIX_PRESENT),$(MATRIX_CORES))

MATRIX_SOURCES := $(addprefix host/bench/,matrix_cases.c matrix_draw.c matrix_program.c \
                  matrix_flat.c matrix_lit.c matrix_colors.c matrix_texture.c matrix_texture_lit.c matrix_texture_colors.c) $(SCENE_WORLD)
MATRIX_DEFINES  = -DMATRIX_CASES='"$(MATRIX_CASES)"' -DMATRIX_FULL=$(if $(filter full,$(MATRIX_PRODUCT)),1,0)
MATRIX_SECONDS := 1500 # after which a program is taken for hung

# What was asked for last; rewritten when it changes, so that the programs are built for it.
MATRIX_ASKED := $(BENCH_DIR)/matrix-asked
$(MATRIX_ASKED): FORCE
	@mkdir -p $(@D)
	@echo "$(MATRIX_PRODUCT): $(MATRIX_CASES)" | cmp -s - $@ || echo "$(MATRIX_PRODUCT): $(MATRIX_CASES)" >$@

# One program for each core. $1: core, $2: its board, $3: its objects.
define matrix_rules
$(SCENE_DIR)/$1/host/bench/matrix_program.o: private SCENE_EXTRA = $$(MATRIX_DEFINES)
$(SCENE_DIR)/$1/host/bench/matrix_program.o: $(MATRIX_ASKED) host/bench/matrix.mk

$(SCENE_DIR)/$1/matrix.elf: $3 port/boards/$2/$2.ld
	$$(call run,link $$@)$(call scene_link,$1) -T port/boards/$2/$2.ld -o $$@ $3 -lgcc

$(SCENE_DIR)/$1/matrix.txt: $(SCENE_DIR)/$1/matrix.elf
	@$$(call scene_run,$1,$$<,$(MATRIX_SECONDS))

-include $$(wildcard $(SCENE_DIR)/$1/host/bench/matrix*.d)
endef
$(foreach core,$(MATRIX_CORES),$(eval $(call matrix_rules,$(core),$(call scene_board,$(core)),$(call \
    scene_objects,$(core),$(MATRIX_SOURCES)))))

MATRIX_HOST := $(BENCH_DIR)/matrix_host
$(MATRIX_HOST): $(call objects,host/bench/matrix_host.c host/bench/bench_host_board.c $(filter host/bench/%,$(MATRIX_SOURCES))) \
                $(BUILD)/obj/bench_meshes.o $(LIBRARY)
	@mkdir -p $(@D)
	$(call run,link $@)$(CC) $(CFLAGS) $(LDFLAGS) -o $@ $^

$(BUILD)/obj/host/bench/matrix_program.o: private INCLUDES += $(MATRIX_DEFINES)
$(BUILD)/obj/host/bench/matrix_program.o: $(MATRIX_ASKED)

$(SCENE_DIR)/matrix-host.txt: $(MATRIX_HOST)
	@$(MATRIX_HOST) >$@.part && mv $@.part $@

.PHONY: bench-matrix matrix-lines matrix-budgets
bench-matrix: ## Count every combination of format, test, source and geometry: build/matrix.tsv; MATRIX_CASES="*/turned"
	@$(ALIVE) bench-matrix $(MAKE) -s $(PARALLEL) matrix-lines
	@$(call bench_skip,bench-matrix,$(MATRIX_ABSENT))
	@sh host/bench/matrix.sh $(SCENE_DIR) $(BUILD)/matrix.tsv $(MATRIX_PRESENT)

matrix-lines: $(SCENE_DIR)/matrix-host.txt $(MATRIX_PRESENT:%=$(SCENE_DIR)/%/matrix.txt)

matrix-budgets: ## Write host/bench/matrix-budgets.tsv anew: what `make check-matrix` compares with
	@$(MAKE) -s bench-matrix MATRIX_CASES= MATRIX_PRODUCT=named
	@sh host/bench/budgets.sh matrix-budgets $(BUILD) >$(BENCH_DIR)/matrix-budgets.tsv
	@mv $(BENCH_DIR)/matrix-budgets.tsv host/bench/matrix-budgets.tsv
	@echo "matrix-budgets: host/bench/matrix-budgets.tsv has $$(grep -vc '^#' host/bench/matrix-budgets.tsv) lines"
