#!/bin/sh
# Gathers what the cores printed: bench_scenes.sh FOLDER TABLE.tsv "SCENE..." CORE...   (called by `make bench`)
# FOLDER/host.txt and FOLDER/CORE/scenes.txt hold lines `scene crc pixels triangles instructions`. Writes the table, prints
# it a scene a line beside the targets of the project, and fails where a core's picture is not the host's.
set -eu
folder=$1 table=$2 scenes=$3
shift 3

for name in S4 S5 S7; do
    grep -q "^$name " "$folder/host.txt" || echo "bench: skipped: $name: no spot.obj or teapot.obj in MODELS (S4k, S5k, S7k: the project's mesh)"
done

for core; do
    sed "s/^/$core /" "$folder/$core/scenes.txt"
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

# PEERS.md: targets for M0+, M3 and M4F; instructions per pixel, or millions a frame.
awk -F '\t' -v cores="$*" '
    function want(name, unit, m0plus, m3, m4) {
        per_pixel[name] = unit == "px"
        target[name, "cortex-m0plus"] = m0plus; target[name, "cortex-m3"] = m3; target[name, "cortex-m4"] = m4
    }
    BEGIN {
        want("S0", "M", "", .06, .06)
        want("S1", "px", 9, 8, 6)
        want("S2", "px", 17, 12, 10.5)
        want("S3", "px", 32, 16, 14.5)
        want("S3a", "px", 24, 13.5, 13)
        want("S4", "M", 3.9, 1.5, 1.4)
        want("S5", "M", 3.9, 1.5, 1.4)
        want("S7", "M", "", 1.4, 1.3)
    }
    NR == 1 { next }
    { if (!($1 in pixels)) name[++names] = $1; pixels[$1] = $4; triangles[$1] = $5; instructions[$1, $2] = $3 }
    END {
        columns = split(cores, core, " ")
        print "Instructions of the draw call, without the clear (S0). In brackets: the target; ! where it is missed."
        printf "%-5s%8s%11s%6s", "scene", "pixels", "triangles", "unit"
        for (c = 1; c <= columns; c++) printf "%19s", core[c]
        print ""
        for (n = 1; n <= names; n++) {
            s = name[n]
            printf "%-5s%8d%11d%6s", s, pixels[s], triangles[s], per_pixel[s] ? "/px" : "M"
            for (c = 1; c <= columns; c++) {
                if (!((s, core[c]) in instructions)) { printf "%19s", "-"; continue }
                figure = instructions[s, core[c]] / (per_pixel[s] ? pixels[s] : 1e6); aim = target[s, core[c]]
                if (aim != "") { all++; if (figure > aim) missed++ }
                printf "%11.3f%8s", figure, aim == "" ? "" : (figure > aim ? " ! " : " ") "(" aim ")"
            }
            print ""
        }
        printf "bench: %d of %d targets met\n", all - missed, all
    }' "$table"
