# SPDX-License-Identifier: MIT
# The accuracy of core/math: build/qtri-verify, its table and plots; and what tests/test_verify_math.c links.
#
# Included by the main Makefile. Needs MPFR (libmpfr-dev), and so is no part of `make`.

VERIFY ?= full
VERIFY_FLAGS_quick := --quick
VERIFY_FLAGS_full  := --full
VERIFY_FLAGS_long  := --long

VERIFY_SOURCES := $(filter-out host/verify/main.c,$(wildcard host/verify/*.c))
VERIFY_LIBRARY := $(BUILD)/libqtri-verify.a
VERIFY_LIBS    := -lmpfr -lgmp -lm -pthread

$(VERIFY_LIBRARY): $(call objects,$(VERIFY_SOURCES))
	@mkdir -p $(@D) && rm -f $@
	$(call run,archive $@)$(AR) rc $@ $^

# Loops over 1024 values are what its time is spent in. A sanitized build comes with its own CFLAGS.
# private: $(BUILD)/flags is a prerequisite and must not see this.
ifeq ($(CFLAGS),-O2)
$(BUILD)/obj/host/verify/%.o: private CFLAGS := -O3
endif

$(BUILD)/qtri-verify: $(BUILD)/obj/host/verify/main.o $(VERIFY_LIBRARY) $(LIBRARY)
	$(call run,link $@)$(CC) $(CFLAGS) $(LDFLAGS) -o $@ $^ $(VERIFY_LIBS)

$(BUILD)/tests/test_verify_math: $(BUILD)/obj/tests/test_verify_math.o $(VERIFY_LIBRARY) $(LIBRARY)
	@mkdir -p $(@D)
	$(call run,link $@)$(CC) $(CFLAGS) $(LDFLAGS) -o $@ $^ -lcmocka $(VERIFY_LIBS)

.PHONY: verify-math
verify-math: $(BUILD)/qtri-verify ## Table of the error of every function, all inputs; VERIFY=quick|long, FUNCTIONS="sin sqrt"
	@$(ALIVE) verify-math $(BUILD)/qtri-verify --threads $(JOBS) \
	    $(or $(VERIFY_FLAGS_$(VERIFY)),$(error VERIFY is quick, full or long, not '$(VERIFY)')) \
	    -o $(BUILD)/math.tsv $(FUNCTIONS)

.PHONY: plot-math
plot-math: $(BUILD)/qtri-verify ## Plots of the error of sin, atan2 and sqrt: build/plots/*.svg, by gnuplot
	@command -v gnuplot >/dev/null || { echo "plot-math: no gnuplot: apt-get install gnuplot-nox" >&2; exit 1; }
	@mkdir -p $(BUILD)/plots
	for name in sin atan2 sqrt; do \
	    $(BUILD)/qtri-verify --plot $$name -o $(BUILD)/plots/$$name.gp && \
	    gnuplot $(BUILD)/plots/$$name.gp >$(BUILD)/plots/$$name.svg || exit 1; \
	done
