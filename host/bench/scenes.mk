# SPDX-License-Identifier: MIT
# The benchmark scenes: instructions on emulated cores, time on the host. Included by bench.mk, whose
# compilers, boards and emulators these rules use.
#
#   make bench BENCH_CORES="cortex-m3 cortex-m3-Os" BENCH_SCENES="S1 S3"     some of it, in seconds

BENCH_SCENES ?=
PROFILE_CORE ?= cortex-m3

# Every core twice, with the library at -O2 and at -Os; or those that the command line names.
SCENE_CORES   := $(if $(filter command,$(origin BENCH_CORES)),$(BENCH_CORES),$(BENCH_CORES) $(BENCH_CORES:%=%-Os))
SCENE_PRESENT := $(call bench_present,$(SCENE_CORES))
SCENE_ABSENT  := $(filter-out $(SCENE_PRESENT),$(SCENE_CORES))

# What `make size` measures: cores and how the library is compiled for them.
SIZE_VARIANTS := $(foreach core,$(filter cortex-m0plus cortex-m3 cortex-m4,$(BENCH_PRESENT)),$(core)-Os $(core)-O2)

# The M4 is an M4F: with a hard-float ABI, though nothing here computes in floating point.
BENCH_FPU_cortex-m4 := -mfpu=fpv4-sp-d16 -mfloat-abi=hard

