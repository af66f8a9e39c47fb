#!/bin/sh
# SPDX-License-Identifier: MIT
# The library compiled for a Cortex-M0+ without a libc: what its objects need, hold and export.
gate=freestanding
. tests/check/files.sh
need arm-none-eabi-gcc arm-none-eabi-nm arm-none-eabi-size

# What GCC may call in integer code: memory functions, 64-bit shifts, products, quotients and comparisons, counts
# of zeros, jump tables. Whatever else is undefined (soft float, malloc, libm, stdio) is a finding.
allowed='mem(cpy|set|move)|__aeabi_mem(cpy|set|clr|move)[48]?|__aeabi_(lmul|llsl|llsr|lasr|u?ldivmod|u?idiv|u?idivmod|u?lcmp)'
allowed="$allowed|__(clz|ctz|popcount)[sd]i2|__(mul|u?div|u?mod)[sd]i3|__gnu_thumb1_case_(sqi|uqi|shi|uhi|si)"

work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
status=0
for file in $(c_files core port/panels | grep '\.c$'); do
    arm-none-eabi-gcc -std=c99 -Os -mcpu=cortex-m0plus -mthumb -ffreestanding -Icore/include -Iport/include \
        -c -o "$work/$(echo "$file" | tr / -).o" "$file" || status=1
done

# symbols OPTION...: a line `object: symbol` for each
symbols()
{
    for object in "$work"/*.o; do
        arm-none-eabi-nm "$@" "$object" | awk -v object="$(basename "$object" .o)" '{ print object ": " $NF }'
    done
}
symbols -g --defined-only >"$work/exports"
symbols --undefined-only >"$work/needs"

findings=$(
    awk 'NR == FNR { have[$2]; next } !($2 in have)' "$work/exports" "$work/needs" |
        grep -vE ": ($allowed)\$" | sed 's/: /: needs /'
    grep -vE ': (qtri_|q16_)' "$work/exports" | sed 's/: /: exports /'
    arm-none-eabi-size "$work"/*.o | awk 'NR > 1 && $2 + $3 > 0 { n = split($6, part, "/")
        print part[n] ": " $2 + $3 " bytes of writable static data" }'
)
[ -z "$findings" ] || { printf '%s\n' "$findings"; status=1; }
[ -s "$work/exports" ] || { echo "nothing was compiled"; status=1; }
finish $status
