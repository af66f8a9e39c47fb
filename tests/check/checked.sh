#!/bin/sh
# SPDX-License-Identifier: MIT
# A library with QTRI_CHECKED stops at mistakes (checked.c) and nowhere else: correct programs draw what they draw without.
# Q16() of a variable does not compile, so that no floating point is linked by mistake, and neither does drawing where int
# has 16 bits.
gate=checked
. tests/check/files.sh
need gcc arm-none-eabi-gcc

build=${BUILD:-build}
flags='-std=c99 -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Wundef -Werror -Icore/include -Iport/include'
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
status=0
root=$(pwd)

# build NAME PROGRAM FLAGS...
build()
{
    name=$1 program=$2
    shift 2
    ls core/*/*.c port/panels/*.c | objects "$work/$name" gcc $flags -I"$root/core/include" -I"$root/port/include" "$@" &&
        gcc $flags "$@" -o "$work/$name/program" "$program" "$work/$name"/*.o
}

build fault tests/check/checked.c -DQTRI_CHECKED -DQTRI_FAULT=checked_fault -DQTRI_MISSING=checked_missing || finish 1
"$work/fault/program" >"$work/mistakes" || { cat "$work/mistakes"; status=1; }
build checked tests/check/options.c -DQTRI_CHECKED || finish 1
plain_build "$build/libqtri.a" || finish 1
gcc $flags -o "$work/plain" tests/check/options.c "$build/libqtri.a" && "$work/plain" >"$work/wanted" || status=1
"$work/checked/program" >"$work/got" || status=1
cmp "$work/wanted" "$work/got" || status=1

# A firmware without a C library, where what stops is a trap.
for file in core/draw/checked.c core/raster/checked_material.c core/frame/surface.c port/panels/panel.c; do
    arm-none-eabi-gcc -ffreestanding -mcpu=cortex-m0plus -mthumb $flags -DQTRI_CHECKED -c -o "$work/object" $file || status=1
    arm-none-eabi-nm -u "$work/object" | grep -i assert && status=1
done

# The names of checks are in nothing that is not checked.
nm "$build/libqtri.a" | grep -E 'qtri_check_|qtri_fault|qtri_prepared_reset|qtri_paint_[a-z]*_part|_scale_any' && { echo "checks in a library that is not checked"; status=1; }

echo '#include <qtri/q16.h>
q16 literal(void);
q16 literal(void) { return Q16(-0.5) + Q16(60); }' >"$work/literal.c"
echo '#include <qtri/q16.h>
q16 variable(int x);
q16 variable(int x) { return Q16(x); }' >"$work/variable.c"
for compiler in gcc clang arm-none-eabi-gcc avr-gcc; do
    command -v $compiler >/dev/null || continue
    $compiler $flags -c -o "$work/object" "$work/literal.c" || status=1
    $compiler $flags -c -o "$work/object" "$work/variable.c" 2>/dev/null && {
        echo "$compiler compiles Q16() of a variable"
        status=1
    }
done

# Where int has 16 bits there are the mathematics and the transforms, and a clear word against the rest.
if command -v avr-gcc >/dev/null; then
    for header in q16 vec mat quat transform surface draw frame; do
        echo "#include <qtri/$header.h>" >"$work/header.c"
        avr-gcc -mmcu=atmega1284p -std=c99 -Icore/include -c -o "$work/object" "$work/header.c" 2>"$work/said"
        case $?$header in
        0surface | 0draw | 0frame) echo "$header.h compiles where int has 16 bits"; status=1 ;;
        1surface | 1draw | 1frame) grep -q 'error "qtri draws where int' "$work/said" || { cat "$work/said"; status=1; } ;;
        1*) cat "$work/said"; status=1 ;;
        esac
    done
else
    echo "checked: skipped: avr-gcc not installed (make setup-all)"
fi
finish $status
