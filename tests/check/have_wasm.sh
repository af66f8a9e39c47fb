#!/bin/sh
# SPDX-License-Identifier: MIT
# Whether clang can build for WebAssembly: it needs lld, wasi-libc and its own builtins for that.
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
echo 'int main(void) { return 0; }' | clang --target=wasm32-wasi -x c -o "$work/program" - 2>/dev/null
