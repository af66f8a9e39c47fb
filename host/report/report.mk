# SPDX-License-Identifier: MIT
# The accuracy report: host/report/report.sh. Included by the main Makefile.

# What is missing here is missing in the page, which says so.
REPORT_MATHS = $(shell printf '\043include <mpfr.h>\nint main(void) { return 0; }' | $(CC) -fsyntax-only -x c - 2>/dev/null && echo verify-math)
REPORT_PLOTS = $(if $(REPORT_MATHS),$(shell command -v gnuplot >/dev/null && echo plot-math))

.PHONY: report
report: all ## The accuracy report as one page, build/report.html: scenes, functions, cost, peers, README's figures
	@$(if $(REPORT_MATHS),$(MAKE) -s VERIFY=quick FUNCTIONS= $(REPORT_MATHS) >/dev/null,:)
	@$(if $(REPORT_PLOTS),$(MAKE) -s $(REPORT_PLOTS) >/dev/null,:)
	@$(ALIVE) report sh host/report/report.sh $(BUILD) $(MODELS)
