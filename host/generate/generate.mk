# SPDX-License-Identifier: MIT
# Tables that programs print. Included by the main Makefile.

GENERATE_DIR := $(BUILD)/generate

.PHONY: tables
tables: ## Write core/math/coefficients.h anew: the polynomials of the elementary functions
	@mkdir -p $(GENERATE_DIR)
	$(CC) -std=c99 $(CFLAGS) -o $(GENERATE_DIR)/coefficients $(wildcard host/generate/coefficients*.c) -lm
	$(GENERATE_DIR)/coefficients >$(GENERATE_DIR)/coefficients.h
	mv $(GENERATE_DIR)/coefficients.h core/math/coefficients.h

# A test compares what it prints with the file.
$(HELPERS): $(call objects,host/generate/coefficients.c)
