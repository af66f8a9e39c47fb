#!/bin/sh
# SPDX-License-Identifier: MIT
# No figure of `make bench` and `make size` is more than 2 % above its budget in host/bench/budgets.tsv, which `make budgets`
# writes. Counts repeat exactly with one compiler; with another version, differences are told but do not fail.
gate=budgets
. tests/check/files.sh
table=host/bench/budgets.tsv

# Benchmarks skip the cores of a tool that is missing, whichever it is, name it, and skip no others.
tools='arm-none-eabi-gcc qemu-system-arm riscv64-unknown-elf-gcc qemu-system-riscv32'
unset MAKEFLAGS MFLAGS # of the make that runs the gates: they name a job server that this one is not given
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
mkdir "$work/path"
(IFS=:; for folder in $PATH; do ln -s "$folder"/* "$work/path/" 2>/dev/null; done)
for tool in $tools; do
    rm -f "$work/path/$tool"
    ln -s "$(command -v true)" "$work/path/$tool"
done
for tool in $tools; do
    rm "$work/path/$tool"
    PATH=$work/path make -n bench-math bench-profile size PROFILE_CORE="$(case $tool in *riscv*) echo rv32imc ;; *) echo cortex-m3 ;; esac)" |
        sed -n 's/^echo "\(.*\)"$/\1/p' >"$work/skipped"
    ln -s "$(command -v true)" "$work/path/$tool"
    case $tool in
    *riscv*) wanted='bench-math: skipped: rv32imc:|bench-profile: skipped: rv32imc:' ;;
    *) wanted='bench-math: skipped: cortex-m0plus cortex-m3 cortex-m4 cortex-m7:|bench-profile: skipped: cortex-m3:|size: skipped: cortex-m0plus cortex-m3 cortex-m4:' ;;
    esac
    echo "$wanted" | tr '|' '\n' | sed "s/\$/ $tool not installed (make setup-all)/" | cmp -s - "$work/skipped" || {
        echo "check: budgets: without $tool the benchmarks say: $(cat "$work/skipped")"
        finish 1
    }
done

for tool in arm-none-eabi-gcc qemu-system-arm; do
    command -v "$tool" >/dev/null 2>&1 || {
        echo "check: $gate skipped: $tool is not installed (make setup-all)"
        exit 0
    }
done
[ -f "$table" ] || { echo "check: $gate skipped: there is no $table (make budgets)"; exit 0; }

# Every core of the table takes half an hour: BUDGET_CORES=all compares them all.
cores=${BUDGET_CORES:-cortex-m0plus cortex-m3 cortex-m0plus-Os cortex-m3-Os}
[ "$cores" != all ] || cores=
alone make -s bench size BENCH_SCENES= ${cores:+"BENCH_CORES=$cores"} >"$work/log" 2>&1 || { cat "$work/log"; finish 1; }
grep 'skipped' "$work/log" | sed 's/^/check: budgets: /'

sh host/bench/budgets.sh budgets "${BUILD:-build}" >"$work/now" || finish 1
awk -v target=budgets -f tests/check/budgets.awk "$table" "$work/now" >"$work/findings"
status=$?
sed 's/^/check: budgets: /' "$work/findings"
finish $status
