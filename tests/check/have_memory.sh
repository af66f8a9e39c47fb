#!/bin/sh
# SPDX-License-Identifier: MIT
# Succeeds where clang can build and run with its sanitizer for memory that was never written; says so where it cannot.
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
echo 'int main(void) { return 0; }' >"$work/empty.c"
command -v clang >/dev/null && clang -fsanitize=memory -o "$work/empty" "$work/empty.c" 2>/dev/null && "$work/empty" && exit 0
echo "test-narrow: without a sanitizer: no clang with -fsanitize=memory (make setup-all)"
exit 1
