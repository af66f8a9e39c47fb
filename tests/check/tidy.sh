#!/bin/sh
# SPDX-License-Identifier: MIT
# clang-tidy with the checks that .clang-tidy chooses; any finding is an error there. Its analyzer follows a function to
# 75,000 states, a third of its default: the rest takes 250 seconds of a processor and has found nothing yet.
gate=tidy
. tests/check/files.sh
need clang-tidy

c_files core port/panels port/examples host | grep '\.c$' | grep -v '^port/examples/glue/' |
    tidy '' '-std=c99 -Icore/include -Iport/include -Ihost -Xclang -analyzer-config -Xclang max-nodes=75000'
finish $?
