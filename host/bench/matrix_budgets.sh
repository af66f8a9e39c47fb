#!/bin/sh
# SPDX-License-Identifier: MIT
# Prints the table of the matrix's budgets, as host/bench/matrix-budgets.tsv has it, from what `make bench-matrix` left in a
# folder: matrix_budgets.sh BUILD   (called by `make matrix-budgets` and by the gate tests/check/matrix.sh)
# A line for each case, a column of instructions for each core.
set -eu

# Counts only repeat with one compiler.
echo "# arm $(arm-none-eabi-gcc --version | head -n 1)"
awk -F '\t' -v OFS='\t' '
    NR == 1 { next }
    !($1 in seen) { seen[$1]; name[++cases] = $1 }
    !($2 in known) { known[$2]; core[++cores] = $2 }
    { instructions[$1, $2] = $3 }
    END {
        line = "case"
        for (c = 1; c <= cores; c++) line = line OFS core[c]
        print line
        for (n = 1; n <= cases; n++) {
            line = name[n]
            for (c = 1; c <= cores; c++) line = line OFS instructions[name[n], core[c]]
            print line
        }
    }' "$1/matrix.tsv"
