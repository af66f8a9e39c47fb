#!/bin/sh
# SPDX-License-Identifier: MIT
# Times the scenes on the host: bench_host.sh TABLE.tsv PROGRAM [BASE-PROGRAM]   (called by `make bench-host`)
# Each program prints `scene median least`, microseconds. They run three times in turn, and of three figures the middle one
# counts. Writes `scene microseconds least`, with a base also `base ratio`: what the base takes, and times this one.
set -eu
table=$1
shift

lines=$(mktemp) || exit 1
trap 'rm -f "$lines"' EXIT
for _ in 1 2 3; do
    for program; do
        "$program" time | sed "s,^,$program ," >>"$lines"
    done
done

awk -v OFS='\t' -v ours="$1" -v base="${2:-}" '
    function middle(list,   n, value, i, j, t) {
        n = split(list, value, " ")
        for (i = 1; i < n; i++) for (j = i + 1; j <= n; j++)
            if (value[j] + 0 < value[i] + 0) { t = value[i]; value[i] = value[j]; value[j] = t }
        return value[int((n + 1) / 2)]
    }
    {
        if (!($2 in seen)) name[++names] = $2
        seen[$2]
        median[$1, $2] = median[$1, $2] " " $3
        if (!(($1, $2) in least) || $4 < least[$1, $2]) least[$1, $2] = $4
    }
    END {
        if (base == "") print "scene", "microseconds", "least"
        else print "scene", "microseconds", "least", "base", "ratio"
        for (n = 1; n <= names; n++) {
            s = name[n]
            now = middle(median[ours, s])
            if (base == "") print s, now, least[ours, s]
            else if ((base, s) in median) { then = middle(median[base, s]); print s, now, least[ours, s], then, sprintf("%.2f", then / now) }
            else print s, now, least[ours, s], "-", "-"
        }
    }' "$lines" >"$table"

awk -F '\t' '
    BEGIN { target["S1"] = 40; target["S2"] = 90; target["S3"] = 55; target["S4"] = 150; target["S5"] = 140 }
    NR == 1 { print "Microseconds of the draw call, without the clear. In brackets: the target; ! where it is missed."
        printf "%-6s%10s%17s%s\n", "scene", "median", "least", (NF > 3 ? "      base   times faster" : ""); next }
    {
        aim = target[$1]
        printf "%-6s%10.1f%7s%10.1f", $1, $2, aim == "" ? "" : ($2 > aim ? " ! " : " ") "(" aim ")", $3
        print (NF > 3 ? sprintf("%10s%15s", $4, $5) : "")
    }' "$table"
