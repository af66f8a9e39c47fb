#!/bin/sh
# SPDX-License-Identifier: MIT
# How far a reader goes who follows one thing that is drawn (routes.c): the files and functions of core that are entered,
# and how often he comes back from another file, once for each pair of functions that calls across files. Inline
# functions count as others; calls through pointers, too. In brackets without headers, core/bits and core/math.   (`make routes`)
set -eu
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
gate=routes
. tests/check/files.sh
jobs=${JOBS:-2}
ls core/*/*.c tests/check/routes.c | objects "$work" gcc -std=c99 -O0 -g -no-pie -fno-pie -finstrument-functions -I"$(pwd)/core/include"
gcc -no-pie -o "$work/program" "$work"/*.o
for what in lit-textured flat line wide-line rectangle band; do
    "$work/program" $what >"$work/events"
    sed -n 's/^E //p' "$work/events" | sort -u >"$work/addresses"
    addr2line -f -e "$work/program" <"$work/addresses" | paste - - | sed 's,[^\t]*/core/,core/,; s,:.*,,' |
        paste "$work/addresses" - >"$work/names"
    awk -v what=$what '
        function small(f) { return f ~ /^core\/(bits|math)\/|h$/ }
        NR == FNR { name[$1] = $2; home[$1] = $3; next }
        $1 == "L" { depth--; next }
        {
            stack[++depth] = $2
            file = home[$2]
            from = depth > 1 ? home[stack[depth - 1]] : file
            if (!(file in files)) { files[file]; all++; plain += !small(file) }
            if (!(name[$2] in functions)) { functions[name[$2]]; f_all++; f_plain += !small(file) }
            link = name[stack[depth - 1]] " " name[$2]
            if (from != file && !(link in links)) { links[link]; r_all++; r_plain += !small(file) }
        }
        END { printf "%-13s %3d (%d) files  %3d (%d) functions  %3d (%d) returns\n", what, all, plain, f_all, f_plain, r_all, r_plain
              if (ENVIRON["LIST"]) for (f in files) print "    " f }' "$work/names" "$work/events"
done
