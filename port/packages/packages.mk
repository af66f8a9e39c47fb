# SPDX-License-Identifier: MIT
# Packages: what is installed, what is made for others to copy. Included by the main Makefile.

PREFIX     ?= /usr/local
export QTRI_URL
LIBDIR     ?= $(PREFIX)/lib
INCLUDEDIR ?= $(PREFIX)/include
DIST       := $(BUILD)/dist

# The options that the library was built with, for who compiles against it.
QTRI_VERSION := $(shell sh port/packages/version.sh)
QTRI_OPTIONS := $(filter -DQTRI_WITH_%,$(CFLAGS))

.PHONY: install uninstall dist dist-arduino
install: $(LIBRARY) ## Install library, headers and qtri.pc below PREFIX (and DESTDIR)
	@mkdir -p $(DESTDIR)$(LIBDIR)/pkgconfig $(DESTDIR)$(INCLUDEDIR)/qtri $(DESTDIR)$(INCLUDEDIR)/qtri_port
	cp $(LIBRARY) $(DESTDIR)$(LIBDIR)/
	cp core/include/qtri.h $(DESTDIR)$(INCLUDEDIR)/
	cp core/include/qtri/*.h $(DESTDIR)$(INCLUDEDIR)/qtri/
	mkdir -p $(DESTDIR)$(INCLUDEDIR)/qtri/body
	cp core/include/qtri/body/*.h $(DESTDIR)$(INCLUDEDIR)/qtri/body/
	cp port/include/qtri_port/*.h $(DESTDIR)$(INCLUDEDIR)/qtri_port/
	sed -e 's|@prefix@|$(PREFIX)|; s|@libdir@|$(LIBDIR)|; s|@includedir@|$(INCLUDEDIR)|' \
	    -e 's|@version@|$(QTRI_VERSION)|; s|@options@|$(QTRI_OPTIONS:%= %)|' \
	    port/packages/qtri.pc.in >$(DESTDIR)$(LIBDIR)/pkgconfig/qtri.pc

uninstall: ## Remove what `make install` put there
	rm -f $(DESTDIR)$(LIBDIR)/libqtri.a $(DESTDIR)$(LIBDIR)/pkgconfig/qtri.pc $(DESTDIR)$(INCLUDEDIR)/qtri.h
	rm -rf $(DESTDIR)$(INCLUDEDIR)/qtri $(DESTDIR)$(INCLUDEDIR)/qtri_port

dist: ## Make build/dist: the library as one qtri.h and qtri.c, and as a library for the Arduino IDE
	@sh port/packages/dist.sh $(DIST)

dist-arduino: ## Make build/dist/arduino/qtri, and check what the Library Manager asks for: QTRI_URL=https://...
	@sh port/packages/dist.sh $(DIST)
	@grep -q '^url=https://' $(DIST)/arduino/qtri/library.properties || \
	    { echo "library.properties: no url: sh port/packages/url.sh https://..., or QTRI_URL=https://..."; exit 1; }
