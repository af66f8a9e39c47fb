#!/bin/sh
# SPDX-License-Identifier: MIT
# clang-tidy with the checks that .clang-tidy chooses; any finding is an error there.
gate=tidy
. tests/check/files.sh
need clang-tidy

c_files core port/panels port/examples host | grep '\.c$' | grep -v '^port/examples/glue/' |
    xargs -P "$jobs" -n 4 sh -c '
        output=$(clang-tidy --quiet "$@" -- -std=c99 -Icore/include -Iport/include -Ihost 2>&1) || {
            printf "%s\n" "$output" | grep -v " warnings\{0,1\} generated\.$"
            exit 1
        }' tidy
finish $?
