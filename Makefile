# SPDX-License-Identifier: MIT
# qtri: a fixed-point 3D renderer in C99. `make help` lists what can be made.
#
#   core/ and port/panels/   -> build/libqtri.a        freestanding: what a firmware links
#   host/                    -> build/libqtri-host.a   files, the double-precision reference, the tools
#   host/tools/main.c        -> build/qtri             the command
#   tests/test_X.c           -> build/tests/test_X     one cmocka program each
#   tests/fuzz_X.c           -> build/fuzz/tests/fuzz_X   one libFuzzer program each
#   tests/support/*.c        -> build/libqtri-test.a   what the tests share
#
# The same rules serve the sanitized and the fuzzed build; only BUILD, CC and CFLAGS differ.

# Settings -----------------------------------------------------------------------------------------

CFLAGS ?= -O2
BUILD  ?= build
# How much `make test` and `make check` do at a time.
JOBS   ?= $(shell getconf _NPROCESSORS_ONLN 2>/dev/null || echo 2)
# The folder of the meshes; where it is missing, the tests that need one are skipped and say so.
MODELS ?= $(wildcard ../shared/models)
# What `make test` runs, the longest first, so that no processor waits for one of them at the end; how long it fuzzes
# each target, and when it takes a program for hung.
LONGEST      := test_tools_command test_tools_assets test_scene_wrong_texels test_core_stroke test_scene_random \
                test_core_pictures test_panel_bus test_verify_math test_panel_show test_core_depth
# Those whose own loops take longer where they are not optimized than the compiler then saves.
CALCULATING  := test_core_blend test_core_blend_bounds test_core_edges test_core_line test_core_perspective test_core_pictures \
                test_core_q16 test_core_raster
TESTS        ?= $(LONGEST) $(filter-out $(LONGEST),$(basename $(notdir $(wildcard tests/test_*.c))))
FUZZERS      ?= $(basename $(notdir $(wildcard tests/fuzz_*.c)))
FUZZ_SECONDS ?= 15
# Fuzzing for hours pays for a minute of optimizing (make fuzz).
FUZZ_LEVEL   ?= -O0
TEST_SECONDS ?= 300

