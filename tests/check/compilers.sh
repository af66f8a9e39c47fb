#!/bin/sh
# SPDX-License-Identifier: MIT
# A plain C99 compiler, tcc, builds the library and the command, and its pictures are gcc's to the bit.
gate=compilers
. tests/check/files.sh
need gcc tcc cmp

work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
status=0

for compiler in gcc tcc; do
    mkdir "$work/$compiler"
    $compiler -std=c99 -O2 -Icore/include -Iport/include -o "$work/$compiler/qtri" \
        core/*/*.c host/assets/*.c host/io/*.c host/reference/*.c host/tools/*.c -lm || finish 1
    for scene in 03-colour-triangle 05-crossing 09-floor; do
        "$work/$compiler/qtri" render host/scenes/$scene.scene -o "$work/$compiler/$scene" --dump || status=1
    done
done
for file in "$work"/gcc/*.ppm "$work"/gcc/*.id "$work"/gcc/*.depth; do
    cmp "$file" "$work/tcc/${file##*/}" || status=1
done
finish $status
