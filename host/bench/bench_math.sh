#!/bin/sh
# SPDX-License-Identifier: MIT
# Gathers what the cores printed: bench_math.sh FOLDER TABLE.tsv CORE...   (called by `make bench-math`)
# Writes the table `function core instructions`, and prints it a function a line, beside the targets of the project.
set -eu
folder=$1 table=$2
shift 2

printf 'function\tcore\tinstructions\n' >"$table"
for core; do
    grep '^[a-z].* ' "$folder/$core/math.txt" | awk -v core="$core" '{ printf "%s\t%s\t%s\n", $1, core, $2 }' >>"$table"
done

# What each figure contains beside the function: a call that does nothing.
echo "Instructions per call: arguments loaded, call, function, return. An empty function of one and of two arguments takes:"
for core; do
    awk -v core="$core" '/^#nothing/ { figures = figures " " $2 } END { print "    " core figures }' "$folder/$core/math.txt"
done

# PEERS.md's targets for Cortex-M0+ and Cortex-M3.
awk -F '\t' -v cores="$*" '
    function want(name, m0plus, m3) { target[name, "cortex-m0plus"] = m0plus; target[name, "cortex-m3"] = m3 }
    BEGIN {
        want("q16_mul", 28, 10); want("q16_div", 200, 50); want("q16_sqrt", 150, 90); want("q16_rsqrt", 220, 60)
        want("q16_sin", 260, 70); want("q16_sincos", 380, 95); want("q16_atan2", 420, 110)
        want("q16_exp2", 200, 60); want("q16_log2", 200, 70)
        want("qtri_vec3_normalize", 600, 150); want("qtri_mat4_vec4", 500, 75); want("qtri_quat_mul", 600, 110)
    }
    NR == 1 { next }
    { if (!($1 in seen)) name[++names] = $1; seen[$1]; count[$1, $2] = $3 }
    END {
        columns = split(cores, core, " ")
        print "In brackets: the target; ! where it is missed."
        printf "%-32s", "function"
        for (c = 1; c <= columns; c++) printf "%19s", core[c]
        print ""
        for (n = 1; n <= names; n++) {
            printf "%-32s", name[n]
            for (c = 1; c <= columns; c++) {
                figure = count[name[n], core[c]]; aim = target[name[n], core[c]]
                if (figure == "") { printf "%19s", "-"; continue }
                if (aim != "") { all++; if (figure > aim) missed++ }
                printf "%12.1f%7s", figure, aim == "" ? "" : (figure > aim ? " ! " : " ") "(" aim ")"
            }
            print ""
        }
        printf "bench-math: %d of %d targets met\n", all - missed, all
    }' "$table"
