#!/bin/sh
# SPDX-License-Identifier: MIT
# cppcheck's addon for MISRA C:2012 over core and port/panels: how often each rule is broken, build/misra.txt has where.
# A rule that tests/misra.md does not name as a deviation is a finding. misra.sh [FILE...]
#
# A file takes seconds. What was found is kept in build/misra/ under a sum of all that the compiler sees of the file, so
# that only what changed is looked at again.
set -u
gate=misra
. tests/check/files.sh
need cppcheck python3 cc
kept=$(pwd)/build/misra
mkdir -p "$kept"
root=$(pwd)
[ $# -gt 0 ] || set -- $(c_files core port/panels | grep '\.c$')
# The addon leaves files beside the sources: a copy of them.
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
mkdir "$work/port" && cp -R core "$work/" && cp -R port/include port/panels "$work/port/" || exit 1
# cppcheck reads no system headers: these are what <limits.h> and <stdint.h> would say.
cat >"$work/one.sh" <<'END'
flags='-Icore/include -Iport/include'
limits='-DINT_MAX=2147483647 -DSIZE_MAX=4294967295u -DUINTPTR_MAX=4294967295u -DUINT32_MAX=4294967295u'
sum=$({ cat one.sh; cc -std=c99 $flags -E "$1"; cat "$1"; cppcheck --version; } | cksum | tr ' ' -)
found=$2/$(echo "$1" | tr / _)-$sum
[ -f "$found" ] || {
    cppcheck --quiet --std=c99 --addon=misra $flags $limits --suppress=missingIncludeSystem "$1" >"$found.part" 2>&1
    grep -q 'preprocessorErrorDirective\|internalError\|syntaxError' "$found.part" && exit 255
    mv "$found.part" "$found"
}
cat "$found"
END
(
    cd "$work" || exit 1
    printf '%s\n' "$@" | xargs -P "$jobs" -I '{}' sh one.sh '{}' "$kept"
) >"$work/all" || { echo "misra: cppcheck could not read a file: see build/misra/*.part"; finish 1; }
grep '\[misra-c2012-[0-9.]*\]$' "$work/all" | sort -u >"$root/build/misra.txt"
sed 's/.*\[misra-c2012-\([0-9.]*\)\]/\1/' build/misra.txt | sort -V | uniq -c | while read -r count rule; do
    reason=$(sed -n "s/^| $rule |//p" tests/misra.md)
    echo "$rule: $count${reason:+:$reason}"
done >build/misra-rules.txt
cat build/misra-rules.txt
grep -v ':.*:' build/misra-rules.txt && finish 1
finish 0
