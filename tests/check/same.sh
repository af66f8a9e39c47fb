#!/bin/sh
# SPDX-License-Identifier: MIT
# The same pictures to the bit from every compiler, optimisation level, width of a pointer, signedness of char and byte
# order: the benchmarks' scenes and the matrix of formats, depth tests, sources and geometries (host/bench), and random
# states (tests/support/random_states.h), drawn by the library as each builds it. Emulated boards draw the random states
# here, with the library of the benchmarks, and the others in check-budgets and check-matrix. tcc, a plain C99 compiler,
# also builds the command, whose pictures are compared as files. SAME=all takes four minutes and draws with every build of
# the list below, SAME="tcc gcc-O1" with some.
gate=same
. tests/check/files.sh
need gcc clang tcc cmp

build=${BUILD:-build}
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
status=0
alone make -s "$build/bench/scenes/bench_meshes.c" "$build/libqtri.a" MAKEFLAGS= >"$work/log" 2>&1 || { cat "$work/log"; finish 1; }
sh port/packages/dist.sh "$work/dist" >"$work/log" 2>&1 || { cat "$work/log"; finish 1; }

# NAME LIBRARY COMMAND...: how each builds, the slowest first. `one` is the library as one file, `all` its own files,
# `make` what make has built, with which all are compared; `linux` the library of test-boards; `board` the library of the benchmarks for a core of that name, by
# clang as one file, and the program a firmware.
usual='cortex-m0plus-Os cortex-m4 32-bit-O1 big-endian-O2 clang-Os gcc-Os tcc'
cat >"$work/list" <<'END'
make make gcc -O2
cortex-m0plus-Os board arm-none-eabi-gcc -mcpu=cortex-m0plus -Os
cortex-m0plus-clang-Os board arm-none-eabi-gcc -mcpu=cortex-m0plus -Os
cortex-m3 board arm-none-eabi-gcc -mcpu=cortex-m3 -O2
cortex-m4 board arm-none-eabi-gcc -mcpu=cortex-m4 -mfpu=fpv4-sp-d16 -mfloat-abi=hard -O2
cortex-m0plus board arm-none-eabi-gcc -mcpu=cortex-m0plus -O2
cortex-m3-Os board arm-none-eabi-gcc -mcpu=cortex-m3 -Os
gcc-O3 one gcc -O3
gcc-O2-flto all gcc -O2 -flto
clang-O3 one clang -O3
clang-O2 one clang -O2
32-bit-O2 one i686-linux-gnu-gcc -O2 -static
clang-Os one clang -Os -funsigned-char
clang-O1 one clang -O1 -flto
gcc-Os one gcc -Os
big-endian-O2 linux powerpc-linux-gnu-gcc -O2 -static
32-bit-O1 one i686-linux-gnu-gcc -O1 -static
gcc-O1 one gcc -O1 -funsigned-char
clang-O0 one clang -O0
gcc-O0 one gcc -O0
tcc all tcc
END
cat >"$work/draw" <<'END'
work=$1 meshes=$2 name=$3 library=$4
shift 4
command -v "$1" >/dev/null 2>&1 || { echo "same: skipped: $name: $1 not installed (make setup-all)" >"$work/$name.skipped"; exit 0; }
case $name in big-endian*) run=qemu-ppc ;; 32-bit*) run=qemu-i386 ;; cortex*) run=qemu-system-arm ;; *) run='' ;; esac
case $name in cortex-m4*) machine=mps2-an386 ;; *) machine=mps2-an385 ;; esac
[ -z "$run" ] || command -v $run >/dev/null 2>&1 || { echo "same: skipped: $name: $run not installed (make setup-all)" >"$work/$name.skipped"; exit 0; }
set -- "$@" -std=c99 -Icore/include -Ihost/bench
states='tests/support/random_states.c tests/support/random_pictures.c'
here=host/bench
if [ $library = board ]; then
    board=port/boards
    set -- "$@" -mthumb -ffreestanding -fno-tree-loop-distribute-patterns
    core=${BUILD:-build}/bench/scenes/$name/libqtri.a
    case $name in *-clang-*) # a library by clang in firmware by gcc
        core=$work/$name.o
        clang --target=arm-none-eabi -mcpu=cortex-m0plus -mthumb -Os -std=c99 -fshort-enums -ffreestanding -Icore/include \
            -idirafter $board/common/libc -c -o "$core" "$work/dist/single/qtri.c" || exit 1 ;;
    esac
    "$@" -nostdlib -T $board/mps2/mps2.ld -o "$work/$name.program" tests/check/same_states.c $states $here/bench_print.c \
        $board/mps2/*.c $board/common/memory.c "$core" -lgcc &&
        timeout 300 $run -M $machine -semihosting-config enable=on,target=native -display none -monitor none \
            -serial stdio -kernel "$work/$name.program" </dev/null >"$work/$name.states" || { echo "$name: not built or not run"; exit 1; }
    rm -f "$work/$name.program"
    exit
fi
case $library in
one)
    "$@" -c -o "$work/$name.o" "$work/dist/single/qtri.c" || exit 1
    library=$work/$name.o
    ;;
all) library=$(echo core/*/*.c) ;;
linux)
    make -s "${BUILD:-build}/boards/linux_powerpc/firmware.elf" MAKEFLAGS= >"$work/$name.log" && rm "$work/$name.log" || exit 1
    library=$(ls core/*/*.c | sed "s|\(.*\)c\$|${BUILD:-build}/boards/linux_powerpc/\1o|")
    ;;
make) library=${BUILD:-build}/libqtri.a ;;
esac
"$@" -o "$work/$name.program" "$meshes" tests/check/same.c $states $here/bench_host_board.c $here/bench_world.c \
    $here/bench_print.c $here/bench_scenes.c $here/bench_smooth.c $here/bench_paint.c $here/bench_strokes.c \
    $here/matrix_cases.c $here/matrix_draw.c $library &&
    $run "$work/$name.program" >"$work/$name.pictures" || { echo "$name: not built or not run"; exit 1; }
rm -f "$work/$name.program" "$work/$name.o"
END
[ "${SAME:=$usual}" != all ] || SAME='.*'
grep -E "^($(echo "make $SAME" | tr ' ' '|')) " "$work/list" >"$work/asked"
cores=$(awk '$2 == "board" && $1 !~ /clang/ { print $1 }' "$work/asked")
[ -z "$cores" ] || ! command -v arm-none-eabi-gcc >/dev/null || core_libraries $cores || finish 1
sed "s|^|$work $build/bench/scenes/bench_meshes.c |" "$work/asked" | xargs -P "$jobs" -L 1 sh "$work/draw" || status=1

cat "$work"/*.skipped 2>/dev/null
sed -n '/^states /,$p' "$work/make.pictures" >"$work/make.states"
[ "$(wc -l <"$work/make.pictures")" -gt 2900 ] || { echo "too few pictures"; status=1; }
[ "$(awk '{ print $NF }' "$work/make.states" | sort -u | wc -l)" -gt 500 ] || { echo "too few pictures of random states"; status=1; }
grep ' failed$' "$work/make.states" && status=1
for file in "$work"/*.pictures "$work"/*.states; do
    name=${file##*/}
    cmp -s "$file" "$work/make.${name##*.}" || {
        diff "$work/make.${name##*.}" "$file" | sed -n "s/^> /${name%.*} draws otherwise: /p" >"$work/differ"
        head -5 "$work/differ"
        echo "${name%.*} draws $(wc -l <"$work/differ") pictures otherwise"
        status=1
    }
