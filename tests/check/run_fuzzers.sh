#!/bin/sh
# SPDX-License-Identifier: MIT
# Runs the fuzz targets side by side, FUZZ_SECONDS each: run_fuzzers.sh NAME...   (called by `make test-fuzz`)
# tests/NAME.dict is used where it exists, and tests/corpus/NAME.b64, see corpus.sh. What was found stays in
# build/fuzz/corpus/NAME, an input that fails in build/fuzz/findings/NAME-*; `build/fuzz/tests/NAME FILE` repeats it.
set -u
: "${FUZZ_SECONDS:=60}"
export ASAN_OPTIONS="${ASAN_OPTIONS:-allocator_may_return_null=1}"
mkdir -p build/results build/fuzz/findings
[ $# -gt 0 ] || { echo "fuzz: no targets in tests/"; exit 0; }

if ! sh tests/check/have_fuzzer.sh; then
    echo "fuzz: $# targets skipped, clang with its fuzzer runtime is not installed (make setup-all)"
    echo "0 0 $#" >build/results/fuzz
    exit 0
fi

targets=$*
for name in $targets; do
    sh tests/check/corpus.sh unpack "$name"
    set -- -max_total_time="$FUZZ_SECONDS" -timeout=10 -rss_limit_mb=2048 -print_final_stats=1 \
        -artifact_prefix="build/fuzz/findings/$name-" "build/fuzz/corpus/$name"
    # Short inputs first are of no use to a target that takes its drawing behind a thousand bytes.
    [ -f "tests/corpus/$name.b64" ] || set -- -len_control=0 "$@"
    [ ! -f "tests/$name.dict" ] || set -- -dict="tests/$name.dict" "$@"
    (
        status=0
        "build/fuzz/tests/$name" "$@" >"build/fuzz/$name.log" 2>&1 </dev/null || status=$?
        echo "$status" >"build/fuzz/$name.status"
    ) &
done
wait

failed=0 all=0
for name in $targets; do
    log=build/fuzz/$name.log
    runs=$(sed -n 's/^stat::number_of_executed_units: //p' "$log")
    all=$((all + ${runs:-0}))
    if [ "$(cat "build/fuzz/$name.status")" = 0 ] && [ "${runs:-0}" -gt 0 ]; then
        echo "$name: no finding in $runs runs, $FUZZ_SECONDS s"
        echo 1 0 0 >"build/results/$name"
    else
        tail -n 60 "$log"
        echo "$name: FAILED, the input is in build/fuzz/findings/"
        echo 0 1 0 >"build/results/$name"
        failed=1
    fi
done
echo "fuzz: $all runs in all"
exit $failed
