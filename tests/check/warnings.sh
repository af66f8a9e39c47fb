#!/bin/sh
# SPDX-License-Identifier: MIT
# gcc and clang compile every file of the host as strict C99 without a warning, and the cross compiler the firmware of
# the boards. The plain build is gcc's, at -O2, as some of its warnings come from the optimizer; what was built before told
# its warnings then. Tests are compiled without optimisation here. tests/prove/*_values.c are Frama-C's.
# clang reads its files within clang-tidy, which reads many without being begun for each.
gate=warnings
. tests/check/files.sh
need gcc clang clang-tidy arm-none-eabi-gcc

# clang has no -Wdouble-promotion here: it also takes NAN and INFINITY, and a double in a long double, for promotions.
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
flags="-std=c99 $(make -s warnings CC=clang) -Werror"
includes='-Icore/include -Iport/include -Icore -Ihost -Itests/packages/pico -Itests/packages/stm32
          -Itests/packages/esp_idf -Itests/packages/zephyr -Itests/packages/lvgl'

# compile COMPILER FLAGS... < FILES; succeeds if all of them do
compile()
{
    grep '\.c$' | xargs -P "$jobs" -I FILE "$@" $flags FILE
}

status=0
plain_build -k WERROR=-Werror all || status=1
c_files port/examples host | grep -v '^host/\(assets\|io\|panels\|reference\|tools\)/' |
    compile gcc -O2 -S -o /dev/null -Wdouble-promotion $includes || status=1
c_files tests | grep -v '^tests/fuzz_\|^tests/prove/[a-z]*_values' | compile gcc -S -o /dev/null -Wdouble-promotion $includes || status=1
c_files core port/panels port/examples host tests | grep '\.c$' | grep -v '^tests/prove/[a-z]*_values' | tidy "$diagnostics" "$flags $includes" || status=1
c_files port/boards | compile arm-none-eabi-gcc -O2 -c -o /dev/null -ffreestanding -mcpu=cortex-m3 -mthumb -Icore/include -Iport/include || status=1
finish $status
