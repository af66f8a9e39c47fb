# Libraries that read files and work on meshes for the commands `qtri mesh` and `qtri texture`. Each is used where it is
# installed; without it the command is built all the same and says what it therefore cannot do. WITH= builds without any.

WITH ?= libpng assimp meshoptimizer

HOST_DEFINES :=
HOST_LIBS    :=

ifneq ($(filter libpng,$(WITH)),)
ifeq ($(shell pkg-config --exists libpng 2>/dev/null && echo yes),yes)
HOST_DEFINES += -DQTRI_HAVE_LIBPNG $(shell pkg-config --cflags libpng)
HOST_LIBS    += $(shell pkg-config --libs libpng)
endif
endif

ifneq ($(filter assimp,$(WITH)),)
ifeq ($(shell pkg-config --exists assimp 2>/dev/null && echo yes),yes)
HOST_DEFINES += -DQTRI_HAVE_ASSIMP $(shell pkg-config --cflags assimp)
HOST_LIBS    += $(shell pkg-config --libs assimp)
endif
endif

# Debian's package of libmeshoptimizer brings no file for pkg-config: whether it links is tried.
ifneq ($(filter meshoptimizer,$(WITH)),)
ifeq ($(shell echo 'int main(void) { return 0; }' | $(CC) -x c -include meshoptimizer.h - -o /dev/null -lmeshoptimizer 2>/dev/null && echo yes),yes)
HOST_DEFINES += -DQTRI_HAVE_MESHOPTIMIZER
HOST_LIBS    += -lmeshoptimizer
endif
endif

$(BUILD)/obj/host/assets/%.o: INCLUDES += $(HOST_DEFINES)
