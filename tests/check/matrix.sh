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
    sh host/bench/matrix_budgets.sh "$build" >"$work/now" || finish 1
    awk -F '\t' '
        # `# arm arm-none-eabi-gcc ... 12.2.1`: the compiler that the figures are of
        /^#/ { if (NR == FNR) version = $0; else if ($0 != version) other = $0; next }
        $1 == "case" && NR == FNR { for (c = 2; c <= NF; c++) core[c] = $c; next }
        $1 == "case" { for (c = 2; c <= NF; c++) now[c] = $c; next }
        NR == FNR { known[$1]; for (c = 2; c <= NF; c++) budget[$1, core[c]] = $c; next }
        !($1 in known) { print $1 ": no budget (make matrix-budgets)"; failed = 1; next }
        {
            for (c = 2; c <= NF; c++) {
                most = budget[$1, now[c]]
                if (most == "") { print $1 ", " now[c] ": no budget (make matrix-budgets)"; failed = 1; continue }
                compared++
                if ($c < .98 * most) better++
                if ($c <= 1.02 * most) continue
                if (other == "") failed = 1
                printf "%s%s, %s: %d, the budget is %d (%+.1f %%)\n", other == "" ? "" : "notice: ", $1, now[c], $c, most, 100 * ($c / most - 1)
            }
        }
        END {
            if (other != "") print "notice: the budgets are of another compiler: " substr(version, 3) "; here: " substr(other, 3)
            if (better) print "notice: " better " figures are more than 2 % below their budgets: make matrix-budgets"
            if (!compared) { print "nothing was compared with a budget"; failed = 1 }
            exit failed
        }' "$table" "$work/now" >>"$work/findings" || status=1
else
    echo "notice: there is no $table: nothing is compared with budgets (make matrix-budgets)" >>"$work/findings"
fi
sed 's/^/check: matrix: /' "$work/findings"
finish $status
