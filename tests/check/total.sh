#!/bin/sh
# SPDX-License-Identifier: MIT
# The last line of `make test`: adds up build/results/. total.sh STATUS, where STATUS tells whether a step failed.
cat build/results/* 2>/dev/null | awk -v status="$1" '
    { passed += $1; failed += $2; skipped += $3 }
    END {
        if (status != 0 && !failed) { print "a step failed before its tests were counted"; failed = 1 }
        printf "%d passed, %d failed, %d skipped\n", passed, failed, skipped
        exit failed > 0 || passed == 0
    }'
