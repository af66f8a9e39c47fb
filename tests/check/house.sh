#!/bin/sh
# SPDX-License-Identifier: MIT
# The size of the house: files and lines of each folder of core, and the routes of what is drawn (routes.sh), printed
# beside their budgets in house.tsv. A figure above its budget is a finding. `house.sh write` writes the budgets anew.
gate=house
. tests/check/files.sh
need awk gcc
budgets=tests/check/house.tsv

figures()
{
    for folder in core/include/qtri core/include/qtri/body core/bits core/math core/geometry core/frame core/filter core/paint core/raster core/draw; do
        set -- "$folder"/*.[ch]
        printf '%s\t%d\t%d\n' "$folder" $# "$(cat "$@" | wc -l)"
    done
    set -- $(c_files core)
    printf 'core\t%d\t%d\n' $# "$(cat "$@" | wc -l)"
    # `lit-textured   45 (21) files  186 (89) functions  161 (43) returns`: files and returns without headers
    JOBS=$jobs sh tests/check/routes.sh | awk -v OFS='\t' '{ gsub(/[()]/, ""); print "route " $1, $3, $9 }'
}

[ "${1:-}" != write ] || { figures >"$budgets"; exit; }

figures | awk -F '\t' '
    NR == FNR { files[$1] = $2; lines[$1] = $3; next }
    FNR == 1 { printf "%-24s %14s  %16s\n", "", "files", "lines, returns" }
    {
        if (!($1 in files)) { print $1 ": no budget"; bad = 1; next }
        over = $2 > files[$1] || $3 > lines[$1]
        printf "%-24s %5d (%6d)  %7d (%6d)%s\n", $1, $2, files[$1], $3, lines[$1], over ? " !" : ""
        bad = bad || over
    }
    END { exit bad || FNR < 12 }' "$budgets" -
finish $?
