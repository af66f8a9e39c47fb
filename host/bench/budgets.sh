#!/bin/sh
# SPDX-License-Identifier: MIT
# Prints a table of budgets: budgets.sh budgets|matrix-budgets BUILD   (called by `make budgets`, `make matrix-budgets` and
# the gates): host/bench/budgets.tsv from what `make bench` and `make size` left in a folder, matrix-budgets.tsv from what
# `make bench-matrix` did. A line for each figure, a column for each core, `-` where it was not counted.
set -eu
table=$1 build=$2

# Lines `figure core number`. Code includes constants.
figures()
{
    if [ "$table" = matrix-budgets ]; then
        awk -F '\t' -v OFS='\t' 'NR > 1 { print $1, $2, $3 }' "$build/matrix.tsv"
        return
    fi
    awk -F '\t' -v OFS='\t' 'NR > 1 { print $1, $2, $3 }' "$build/bench.tsv"
    awk -F '\t' -v OFS='\t' 'NR > 1 {
        print $1 "-" $3 " code", $2, $4 + $5
        print $1 "-" $3 " static_ram", $2, $6
        print $1 "-" $3 " stack", $2, $7 }' "$build/size.tsv"
}

# `# arm VERSION`: counts only repeat with one compiler.
for tool in arm-none-eabi-gcc riscv64-unknown-elf-gcc; do
    if command -v "$tool" >/dev/null 2>&1; then
        echo "# ${tool%%[-0-9]*} $("$tool" --version | head -n 1)"
    fi
done
figures | awk -F '\t' '
    !($1 in seen) { seen[$1]; name[++names] = $1 }
    !($2 in known) { known[$2]; core[++cores] = $2 }
    { figure[$1, $2] = $3 }
    END {
        printf "what"
        for (c = 1; c <= cores; c++) printf "\t%s", core[c]
        print ""
        for (n = 1; n <= names; n++) {
            printf "%s", name[n]
            for (c = 1; c <= cores; c++) printf "\t%s", (name[n], core[c]) in figure ? figure[name[n], core[c]] : "-"
            print ""
        }
    }'