# A profile needs to know of each instruction which line it comes from, which takes the compiler an eighth of its time.
SCENE_PROFILE := $(filter bench-profile profile-programs,$(MAKECMDGOALS))
SCENE_DIR     := $(BENCH_DIR)/$(if $(SCENE_PROFILE),profile,scenes)
SCENE_MODELS  := $(wildcard $(MODELS:%=%/spot.obj) $(MODELS:%=%/teapot.obj))
SCENE_WORLD   := $(wildcard core/*/*.c) $(addprefix host/bench/,bench_world.c bench_print.c) $(SCENE_DIR)/bench_meshes.c
SCENE_SOURCES := $(addprefix host/bench/,bench_scenes.c bench_smooth.c bench_paint.c bench_strokes.c bench_program.c) $(SCENE_WORLD)
# What -fstack-usage and -fcallgraph-info write, `make size` reads; they change no code.
SCENE_FLAGS   := -std=c99 $(if $(SCENE_PROFILE),-g -fno-var-tracking) -fstack-usage -fcallgraph-info=su -ffreestanding -ffunction-sections -fdata-sections -Icore/include -Ihost/bench -idirafter port/boards/common/libc

# The compiler and the flags of one object of a core. $1: core, $2: source.
scene_compile = $(call bench_cc,$1) $(BENCH_FPU_$(bench_core)) $(if $(filter core/% host/bench/app_%,$2),$(bench_optimize),-O2) $(SCENE_FLAGS)
scene_link    = $(call bench_cc,$1) $(BENCH_FPU_$(bench_core)) $(BENCH_LINK)

# The meshes, as C for all and as OBJ for the reference. Written anew when the models come or go.
SCENE_TOOL := $(SCENE_DIR)/bench_meshes
$(SCENE_TOOL): $(call objects,host/bench/bench_meshes.c host/bench/mesh_write.c) $(HOST) $(LIBRARY)
	$(folder)
	$(call run,link $@)$(CC) $(CFLAGS) $(LDFLAGS) -o $@ $^ -lm $(HOST_LIBS)

$(SCENE_DIR)/bench_meshes.c: $(SCENE_TOOL) $(SCENE_MODELS) $(SCENE_DIR)/models
	$(SCENE_TOOL) $(@D) $(or $(MODELS),none)

$(SCENE_DIR)/models: FORCE
	$(folder)
	@echo '$(SCENE_MODELS)' | cmp -s - $@ || echo '$(SCENE_MODELS)' >$@

# What a program prints on a core is its .txt; the last line is `end`. $1: core, $2: program, $3: seconds.
scene_run = timeout $3 $(call bench_emulator,$1) -display none -monitor none -serial stdio -kernel $2 </dev/null >$(2:.elf=.part) && \
            grep -q '^end$$' $(2:.elf=.part) && mv $(2:.elf=.part) $(2:.elf=.txt)

# The library and a program for each core. $1: core, $2: its board, $3: its objects. Boards and gates use this library, too.
# A compiler's cache would keep objects without their stacks and calls.
define scene_rules
$(SCENE_DIR)/$1/libqtri.a: $(filter $(SCENE_DIR)/$1/core/%,$3)
	@rm -f $$@ && $(patsubst %gcc,%ar,$(firstword $(call bench_cc,$1))) rc $$@ $$^

$(SCENE_DIR)/$1/bench.elf: $3 port/boards/$2/$2.ld
	$$(call run,link $$@)$(call scene_link,$1) -Wl,-Map=$$(@:.elf=.map) -T port/boards/$2/$2.ld -o $$@ $3 -lgcc

$(SCENE_DIR)/$1/port/boards/common/memory.o: private SCENE_EXTRA := -fno-tree-loop-distribute-patterns

$(SCENE_DIR)/$1/%.o: %.c host/bench/bench.mk host/bench/scenes.mk
	$$(folder)
	@CCACHE_DISABLE=1 $$(call scene_compile,$1,$$<) $$(SCENE_EXTRA) -MMD -MP -c -o $$@ $$<

$(SCENE_DIR)/$1/%.o: %.S
	$$(folder)
	@$(call bench_cc,$1) -c -o $$@ $$<

$(SCENE_DIR)/$1/bench.txt: $(SCENE_DIR)/$1/bench.elf
	@$$(call scene_run,$1,$$<,300)

-include $$(wildcard $(3:.o=.d))
endef
scene_board   = $(notdir $(call bench_board,$1))
scene_objects = $(addsuffix .o,$(basename $(addprefix $(SCENE_DIR)/$1/,$2 port/boards/common/memory.c \
                $(wildcard port/boards/$(scene_board)/*.[cS]))))
$(foreach core,$(sort $(SCENE_CORES) $(PROFILE_CORE) $(SIZE_VARIANTS:%-O2=%)),$(eval $(call scene_rules,$(core),$(call \
    scene_board,$(core)),$(call scene_objects,$(core),$(SCENE_SOURCES)))))

SCENE_HOST         := $(BENCH_DIR)/bench_host
SCENE_HOST_SOURCES := $(addprefix host/bench/,bench_host.c bench_host_board.c bench_check.c) $(filter host/bench/%,$(SCENE_SOURCES))
$(SCENE_HOST): $(call objects,$(SCENE_HOST_SOURCES)) \
               $(BUILD)/obj/bench_meshes.o $(HOST) $(LIBRARY)
	$(folder)
	$(call run,link $@)$(CC) $(CFLAGS) $(LDFLAGS) -o $@ $^ -lm

$(BUILD)/obj/bench_meshes.o: $(SCENE_DIR)/bench_meshes.c $(BUILD)/flags
	$(folder)
	$(call run,compile $<)$(CC) -std=c99 $(CFLAGS) $(INCLUDES) -Ihost/bench -c -o $@ $<

$(SCENE_DIR)/host.txt: $(SCENE_HOST)
	@$(SCENE_HOST) >$@.part && $(SCENE_HOST) check $(SCENE_DIR) >$(SCENE_DIR)/check.txt || \
	    { cat $(SCENE_DIR)/check.txt; echo "bench: the host's picture is wrong"; exit 1; }
	@mv $@.part $@

.PHONY: bench bench-lines
bench: ## Count the instructions of every benchmark scene on emulated cores: build/bench.tsv
	@$(ALIVE) bench $(MAKE) -s $(PARALLEL) bench-lines
	@$(call bench_skip,bench,$(SCENE_ABSENT))
	@sh host/bench/bench_scenes.sh $(SCENE_DIR) $(BUILD)/bench.tsv "$(BENCH_SCENES)" $(SCENE_PRESENT)

bench-lines: $(SCENE_DIR)/host.txt $(SCENE_PRESENT:%=$(SCENE_DIR)/%/bench.txt)

# Anti-aliasing --------------------------------------------------------------------------------------
# POSES=12: as many of each subject; more are slower.

POSES ?= 3

SMOOTH_TOOL  := $(BENCH_DIR)/antialias
SMOOTH_CORES := $(filter cortex-m0plus cortex-m3,$(SCENE_PRESENT))

$(SMOOTH_TOOL): $(call objects,host/bench/antialias.c host/bench/bench_world.c) $(BUILD)/obj/bench_meshes.o $(HOST) $(LIBRARY)
	$(folder)
	$(call run,link $@)$(CC) $(CFLAGS) $(LDFLAGS) -o $@ $^ -lm

.PHONY: antialias antialias-lines
antialias: ## Print how good each kind of anti-aliasing is, what it costs and what memory it takes; POSES=12
	@$(ALIVE) antialias $(MAKE) -s $(PARALLEL) antialias-lines
	@$(ALIVE) antialias $(SMOOTH_TOOL) $(SCENE_DIR) $(or $(MODELS),none) $(POSES)
	@$(call bench_skip,antialias: instructions,$(filter cortex-m0plus cortex-m3,$(SCENE_ABSENT)))
	@sh host/bench/antialias.sh $(SCENE_DIR) $(SMOOTH_CORES)

antialias-lines: $(SMOOTH_TOOL) $(SMOOTH_CORES:%=$(SCENE_DIR)/%/bench.txt)

# Profile --------------------------------------------------------------------------------------------
# FUNCTIONS="qtri_large_next_row draw": also their disassembly, with how often each instruction ran.

PROFILE_SCENES := $(or $(BENCH_SCENES),$(if $(filter %/spot.obj,$(SCENE_MODELS)),S4 S5 S7,S4k S5k S7k))

# The program of one scene: that of all, with another bench_program.o.
profile_dir     := $(SCENE_DIR)/$(PROFILE_CORE)
profile_board   := $(call scene_board,$(PROFILE_CORE))
profile_objects := $(filter-out %/bench_program.o,$(call scene_objects,$(PROFILE_CORE),$(SCENE_SOURCES)))

$(PROFILE_SCENES:%=$(profile_dir)/profile-%.o): $(profile_dir)/profile-%.o: host/bench/bench_program.c host/bench/bench_program.h host/bench/bench_scenes.h host/bench/scenes.mk
	$(folder)
	@$(call scene_compile,$(PROFILE_CORE),$<) -DBENCH_ONLY='"$*"' -c -o $@ $<

$(PROFILE_SCENES:%=$(profile_dir)/%.elf): $(profile_dir)/%.elf: $(profile_dir)/profile-%.o $(profile_objects)
	@$(call scene_link,$(PROFILE_CORE)) -T port/boards/$(profile_board)/$(profile_board).ld -o $@ $^ -lgcc

profile_prefix := $(patsubst %gcc,%,$(firstword $(call bench_cc,$(PROFILE_CORE))))

profile_present := $(and $(call bench_has,$(call bench_cc,$(PROFILE_CORE))),$(call bench_has,$(call bench_emulator,$(PROFILE_CORE))))

.PHONY: bench-profile profile-programs
bench-profile: ## Instructions per stage and function of S4 S5 S7; PROFILE_CORE=cortex-m0plus BENCH_SCENES="S3 S4" FUNCTIONS=...
ifeq ($(profile_present),)
	@$(call bench_skip,bench-profile,$(PROFILE_CORE))
else
	@$(MAKE) -s $(PARALLEL) profile-programs
	@$(foreach scene,$(PROFILE_SCENES),echo; echo "== $(scene), $(PROFILE_CORE)"; \
	    FUNCTIONS='$(FUNCTIONS)' sh host/bench/profile.sh $(profile_dir)/$(scene).elf $(profile_prefix) \
	        $(call bench_emulator,$(PROFILE_CORE)) || exit 1;)
endif

profile-programs: $(PROFILE_SCENES:%=$(profile_dir)/%.elf)

# Time on the host -----------------------------------------------------------------------------------
# BASE=COMMIT builds that commit's benchmark as well, and times the scenes that both have in turn.

BASE ?=

HOST_FAST := build/o3
BASE_ID   := $(if $(BASE),$(shell git rev-parse --short $(BASE) 2>/dev/null))
BASE_DIR  := build/base/$(BASE_ID)

.PHONY: bench-host
bench-host: ## Time every benchmark scene on the host, -O3: build/bench-host.tsv; BASE=COMMIT compares
	@$(if $(BASE),$(if $(BASE_ID),,echo "bench-host: there is no commit $(BASE)"; exit 1))
	@$(MAKE) -s $(PARALLEL) BUILD=$(HOST_FAST) CFLAGS=-O3 $(HOST_FAST)/bench/bench_host
	@$(if $(BASE),$(MAKE) -s BUILD=$(BUILD) $(BASE_DIR)/$(HOST_FAST)/bench/bench_host)
	@sh host/bench/bench_host.sh build/bench-host.tsv $(HOST_FAST)/bench/bench_host $(if $(BASE),$(BASE_DIR)/$(HOST_FAST)/bench/bench_host)

ifneq ($(BASE_ID),)
$(BASE_DIR)/$(HOST_FAST)/bench/bench_host:
	@rm -rf $(BASE_DIR) && mkdir -p $(BASE_DIR)
	@git archive $(BASE_ID) | tar -xf - -C $(BASE_DIR)
	@$(MAKE) -s $(PARALLEL) -C $(BASE_DIR) BUILD=$(HOST_FAST) CFLAGS=-O3 MODELS=$(abspath $(MODELS)) $(HOST_FAST)/bench/bench_host
endif
