#!/bin/sh
# SPDX-License-Identifier: MIT
# The page of host/web in Chromium, opened as a file: its pictures and headers are, byte for byte, those of the command,
# wrong files are refused in words, nothing goes to the console or the network. Skipped where a tool is missing:
# Chromium is too large for `make setup-all`.
gate=web
. tests/check/files.sh
need make

chromium=$(command -v chromium || command -v chromium-browser || command -v google-chrome)
[ -n "$chromium" ] && command -v node >/dev/null && sh tests/check/have_wasm.sh && pkg-config --exists assimp stb || {
    echo "check: $gate skipped, it needs chromium, nodejs, clang, lld, wasi-libc, libclang-rt-14-dev-wasm32 and what make setup installs"
    exit 0
}

build=${BUILD:-build}
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
make -s "$build/qtri" web >"$work/log" || { cat "$work/log"; finish 1; }
node tests/tools/web.js "$chromium" "$build/web" "$build/qtri" "$work"
finish $?
