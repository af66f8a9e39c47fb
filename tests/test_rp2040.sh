#!/bin/sh
# SPDX-License-Identifier: MIT
# Runs examples on an emulated RP2040, compares what its display shows with what the host draws, and prints what they cost.
#   tests/test_rp2040.sh BUILD/examples RP2040JS FRAMES NAME...
# Of FRAMES frames the first also makes what the example draws: cycles are the mean of the others.
set -u
folder=$1
rp2040js=$2
frames=$3
shift 3
: "${TIME_LIMIT:=120}"
mkdir -p build/results
table=$folder/rp2040/table.txt
echo 'example cycles/frame frames/s flash RAM mismatches' >"$table"
passed=0 failed=0
for name; do
    here=$folder/rp2040/$name
    rm -rf "$here/shown" "$here/verdict.txt"
    mkdir -p "$here/shown" "$here/expected"
    # A pipe has the status of its end; the display's program ends well when the emulator does not.
    { timeout "$TIME_LIMIT" node tests/boards/rp2040.mjs "$rp2040js" "$here/firmware.elf" "$frames"; echo "status $?"; } |
        "$folder/rp2040/display" "$here/shown" >"$here/output.txt" &&
        grep -q '^status 0$' "$here/output.txt" &&
        "$folder/$name/host" lcd "$here/expected" "$here/shown" "$frames" >"$here/verdict.txt" &&
        awk -v frames="$frames" '$1 == "frame" && $6 >= $4 / 50 { drawn++ } END { exit drawn != frames }' "$here/verdict.txt"
    if [ $? = 0 ]; then
        passed=$((passed + 1))
    else
        failed=$((failed + 1))
        echo "rp2040 $name: FAILED"
        tail -n 3 "$here/output.txt" "$here/verdict.txt" 2>/dev/null
    fi
    arm-none-eabi-size "$here/firmware.elf" | awk -v name="$name" -v verdict="$here/verdict.txt" -v output="$here/output.txt" '
        NR == 2 { flash = $1 + $2; ram = $2 + $3 }
        END {
            while ((getline line <output) > 0) if (split(line, word, " ") == 4 && word[1] == "frame" && n++ > 0) sum += word[4]
            while ((getline line <verdict) > 0) if (split(line, word, " ") == 6) wrong += word[5]
            cycles = n > 1 ? sum / (n - 1) : 0
            printf "%s %d %.1f %d %d %d\n", name, cycles, (cycles > 0 ? 125e6 / cycles : 0), flash, ram, wrong
        }' >>"$table"
done
awk '{ printf "%-8s %13s %9s %7s %6s %10s\n", $1, $2, $3, $4, $5, $6 }' "$table"
echo "rp2040: $passed examples show the host's pixels in $frames frames each, $failed do not"
echo "$passed $failed 0" >build/results/rp2040
[ "$failed" = 0 ] && [ "$passed" -gt 0 ]
