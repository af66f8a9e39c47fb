#!/bin/sh
# SPDX-License-Identifier: MIT
# Runs a command and says every 20 seconds how long it has been at work: alive.sh NAME COMMAND ...
# What it says goes to standard error. Its status is the command's.
set -u
name=$1
shift
(
    passed=0
    # Each second, so that nothing waits for long when the command is done.
    while sleep 1 && kill -0 "$$" 2>/dev/null; do
        passed=$((passed + 1))
        [ $((passed % 20)) -ne 0 ] || echo "$name: at work for $passed seconds" >&2
    done
) </dev/null >/dev/null &
teller=$!
status=0
"$@" || status=$?
kill "$teller" 2>/dev/null
wait "$teller" 2>/dev/null
exit "$status"
