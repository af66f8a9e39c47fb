#!/bin/sh
# SPDX-License-Identifier: MIT
# Where code and stack of an application go: size_functions.sh FOLDER OBJECTS APPLICATION   (called by `make size-functions`)
# FOLDER has the programs of a core and an optimization, OBJECTS what they are linked of. Prints the bytes of every file and of the largest functions linked, and
# the calls that go deepest, by the compiler's call graph. What an indirect call leads to is taken to be every static
# function that nobody calls by name; the compiler's own functions are taken to need no stack.
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
find "$objects/core" "$objects/host/bench/app_$application.ci" -name '*.ci' -exec cat {} + | awk -F '"' -v linked_list="$folder/$application.functions" '
    BEGIN { while ((getline line < linked_list) > 0) { split(line, part, " "); linked[part[3]] } }
    function plain(title) { sub(/.*:/, "", title); return title }
    /^node:/ {
        if (match($4, /[0-9]+ bytes/)) frame[$2] = substr($4, RSTART) + 0
        next
    }
    /^edge:/ { if (!(($2, $4) in edge)) { edge[$2, $4]; out[$2] = out[$2] SUBSEP $4; called[$4] } }
    # The deepest that a call of `title` goes; next_of remembers by which call.
    function depth(title,   list, n, i, d, best) {
        if (title in known) return known[title]
        known[title] = frame[title] # a recursive call counts once
        n = split(out[title], list, SUBSEP)
        best = 0
        for (i = 2; i <= n; i++) {
            d = list[i] == "__indirect_call" ? indirect(title) : depth(list[i])
            if (d > best) { best = d; next_of[title] = list[i] == "__indirect_call" ? target[title] : list[i] }
        }
        return known[title] = frame[title] + best
    }
    function indirect(from,   t, d, best) {
        best = 0
        for (t in frame) if (t ~ /^core.*:/ && !(t in called) && plain(t) in linked) {
            d = depth(t)
            if (d > best) { best = d; target[from] = t }
        }
        return best
    }
    function show(start,   t, sum) {
        sum = 0
        for (t = start; t != "" && !((start, t) in shown); t = next_of[t]) {
            shown[start, t]
            sum += frame[t]
            printf "%6d %7d   %s\n", frame[t], sum, t
        }
        print ""
    }
    END {
        for (f = 0; f < 2; f++) {
            from = f ? "app_frame" : "app_setup"
            n = split(out[from], list, SUBSEP)
            deepest = ""
            for (i = 2; i <= n; i++) if (deepest == "" || depth(list[i]) > depth(deepest)) deepest = list[i]
            show(deepest)
        }
    }'
