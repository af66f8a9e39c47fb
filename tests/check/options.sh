#!/bin/sh
# SPDX-License-Identifier: MIT
# The library without each option of config.h, and without all of them: it compiles without a warning, and what is left
# draws the pixels of the whole library (options.c).
gate=options
. tests/check/files.sh
need gcc

flags='-std=c99 -O1 -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Wundef -Werror -Icore/include'
all=$(sed -n 's/^#define QTRI_WITH_\([A-Z0-9_]*\) 1$/\1/p' core/include/qtri/config.h)
[ -n "$all" ] || { echo "no option found"; finish 1; }
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
status=0

# The mathematics has no options.
mkdir "$work/math"
ls core/bits/*.c core/math/*.c | xargs -P "$jobs" -n 8 sh -c 'to=$1; shift; for file; do gcc -std=c99 -O1 -Icore/include -c -o "$to/$(basename "$file" .c).o" "$file" || exit 1; done' \
    sh "$work/math" || finish 1

# build NAME OPTION...: a program of the library without these
cat >"$work/build" <<'END'
name=$1 folder=$2 flags=$3
shift 3
for option; do flags="$flags -DQTRI_WITH_$option=0"; done
mkdir "$folder/$name"
for file in core/draw/*.c core/frame/*.c core/geometry/*.c core/filter/*.c core/paint/*.c core/raster/*.c tests/check/options.c; do
    gcc $flags -c -o "$folder/$name/$(basename "$file" .c).o" "$file" || exit 1
done
gcc -o "$folder/$name/program" "$folder/$name"/*.o "$folder"/math/*.o
END

# A line `NAME OPTION...` for each library.
{
    echo whole
    for option in $all; do echo "$option $option"; done
    echo nothing $all
} >"$work/list"
while read -r name options; do
    echo "$name $work '$flags'${options:+ $options}"
done <"$work/list" | xargs -P "$jobs" -L 1 sh "$work/build" || finish 1

while read -r name options; do
    "$work/$name/program" >"$work/$name.got" && "$work/whole/program" $options >"$work/$name.wanted" || status=1
    diff "$work/$name.wanted" "$work/$name.got" >"$work/diff" || {
        echo "without $options:"
        head -6 "$work/diff"
        status=1
    }
done <"$work/list"
[ "$(sort -u "$work/whole.got" | wc -l)" -gt 60 ] || { echo "too few pictures"; status=1; }
finish $status
