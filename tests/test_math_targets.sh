#!/bin/sh
# SPDX-License-Identifier: MIT
# The mathematics gives the same results everywhere: builds the checksums (tests/boards/math_sums*.c) for one target after
# another, runs them, natively or emulated, and compares every line with the host's. Called by `make test-math-targets`.
# A target whose compiler or emulator is missing is skipped and named. JOBS: how many at a time; SAMPLES: of each function.
set -u
: "${JOBS:=2}" "${SAMPLES:=100000}" "${TIME_LIMIT:=300}"
few=$(((SAMPLES + 199) / 200)) # for the AVR, whose emulator is as slow as it is
out=build/math-targets

host=x86-64-gcc-O2
targets='cortex-m0plus avr-16-bit-int cortex-m3 rv32imc powerpc-big-endian arm64 x86-64-gcc-O0 x86-64-clang-O3'

# Where int has 16 bits, what overflows it is an error in the source.
flags='-std=c99 -Wall -Werror=overflow -Icore/include'
sources=$(echo core/bits/*.c core/math/*.c core/geometry/camera.c core/geometry/row.c core/geometry/transform.c \
    tests/boards/math_sums.c tests/boards/math_sums_functions.c tests/boards/math_sums_transform.c)
sections='-ffunction-sections -fdata-sections -Wl,--gc-sections'
# The boards' memcpy must not be recognised as a memcpy.
bare="-O2 -ffreestanding -fno-tree-loop-distribute-patterns $sections -nostdlib"
console='-display none -monitor none -serial stdio'

# describe TARGET: the tools it needs, how it is built and how it is run.
describe()
{
    boards=port/boards
    case $1 in
    x86-64-gcc-O0) with_libc 'gcc -O0' ;;
    x86-64-gcc-O2) with_libc 'gcc -O2' ;;
    x86-64-clang-O3) with_libc 'clang -O3' ;;
    arm64) with_libc 'aarch64-linux-gnu-gcc -O2 -static' qemu-aarch64 ;;
    powerpc-big-endian) with_libc 'powerpc-linux-gnu-gcc -O2 -static' qemu-ppc ;;
    cortex-*)
        without_libc "arm-none-eabi-gcc -mcpu=$1 -mthumb -mno-unaligned-access $bare -T $boards/mps2/mps2.ld" \
            "$(echo $boards/mps2/*.c $boards/common/*.c) -lgcc" \
            "qemu-system-arm -M mps2-an385 -semihosting-config enable=on,target=native $console -kernel"
        ;;
    rv32imc)
        without_libc "riscv64-unknown-elf-gcc -march=rv32imc -mabi=ilp32 $bare -T $boards/virt/virt.ld" \
            "$(echo $boards/virt/*.[cS] $boards/common/*.c) -lgcc" \
            "qemu-system-riscv32 -M virt -bios none $console -kernel"
        ;;
    avr-16-bit-int)
        without_libc "avr-gcc -mmcu=atmega1284p -Os -mcall-prologues -Werror=shift-count-overflow $sections" \
            "$(echo $boards/atmega1284p/*.[cS])" \
            'simavr -m atmega1284p -f 16000000' "$few"
        ;;
    esac
}

# with_libc COMPILER [EMULATOR]
with_libc()
{
    run=${2-}
    argument=$SAMPLES
    tools="${1%% *} $run"
    build="$1 $flags $sources tests/boards/math_sums_host.c"
}

# without_libc COMPILER BOARD_FILES EMULATOR [SAMPLES]
without_libc()
{
    run=$3
    argument=
    tools="${1%% *} ${3%% *}"
    build="$1 $flags -DMATH_SUMS_SAMPLES=${4-$SAMPLES}u $sources tests/boards/math_sums_board.c $2"
}

# One target: leaves TARGET.sums, and TARGET.failed or TARGET.skipped with the reason in it.
if [ "${1:-}" = --one ]; then
    target=$2
    describe "$target"
    for tool in $tools; do
        command -v "$tool" >/dev/null 2>&1 || echo "$tool" >>"$out/$target.skipped"
    done
    [ ! -e "$out/$target.skipped" ] || exit 0
    if ! $build -o "$out/$target" >"$out/$target.log" 2>&1; then
        echo "does not build, $out/$target.log" >"$out/$target.failed"
        exit 0
    fi
    timeout "$TIME_LIMIT" $run "$out/$target" $argument </dev/null >"$out/$target.log" 2>&1 ||
        echo "status $? of $run $out/$target $argument" >"$out/$target.failed"
    # simavr colours the lines of the console and ends each with a dot.
    LC_ALL=C tr -d '\033\r' <"$out/$target.log" |
        sed -n 's/^\(\[[0-9;]*m\)*//; s/\.$//; /^[a-z0-9_]* [0-9a-f]\{8\}$/p' >"$out/$target.sums"
    exit 0
fi

rm -rf "$out"
mkdir -p "$out" build/results
printf '%s\n' $host $targets | SAMPLES=$SAMPLES xargs -P "$JOBS" -n 1 sh "$0" --one
if [ ! -x "$out/$host" ] || ! "$out/$host" "$few" >"$out/host-few.sums"; then
    cat "$out/$host.log" "$out/$host.skipped" 2>/dev/null
    echo "0 1 0" >build/results/math-targets
    echo "math targets: 0 compared, the host's sums failed"
    exit 1
fi

compared=0 equal=0 mismatches=0 skipped=0
for target in $targets; do
    expected=$out/$host.sums
    [ "$target" != avr-16-bit-int ] || expected=$out/host-few.sums
    if [ -e "$out/$target.skipped" ]; then
        echo "$target: skipped: $(xargs <"$out/$target.skipped") not installed (make setup-all)"
        skipped=$((skipped + 1))
        continue
    fi
    if [ -e "$out/$target.failed" ]; then
        echo "$target: FAILED: $(cat "$out/$target.failed")"
        grep -m 8 -E 'error|undefined' "$out/$target.log"
        mismatches=$((mismatches + 1))
    fi
    [ -s "$out/$target.sums" ] || continue
    # The same functions in the same order, a line missing at the end included.
    awk -v target="$target" '
        NR == FNR { sum[$1] = $2; next }
        { seen[$1]; if ($2 == sum[$1]) same++; else print "    " target ": " $1 " differs" > "/dev/stderr" }
        END { for (name in sum) all++; print same + 0, all - same }' "$expected" "$out/$target.sums" >"$out/verdict"
    read -r same different <"$out/verdict"
    echo "$target: $same of $((same + different)) equal the host's"
    compared=$((compared + same + different))
    equal=$((equal + same))
    mismatches=$((mismatches + different))
done

# Every function that the public headers declare is among those summed, but for constants and second names.
grep -hoE '\b(q16|qtri_(vec[234]|mat[34]|quat|attitude))_[a-z0-9_]+\(' core/include/qtri/q16*.h core/include/qtri/vec*.h \
    core/include/qtri/mat*.h core/include/qtri/quat*.h | tr -d '(' | LC_ALL=C sort -u >"$out/declared"
cut -d ' ' -f 1 "$out/$host.sums" | LC_ALL=C sort -u >"$out/summed"
for name in $(comm -23 "$out/declared" "$out/summed" | grep -vE '_(identity|sat|euler_deg|times)$'); do
    echo "no checksum covers $name (host/bench/math_functions.inc)"
    mismatches=$((mismatches + 1))
done

echo "$equal $mismatches $skipped" >build/results/math-targets
echo "math targets: $compared compared, $mismatches mismatches"
[ "$mismatches" = 0 ] && [ "$compared" -gt 0 ]
