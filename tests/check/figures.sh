#!/bin/sh
# SPDX-License-Identifier: MIT
# README's figures are those of their sources, which host/report/figures.tsv names for each row of README's tables: budgets,
# and what `qtri demo` prints. Without the models their rows are skipped, by name.
gate=figures
. tests/check/files.sh
need awk make

build=${BUILD:-build}
make -s "$build/qtri" >/dev/null || finish 1
work=$(mktemp) || exit 1
trap 'rm -f "$work"' EXIT
sh host/report/figures.sh "$build" "${MODELS:-$(ls -d ../shared/models 2>/dev/null)}" >"$work" || finish 1
awk -F '\t' '
    $5 == "differs" { printf "README.md: %s, %s: %s, but `%s` gives %s\n", $1, $2, $3, $6, $4; bad = 1 }
    $5 == "unknown" { printf "%s has no row \"%s\" with these figures\n", $6, $1; bad = 1 }
    $5 == "absent" && !told[$1]++ { printf "check: figures: skipped: %s: its model is not there (host/bench/README.md, Models)\n", $1 }
    $5 == "ok" { compared++ }
    END {
        if (compared < 60) { printf "only %d figures were compared\n", compared; bad = 1 }
        exit bad
    }' "$work"
finish $?
