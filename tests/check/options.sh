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

# One file of one library. Where the preprocessor leaves what it leaves of it in the whole library, its object is that.
cat >"$work/compile" <<'END'
folder=$1 whole=$2 file=$3
shift 3
object=$(echo "$file" | tr / -)
gcc "$@" -E -P -o "$folder/$object.i" "$file" || exit 1
if [ "$folder" != "$whole" ] && cmp -s "$folder/$object.i" "$whole/$object.i"; then
    cp "$whole/$object.o" "$folder/$object.o"
else
    gcc "$@" -c -o "$folder/$object.o" "$file"
fi
END

# build NAME OPTION...: a program of the library without these
build()
{
    folder=$work/$1
    shift
    defines=$(printf ' -DQTRI_WITH_%s=0' "$@")
    [ $# != 0 ] || defines=
    mkdir "$folder"
    ls core/*/*.c tests/check/options.c |
        xargs -P "$jobs" -I FILE sh "$work/compile" "$folder" "$work/whole" FILE $flags $defines || finish 1
    gcc -o "$folder/program" "$folder"/*.o || finish 1
}

# A line `NAME OPTION...` for each library.
{
    for option in $all; do echo "$option $option"; done
    [ "$(echo "$all" | wc -l)" = 1 ] || echo nothing $all
} >"$work/list"
build whole
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
