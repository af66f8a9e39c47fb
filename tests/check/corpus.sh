#!/bin/sh
# SPDX-License-Identifier: MIT
# Inputs of the fuzz targets that stay in the repository: tests/corpus/NAME.b64 has one a line, as base64.
#
#   corpus.sh unpack NAME   adds them to build/fuzz/corpus/NAME, from which the target starts
#   corpus.sh pack NAME     keeps of build/fuzz/corpus/NAME what reaches something that no smaller input reaches, the
#                           smallest first, up to 64 KB   (called by `make corpus`)
set -eu
recorded=tests/corpus/$2.b64 folder=build/fuzz/corpus/$2

case $1 in
unpack)
    mkdir -p "$folder"
    [ -f "$recorded" ] || exit 0
    number=0
    while read -r line; do
        number=$((number + 1))
        echo "$line" | base64 -d >"$folder/recorded-$number"
    done <"$recorded"
    ;;
pack)
    work=$(mktemp -d)
    trap 'rm -rf "$work"' EXIT
    mkdir "$work/least"
    "build/fuzz/tests/$2" -merge=1 "$work/least" "$folder" >"$work/log" 2>&1 || { cat "$work/log"; exit 1; }
    find "$work/least" -type f -size -9 -exec wc -c {} + | grep -v ' total$' | sort -n -k1,1 -k2,2 |
        while read -r bytes file; do
            base64 -w 0 "$file"
            echo
        done | awk '{ bytes += length($0) + 1; if (bytes <= 65536) print }' >"$recorded"
    echo "$recorded: $(wc -l <"$recorded") inputs of $(find "$folder" -type f | wc -l)"
    ;;
*)
    echo "corpus.sh: unpack or pack" >&2
    exit 2
    ;;
esac
