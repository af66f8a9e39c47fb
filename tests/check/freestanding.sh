#!/bin/sh
# SPDX-License-Identifier: MIT
# The library compiled for a Cortex-M0+ without a libc: what its objects need, hold and export. gcc's objects of core are
# those of the benchmarks. clang compiles it without a warning for three cores: each may have inline assembler of its own,
# which clang assembles itself.
gate=freestanding
. tests/check/files.sh
need clang arm-none-eabi-gcc arm-none-eabi-nm arm-none-eabi-size

# What GCC may call in integer code: memory functions, 64-bit shifts, products, quotients and comparisons, counts
# of zeros, jump tables. Whatever else is undefined (soft float, malloc, libm, stdio) is a finding.
allowed='mem(cpy|set|move)|__aeabi_mem(cpy|set|clr|move)[48]?|__aeabi_(lmul|llsl|llsr|lasr|u?ldivmod|u?idiv|u?idivmod|u?lcmp)'
allowed="$allowed|__(clz|ctz|popcount)[sd]i2|__(mul|u?div|u?mod)[sd]i3|__gnu_thumb1_case_(sqi|uqi|shi|uhi|si)"

library=$(pwd)/${BUILD:-build}/bench/scenes/cortex-m0plus-Os/libqtri.a
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
status=0
warnings="$(make -s warnings CC=clang) -Werror"

core_libraries cortex-m0plus-Os || finish 1
sh port/packages/dist.sh "$work/dist" >"$work/log" 2>&1 || { cat "$work/log"; finish 1; }
mkdir "$work/gcc" "$work/clang-cortex-m0plus" "$work/clang-cortex-m4" "$work/clang-cortex-m3"
root=$(pwd)
(cd "$work/gcc" && arm-none-eabi-ar x "$library" &&
    arm-none-eabi-gcc -std=c99 -ffreestanding -Os -mcpu=cortex-m0plus -mthumb -I"$root/core/include" -I"$root/port/include" -c "$root"/port/panels/*.c) ||
    finish 1
# clang's are of the library in one file: it takes longer to begin than to compile most of the others. There a static name
# of one file may be a parameter's of another.
clang="clang --target=arm-none-eabi -mthumb -std=c99 -ffreestanding $warnings -Wno-shadow -idirafter port/boards/common/libc"
xargs -P "$jobs" -L 1 $clang -c "$work/dist/single/qtri.c" -o <<END || status=1
$work/clang-cortex-m0plus/qtri.o -mcpu=cortex-m0plus -Os
$work/clang-cortex-m4/qtri.o -mcpu=cortex-m4 -mfloat-abi=hard -O1
$work/clang-cortex-m3/qtri.o -mcpu=cortex-m3 -O0
END

# symbols FOLDER OPTION...: a line `object: symbol` for each
symbols()
{
    (cd "$work/$1" && arm-none-eabi-nm -A $2 $3 *.o) | awk '{ object = $1; sub(/\.o:.*/, "", object); print object ": " $NF }'
}

# What is wrong with the objects of a folder.
findings()
{
    symbols "$1" -g --defined-only >"$work/exports"
    symbols "$1" --undefined-only >"$work/needs"
    awk 'NR == FNR { have[$2]; next } !($2 in have)' "$work/exports" "$work/needs" |
        grep -vE ": ($allowed)\$" | sed 's/: /: needs /'
    grep -vE ': (qtri_|q16_)' "$work/exports" | sed 's/: /: exports /'
    arm-none-eabi-size "$work/$1"/*.o | awk 'NR > 1 && $2 + $3 > 0 { n = split($6, part, "/")
        print part[n] ": " $2 + $3 " bytes of writable static data" }'
    [ -s "$work/exports" ] || echo "nothing was compiled"
}
for folder in gcc clang-cortex-m0plus clang-cortex-m4; do
    findings $folder >"$work/found"
    [ ! -s "$work/found" ] || { sed "s/^/$folder: /" "$work/found"; status=1; }
done
finish $status
