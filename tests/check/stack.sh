#!/bin/sh
# SPDX-License-Identifier: MIT
# The static call graph of the library, by the compiler: nothing calls itself, not through others either, no frame's size
# depends on arguments, and no public function takes more stack than stack.calls allows. That file also lists what indirect
# calls lead to; a function whose address is taken and that is in no list is a finding. STACK_SHOW=1 prints all depths.
gate=stack
. tests/check/files.sh
need arm-none-eabi-gcc
export CCACHE_DISABLE=1 # a cache keeps objects without their graphs

work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
status=0

# A name is a line `symbol` of a public header's declaration.
cat core/include/qtri/*.h port/include/qtri_port/*.h | grep -oE '\b(qtri|q16)_[a-z0-9_]+\(' | tr -d '(' | sort -u >"$work/public"

core_libraries cortex-m0plus-Os cortex-m3 || finish 1
for build in cortex-m0plus-Os cortex-m3; do
    for file in port/panels/*.c; do
        arm-none-eabi-gcc -std=c99 -mcpu=${build%-Os} $(case $build in *-Os) echo -Os ;; *) echo -O2 ;; esac) -mthumb -ffreestanding \
            -Icore/include -Iport/include -fcallgraph-info=su -c -o "$work/$(basename "$file" .c).o" "$file" || finish 1
    done
    cat $(ls core/*/*.c | sed "s|^\(.*\)c\$|${BUILD:-build}/bench/scenes/$build/\1ci|") "$work"/*.ci >"$work/graphs" || finish 1
    awk -F '"' -v build="$build" -v show="${STACK_SHOW:-}" -v public="$work/public" "$(cat tests/check/stack_calls.awk)"'
        BEGIN { while ((getline line < public) > 0) is_public[line] }
        function complain(text) { print build ": " text; bad = 1 }
        function way(t,   text, cut, next_t) {
            for (text = ""; t != ""; t = next_t) {
                text = text " " t "(" frame[t] + 0 ")"
                next_t = next_of[cut, t]
                if (whole(t) in never) cut = cut never[whole(t)]
            }
            return text
        }
        END {
            for (t in frame) depth(t)
            for (t in frame) if (t in is_public) {
                most = 0
                for (i = limits; i >= 1; i--) if (t ~ pattern(limit_name[i])) most = limit_bytes[i]
                if (known["", t] > most) complain(t ": " known["", t] " bytes of stack, above " most ":" way(t))
                if (show) printf "%6d %s:%s\n", known["", t], build, way(t)
            }
            for (key in unknown) if (key !~ /[*]/) complain(key ": in a list, and no function")
            for (t in frame) exists[whole(t)]
            for (key in never) { n = split(key never[key], list, " "); for (i = 1; i <= n; i++) if (!(list[i] in exists)) complain(list[i] ": never called, and no function") }
            # Static functions are called by somebody: by name, or by a list.
            for (key in targets) { n = split(targets[key], list, " "); for (i = 1; i <= n; i++) { m = split(expand(list[i]), each, " "); for (j = 1; j <= m; j++) listed[each[j]] } }
            for (t in frame) if (t ~ /:/ && !(t in called) && !(t in listed) && t !~ /[.](part|constprop|isra)[.]/) complain(t ": its address is taken, and no list has it")
            exit bad
        }' "$work/graphs" || status=1
done
finish $status
