#!/bin/sh
# SPDX-License-Identifier: MIT
# Gathers what the cores printed: bench_scenes.sh FOLDER TABLE.tsv "SCENE..." CORE...   (called by `make bench`)
# FOLDER/host.txt and FOLDER/CORE/bench.txt hold lines `scene crc pixels triangles instructions`. Writes the table, prints
# it a scene a line beside the targets of the project, and fails where a core's picture is not the host's. A core named
# CORE-Os has its library compiled at -Os, and a table of its own beside what CORE takes.
set -eu
folder=$1 table=$2 scenes=$3
shift 3

for name in S4 S5; do
    grep -q "^$name " "$folder/host.txt" ||
        echo "bench: skipped: $name and what is drawn of its mesh: no $([ $name = S4 ] && echo spot || echo teapot).obj in MODELS (host/bench/README.md, Models); the rows that end in k are of the project's own mesh"
done

for core; do
    sed "s/^/$core /" "$folder/$core/bench.txt"
done | awk -v OFS='\t' -v scenes="$scenes" -v cores="$*" '
    BEGIN {
        print "scene", "core", "instructions", "pixels", "triangles", "per_pixel", "per_triangle"
        count = split(scenes, list, " ")
        for (i = 1; i <= count; i++) wanted[list[i]]
    }
    NR == FNR { crc[$1] = $2; expected += $1 != "end"; next }
    $2 == "end" { next }
    {
        lines++
        if (crc[$2] != $3) { print "bench: " $1 ": " $2 ": not the picture of the host" >"/dev/stderr"; bad = 1 }
        if (count && !($2 in wanted)) next
        print $2, $1, $6, $4, $5, sprintf("%.2f", $6 / $4), $5 ? sprintf("%.1f", $6 / $5) : "-"
    }
    END {
        if (lines != expected * split(cores, unused, " ")) { print "bench: a core did not draw every scene" >"/dev/stderr"; bad = 1 }
        exit bad
    }' "$folder/host.txt" - >"$table"

# Targets for M0+, M3 and M4F: instructions per pixel, or millions a frame.
awk -F '\t' -v cores="$*" '
    function want(name, what, m0plus, m3, m4) {
        unit[name] = what
        target[name, "cortex-m0plus"] = m0plus; target[name, "cortex-m3"] = m3; target[name, "cortex-m4"] = m4
    }
    function figure_of(s, core) {
        return instructions[s, core] / (unit[s] == "/px" ? pixels[s] : unit[s] == "/corner" ? 3 * triangles[s] : unit[s] == "/char" ? triangles[s] : 1e6)
    }
    function heading(from, to,   c) {
        printf "%-5s%8s%11s%9s", "scene", "pixels", "triangles", "unit"
        for (c = from; c <= to; c++) printf "%19s", core[c]
        print ""
    }
    function beginning(s) { printf "%-5s%8d%11d%9s", s, pixels[s], triangles[s], s in unit ? unit[s] : "M" }
    BEGIN {
        want("S0", "M", "", .06, .06)
        want("S1", "/px", 8.4, 7.4, 5.8)
        want("S2", "/px", 16.3, 11.7, 10.7)
        want("S3", "/px", 24.4, 15.5, 14.8)
        want("S3a", "/px", 21.4, 14.3, 13.5)
        want("S3m", "/px", 27.4, 17.7, "")
        want("S8m", "/px", "", "", "")
        want("S11m", "/px", 69.9, 46.0, "")
        want("S4", "M", 2.7, 1.40, 1.45)
        want("S5", "M", 2.7, 1.42, 1.45)
        want("S6", "M", 3.8, 2.15, 2.2)
        want("S7", "M", 2.95, 1.27, 1.31)
        want("S8", "/px", 88, 52, 52)
        want("S8w", "/px", 78, 46, 46)
        want("S9", "M", 3.4, 1.8, 1.85)
        want("S10", "M", 3.18, 1.39, "")
        want("S11", "/px", 58, 36, 37)
        want("S12", "M", "", "", 1.0)
        want("S13", "M", "", "", 2.6)
        want("S14", "M", 3.2, 1.35, 1.35)
        want("SE", "M", .0035, .0018, "")
        want("KC", "M", 5.5, 3.5, "")
        want("KQ", "M", .64, .33, "")
        want("ST", "/corner", "", "", "")
        want("STk", "/corner", "", "", "")
        want("B1", "/px", "", "", "")
        want("B2", "/px", 75, 50, "")
        want("B3", "/px", 55, 38, "")
        want("B5", "/px", "", "", "")
        want("B6", "/px", "", "", "")
        want("F5", "M", "", "", "")
        want("F2", "/px", 80, 53, "")
        want("P1", "/px", 1.5, 1.5, 1.5)
        want("P2", "/px", "", "", "")
        want("P3", "/px", 45, 27, "")
        want("P4", "/px", 4, 4, 4)
        want("P5", "/px", 9, 9, 9)
        want("P6", "/px", "", "", "")
        want("P7", "/px", "", "", "")
        want("P8", "/px", "", "", "")
        want("P9", "/px", "", "", "")
        want("P10", "/char", 1500, 900, 900)
        # Plain cores first, then those at -Os.
        n = split(cores, given, " ")
        for (c = 1; c <= n; c++) if (given[c] !~ /-Os$/) core[++plain] = given[c]
        for (c = 1; c <= n; c++) if (given[c] ~ /-Os$/) core[plain + ++small] = given[c]
    }
    NR == 1 { next }
    { if (!($1 in pixels)) name[++names] = $1; pixels[$1] = $4; triangles[$1] = $5; instructions[$1, $2] = $3 }
    END {
        if (plain) {
            print "Instructions of the draw call, without the clear (S0). In brackets: the target; ! where it is missed."
            heading(1, plain)
        }
        for (n = 1; plain && n <= names; n++) {
            s = name[n]
            beginning(s)
            for (c = 1; c <= plain; c++) {
                figure = figure_of(s, core[c]); aim = target[s, core[c]]
                if (aim != "") { all++; if (figure > aim) missed++ }
                printf "%11.3f%8s", figure, aim == "" ? "" : (figure > aim ? " ! " : " ") "(" aim ")"
            }
            print ""
        }
        if (small) {
            print (plain ? "\n" : "") "The library at -Os; behind it, times what -O2 takes."
            heading(plain + 1, plain + small)
        }
        for (n = 1; small && n <= names; n++) {
            s = name[n]
            beginning(s)
            for (c = plain + 1; c <= plain + small; c++) {
                other = core[c]; sub(/-Os$/, "", other)
                printf "%11.3f%8s", figure_of(s, core[c]), (s, other) in instructions ? sprintf("x %.2f", instructions[s, core[c]] / instructions[s, other]) : ""
            }
            print ""
        }
        if (plain) printf "bench: %d of %d targets met\n", all - missed, all
    }' "$table"
