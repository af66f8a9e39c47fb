#!/bin/sh
# SPDX-License-Identifier: MIT
# Proves that the mathematics does nothing that C does not define, whatever its arguments; prints a line a proof.
# JOBS (1) proofs run at once. tests/prove/README.md says what is proved and how long it takes.
#
#   prove.sh values    tests/prove/*_values.c by Frama-C's Eva: int of 32 bits with a long multiply and without, int of
#                      16 bits without. PROOFS="prove_mul" VARIANTS="wide narrow int16"
#   prove.sh inputs    tests/prove/math_inputs.c by trying every argument, with and without long multiply.
#                      FUNCTIONS="sqrt recip" VARIANTS="wide narrow"
set -u
log=build/prove
mkdir -p "$log"
short='-DQTRI_LONG_MULTIPLY=0 -DQTRI_DIVIDE=0' # of cores without a long multiply

# All of bits and math that this file of proofs does not include as a whole itself.
mathematics() {
    own=$(sed -n 's,^#include "../../\(core/.*\.c\)".*,\1,p' "$1")
    ls core/bits/*.c core/math/*.c | grep -vxF "${own:-none}"
}

# The proof NAME for VARIANT.
value() {
    name=$1 variant=$2
    file=$(grep -l "^void $name(void)" tests/prove/*_values.c)
    # The functions that this proof takes as specified: the lines above it name them.
    specified=$(awk -v proof="void $name(void)" '
        /^\/\/ specified: / { names = names (names == "" ? "" : ",") $3; next }
        $0 == proof { print names }
        { names = "" }' "$file")
    with="$(mathematics "$file") $(frama-c -print-share-path)/libc/__fc_builtin.c"
    case $file in
    *kernel*)
        with="$with core/raster/dda.c core/raster/depth_float16.c core/raster/depth_linear24.c
            core/raster/depth_linear32.c core/geometry/clip.c core/frame/pixel.c"
        ;;
    esac
    machine=x86_32 flags=
    case $variant in
    wide) with=$(echo "$with" | grep -v 'bits/shared\.c') ;;
    narrow | int16)
        [ "$variant" = int16 ] && machine=x86_16
        flags=$short
        # Products of 64 bits are functions of their own file then, that other proofs take as specified.
        if [ "$name" != prove_products ]; then
            flags="$flags -DQTRI_SHARE=1 -include tests/prove/specified.h"
            specified=${specified:+$specified,}qtri_mul_u32,qtri_mul_s32
        fi
        ;;
    *) echo "prove: there is no variant $variant" >&2; exit 2 ;;
    esac
    case $specified in
    zeros,*)
        flags="$flags -include tests/prove/zeros.h"
        specified=specified_clz32,specified_clz64,${specified#zeros,}
        ;;
    esac
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
        -eva-slevel $(echo $slevel | tr , ' ') ${specified:+-eva-use-spec $specified} \
        -main "$name" "$file" $with >"$log/$name-$variant.txt" 2>&1
    status=$?
    if [ $status = 0 ] && grep -q '0 alarms generated' "$log/$name-$variant.txt" &&
        ! grep -q 'status unknown\|status invalid\|NON TERMINATING' "$log/$name-$variant.txt"; then
        echo "prove: ${name#prove_}, $variant: proved, $(($(date +%s) - start)) s"
    else
        echo "prove: ${name#prove_}, $variant: NOT proved; $log/$name-$variant.txt"
        return 1
    fi
}

values() {
    command -v frama-c >/dev/null 2>&1 || { echo "prove: skipped: frama-c is not installed (make setup-proof)"; exit 0; }
    for name in ${PROOFS:-$(sed -n 's/^void \(prove_[a-z0-9_]*\)(void)$/\1/p' tests/prove/*_values.c)}; do
        for variant in ${VARIANTS:-wide narrow int16}; do
            # Of the pipeline no int of 16 bits: config.h refuses to draw there.
            [ "$variant" = int16 ] && grep -q "^void $name(void)" tests/prove/kernel_values.c && continue
            echo "$name $variant"
        done
    done | xargs -P "${JOBS:-1}" -n 2 sh "$0" value
}

# All arguments of the function NAME for VARIANT.
input() {
    name=$1 variant=$2
    start=$(date +%s)
    if "$log/inputs-$variant" "$name" 2>"$log/$name-$variant.txt"; then
        echo "prove: $name, $variant: every argument, $(($(date +%s) - start)) s"
    else
        echo "prove: $name, $variant: FAILED; $log/$name-$variant.txt"
        return 1
    fi
}

inputs() {
    command -v clang >/dev/null 2>&1 || { echo "prove: skipped: clang is not installed (make setup-all)"; exit 0; }
    for variant in ${VARIANTS:-wide narrow}; do
        flags=
        [ "$variant" = narrow ] && flags=$short
        # shellcheck disable=SC2046,SC2086
        clang -std=c99 -O2 -fsanitize=undefined -fno-sanitize-recover=all $flags -Icore/include -Icore \
            -o "$log/inputs-$variant" tests/prove/math_inputs.c $(mathematics tests/prove/math_inputs.c) || exit 1
    done
    for name in ${FUNCTIONS:-$("$log/inputs-$variant")}; do
        for variant in ${VARIANTS:-wide narrow}; do
            echo "$name $variant"
        done
    done | xargs -P "${JOBS:-1}" -n 2 sh "$0" input
}

case ${1:-} in
values | inputs) "$1" ;;
value | input) "$@" ;;
*) echo "usage: prove.sh values|inputs" >&2; exit 2 ;;
esac
