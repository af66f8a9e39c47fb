#!/bin/sh
# SPDX-License-Identifier: MIT
# Runs a command and says every 20 seconds how long it has been at work: alive.sh NAME COMMAND ...
# What it says goes to standard error. Its status is the command's.
set -u
name=$1
shift
(
    passed=0
    # Nothing waits for the last sleep when the command is done: it holds no file of it.
    while sleep 5 2>/dev/null && kill -0 "$$" 2>/dev/null; do
        passed=$((passed + 5))
        [ $((passed % 20)) -ne 0 ] || echo "$name: at work for $passed seconds" >&2
    done
) </dev/null >/dev/null &
teller=$!
status=0
"$@" || status=$?
kill "$teller" 2>/dev/null
wait "$teller" 2>/dev/null
exit "$status"
