#!/bin/sh
# SPDX-License-Identifier: MIT
# The size of the house: files and lines of each folder of core, and the routes of what is drawn (routes.sh), printed
# beside their budgets in house.tsv. A figure above its budget is a finding, and so is a public function that no tool,
# example or page shows. `house.sh write` writes the budgets anew.
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

# Functions of the headers, but for those of the mathematics, which core/math/README.md lists by families.
unshown()
{
    work=$(mktemp -d) || exit 1
    ls core/include/qtri/*.h | grep -vE '/(q16|vec|mat|quat|pipeline_make|error)\.h$' |
        xargs grep -hoE '\bqtri_[a-z0-9_]+\(' | tr -d '(' | LC_ALL=C sort -u >"$work/declared"
    { c_files host/tools host/assets host/io port
      find . -name '*.md' ! -name CHANGELOG.md ! -path './build/*'; find port/packages -name '*.ino'
      echo core/include/qtri/pipeline_make.h
    } | xargs cat | grep -oE '\bqtri_[a-z0-9_]+' | LC_ALL=C sort -u >"$work/shown"
    LC_ALL=C comm -23 "$work/declared" "$work/shown"
    rm -r "$work"
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
status=$?
for name in $(unshown); do
    echo "$name: shown by no tool, example or page (core/HOWTO.md)"
    status=1
done
finish $status
