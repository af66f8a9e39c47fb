#!/bin/sh
# SPDX-License-Identifier: MIT
# Bytes that each option of config.h saves alone: size_options.sh FOLDER "APPLICATION..." COMPILER...   (called by
# `make size-options`)
# COMPILER... compiles for a core; FOLDER holds the objects. What an application links without an option is compared with
# what it links with all.
set -eu
folder=$1 applications=$2
shift 2
size=${1%gcc}size
options=$(sed -n 's/^#define QTRI_WITH_\([A-Z0-9_]*\) 1$/\1/p' core/include/qtri/config.h)

# build NAME FLAG...: a line of the bytes of each application
build()
{
    name=$1
    shift
    mkdir -p "$folder/$name"
    # The mathematics has no options.
    [ "$name" = all ] && files=$(ls core/*/*.c port/boards/common/memory.c) || files=$(ls core/*/*.c | grep -v "^core/\(bits\|math\)/")
    for file in $files; do
        "$@" -c -o "$folder/$name/$(basename "$file" .c).o" "$file"
    done
    [ "$name" = all ] || cp -f $(ls core/bits/*.c core/math/*.c port/boards/common/memory.c | sed "s,.*/\(.*\)\.c,$folder/all/\1.o,") "$folder/$name"
    for application in $applications; do
        "$@" -c -o "$folder/app_$application.o" "host/bench/app_$application.c"
        # What the application calls that is not in the library stays undefined.
        "$@" -nostdlib -Wl,--gc-sections -Wl,--entry=app_frame -Wl,--undefined=app_setup -Wl,--defsym=display_write=0 \
            -o "$folder/program" "$folder/app_$application.o" "$folder/$name"/*.o -lgcc
        "$size" "$folder/program" | awk 'NR == 2 { printf "%d ", $1 }'
    done
}

all=$(build all "$@")
printf '%-18s' 'bytes saved'
printf '%12s' $applications
echo
for option in $options; do
    now=$(build "$option" "$@" "-DQTRI_WITH_$option=0") || now=
    printf '%s\n%s\n' "$all" "$now" | awk -v option="$option" '
        NR == 1 { n = split($0, all, " "); next }
        { printf "%-18s", option; for (i = 1; i <= n; i++) printf "%12d", all[i] - $i; print "" }'
done
