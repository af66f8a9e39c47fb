# SPDX-License-Identifier: MIT
# The command for Windows, without libraries, by MinGW's cross compiler: build/windows/qtri.exe. Included by the main
# Makefile.

MINGW         ?= x86_64-w64-mingw32-
WINDOWS_BUILD ?= build/windows

.PHONY: windows
windows: ## Build the command for Windows by MinGW: build/windows/qtri.exe
	@$(MAKE) BUILD=$(WINDOWS_BUILD) CC=$(MINGW)gcc AR=$(MINGW)ar WITH= \
	    CFLAGS='$(CFLAGS) -D__USE_MINGW_ANSI_STDIO=1' $(WINDOWS_BUILD)/qtri.exe

# No file but the program is needed: -static.
$(BUILD)/qtri.exe: $(BUILD)/obj/host/tools/main.o $(HOST) $(LIBRARY)
	$(call run,link $@)$(CC) $(CFLAGS) $(LDFLAGS) -static -o $@ $^ -lm
