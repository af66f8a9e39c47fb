# SPDX-License-Identifier: MIT
# The page, a folder of files that needs no server: core, reference and commands as WebAssembly. Needs clang, lld and
# wasi-libc. Included by the main Makefile.

WEB_DIR := $(BUILD)/web
WEB_OBJ := $(BUILD)/obj-web

# Without what needs processes, signals or files of a disk, for which web_files.c and web_system.c stand in.
web_sources := $(wildcard core/*/*.c host/io/*.c host/reference/*.c host/assets/*.c host/web/*.c) \
               $(wildcard host/tools/mesh_*.c host/tools/scene_*.c) host/tools/model_command.c host/tools/texture_command.c host/tools/options.c host/tools/compare.c host/tools/font_build.c
web_sources := $(filter-out host/io/file.c host/io/file_i%.c host/io/system_posix.c host/io/system_windows.c host/assets/apart%.c host/tools/scene_view.c,$(web_sources))
web_exports := malloc free web_command web_scene web_draw web_count \
               web_file_create web_file_content web_file_length web_files_clear
WEB_CC      := clang --target=wasm32-wasi -std=c99 -O2

$(WEB_OBJ)/%.o: %.c host/web/web.mk
	@mkdir -p $(@D)
	$(call run,compile $< for the page)$(WEB_CC) -Icore/include -Iport/include -MMD -MP -c -o $@ $<

$(WEB_OBJ)/qtri.wasm: $(web_sources:%.c=$(WEB_OBJ)/%.o)
	$(call run,link $@)$(WEB_CC) -mexec-model=reactor -Wl,-z,stack-size=1048576 -Wl,--strip-all $(web_exports:%=-Wl,--export=%) -o $@ $^

# Base64 in a script, since a page that is opened as a file may fetch nothing.
$(WEB_DIR)/qtri.js: $(WEB_OBJ)/qtri.wasm
	@mkdir -p $(@D)
	@{ printf 'const QTRI_WASM = "'; base64 -w 0 $<; printf '";\n'; } >$@

web_files := index.html page.css engine.js files.js page.js
$(web_files:%=$(WEB_DIR)/%): $(WEB_DIR)/%: host/web/%
	@mkdir -p $(@D)
	@cp $< $@

.PHONY: web
web: ## Make build/web/index.html, a page that draws models as a microcontroller would; needs clang, lld, wasi-libc
	@sh tests/check/have_wasm.sh || \
	    { echo 'web: clang cannot build for WebAssembly here: apt-get install clang lld wasi-libc libclang-rt-14-dev-wasm32' >&2; exit 1; }
	@$(MAKE) -s $(PARALLEL) $(WEB_DIR)/qtri.js $(web_files:%=$(WEB_DIR)/%)
	@echo "web: $(WEB_DIR)/index.html, $$(du -sk $(WEB_DIR) | cut -f 1) KB"

-include $(shell find $(WEB_OBJ) -name '*.d' 2>/dev/null)
