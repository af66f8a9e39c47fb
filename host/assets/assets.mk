# SPDX-License-Identifier: MIT
# Libraries that read files and work on meshes for the commands `qtri mesh` and `qtri texture`. Each is used where it is
# installed; without it the command is built all the same and says what it therefore cannot do. WITH= builds without any.

WITH ?= libpng stb assimp meshoptimizer freetype

HOST_DEFINES :=
HOST_LIBS    :=

# $1: a library of WITH, $2: its name for pkg-config, $3: the macro that says that it is there.
define host_library
ifneq ($(and $(filter $1,$(WITH)),$(shell pkg-config --exists $2 2>/dev/null && echo yes)),)
HOST_DEFINES += -D$3 $(shell pkg-config --cflags $2)
HOST_LIBS    += $(shell pkg-config --libs $2)
endif
endef
$(eval $(call host_library,libpng,libpng,QTRI_HAVE_LIBPNG))
$(eval $(call host_library,stb,stb,QTRI_HAVE_STB))
$(eval $(call host_library,assimp,assimp,QTRI_HAVE_ASSIMP))
$(eval $(call host_library,freetype,freetype2,QTRI_HAVE_FREETYPE))

# Debian's package of libmeshoptimizer brings no file for pkg-config: whether it links is tried.
ifneq ($(filter meshoptimizer,$(WITH)),)
ifeq ($(shell echo 'int main(void) { return 0; }' | $(CC) -x c -include meshoptimizer.h - -o /dev/null -lmeshoptimizer 2>/dev/null && echo yes),yes)
HOST_DEFINES += -DQTRI_HAVE_MESHOPTIMIZER
HOST_LIBS    += -lmeshoptimizer
endif
endif

$(BUILD)/obj/host/assets/%.o: INCLUDES += $(HOST_DEFINES)

# For who links the host's library by other means than make, as the gate of packages does.
.PHONY: host-libs
host-libs:
	@echo '$(HOST_LIBS)'

# gear.h of the README, and its sample and those of core/HOWTO.md, word for word, for tests/test_readme.c ------------------

README_DIR := $(BUILD)/readme

$(README_DIR)/gear.h: $(BUILD)/qtri
	@mkdir -p $(@D)
	@$(BUILD)/qtri mesh gear -o $@ >/dev/null

$(README_DIR)/sample.c: README.md
	@mkdir -p $(@D)
	@awk '/^```c$$/ { on = 1; next } /^```$$/ { on = 0 } on' README.md >$@
	@echo 'const qtri_mesh *readme_gear(void); const qtri_mesh *readme_gear(void) { return &gear; }' >>$@

$(README_DIR)/sample.o: $(README_DIR)/sample.c $(README_DIR)/gear.h $(BUILD)/flags
	$(call run,compile $<)$(CC) -std=c99 $(CFLAGS) -Wall -Wextra $(INCLUDES) -I$(README_DIR) -c -o $@ $<

$(README_DIR)/howto.o: core/HOWTO.md $(BUILD)/flags
	@mkdir -p $(@D)
	@{ echo '#include "qtri.h"'; awk '/^```c$$/ { on = 1; next } /^```$$/ { on = 0 } on' core/HOWTO.md; } >$(@:.o=.c)
	$(call run,compile $(@:.o=.c))$(CC) -std=c99 $(CFLAGS) -Wall -Wextra $(INCLUDES) -c -o $@ $(@:.o=.c)

$(BUILD)/tests/test_readme: $(BUILD)/obj/tests/test_readme.o $(README_DIR)/sample.o $(README_DIR)/howto.o $(HELPERS) $(HOST) $(LIBRARY)
	@mkdir -p $(@D)
	$(call run,link $@)$(CC) $(CFLAGS) $(LDFLAGS) -o $@ $^ -lcmocka -lm $(HOST_LIBS)
