#!/bin/sh
# SPDX-License-Identifier: MIT
# Proves that the mathematics does nothing that C does not define, whatever its arguments; prints a line a proof.
#
#   prove.sh values    tests/prove/*_values.c by Frama-C's Eva: int of 32 bits with a long multiply and without, int of
#                      16 bits without; half an hour. PROOFS="prove_mul" VARIANTS="wide narrow int16"
#   prove.sh inputs    tests/prove/math_inputs.c by trying every argument, with and without long multiply; an hour or two
set -u
log=build/prove
mkdir -p "$log"
failed=0

# One proof with these flags of the preprocessor, for a machine that Frama-C knows.
prove() {
    name=$1 variant=$2 machine=$3 flags=$4
    # The functions that other proofs take as specified; a function is not specified in the proof of itself.
    specified=qtri_reciprocal_q62
    [ "$name" = prove_pow_log ] || specified=$specified,precise_log2_q43
    file=$(grep -l "^void $name(void)" tests/prove/*_values.c)
    case $file in
    *kernel*) with="$sources $kernels" specified=qtri_divide_long ;;
    *) with=$sources ;;
    esac
    case $flags in *SHARE=1*) specified=$specified,qtri_mul_u32,qtri_mul_s32 ;; esac
    slevel=100
    precision=1
    case $name in
    prove_div) slevel=40 ;;
    prove_log | prove_pow_log) slevel=100,-eva-slevel-function,$name:5000 ;;
    esac
    [ "$name" = prove_sin ] && precision=4
    start=$(date +%s)
    # shellcheck disable=SC2086
    frama-c -machdep "$machine" -cpp-extra-args="-U__GNUC__ -Icore/include -Icore $flags" -eva -eva-precision $precision \
        -eva-slevel $(echo $slevel | tr , ' ') -eva-use-spec $specified \
        -main "$name" "$file" $with >"$log/$name-$variant.txt" 2>&1
    status=$?
    if [ $status = 0 ] && grep -q '0 alarms generated' "$log/$name-$variant.txt" &&
        ! grep -q 'status unknown\|status invalid\|NON TERMINATING' "$log/$name-$variant.txt"; then
        echo "prove: ${name#prove_}, $variant: proved, $(($(date +%s) - start)) s"
    else
        echo "prove: ${name#prove_}, $variant: NOT proved; $log/$name-$variant.txt"
        failed=1
    fi
}

values() {
    command -v frama-c >/dev/null 2>&1 || { echo "prove: skipped: frama-c is not installed (make setup-proof)"; exit 0; }
    sources="core/math/eighths.c core/math/scaled.c core/math/sincos.c core/math/series.c $(ls core/bits/*.c) \
        $(ls core/math/q16*.c | grep -v 'q16_pow\.c') $(frama-c -print-share-path)/libc/__fc_builtin.c"
    kernels="core/raster/dda.c core/raster/depth_float16.c core/raster/depth_linear24.c \
        core/raster/depth_linear32.c core/geometry/clip.c core/frame/pixel.c core/frame/colors.c"
    for name in ${PROOFS:-$(sed -n 's/^void \(prove_[a-z0-9_]*\)(void)$/\1/p' tests/prove/*_values.c)}; do
        # Products of 64 bits are functions of their own file then, that other proofs take as specified.
        narrow='-DQTRI_LONG_MULTIPLY=0 -DQTRI_DIVIDE=0 -DQTRI_SHARE=1'
        case $name in
        prove_products) narrow='-DQTRI_LONG_MULTIPLY=0 -DQTRI_DIVIDE=0' ;;
        *) narrow="$narrow -include tests/prove/specified.h" ;;
        esac
        for variant in ${VARIANTS:-wide narrow int16}; do
            case $variant in
            wide) prove "$name" wide x86_32 '' ;;
            narrow) prove "$name" narrow x86_32 "$narrow" ;;
            int16) # the mathematics alone: config.h refuses to draw there
                grep -q "^void $name(void)" tests/prove/kernel_values.c || prove "$name" int16 x86_16 "$narrow" ;;
            *) echo "prove: there is no variant $variant" >&2; exit 2 ;;
            esac
        done
    done
}

inputs() {
    command -v clang >/dev/null 2>&1 || { echo "prove: skipped: clang is not installed (make setup)"; exit 0; }
    for variant in wide narrow; do
        flags=
        [ $variant = narrow ] && flags='-DQTRI_LONG_MULTIPLY=0 -DQTRI_DIVIDE=0'
        # shellcheck disable=SC2086
        clang -std=c99 -O2 -fsanitize=undefined -fno-sanitize-recover=all $flags -Icore/include -Icore \
            -o "$log/inputs-$variant" tests/prove/math_inputs.c core/math/q16*.c core/math/eighths.c core/math/scaled.c \
            core/math/series.c core/math/sincos.c core/math/side_angle.c core/bits/*.c || exit 1
        for name in ${FUNCTIONS:-$("$log/inputs-$variant")}; do
            start=$(date +%s)
            if "$log/inputs-$variant" "$name" 2>"$log/$name-$variant.txt"; then
                echo "prove: $name, $variant: every argument, $(($(date +%s) - start)) s"
            else
                echo "prove: $name, $variant: FAILED; $log/$name-$variant.txt"
                failed=1
            fi
        done
    done
}

case ${1:-} in
values | inputs) "$1" ;;
*) echo "usage: prove.sh values|inputs" >&2; exit 2 ;;
esac
exit $failed
