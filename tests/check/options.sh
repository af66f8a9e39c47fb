#!/bin/sh
# SPDX-License-Identifier: MIT
# The library without each option of config.h, and without all of them: it compiles without a warning, and what is left
# draws the pixels of the whole library (options.c).
gate=options
. tests/check/files.sh
need gcc

flags='-std=c99 -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Wundef -Werror -Icore/include'
all=$(sed -n 's/^#define QTRI_WITH_\([A-Z0-9_]*\) 1$/\1/p' core/include/qtri/config.h)
[ -n "$all" ] || { echo "no option found"; finish 1; }
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
status=0
root=$(pwd)
library=${BUILD:-build}/libqtri.a

# What the preprocessor leaves of every file of core, as lines `file<tab>line`: preprocessed FLAG...
preprocessed()
{
    ls core/*/*.c | xargs gcc $flags "$@" -E | awk -v OFS='\t' '
        /^# [0-9]+ "core\/.*\.c"$/ { file = substr($3, 2, length($3) - 2) }
        !/^#/ && NF { print file, $0 }'
}

# build NAME OPTION...: a program of the library without these. Where the preprocessor leaves of a file what it leaves in
# the whole library, which is that of make, its object is that.
build()
{
    folder=$work/$1
    shift
    defines=$(printf ' -DQTRI_WITH_%s=0' "$@")
    mkdir "$folder"
    preprocessed $defines >"$folder/preprocessed" || finish 1
    diff "$work/preprocessed" "$folder/preprocessed" | sed -n 's/^[<>] \([^\t]*\)\t.*/\1/p' | sort -u >"$folder/differ"
    cp "$library" "$folder/rest.a"
    ar d "$folder/rest.a" $(sed 's,.*/,,; s,c$,o,' "$folder/differ") &&
        objects "$folder" gcc $flags -I"$root/core/include" $defines <"$folder/differ" &&
        gcc $flags $defines -o "$folder/program" tests/check/options.c "$folder"/*.o "$folder/rest.a" || finish 1
}

# A line `NAME OPTION...` for each library.
{
    for option in $all; do echo "$option $option"; done
    [ "$(echo "$all" | wc -l)" = 1 ] || echo nothing $all
} >"$work/list"
preprocessed >"$work/preprocessed" || finish 1
plain_build "$library" && mkdir "$work/whole" && gcc $flags -o "$work/whole/program" tests/check/options.c "$library" || finish 1
while read -r name options; do build "$name" $options; done <"$work/list"

while read -r name options; do
    "$work/$name/program" >"$work/$name.got" && "$work/whole/program" $options >"$work/$name.wanted" || status=1
    diff "$work/$name.wanted" "$work/$name.got" >"$work/diff" || {
        echo "without $options:"
        head -6 "$work/diff"
        status=1
    }
done <"$work/list"
[ "$("$work/whole/program" | sort -u | wc -l)" -gt 60 ] || { echo "too few pictures"; status=1; }
finish $status
