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

# compile FOLDER COMMAND...: an object of every file that standard input names
compile()
{
    into=$work/$1
    shift
    mkdir -p "$into"
    xargs -r -P "$jobs" -n 2 sh -c 'into=$1 command=$2; shift 2; for file; do
        $command -c -o "$into/$(echo "$file" | tr / -).o" "$file" || { echo "no object of $file by $command"; failed=1; }; done
        exit ${failed:-0}' sh "$into" "$* -std=c99 -ffreestanding -Icore/include -Iport/include" || status=1
}
core_libraries cortex-m0plus-Os || finish 1
ls port/panels/*.c | compile gcc arm-none-eabi-gcc -Os -mcpu=cortex-m0plus -mthumb
(cd "$work/gcc" && arm-none-eabi-ar x "$library") || finish 1
clang="clang --target=arm-none-eabi -mthumb $warnings -idirafter port/boards/common/libc"
ls core/*/*.c port/panels/*.c | compile clang-cortex-m0plus $clang -mcpu=cortex-m0plus -Os
ls core/*/*.c port/panels/*.c | compile clang-cortex-m4 $clang -mcpu=cortex-m4 -mfloat-abi=hard -O1
ls core/*/*.c port/panels/*.c | compile clang-cortex-m3 $clang -mcpu=cortex-m3 -O0

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
