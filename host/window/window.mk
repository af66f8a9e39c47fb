# SPDX-License-Identifier: MIT
# A window that shows a scene, a model or an example: needs SDL2. Included by the main Makefile, behind examples.mk.

SCENE   ?=
EXAMPLE ?=
# A model that is no OBJ is shown as the example `mesh` shows it.
window_example := $(or $(EXAMPLE),$(if $(filter-out %.obj,$(MODEL)),mesh))
window_scene   := $(or $(SCENE),$(filter %.obj,$(MODEL)))

WINDOW_DIR := $(BUILD)/window
window_program = $(WINDOW_DIR)/$(if $(window_example),example-$(window_example),scene)
SDL_CFLAGS  = $(shell pkg-config --cflags sdl2)
SDL_LIBS    = $(shell pkg-config --libs sdl2)
window_screen := $(call objects,host/window/screen.c)

$(WINDOW_DIR)/scene: $(call objects,host/window/window_scene.c) $(window_screen) $(HOST) $(LIBRARY)
	@mkdir -p $(@D)
	$(call run,link $@)$(CC) $(CFLAGS) $(LDFLAGS) -o $@ $^ $(SDL_LIBS) -lm $(HOST_LIBS)

define window_rules
$(WINDOW_DIR)/example-$1: $(call objects,$(call example_sources,$1) port/examples/display.c host/window/window_example.c) $(window_screen) $(HOST) $(LIBRARY)
	@mkdir -p $$(@D)
	$$(call run,link $$@)$$(CC) $$(CFLAGS) $$(LDFLAGS) -o $$@ $$^ $$(SDL_LIBS) -lm $$(HOST_LIBS)
endef
$(foreach e,$(EXAMPLES),$(eval $(call window_rules,$e)))

.PHONY: window
window: ## Look at it in a window: SCENE=host/scenes/09-floor.scene, MODEL=cow.obj or EXAMPLE=terrain; needs SDL2
	@pkg-config --exists sdl2 2>/dev/null || { echo 'window: SDL2 is not installed, or pkg-config: apt-get install libsdl2-dev pkg-config' >&2; exit 1; }
	@[ -n '$(window_example)$(window_scene)' ] || { echo 'window: what is to be seen? SCENE=FILE, MODEL=FILE or EXAMPLE=$(firstword $(EXAMPLES)) ($(EXAMPLES))' >&2; exit 2; }
	@[ -z '$(window_example)' ] || [ -n '$(filter $(window_example),$(EXAMPLES))' ] || { echo 'window: EXAMPLE is one of $(EXAMPLES)' >&2; exit 2; }
	@$(MAKE) -s $(window_program)
	@$(window_program) $(if $(window_example),$(example_display_$(window_example)),$(window_scene) --folder $(WINDOW_DIR))
