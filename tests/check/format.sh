#!/bin/sh
# SPDX-License-Identifier: MIT
# Every C file is as clang-format writes it; `clang-format -i FILE` makes it so.
gate=format
. tests/check/files.sh
need clang-format

findings=$(c_files core port host tests | xargs clang-format --dry-run -Werror 2>&1)
status=$?
# One line for each line it would change, without the excerpt.
printf '%s\n' "$findings" | sed -n 's/^\([^ :][^:]*:[0-9]*\):[0-9]*: error: .*/\1: clang-format would change this/p' | uniq
[ "$status" = 0 ] || printf '%s\n' "$findings" | grep -v '^ ' | grep -v clang-format-violations
finish $status
