#!/bin/sh
# SPDX-License-Identifier: MIT
# Prints README's figures beside those of their sources, tabs between: figures.sh BUILD [MODELS]   (figures.awk says what)
set -eu
build=$1
models=${2:-}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
for name in $(awk -F '\t' '$3 == "demo" { print $4 }' host/report/figures.tsv); do
    "$build/qtri" demo -o "$work" ${models:+--models "$models"} --only "$name"
done >"$work/demo"
awk -f host/report/figures.awk host/report/figures.tsv host/bench/budgets.tsv host/report/peers.tsv "$work/demo" README.md
