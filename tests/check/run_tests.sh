#!/bin/sh
# SPDX-License-Identifier: MIT
# Runs cmocka programs, JOBS at a time: run_tests.sh NAME...   (called by `make test-plain`)
# A program's output goes to $BUILD/tests/NAME.log, its counts to build/results/; both are shown if it fails.
set -u
: "${BUILD:=build}" "${JOBS:=2}" "${TEST_SECONDS:=300}" "${MODELS:=}"

# The environment the tests may rely on, with full paths: QTRI_TMP for what they write, QTRI_COMMAND, and QTRI_MODELS
# where there are models. QTRI_TEST_LONG is the user's to set.
mkdir -p "$BUILD/tmp" build/results
QTRI_TMP=$(cd "$BUILD/tmp" && pwd)
QTRI_COMMAND=$(cd "$BUILD" && pwd)/qtri
export QTRI_TMP QTRI_COMMAND
unset QTRI_MODELS
if [ -n "$MODELS" ]; then
    QTRI_MODELS=$(cd "$MODELS" && pwd) || exit 1
    export QTRI_MODELS
fi
export CMOCKA_MESSAGE_OUTPUT=TAP
export ASAN_OPTIONS="${ASAN_OPTIONS:-allocator_may_return_null=1:detect_stack_use_after_return=1}"
export UBSAN_OPTIONS="${UBSAN_OPTIONS:-print_stacktrace=1}"
export BUILD TEST_SECONDS

if [ "${1:-}" != --one ]; then
    [ $# -gt 0 ] || { echo "no tests in tests/"; exit 1; }
    rm -f build/results/"$(echo "$BUILD/" | tr / -)"*
    QTRI_TEST_COUNT=$#
    export QTRI_TEST_COUNT
    printf '%s\n' "$@" | xargs -P "$JOBS" -n 1 sh "$0" --one
    exit $?
fi

name=$2 log=$BUILD/tests/$2.log
limit=''
# A build that counts what runs (make coverage) does so for each test, the commands that it starts included.
[ -z "${PROFILES:-}" ] || export LLVM_PROFILE_FILE="$PROFILES/$name-%m.profraw"
command -v timeout >/dev/null 2>&1 && limit="timeout $TEST_SECONDS"
status=0
$limit "$BUILD/tests/$name" >"$log" 2>&1 </dev/null || status=$?

# TAP: `1..N` opens a group; `ok 1 - name`, `not ok 2 - name` and `not ok 3 # SKIP name` are its tests, perhaps
# behind text that a test printed. Tests announced and never heard of, a crash or no test at all: failed.
counts=$(awk -v status="$status" '
    /^1\.\.[0-9]+$/                  { planned += substr($0, 4); next }
    /ok [1-9][0-9]* (- .*)?# SKIP/   { skipped++; next }
    /not ok [1-9][0-9]* - /          { failed++; next }
    /ok [1-9][0-9]* - /              { passed++ }
    END {
        missing = planned - passed - failed - skipped
        failed += missing > 0 ? missing : -missing
        if (!failed && (status != 0 || planned == 0)) failed = 1
        print passed + 0, failed + 0, skipped + 0
    }' "$log")
result=build/results/$(echo "$BUILD/" | tr / -)
echo "$counts" >"$result$name"
rank="$(ls "$result"* | wc -l) of $QTRI_TEST_COUNT"

set -- $counts
if [ "$2" = 0 ]; then
    echo "$rank: $BUILD/tests/$name: $1 passed$([ "$3" = 0 ] || echo ", $3 skipped")"
    sed -n 's/.*ok [0-9]* .*# SKIP /    skipped: /p' "$log"
    exit 0
fi
[ "$status" != 124 ] || echo "killed after $TEST_SECONDS seconds" >>"$log"
# One write, so that the logs of programs that fail together stay apart.
printf '%s\n' "$(cat "$log"; echo "$rank: $BUILD/tests/$name: $1 passed, $2 FAILED, $3 skipped, status $status")"
exit 1
