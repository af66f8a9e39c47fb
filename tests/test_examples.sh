#!/bin/sh
# SPDX-License-Identifier: MIT
# Runs the examples' firmware in QEMU and compares what the displays show with what the host draws.
#   tests/test_examples.sh BUILD/examples NAME:lcd|oled:EMULATOR...
set -u
folder=$1
shift
passed=0 failed=0
mkdir -p build/results
for example; do
    name=${example%%:*}
    rest=${example#*:}
    display=${rest%%:*}
    emulator=${rest#*:}
    here=$folder/$name
    rm -rf "$here/shown"
    mkdir -p "$here/frames"
    if sh tests/boards/run_display.sh "$emulator" "$here/firmware.elf" "$here/shown" >"$here/output.txt" 2>&1 &&
        "$here/host" "$display" "$here/frames" "$here/shown" >"$here/verdict.txt" 2>&1 &&
        awk '$1 == "frame" && $6 >= $4 / 50 { drawn++ } END { exit drawn != 8 }' "$here/verdict.txt"; then
        passed=$((passed + 1))
        awk -v name="$name" '$1 == "frame" { sum += $4; n++ } END {
            printf "example %s: %d frames are the host'\''s, %d instructions each\n", name, n, sum / n }' "$here/output.txt"
    else
        failed=$((failed + 1))
        echo "example $name: FAILED"
        tail -3 "$here/output.txt" "$here/verdict.txt" 2>/dev/null
    fi
done
echo "$passed $failed 0" >build/results/examples
[ "$failed" = 0 ]
