#!/bin/sh
# SPDX-License-Identifier: MIT
# cppcheck's addon for MISRA C:2012 over core and port/panels: how often each rule is broken, build/misra.txt has where.
# A rule that tests/misra.md does not name as a deviation is a finding. misra.sh [FILE...]
set -u
gate=misra
. tests/check/files.sh
need cppcheck python3
mkdir -p build
root=$(pwd)
[ $# -gt 0 ] || set -- $(c_files core port/panels | grep '\.c$')
# The addon leaves files beside the sources: a copy of them.
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
mkdir "$work/port" && cp -R core "$work/" && cp -R port/include port/panels "$work/port/" || exit 1
(
    cd "$work" || exit 1
    printf '%s\n' "$@" | xargs -P "$jobs" -n 8 cppcheck --quiet --std=c99 --addon=misra -Icore/include -Iport/include \
        --suppress=missingIncludeSystem 2>&1
) | grep '\[misra-c2012-[0-9.]*\]$' | sort -u >"$root/build/misra.txt"
sed 's/.*\[misra-c2012-\([0-9.]*\)\]/\1/' build/misra.txt | sort -V | uniq -c | while read -r count rule; do
    reason=$(sed -n "s/^| $rule |//p" tests/misra.md)
    echo "$rule: $count${reason:+:$reason}"
done >build/misra-rules.txt
cat build/misra-rules.txt
grep -v ':.*:' build/misra-rules.txt && finish 1
finish 0