done
states=$(grep -c '^states ' "$work/make.states")
builds=$(ls "$work"/*.pictures | wc -l)
boards=$(($(ls "$work"/*.states | wc -l) - 1))
echo "check: $gate: $(($(wc -l <"$work/make.pictures") - 3)) pictures by $builds builds, $states of them of random states, by $boards on emulated boards too"

case " $SAME " in *' tcc '* | ' .* ') ;; *) finish $status; exit 0 ;; esac
for compiler in gcc tcc; do
    mkdir "$work/$compiler"
    if [ $compiler = gcc ] && [ -x "$build/qtri" ]; then
        cp "$build/qtri" "$work/gcc/qtri"
    else
        $compiler -std=c99 -O2 -Icore/include -Iport/include -o "$work/$compiler/qtri" \
            core/*/*.c host/assets/*.c host/io/*.c host/reference/*.c host/tools/*.c -lm || finish 1
    fi
    for scene in 03-colour-triangle 05-crossing 09-floor; do
        "$work/$compiler/qtri" render host/scenes/$scene.scene -o "$work/$compiler/$scene" --dump || status=1
    done
done
for file in "$work"/gcc/*.ppm "$work"/gcc/*.id "$work"/gcc/*.depth; do
    cmp "$file" "$work/tcc/${file##*/}" || status=1
done
finish $status
