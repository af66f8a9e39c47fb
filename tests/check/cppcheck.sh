#!/bin/sh
# SPDX-License-Identifier: MIT
# cppcheck's warnings on the code that ships. An exception is written at its line: // cppcheck-suppress ID
gate=cppcheck
. tests/check/files.sh
need cppcheck

# missingIncludeSystem: its library of models replaces them. duplicateAssignExpression: `x_min = a, x_max = a` is meant.
c_files core port/panels port/examples host | grep '\.c$' | grep -v '^port/examples/glue/' |
    xargs cppcheck --quiet -j "$jobs" --std=c99 --library=posix -Icore/include -Iport/include -Ihost \
        --enable=warning,performance,portability --error-exitcode=1 --inline-suppr \
        --suppress=missingIncludeSystem --suppress=duplicateAssignExpression
finish $?
