#!/bin/sh
# SPDX-License-Identifier: MIT
# Plain words. A comment begins with a noun, not with "The same", "Of" or "Its"; a name is the field's; prose has no runs
# of spaces; a commit's subject has at most 72 characters. words.tsv tells how many there may still be of each, so that
# their number falls and does not grow.
gate=words
. tests/check/files.sh
need awk git grep
table=tests/check/words.tsv
since=3fde8d6 # the last commit before this gate

# name, count of each kind of finding; with FIND=NAME the findings themselves.
count()
{
    if [ "${FIND:-}" = "$1" ]; then cat >&2; else printf '%s\t%d\n' "$1" "$(wc -l)"; fi
}

files=$(c_files core port host tests)
figures()
{
    grep -nE '^ *(/\*|//) *(The same|That of|Those of|Of|Its|Their)\b' $files | count 'comment that begins without a noun'
    # Declarations only: a name in use stands in one of them.
    for word in hold held least greatest most magnitude corner halo rolling gentle taker reach rests tint lamp seen crossing bent; do
        grep -hoE "\bqtri_[a-z0-9_]*\b" $(c_files core/include port/include) | LC_ALL=C sort -u | grep -E "_$word(_|s_|s?\$|[0-9])" | count "public name with $word"
    done
    cat README.md CHANGELOG.md CONTRIBUTING.md core/README.md core/math/README.md host/README.md host/*/README.md port/README.md port/*/README.md tests/README.md |
        grep -nE '^[A-Za-z].*[a-z,.;]  +[A-Za-z]' | count 'run of spaces in prose'
    if git rev-parse -q --verify "$since^{commit}" >/dev/null; then
        git log --format=%s "$since..HEAD" | awk 'length > 72' | count 'subject over 72 characters'
    fi
}

[ "${1:-}" != write ] || { figures >"$table"; exit; }

figures | awk -F '\t' '
    NR == FNR { budget[$1] = $2; next }
    $2 > budget[$1] { printf "%s: %d, at most %d (FIND=\"%s\" sh tests/check/words.sh shows them)\n", $1, $2, budget[$1], $1; bad = 1 }
    END { exit bad }' "$table" -
finish $?
