# SPDX-License-Identifier: MIT
# The page, a folder of files that needs no server: core, reference and commands as WebAssembly. Needs clang, lld and
# wasi-libc. Included by the main Makefile.

WEB_DIR := $(BUILD)/web
WEB_OBJ := $(BUILD)/obj-web

# Without what needs processes, signals or files of a disk, for which the files of host/web stand in.
web_sources := $(wildcard core/*/*.c host/io/*.c host/reference/*.c host/assets/*.c host/web/*.c) \
               $(wildcard host/tools/mesh_*.c host/tools/model_*.c host/tools/scene_*.c) host/tools/options.c host/tools/compare.c host/tools/font_build.c
web_sources := $(filter-out host/io/file.c host/io/file_i%.c host/io/system_posix.c host/io/system_windows.c host/assets/apart%.c host/assets/asset_order.c host/tools/scene_view.c,$(web_sources))
# Headers alone of the libraries that the command has: stb is compiled of its own, web_import.c stands in for assimp.
web_defines := -DQTRI_HAVE_STB $(shell pkg-config --cflags stb 2>/dev/null) -DQTRI_HAVE_ASSIMP -I$(WEB_OBJ)/include
web_exports := malloc free web_model web_show web_scene web_draw web_count \
               web_file_create web_file_content web_file_length web_files_clear
WEB_CC      := clang --target=wasm32-wasi -std=c99 -O2

$(WEB_OBJ)/host/assets/image_stb.o: web_defines += -DSTB_IMAGE_IMPLEMENTATION -DSTBI_NO_STDIO -DSTBI_ONLY_JPEG -DSTBI_ONLY_PNG

# The folder of assimp's headers alone: those beside it are of this computer's C library.
$(WEB_OBJ)/include/assimp:
	@mkdir -p $(@D)
	@ln -sfn "$$(pkg-config --variable=includedir assimp)/assimp" $@

$(WEB_OBJ)/%.o: %.c host/web/web.mk | $(WEB_OBJ)/include/assimp
	@mkdir -p $(@D)
	$(call run,compile $< for the page)$(WEB_CC) $(web_defines) -Icore/include -Iport/include -MMD -MP -c -o $@ $<

$(WEB_OBJ)/qtri.wasm: $(web_sources:%.c=$(WEB_OBJ)/%.o)
	@echo page_order >$(@D)/imports
	$(call run,link $@)$(WEB_CC) -mexec-model=reactor -Wl,--allow-undefined-file=$(@D)/imports -Wl,-z,stack-size=1048576 -Wl,--strip-all $(web_exports:%=-Wl,--export=%) -o $@ $^

# Base64 in a script, since a page that is opened as a file may fetch nothing; before it the library meshoptimizer of npm
# where `make setup-all` has installed it.
web_order := $(wildcard build/npm/node_modules/meshoptimizer/meshopt_encoder.js)
$(WEB_DIR)/qtri.js: $(WEB_OBJ)/qtri.wasm $(web_order)
	@mkdir -p $(@D)
	@{ cat $(web_order) /dev/null; printf 'const QTRI_WASM = "'; base64 -w 0 $<; printf '";\n'; } >$@

web_files := index.html page.css engine.js files.js page.js
$(web_files:%=$(WEB_DIR)/%): $(WEB_DIR)/%: host/web/%
	@mkdir -p $(@D)
	@cp $< $@

.PHONY: web
web: ## Make build/web/index.html, a page that draws models as a microcontroller would; needs clang, lld, wasi-libc
	@sh tests/check/have_wasm.sh && pkg-config --exists assimp stb || \
	    { echo 'web: needs clang for WebAssembly and headers: apt-get install clang lld wasi-libc libclang-rt-14-dev-wasm32 libassimp-dev libstb-dev' >&2; exit 1; }
	@$(MAKE) -s $(PARALLEL) $(WEB_DIR)/qtri.js $(web_files:%=$(WEB_DIR)/%)
	@echo "web: $(WEB_DIR)/index.html, $$(du -sk $(WEB_DIR) | cut -f 1) KB"

-include $(shell find $(WEB_OBJ) -name '*.d' 2>/dev/null)
