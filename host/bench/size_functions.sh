#!/bin/sh
# SPDX-License-Identifier: MIT
# Where code and stack of an application go: size_functions.sh FOLDER OBJECTS APPLICATION   (called by `make size-functions`)
# FOLDER has the programs of a core and an optimization, OBJECTS what they are linked of. Prints the bytes of every file and
# of the largest functions linked, and the calls that go deepest, by the compiler's call graph; what indirect calls lead to
# is what stack.calls says. The compiler's own functions are taken to need no stack.
set -eu
folder=$1 objects=$2 application=$3

echo "Bytes of code   file"
awk '
    function hexadecimal(text,   i, value) {
        value = 0
        for (i = 3; i <= length(text); i++) value = 16 * value + index("0123456789abcdef", substr(text, i, 1)) - 1
        return value
    }
    function add() {
        if (file !~ /\/(core|boards\/common)\/|libgcc\.a/ || section !~ /^\.text/) return
        sub(/.*\/core\//, "core/", file); sub(/.*libgcc\.a/, "libgcc", file); sub(/.*port\//, "port/", file)
        sub(/^\.text\.?/, "", section)
        print hexadecimal(size), file, section
    }
    /^Linker script and memory map/ { map = 1 }
    !map { next }
    NF == 1 && /^ \./ { section = $1; next }
    NF == 4 && /^ \./ { section = $1; size = $3; file = $4; add() }
    NF == 3 && /^ +0x/ && section != "" { size = $2; file = $3; add() }
    { section = "" }' "$folder/$application.map" >"$folder/$application.functions"
awk '{ bytes[$2] += $1; all += $1 } END { for (f in bytes) printf "%13d   %s\n", bytes[f], f; printf "%13d   all\n", all }' \
    "$folder/$application.functions" | sort -rn

echo
echo "Bytes of code   function"
sort -rn "$folder/$application.functions" | awk 'NR <= 40 && $1 > 0 { printf "%13d   %-36s %s\n", $1, $3, $2 }'

echo
echo "Bytes of stack, total   calls, deepest first"
find "$objects/core" "$objects/host/bench/app_$application.ci" -name '*.ci' -exec cat {} + |
    awk -F '"' -v linked_list="$folder/$application.functions" "$(cat tests/check/stack_calls.awk)"'
    BEGIN { while ((getline line < linked_list) > 0) { split(line, part, " "); linked[part[3]] } }
    function complain(text) { } # make check-stack does
    function is_linked(t) { sub(/.*:/, "", t); return t in linked }
    function show(t,   sum, cut, next_t) {
        for (sum = 0; t != ""; t = next_t) {
            sum += frame[t]
            printf "%6d %7d   %s\n", frame[t], sum, t
            next_t = next_of[cut, t]
            if (whole(t) in never) cut = cut never[whole(t)]
        }
        print ""
    }
    function show_deepest(from,   list, n, i, deepest) {
        n = split(out[from], list, " ")
        for (i = 1; i <= n; i++) if (deepest == "" || depth(list[i]) > depth(deepest)) deepest = list[i]
        show(deepest)
    }
    END {
        for (t in frame) if (file_of[t] ~ /^core\// && !is_linked(t)) delete frame[t]
        show_deepest("app_setup")
        show_deepest("app_frame")
    }'