LIBRARY_SOURCES := $(wildcard core/*/*.c port/panels/*.c)
HOST_SOURCES    := $(filter-out host/tools/main.c,$(wildcard host/assets/*.c host/io/*.c host/panels/*.c host/reference/*.c host/tools/*.c))
HELPER_SOURCES  := $(wildcard tests/support/*.c)

LIBRARY  := $(BUILD)/libqtri.a
HOST     := $(BUILD)/libqtri-host.a
HELPERS  := $(BUILD)/libqtri-test.a
ARCHIVES := $(HELPERS) $(HOST) $(LIBRARY)

# Tests also look inside: "math/bits.h", "io/scene.h".
INCLUDES := -Icore/include -Iport/include
$(BUILD)/obj/tests/%.o: INCLUDES += -Icore -Ihost
$(patsubst tests/%.c,$(BUILD)/obj/tests/%.o,$(filter-out $(CALCULATING:%=tests/%.c),$(wildcard tests/*.c tests/support/*.c))): \
INCLUDES += $(TEST_FLAGS)
$(BUILD)/obj/core/%.o:  INCLUDES += $(CORE_FLAGS)
$(BUILD)/obj/core/draw/pipeline%.o $(BUILD)/obj/core/raster/pipelines_%.o $(BUILD)/obj/core/raster/line_pipelines.o: \
INCLUDES += $(PIPELINE_FLAGS)


include host/assets/assets.mk

# Header dependencies, from every compiler that can write them.
DEPENDENCIES := $(shell $(CC) -MMD -MP -MF /dev/null -c -o /dev/null -x c /dev/null 2>/dev/null && echo -MMD -MP)

# The plain build is compiled with these, which `make check` makes errors (check-warnings): so nothing is compiled twice.
WARNINGS := -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Wstrict-prototypes -Wmissing-prototypes -Wvla -Wundef -Wcast-qual \
            -Wwrite-strings $(if $(findstring clang,$(CC)),,-Wdouble-promotion)
$(BUILD)/obj/%.o: INCLUDES += $(if $(filter build,$(BUILD)),$(WARNINGS) $(WERROR))
.PHONY: warnings
warnings:
	@echo '$(WARNINGS)'
check check-warnings: export WERROR := -Werror

SANITIZE := -O1 -g1 -fno-omit-frame-pointer -fno-sanitize-recover=all \
            -fsanitize=address,undefined,float-cast-overflow
SANITIZE_THREADS := -O0 -g1 -fsanitize=thread
SANITIZE_MEMORY  := -O1 -g1 -fno-omit-frame-pointer -fno-sanitize-recover=all -fsanitize=memory
# Core is built for it as by any C99 compiler: an empty line of assembly would count as a use of room to spare.
PLAIN_C99 := -U__GNUC__ -fno-strict-aliasing

# Minutes to compile there: the pipelines' other tests draw by the same body. Tests and pipelines are compiled without
# optimisation, which takes gcc a quarter or less of the time and asks the same. Not for memory: clang compiles tests fast,
# and they would run 100 seconds longer.
SLOW_TO_SANITIZE := test_pipeline_random
UNOPTIMIZED      := PIPELINE_FLAGS=-O0 TEST_FLAGS=-O0
# What `make check` runs without sanitizers: those, and programs that try more where they are faster (support/core.h).
MORE_WHEN_PLAIN   = $(filter $(SLOW_TO_SANITIZE) \
                    $(basename $(notdir $(shell grep -lwE 'random_cases|repeats|IS_SANITIZED|SANITIZED' tests/test_*.c))),$(TESTS))

# Cores that multiply 32 by 32 bits to 32 and do not divide, see core/bits/bits.h.
NARROW := -DQTRI_LONG_MULTIPLY=0 -DQTRI_DIVIDE=0

# In front of a command: a short line in its place, or the command itself with V=1; neither with -s.
run = $(if $(V),,@$(if $(findstring s,$(firstword -$(MAKEFLAGS))),,echo '$1' && ))

# In a recipe: makes the target's folder where there is none. A process for each object would cost a minute of all builds.
folder = $(if $(wildcard $(@D)),,@mkdir -p $(@D))

# -j for a make that this one starts, unless they already share the jobs.
PARALLEL = $(if $(findstring -j,$(MAKEFLAGS)),,-j$(JOBS))

# Building -----------------------------------------------------------------------------------------

.PHONY: all
.DEFAULT_GOAL := all
all: $(LIBRARY) $(BUILD)/qtri ## Build build/libqtri.a and build/qtri (the default); needs only a C99 compiler

$(BUILD)/qtri: $(BUILD)/obj/host/tools/main.o $(HOST) $(LIBRARY)
	$(call run,link $@)$(CC) $(CFLAGS) $(LDFLAGS) -o $@ $^ -lm $(HOST_LIBS)

objects = $(1:%.c=$(BUILD)/obj/%.o)
$(LIBRARY): $(call objects,$(LIBRARY_SOURCES))
$(HOST):    $(call objects,$(HOST_SOURCES))
$(HELPERS): $(call objects,$(HELPER_SOURCES))

$(ARCHIVES):
	@mkdir -p $(@D) && rm -f $@
	$(call run,archive $@)$(AR) rc $@ $^

$(BUILD)/obj/%.o: %.c $(BUILD)/flags
	$(folder)
	$(call run,compile $<)$(CC) -std=c99 $(CFLAGS) $(INCLUDES) $(DEPENDENCIES) -c -o $@ $<

# The compiler and its flags; rewritten when they change, so that everything is rebuilt.
$(BUILD)/flags: FORCE
	$(folder)
	@echo '$(CC) $(CFLAGS) $(HOST_DEFINES)' | cmp -s - $@ || echo '$(CC) $(CFLAGS) $(HOST_DEFINES)' > $@

.PHONY: FORCE
.SECONDARY:
-include $(shell find $(BUILD)/obj -name '*.d' 2>/dev/null)

.PHONY: demo
demo: all ## Draw the demonstration pictures into build/demo; MODELS=FOLDER names the meshes
	@mkdir -p $(BUILD)/demo
	$(BUILD)/qtri demo -o $(BUILD)/demo $(if $(MODELS),--models $(MODELS))

.PHONY: clean
clean: ## Remove build/
	rm -rf build

# Testing ------------------------------------------------------------------------------------------
# Every step leaves a line `passed failed skipped` per program in build/results/; `make test` adds them up.

# Long commands say every 20 seconds that they are at work.
ALIVE := sh tests/check/alive.sh

.PHONY: setup setup-all
setup: ## Install what `make test` needs (Debian, as root); elsewhere name it
	@sh tests/check/setup.sh

setup-all: ## Install what `make check` needs besides: cross compilers, emulators, clang; 3 GB
	@sh tests/check/setup.sh all

.PHONY: test
test: ## Run every test program under the address and undefined-behaviour sanitizers: some minutes
	@rm -rf build/results
	@echo 'test: compiles the library and $(words $(TESTS)) programs, then runs them: some minutes on two cores'
	@status=0; $(ALIVE) test $(MAKE) -s $(PARALLEL) test-sanitized || status=1; sh tests/check/total.sh $$status

# What `make check` runs of the tests besides: other builds, fuzzing, emulated boards.
.PHONY: test-others test-more
test-others: ## Run the tests of other builds: plain, narrow, threads, fuzzed, on boards; FUZZ_SECONDS=600 fuzzes longer
	@rm -rf build/results
	@status=0; \
	for step in test-more test-fuzz; do \
	    $(ALIVE) $$step $(MAKE) -s $(PARALLEL) $$step || status=1; \
	done; \
	$(ALIVE) test-others $(MAKE) -s -k $(PARALLEL) --output-sync=target $(TOGETHER) || status=1; \
	sh tests/check/total.sh $$status

# One emulator after the other leaves processors idle: these run beside each other.
TOGETHER := test-math-targets test-narrow test-threads $(if $(wildcard port/boards/boards.mk),test-boards) \
            $(if $(wildcard port/examples/examples.mk),test-examples test-rp2040)

.PHONY: test-plain
test-plain: $(if $(filter-out %_threads,$(TESTS)),all) $(TESTS:%=$(BUILD)/tests/%) ## Run the cmocka programs; TESTS=test_core_project runs one
	@BUILD=$(BUILD) JOBS=$(JOBS) TEST_SECONDS=$(TEST_SECONDS) MODELS=$(MODELS) \
	    sh tests/check/run_tests.sh $(TESTS)

test-more: ## Run those without sanitizers that try less under them, or are not run
	@$(MAKE) -s $(PARALLEL) TESTS='$(MORE_WHEN_PLAIN)' test-plain

.PHONY: test-sanitized
test-sanitized: ## Run them under the address and undefined-behaviour sanitizers
	@$(MAKE) -s $(PARALLEL) BUILD=build/sanitize CFLAGS='$(SANITIZE)' $(UNOPTIMIZED) TESTS='$(filter-out $(SLOW_TO_SANITIZE),$(TESTS))' test-plain

.PHONY: test-threads
test-threads: ## Run the tests that have threads under the thread sanitizer
	@$(MAKE) -s $(PARALLEL) BUILD=build/threads CFLAGS='$(SANITIZE_THREADS)' $(UNOPTIMIZED) TESTS='$(filter %_threads,$(TESTS))' test-plain

# The code of small cores, and whether it reads what was never written: one build asks both. Only what runs code of core
# and port: cmocka and libm know nothing of this sanitizer, clang's alone.
.PHONY: test-narrow
test-narrow: ## Run the tests of core and panels with the code of cores without long multiply and divide, under clang's sanitizer for memory never written
	@if sh tests/check/have_memory.sh; then \
	    $(MAKE) -s $(PARALLEL) BUILD=build/narrow CC=clang CFLAGS='$(SANITIZE_MEMORY) $(NARROW)' CORE_FLAGS='$(PLAIN_C99)' \
	        TESTS='$(filter test_core_% test_panel_%,$(TESTS))' test-plain; \
	else \
	    $(MAKE) -s $(PARALLEL) BUILD=build/narrow CFLAGS='-O1 $(NARROW)' TESTS='$(filter test_core_%,$(TESTS))' test-plain; \
	fi

.PHONY: test-fuzz fuzzers
test-fuzz: ## Run the fuzz targets under both sanitizers, FUZZ_SECONDS each, with clang
	@if sh tests/check/have_fuzzer.sh; then \
	    $(MAKE) -s $(PARALLEL) BUILD=build/fuzz CC=clang CFLAGS='$(SANITIZE) $(FUZZ_LEVEL) -fsanitize=fuzzer-no-link' $(UNOPTIMIZED) fuzzers; \
	fi
	@FUZZ_SECONDS=$(FUZZ_SECONDS) sh tests/check/run_fuzzers.sh $(FUZZERS)

fuzzers: $(FUZZERS:%=$(BUILD)/tests/%)

$(BUILD)/tests/fuzz_%: LDFLAGS += -fsanitize=fuzzer
$(BUILD)/tests/%_threads: LDFLAGS += -pthread
# Random pipelines, a file of few, as the compiler takes long for each; those of one are to be small.
RANDOM_PIPELINES ?= 60
RANDOM_PARTS     := 0 1 2 3 4 5
random_pipelines  = $(RANDOM_PARTS:%=$(BUILD)/random_pipelines/part_%.o) $(BUILD)/random_pipelines/list.o
$(BUILD)/random_pipelines/%.o: tests/tools/random_pipelines.awk $(BUILD)/flags $(wildcard core/include/qtri/*.h core/include/qtri/body/*.h)
	$(folder)
	@awk -v seed=223 -v count=$(RANDOM_PIPELINES) -v parts=$(words $(RANDOM_PARTS)) \
	    $(if $(filter list,$*),-v list=1,-v part=$(*:part_%=%)) -f $< >$(@:.o=.c)
	$(call run,compile $@)$(CC) -std=c99 $(CFLAGS) $(if $(filter part_5,$*),-Os,-O1) -Icore/include -c -o $@ $(@:.o=.c)
$(BUILD)/tests/test_pipeline_random: $(random_pipelines)

# What `qtri pipelines` prints of scenes, compiled as it is.
PASTED := 09-floor-mipmapped 11-antialias-msaa 11-light-pixel 11-vertex-alpha 12-fog
$(BUILD)/pasted/%.o: host/scenes/%.scene $(BUILD)/qtri
	$(folder)
	@$(BUILD)/qtri pipelines $< --name pasted_$(subst -,_,$*) >$(@:.o=.c)
	$(call run,compile $@)$(CC) -std=c99 $(CFLAGS) $(TEST_FLAGS) -Icore/include -c -o $@ $(@:.o=.c)
$(BUILD)/tests/test_tools_pipelines: $(PASTED:%=$(BUILD)/pasted/%.o)

# Tests of threads need the library alone: the thread sanitizer compiles nothing else.
$(BUILD)/tests/%_threads: $(BUILD)/obj/tests/%_threads.o $(LIBRARY)
	$(folder)
	$(call run,link $@)$(CC) $(CFLAGS) $(LDFLAGS) -o $@ $^ -lcmocka -lm

$(BUILD)/tests/%: $(BUILD)/obj/tests/%.o $(ARCHIVES)
	$(folder)
	$(call run,link $@)$(CC) $(CFLAGS) $(LDFLAGS) -o $@ $^ -lcmocka -lm $(HOST_LIBS)

.PHONY: fuzz
fuzz: ## Fuzz for hours: FUZZ_SECONDS=3600 FUZZERS="fuzz_draw fuzz_math"; what is reached stays in build/fuzz/corpus
	@$(ALIVE) fuzz $(MAKE) -s test-fuzz FUZZ_LEVEL=-O1 FUZZ_SECONDS=$(if $(filter command%,$(origin FUZZ_SECONDS)),$(FUZZ_SECONDS),600)

.PHONY: corpus
corpus: ## Keep in tests/corpus what fuzzing has found to reach, the smallest inputs
	@for name in $(FUZZERS); do sh tests/check/corpus.sh pack $$name || exit 1; done

# Not part of `make test`: minutes, and hours. They need python3 and llvm (make setup-proof).

COVERAGE := -O1 -g -fprofile-instr-generate -fcoverage-mapping
MUTANTS  ?= 500
SEED     ?= 1

.PHONY: reference
reference: ## Write the API reference with Doxygen: build/reference/index.html
	@sh tests/check/reference.sh

.PHONY: routes
routes: ## Files, functions and returns that lead through core from a draw call to its pixels
	@JOBS=$(JOBS) sh tests/check/routes.sh

.PHONY: pictures
RECORDING := test_scene_pictures test_core_pictures test_core_values test_core_corpus
pictures: $(RECORDING:%=$(BUILD)/tests/%) ## Record in tests/pictures.tsv the pictures that the core draws now
	@rm -f $(BUILD)/pictures.tsv
	@for program in $^; do \
	    CMOCKA_MESSAGE_OUTPUT=TAP QTRI_RECORD=$(BUILD)/pictures.tsv $$program >$(BUILD)/pictures.log || { cat $(BUILD)/pictures.log; exit 1; }; \
	done
	@mv $(BUILD)/pictures.tsv tests/pictures.tsv

.PHONY: coverage mutate misra prove prove-inputs setup-proof
coverage: ## Lines and branches of core and port that the plain tests reach; tests/coverage.allow lists what they do not
	@rm -rf build/coverage/raw && mkdir -p build/coverage/raw
	@LLVM_PROFILE_FILE=$(CURDIR)/build/coverage/raw/build-%m.profraw PROFILES=$(CURDIR)/build/coverage/raw $(ALIVE) coverage $(MAKE) -s $(PARALLEL) BUILD=build/coverage CC=clang CFLAGS='$(COVERAGE)' test-plain
	@python3 tests/tools/coverage.py build/coverage tests/coverage.allow

mutate: all $(TESTS:%=$(BUILD)/tests/%) ## Change operators and constants of core at random and report what no test notices; MUTANTS=500 SEED=1; FILES="core/paint/*.c": of these; AGAIN=again: survivors
	@FILES='$(FILES)' HOST_LIBS='$(HOST_LIBS)' QTRI_MODELS='$(abspath $(MODELS))' JOBS=$(JOBS) $(ALIVE) mutate python3 tests/tools/mutate.py $(BUILD) $(MUTANTS) $(SEED) $(AGAIN)

misra: ## What cppcheck says of MISRA C:2012 in core, by rule; tests/misra.md has the deviations
	@$(ALIVE) misra sh tests/tools/misra.sh

prove: ## Prove by Frama-C that mathematics and kernels do nothing that C does not define, for all arguments; half an hour
	@JOBS=$(JOBS) $(ALIVE) prove sh tests/tools/prove.sh values

prove-inputs: ## The same by trying all 2^32 arguments of the functions of one, half an hour; FUNCTIONS="sqrt recip"
	@JOBS=$(JOBS) $(ALIVE) prove-inputs sh tests/tools/prove.sh inputs

setup-proof: ## Install what coverage, mutate, misra, prove and plot-math need besides (Debian, as root)
	apt-get install -y -qq --no-install-recommends python3 llvm cppcheck frama-c-base gnuplot-nox

.PHONY: test-math-targets
test-math-targets: ## Compare checksums of the mathematics: x86-64, Arm, RISC-V, big-endian PowerPC, AVR
	@JOBS=$(JOBS) sh tests/test_math_targets.sh

# Checking -----------------------------------------------------------------------------------------
# Each gate is a script of its name in tests/check/ and prints `check: NAME ok` and its seconds, or its findings.

# What keeps one processor alone for long is not left for the end.
GATES := check-format check-packages check-cppcheck check-warnings check-headers check-levels \
         check-freestanding check-options check-same check-tree \
         check-tidy check-budgets check-matrix check-checked check-stack check-version \
         check-house check-words check-reference check-figures check-window check-windows check-web

.PHONY: check $(GATES)
check: ## Run the tests of other builds (test-others) and every gate below
	@status=0; $(MAKE) -s test-others || status=1; \
	$(ALIVE) check $(MAKE) -s -k $(PARALLEL) --output-sync=target $(GATES) || status=1; exit $$status

check-format:       ## clang-format has nothing to change
check-cppcheck:     ## cppcheck finds nothing
check-tidy:         ## clang-tidy finds nothing (.clang-tidy says what is asked)
check-warnings:     ## gcc and clang compile everything as C99 without a warning
check-headers:      ## Every public header compiles alone, in C99 and C++11, and links from C++
check-levels:       ## A file includes only from its own folder and those below
check-freestanding: ## The library for a Cortex-M0+ needs no libc, float, malloc or writable data
check-options:      ## Built without any option of config.h, the library draws the same pixels of what is left
check-same:         ## gcc, clang and tcc, of 32 bits, big-endian and on boards, draw the same 2,900 pictures (SAME=all: each at all levels)
check-checked:      ## A build with QTRI_CHECKED stops at mistakes, and Q16() of a variable does not compile
check-budgets:      ## No figure of bench and size is more than 2 % above its budget (make budgets)
check-matrix:       ## No cell of bench-matrix costs twice its class's best or 2 % more than its budget (make matrix-budgets)
check-stack:        ## Nothing calls itself, and no public function takes more stack than its limit
check-version:      ## Every manifest has the version of qtri/version.h, every source its SPDX line
check-packages:     ## Each package is built and used; what needs a missing tool is skipped by name
check-house:        ## Files and lines of each folder of core, and routes, within their budgets (sh tests/check/house.sh write)
check-words:        ## Names and comments have plain words, subjects of commits at most 72 characters
check-reference:    ## Doxygen reads every public header, and no public name is without documentation
check-figures:      ## README's figures are those of budgets and demo that they stand for
check-window:       ## The window, without a screen, shows the pixels of `qtri render` and of the examples
check-web:          ## The page, in Chromium, shows and writes what `qtri` does, and refuses wrong files in words
check-windows:      ## The command compiles for Windows by MinGW and, under Wine, writes the same bytes as here
check-tree:         ## No overlong or binary files, tabs, paths of one machine or sources of one name

$(GATES): check-%:
	@sh tests/check/$*.sh

.PHONY: check-models
check-models: $(BUILD)/qtri ## Convert every model of a folder, MODELS: each header compiles, or the refusal is a line
	@QTRI_COMMAND=$(BUILD)/qtri sh tests/check/models.sh '$(MODELS)'

.PHONY: help
help: ## List these targets; V=1 with any of them shows commands in full
	@awk -F ':.*## ' '/^[a-z][a-z-]*:.*## / { printf "make %-20s%s\n", $$1, $$2 }' $(MAKEFILE_LIST)

# Boards: firmware for emulated microcontrollers, its targets among them `test-boards` ----------------

-include host/bench/bench.mk
-include port/boards/boards.mk
-include host/generate/generate.mk
-include host/verify/verify.mk
-include host/report/report.mk
-include port/packages/packages.mk
-include port/examples/examples.mk
-include host/window/window.mk
-include host/web/web.mk
-include host/windows.mk
