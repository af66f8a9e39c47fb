#!/bin/sh
# SPDX-License-Identifier: MIT
# Gathers what the cores printed: matrix.sh FOLDER TABLE.tsv CORE...   (called by `make bench-matrix`)
# FOLDER/matrix-host.txt and FOLDER/CORE/matrix.txt hold lines `case hash pixels instructions`. Writes the table
# `case core instructions pixels per_pixel`, and TABLE-classes.tsv, which it prints: how far the cells of a class are apart.
# A class is what has source, texels, filter, wrap and geometry in common, and a depth test or none. Fails where a core's picture is not the host's.
set -eu
folder=$1 table=$2
shift 2

grep -q '/mesh ' "$folder/matrix-host.txt" || echo "bench-matrix: no case of the geometry \`mesh\`: not asked for, or no spot.obj in MODELS"

for core; do
    sed "s,^,$core ," "$folder/$core/matrix.txt"
done | awk -v OFS='\t' -v cores="$*" '
    BEGIN { print "case", "core", "instructions", "pixels", "per_pixel" }
    NR == FNR { hash[$1] = $2; expected += $1 != "end"; next }
    $2 == "end" { next }
    {
        lines++
        if (hash[$2] != $3) { print "bench-matrix: " $1 ": " $2 ": not the picture of the host" >"/dev/stderr"; bad = 1 }
        print $2, $1, $5, $4, sprintf("%.2f", $5 / $4)
    }
    END {
        if (!expected) { print "bench-matrix: there is no such case" >"/dev/stderr"; bad = 1 }
        if (lines != expected * split(cores, unused, " ")) { print "bench-matrix: a core did not draw every case" >"/dev/stderr"; bad = 1 }
        exit bad
    }' "$folder/matrix-host.txt" - >"$table"

# The classes: `class core cells best median worst times worst_case`, instructions a pixel, the worst as times the best.
awk -F '\t' -v OFS='\t' -v cores="$*" '
    function class_of(name,   part, n) {
        n = split(name, part, "/")
        class = n == 4 ? part[3] "/" part[4] : part[3] "/" part[4] "/" part[5] "/" part[6] "/" part[7]
        return part[2] == "off" ? class "/off" : class
    }
    function sort(list, n,   gap, i, j, value) {
        for (gap = int(n / 2); gap > 0; gap = int(gap / 2))
            for (i = gap + 1; i <= n; i++) {
                value = list[i]
                for (j = i; j > gap && list[j - gap] > value; j -= gap) list[j] = list[j - gap]
                list[j] = value
            }
    }
    NR == 1 { next }
    {
        class = class_of($1)
        if (!(class in seen)) { seen[class]; name[++classes] = class }
        key = class SUBSEP $2
        cost = $3 / $4
        cell[key, ++cells[key]] = cost
        if (cells[key] == 1 || cost > greatest[key]) { greatest[key] = cost; worst[key] = $1 }
    }
    END {
        columns = split(cores, core, " ")
        print "class", "core", "cells", "best", "median", "worst", "times", "worst_case"
        for (n = 1; n <= classes; n++)
            for (c = 1; c <= columns; c++) {
                key = name[n] SUBSEP core[c]
                count = cells[key]
                for (i = 1; i <= count; i++) list[i] = cell[key, i]
                sort(list, count)
                print name[n], core[c], count, sprintf("%.2f", list[1]), sprintf("%.2f", list[int((count + 1) / 2)]), \
                    sprintf("%.2f", list[count]), sprintf("%.2f", list[count] / list[1]), worst[key]
            }
    }' "$table" >"${table%.tsv}-classes.tsv"

awk -F '\t' -v cores="$*" '
    # The case without what its class says.
    function rest_of(name,   part, n) {
        n = split(name, part, "/")
        return part[1] "/" part[2]
    }
    function finish() {
        if (class != "") printf "%-50s%6d%s  %s\n", class, cells, line, rest_of(which)
        line = ""
        most = 0
    }
    BEGIN {
        columns = split(cores, core, " ")
        print "Instructions a pixel: the best, median and worst cell of each class, and the worst as times the best, ! above 2; behind"
        print "them the cell that is most: surface and depth test."
        printf "%-50s%6s", "", ""
        for (c = 1; c <= columns; c++) printf "%18s%15s", core[c], ""
        printf "\n%-50s%6s", "class", "cells"
        for (c = 1; c <= columns; c++) printf "%8s%8s%9s%7s ", "best", "median", "worst", "times"
        print "  which"
    }
    NR == 1 { next }
    $1 != class { finish(); class = $1; cells = $3; classes++ }
    {
        line = line sprintf("%8.1f%8.1f%9.1f%7.1f", $4, $5, $6, $7) ($7 > 2 ? "!" : " ")
        if ($7 > most) { most = $7; which = $8 }
        apart[$2] += $7 > 2
        if ($7 > highest[$2]) { highest[$2] = $7; where[$2] = $8 }
    }
    END {
        finish()
        for (c = 1; c <= columns; c++)
            printf "bench-matrix: %s: %d of %d classes have a cell above twice their best; most: %.1f times, %s\n", core[c], apart[core[c]], classes, highest[core[c]], where[core[c]]
    }' "${table%.tsv}-classes.tsv"
