#!/bin/sh
# SPDX-License-Identifier: MIT
# Bytes of code and constants of core/math: size_math.sh FOLDER TABLE.tsv CORE...   (called by `make size-math`)
# FOLDER/size-CORE/ holds the objects. Writes `object core bytes` and prints it; "everything" and the program are linked, so
# that they include what the compiler's library adds (64-bit division).
set -eu
folder=$1 table=$2
shift 2

# Links a program that uses the functions named, and nothing that they do not need; prints its bytes.
linked()
{
    core=$1
    shift
    arm-none-eabi-gcc -mcpu="$core" -mthumb -nostdlib -Wl,--gc-sections -Wl,--entry="$1" \
        $(printf ' -Wl,--undefined=%s' "$@") -o "$folder/size-$core/program" "$folder/size-$core"/*.o \
        "$folder/size-$core/memory/memory.o" -lgcc
    arm-none-eabi-size "$folder/size-$core/program" | awk 'NR == 2 { print $1 + $2 }'
}

printf 'object\tcore\tbytes\n' >"$table"
for core; do
    objects=$folder/size-$core
    mkdir -p "$objects/memory"
    arm-none-eabi-gcc -mcpu="$core" -mthumb -std=c99 -Os -ffreestanding -ffunction-sections \
        -fno-tree-loop-distribute-patterns -c -o "$objects/memory/memory.o" port/boards/common/memory.c
    arm-none-eabi-size "$objects"/*.o | awk -v core="$core" 'NR > 1 {
        sub(/.*\//, "", $6); sub(/\.o$/, "", $6); printf "%s\t%s\t%d\n", $6, core, $1 + $2 }' >>"$table"
    public=$(arm-none-eabi-nm -g --defined-only "$objects"/*.o | awk 'NF == 3 { print $3 }' | grep -oE '^(q16|qtri)_.*')
    scalar=$(printf '%s\n' "$public" | grep '^q16_')
    {
        printf 'everything, linked\t%s\t%s\n' "$core" "$(linked "$core" $public)"
        printf 'all of q16_*, linked\t%s\t%s\n' "$core" "$(linked "$core" $scalar)"
        for pair in 'q16_mul q16_sin' 'q16_mul q16_sin_deg'; do
            printf '%s\n' "$public" | grep -qx "${pair#* }" || continue
            printf 'program of %s\t%s\t%s\n' "$(echo $pair | sed 's/ / and /')" "$core" "$(linked "$core" $pair)"
        done
    } >>"$table"
done

awk -F '\t' -v cores="$*" '
    NR == 1 { next }
    { if (!($1 in seen)) name[++names] = $1; seen[$1]; bytes[$1, $2] = $3 }
    END {
        columns = split(cores, core, " ")
        printf "%-36s", "bytes of code and constants"
        for (c = 1; c <= columns; c++) printf "%20s", core[c] (core[c] == "cortex-m3" ? " -O2" : " -Os")
        print ""
        for (n = 1; n <= names; n++) {
            printf "%-36s", name[n]
            for (c = 1; c <= columns; c++) printf "%20s", bytes[name[n], core[c]]
            if (name[n] ~ /^everything/) printf "   (target: 6144 on cortex-m3)%s", (bytes[name[n], "cortex-m3"] > 6144 ? " !" : "")
            print ""
        }
    }' "$table"
