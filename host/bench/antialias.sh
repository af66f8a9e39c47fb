#!/bin/sh
# SPDX-License-Identifier: MIT
# What anti-aliasing adds to the instructions of spot, or without it of the knot: antialias.sh FOLDER CORE...
# (called by `make antialias`)
set -eu
folder=$1
shift

[ $# -gt 0 ] || exit 0
mesh=
grep -q '^S4 ' "$folder/$1/bench.txt" || {
    echo "antialias: no spot.obj in MODELS: instructions are those of the project's knot"
    mesh=k
}
for core; do
    sed "s/^/$core /" "$folder/$core/bench.txt"
done | awk -v cores="$*" -v mesh="$mesh" '
    # Rows of the knot end in k, but for S4kb; that of two triangles has no mesh.
    function row(scene) { return scene == "" || scene ~ /^S11/ ? scene : mesh == "" ? scene : scene == "S4b" ? "S4kb" : scene mesh }
    function line(what, scene, base, scale, unit,   c) {
        scene = row(scene)
        base = row(base)
        printf "%-46s", what
        for (c = 1; c <= n; c++) printf "%16.3f", (count[core[c], scene] - (base != "" ? count[core[c], base] : 0)) / scale
        print "  " unit
    }
    BEGIN { n = split(cores, core, " ") }
    { count[$1, $2] = $6 }
    END {
        printf "\n%-46s", "Instructions on top of none (S4, S4b)"
        for (c = 1; c <= n; c++) printf "%16s", core[c]
        print ""
        line("none, whole frame", "S4", "", 1e6, "M")
        line("edge pass", "S4e", "S4", 1e6, "M")
        line("edge pass by sums", "S4es", "S4", 1e6, "M")
        line("none, bands of 16 rows", "S4b", "", 1e6, "M")
        line("edge pass and overlap", "S4be", "S4b", 1e6, "M")
        line("edge pass, overlap kept", "S4br", "S4b", 1e6, "M")
        line("2x2 samples", "S4h", "S4", 1e6, "M")
        line("4 samples", "S4x", "S4", 1e6, "M")
        line("4 samples, textured (S6)", "S6x", "S6", 1e6, "M")
        line("4 samples, a large texture (S11)", "S11x", "S11", 1e6, "M")
        line("FXAA", "S4f", "S4", 1e6, "M")
        line("a frame more to a sum, beside drawing", "S4a", "", 76800, "a pixel")
        line("the mean of a sum", "S4m", "", 76800, "a pixel")
    }'
