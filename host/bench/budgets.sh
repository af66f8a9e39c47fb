#!/bin/sh
# SPDX-License-Identifier: MIT
# Prints the table of budgets, as host/bench/budgets.tsv has it, from what `make bench` and `make size` left in a folder:
# budgets.sh BUILD   (called by `make budgets` and by the gate tests/check/budgets.sh)
set -eu
build=$1

# `# arm VERSION`: counts only repeat with one compiler.
for tool in arm-none-eabi-gcc riscv64-unknown-elf-gcc; do
    if command -v "$tool" >/dev/null 2>&1; then
        echo "# ${tool%%[-0-9]*} $("$tool" --version | head -n 1)"
    fi
done
printf 'what\tcore\tbudget\n'
awk -F '\t' -v OFS='\t' 'NR > 1 { print $1, $2, $3 }' "$build/bench.tsv"
# Code includes constants.
awk -F '\t' -v OFS='\t' 'NR > 1 {
    print $1 "-" $3 " code", $2, $4 + $5
    print $1 "-" $3 " static_ram", $2, $6
    print $1 "-" $3 " stack", $2, $7 }' "$build/size.tsv"
