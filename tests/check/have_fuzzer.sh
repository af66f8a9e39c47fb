#!/bin/sh
# SPDX-License-Identifier: MIT
# Succeeds where clang can link a libFuzzer program.
program=$(mktemp) || exit 1
trap 'rm -f "$program"' EXIT
echo 'int LLVMFuzzerTestOneInput(const char *d, unsigned long n); int LLVMFuzzerTestOneInput(const char *d, unsigned long n) { return d && n > 9; }' |
    clang -fsanitize=fuzzer,address,undefined -x c - -o "$program" >/dev/null 2>&1
