#!/bin/sh
# SPDX-License-Identifier: MIT
# No cell of `make bench-matrix` costs more than twice the best cell of its class, so that what is fast is fast next door too
# (classes of host/bench/matrix-apart.tsv: as many times as it says), nor more than 2 % above its budget in
# host/bench/matrix-budgets.tsv, which `make matrix-budgets` writes. Counts repeat exactly with one compiler; with another
# version, differences from budgets are told but do not fail.
gate=matrix
. tests/check/files.sh
table=host/bench/matrix-budgets.tsv
apart=host/bench/matrix-apart.tsv
[ -f "$apart" ] || apart=/dev/null
build=${BUILD:-build}

for tool in arm-none-eabi-gcc qemu-system-arm; do
    command -v "$tool" >/dev/null 2>&1 || {
        echo "check: $gate skipped: $tool is not installed (make setup-all)"
        exit 0
    }
done

# The flags of the make that runs the gates name a job server that this one is not given.
unset MAKEFLAGS MFLAGS
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
alone make -s bench-matrix MATRIX_CASES= MATRIX_PRODUCT=named >"$work/log" 2>&1 || { cat "$work/log"; finish 1; }
grep -e 'skipped' -e 'no case' "$work/log" | sed 's/^/check: matrix: /'
status=0

awk -F '\t' '
    FILENAME != ARGV[2] { if ($0 !~ /^#/) known[$1] = $2; next }
    FNR == 1 { next }
    { most = $1 in known ? 1.02 * known[$1] : 2; classes++ }
    $7 > most { print $2 ", " $8 ": " $6 " instructions a pixel, " $7 " times the best of " $1; failed = 1 }
    END {
        if (!classes) { print "nothing was measured"; failed = 1 }
        exit failed
    }' "$apart" "$build/matrix-classes.tsv" >"$work/findings" || status=1

if [ -f "$table" ]; then
    sh host/bench/budgets.sh matrix-budgets "$build" >"$work/now" || finish 1
    awk -v target=matrix-budgets -f tests/check/budgets.awk "$table" "$work/now" >>"$work/findings" || status=1
else
    echo "notice: there is no $table: nothing is compared with budgets (make matrix-budgets)" >>"$work/findings"
fi
sed 's/^/check: matrix: /' "$work/findings"
finish $status
