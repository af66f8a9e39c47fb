#!/bin/sh
# SPDX-License-Identifier: MIT
# Converts every model of a folder, whoever made it: models.sh FOLDER. Each either becomes a header that compiles without
# a warning, or is refused in one line; what was left out, and why a file was refused, is printed.
set -u
qtri=${QTRI_COMMAND:-build/qtri}
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
find "$1" -type f | grep -iE '\.(obj|ply|stl|gltf|glb)$' | sort >"$work/list"
kept=0 refused=0 wrong=0
while IFS= read -r model; do
    "$qtri" model "$model" -o "$work/m.h" --preview "$work/m.ppm" >/dev/null 2>"$work/says" </dev/null
    status=$?
    cat "$work/says"
    if [ $status = 0 ]; then
        kept=$((kept + 1))
        printf '#include "m.h"\nconst qtri_part *parts(void);\nconst qtri_part *parts(void) { return m; }\n' >"$work/m.c"
        gcc -std=c99 -Wall -Wextra -Werror -Icore/include -I"$work" -fsyntax-only "$work/m.c" && continue
        echo "$model: its header does not compile"
    elif [ $status = 1 ] && [ "$(wc -l <"$work/says")" -ge 1 ]; then
        refused=$((refused + 1))
        continue
    else
        echo "$model: status $status"
    fi
    wrong=$((wrong + 1))
done <"$work/list"
echo "models: $kept converted, $refused refused, $wrong wrong"
[ $wrong = 0 ]
