#!/bin/sh
# SPDX-License-Identifier: MIT
# The pipeline's levels: who may include whom.
#   core/bits < math < geometry < frame < filter < paint < raster < draw, host/io < reference < assets < tools < bench, window and web: own folder or lower;
#   the same for calls between files of core, which may not go in circles either;
#   core and port/panels: public headers and five system headers, a checked build also assert.h; neither the umbrella qtri.h nor the host;
#   host/reference: nothing of core, not even by way of another header.
gate=levels
. tests/check/files.sh
need awk gcc

found=$(c_files core port/include port/panels host | xargs grep -n '^ *# *include' | awk -F: '
    function exists(path,   line, ok) { ok = (getline line < path) >= 0; close(path); return ok }
    # a/b/../c/x.h -> a/c/x.h
    function plain(path) { while (sub(/[^\/]+\/\.\.\//, "", path)); return path }
    function resolve(name, from) {
        split(plain(from "/" name) " core/include/" name " port/include/" name " core/" name " host/" name, places, " ")
        for (i = 1; i <= 5; i++) if (exists(places[i])) return places[i]
        return ""
    }
    function folder(path) { sub(/\/[^\/]*$/, "", path); return path }
    function public(path) { return path ~ /^(core|port)\/include\// }
    function lower(from, to) {
        return from == to || (from in level && to in level && level[to] < level[from] &&
                              substr(from, 1, 4) == substr(to, 1, 4))
    }
    function complain(text) { print $1 ":" $2 ": includes " name ": " text }
    BEGIN {
         level["core/bits"] = 0; level["core/math"] = 1; level["core/geometry"] = 2; level["core/frame"] = 3; level["core/filter"] = 4
         level["core/paint"] = 5; level["core/raster"] = 6; level["core/draw"] = 7
        level["host/io"] = 1; level["host/reference"] = 2; level["host/assets"] = 3; level["host/tools"] = 4
         level["host/bench"] = 5; level["host/window"] = 5; level["host/web"] = 5
        freestanding = "^(stdint|stddef|stdbool|limits|string)\\.h$"
    }
    {
        from = folder($1)
        name = $0; sub(/^[^<"]*[<"]/, "", name); sub(/[>"].*/, "", name)
        target = resolve(name, from)
        if (target == "") {
            if ($0 ~ /"/) complain("no such file")
            else if ($1 !~ /^host\// && name !~ freestanding && !($1 ~ /qtri\/error.h$/ && name == "assert.h")) complain("not one of the five system headers")
        } else if ($1 ~ /^core\//) {
            if (target == "core/include/qtri.h") complain("the umbrella is for applications")
            else if (public($1) && !public(target)) complain("a private header in a public one")
            else if (target !~ /^core\//) complain("core is below " folder(target))
            else if (!public(target) && !lower(from, folder(target))) complain(from " is not above " folder(target))
            else if (target == $1) complain("itself")
        } else if ($1 ~ /^port\//) {
            if (target == "core/include/qtri.h") complain("the umbrella is for applications")
            else if (!public(target) && folder(target) != from) complain("not a public header")
        } else if (target ~ /^host\// && !lower(from, folder(target)))
            complain(from " is not above " folder(target))
    }' | grep -v '^core/include/qtri\.h:')

# All that the reference reads, directly or not. -M, because -MM is silent about what <> finds.
reads=$(c_files host/reference | grep '\.c$' | xargs gcc -std=c99 -M -Ihost -Icore/include -Iport/include -Icore | awk '
    /^[^ ]+\.o:/ { file = $1; sub(/\.o:$/, ".c", file) }
    { for (i = 1; i <= NF; i++) if (match($i, /(^|\/)core\/.*/)) print "host/reference/" file ": the reference must not read " substr($i, RSTART) }' | sort -u)

# Calls, which includes do not show: a file names nothing that a folder above it defines, and no files name each
# other in a circle. Tables of functions count as calls.
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
c_files core | grep '\.c$' >"$work/files"
objects "$work/objects" gcc -std=c99 -O0 -I"$(pwd)/core/include" <"$work/files" || uncompiled=1
(cd "$work/objects" && nm -A -g *.o) | awk '
    NR == FNR { name = $0; sub(/.*\//, "", name); sub(/c$/, "o", name); path[name] = $0; next }
    { split($1, place, ":"); print path[place[1]], $(NF - 1), $NF }' "$work/files" - >"$work/symbols"
awk 'NR == FNR { if ($2 != "U") home[$3] = $1; next }
     $2 == "U" && ($3 in home) && home[$3] != $1 && !seen[$1, home[$3]]++ { print $1, home[$3], $3 }' \
    "$work/symbols" "$work/symbols" >"$work/calls"
calls=$(awk '
    BEGIN { split("bits math geometry frame filter paint raster draw", order, " "); for (i in order) level[order[i]] = i }
    { split($1, from, "/"); split($2, to, "/") }
    level[to[2]] > level[from[2]] { print $1 ": names " $3 " of " $2 ", which is above" }' "$work/calls"
    awk '{ print $1, $2 }' "$work/calls" | tsort 2>&1 >/dev/null | sed -n 's,^tsort: core,core,p' |
        awk '{ circle = circle " " $0 } END { if (circle != "") print "a circle of calls:" circle }')

found=$(printf '%s\n' "$found" "$reads" "$calls" "${uncompiled:+core does not compile}" | sed '/^$/d')
[ -z "$found" ] || printf '%s\n' "$found"
[ -z "$found" ]
finish $?
