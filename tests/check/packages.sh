#!/bin/sh
# SPDX-License-Identifier: MIT
# Each package is made, and used by an application, whose picture must be that of the library as make builds it. What
# needs a tool that is not installed is skipped, by name.
gate=packages
. tests/check/files.sh
need gcc make

work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
status=0
root=$(pwd)

fail()
{
    echo "packages: $*"
    status=1
}

# has TOOL WHAT: whether there is one; otherwise says what is skipped.
has()
{
    command -v "$1" >/dev/null 2>&1 || { echo "packages: skipped: $2: $1 is not installed"; return 1; }
}

# quiet LOG COMMAND...: its output, if it fails.
quiet()
{
    log=$1
    shift
    "$@" >"$work/$log" 2>&1 || { tail -20 "$work/$log"; fail "$log"; return 1; }
}

plain_build all || finish 1
gcc -std=c99 -Icore/include -Iport/include -o "$work/plain" tests/packages/consumer.c build/libqtri.a || finish 1
expected=$("$work/plain") || fail "the application itself"
[ "$(build/qtri --version)" = "qtri $(sh port/packages/version.sh)" ] || fail "qtri --version"

# same NAME PROGRAM
same()
{
    [ "$("$2" 2>&1)" = "$expected" ] || fail "$1: '$("$2" 2>&1)', not '$expected'"
}

# make install, with an option and without ------------------------------------------------------------------------------

quiet install make -s install PREFIX="$work/prefix"
if has pkg-config "qtri.pc"; then
    PKG_CONFIG_PATH=$work/prefix/lib/pkgconfig
    export PKG_CONFIG_PATH
    quiet pkg-config gcc -std=c99 -o "$work/installed" tests/packages/consumer.c $(pkg-config --cflags --libs qtri) &&
        same "make install" "$work/installed"
    pkg-config --exact-version="$(sh port/packages/version.sh)" qtri || fail "qtri.pc: its version"
fi

# The command of port/README.md, word for word but for its -O2, which takes a minute, in a folder as it is after a checkout:
# all objects together are the library, and an application with a board's start-up code links with them.

if has arm-none-eabi-gcc "the command of port/README.md"; then
    board=$root/port/boards/mps2
    mkdir "$work/port" && ln -s "$root/core" "$root/port" "$work/port/"
    awk '/^    arm-none-eabi-gcc / { found = 1 } found { print } found && !/\\$/ { exit }' port/README.md |
        sed 's/ -O2 / -O0 /' >"$work/port/command"
    grep -q 'core/\*/\*\.c port/panels/\*\.c$' "$work/port/command" || fail "port/README.md: there is no command that compiles the library"
    cd "$work/port" || finish 1
    quiet "the command of the README" sh -e ./command &&
        quiet "the objects of the command" arm-none-eabi-ld -r -o ../library.o ./*.o &&
        quiet "an application with these objects" arm-none-eabi-gcc -std=c99 -mcpu=cortex-m0plus -mthumb -O2 -ffreestanding -fno-tree-loop-distribute-patterns \
            -nostdlib -Wl,--gc-sections -Icore/include -T "$board/mps2.ld" -o ../application.elf "$root/host/bench/app_textured.c" "$root/host/bench/size_board.c" "$root/host/bench/bench_print.c" \
            "$board/startup.c" "$board/board.c" "$board/main.c" "$root/port/boards/common/memory.c" ./*.o -lgcc
    cd "$root" || finish 1
    missing=$(arm-none-eabi-nm -u "$work/library.o" | awk '$2 ~ /^(qtri|q16)_/ { print $2 }')
    [ -z "$missing" ] || fail "port/README.md: its command's objects lack $missing"
fi

# The amalgamation, whose pictures check-same compares -----------------------------------------------------------------

quiet dist sh port/packages/dist.sh "$work/dist" || finish 1
single=$work/dist/single
flags='-std=c99 -Wall -Wextra -Wpedantic -Werror'
quiet "amalgamation, gcc" gcc $flags -c -o "$single/qtri.o" "$single/qtri.c" || finish 1
quiet "amalgamation, gcc -Os" gcc $flags -Os -fsyntax-only "$single/qtri.c"
quiet "amalgamation, application" gcc $flags -I"$single" -o "$single/app" tests/packages/consumer.c "$single/qtri.o" &&
    same "amalgamation" "$single/app"
has clang "amalgamation" && quiet "amalgamation, clang" clang $flags -c -o "$single/clang.o" "$single/qtri.c"
has tcc "amalgamation" && quiet "amalgamation, tcc" tcc -std=c99 -c -o "$single/tcc.o" "$single/qtri.c"
if has arm-none-eabi-gcc "amalgamation"; then
    quiet "amalgamation, Cortex-M4" arm-none-eabi-gcc $flags -Os -mcpu=cortex-m4 -mthumb -ffreestanding -fsyntax-only "$single/qtri.c"
    # Constants without a name share one section: with the address of one, an application would link what it does not use.
    object=build/bench/size/cortex-m0plus-Os/qtri.o held=
    quiet "amalgamation, Cortex-M0+" alone make -s MAKEFLAGS= $object &&
        held=$(arm-none-eabi-objdump -r -j .rodata $object | awk '/R_ARM/ { print $3 }')
    [ -z "$held" ] || fail "amalgamation: a constant without a name holds the address of $held"
fi
has g++ "amalgamation as C++" && echo '#include "qtri.h"' >"$work/one.cc" &&
    quiet "amalgamation, C++" g++ -std=c++11 -Wall -Wextra -Werror -fsyntax-only -I"$single" "$work/one.cc"
stray=$(nm -g --defined-only "$single/qtri.o" | awk '$3 !~ /^(qtri|q16)_/ { print $3 }')
[ -z "$stray" ] || fail "amalgamation: exports $stray"

# The Arduino library: src/ is the only folder that is searched ---------------------------------------------------------

arduino=$work/dist/arduino/qtri
grep -q "^version=$(sh port/packages/version.sh)$" "$arduino/library.properties" || fail "library.properties: its version"
awk -F '\t' 'NF != 2 || $2 !~ /^(KEYWORD1|KEYWORD2|LITERAL1)$/ { exit 1 }' "$arduino/keywords.txt" || fail "keywords.txt"
[ "$(grep -c -e '^qtri_draw_mesh.KEYWORD2$' -e '^qtri_mesh.KEYWORD1$' "$arduino/keywords.txt")" = 2 ] || fail "keywords.txt lacks names"
find "$arduino/src" -name '*.c' -exec gcc -std=gnu11 -w -I"$arduino/src" -fsyntax-only {} + || fail "Arduino: sources"
# sketch NAME SOURCE...: the sketch with stand-ins of what it calls
sketch()
{
    name=$1
    shift
    quiet "Arduino, $name" g++ -std=gnu++11 -Wall -Wextra -I"$arduino/src" -Ihost -Itests/packages/arduino -Itests/packages/tft_espi -Itests/packages/lvgl \
        -include Arduino.h -o "$work/$name" -x c++ "$arduino/examples/$name/$name.ino" "$@" -x none "$work/glue-display.o" $glue_libraries &&
        quiet "Arduino, $name runs" timeout 60 "$work/$name"
}

glue_libraries="build/libqtri-host.a build/libqtri.a -lm $(make -s host-libs)"
for file in README.md examples keywords.txt; do
    [ -e "$arduino/$file" ] || fail "the Arduino library has no $file"
done
for field in name version author maintainer sentence paragraph category architectures includes; do
    grep -q "^$field=." "$arduino/library.properties" || fail "library.properties: no $field"
done
# An address is written into the manifests once, however often; without one they have none.
mkdir "$work/url" && cp library.json idf_component.yml "$work/url/"
for url in https://a.example/b/qtri https://c.example/d/qtri-2; do
    (cd "$work/url" && sh "$root/port/packages/url.sh" $url && [ "$(sh "$root/port/packages/url.sh")" = $url ] &&
        [ "$(grep -c "$url.git" library.json idf_component.yml | tr '\n' ' ')" = "library.json:1 idf_component.yml:1 " ] &&
        { ! command -v jq >/dev/null || [ "$(jq -r .repository.url library.json)" = $url.git ]; }) || fail "url.sh $url"
done
sh port/packages/url.sh http://a.example/b 2>/dev/null && fail "url.sh took what is not https"
if has g++ "Arduino sketches"; then
    quiet "Arduino, the display" gcc -std=c11 -Ihost -c -o "$work/glue-display.o" tests/packages/glue/display.c
    quiet "Arduino, LVGL" gcc -std=c11 -Itests/packages/lvgl -c -o "$work/lvgl.o" tests/packages/lvgl/lvgl.c
    for name in TexturedModel OledWireframe Gauge; do
        sketch $name tests/packages/arduino/core.cpp
    done
    sketch TftEspi tests/packages/tft_espi/glue.cpp
    sketch Lvgl tests/packages/arduino/run.cpp -x none "$work/lvgl.o"
    [ "$(ls -d "$arduino"/examples/*/ | wc -l)" = 5 ] || fail "not all of the Arduino library's sketches are tried"
fi

# The glue of the examples, with stand-ins of what it calls: frames arrive at a simulated controller -------------------

glue_flags='-O1 -Wall -Wextra -Werror -Icore/include -Iport/include'

# glue NAME EXAMPLE FOLDER: port/examples/glue/NAME.c with the stand-ins of tests/packages/FOLDER
glue()
{
    quiet "glue, $1, $2" gcc -std=c11 $glue_flags -Ihost -Itests/packages/"$3" -o "$work/glue" port/examples/"$2/$2".c \
        port/examples/glue/"$1".c tests/packages/"$3"/*.c tests/packages/glue/display.c $glue_libraries &&
        quiet "glue, $1, $2 runs" timeout 60 "$work/glue"
}

for example in mesh gauge; do
    glue pico $example pico
done
glue stm32_hal mesh stm32
glue esp_idf mesh esp_idf
glue zephyr mesh zephyr
glue lvgl mesh lvgl
# The first example with a model, as `make examples MODEL=knot` makes it.
quiet "a model" build/qtri model knot -o "$work/model.h"
quiet "the example with a model" gcc -std=c99 $glue_flags -Ihost -I"$work" -DQTRI_EXAMPLE_MODEL -o "$work/model" port/examples/mesh/mesh.c \
    port/examples/host.c port/examples/display.c $glue_libraries && quiet "the example with a model runs" "$work/model" lcd "$work"

if has g++ "glue of Arduino's libraries"; then
    quiet "glue, the example" gcc -std=c11 $glue_flags -c -o "$work/example.o" port/examples/mesh/mesh.c
    quiet "glue, the display" gcc -std=c11 $glue_flags -Ihost -c -o "$work/display.o" tests/packages/glue/display.c
    for name in arduino tft_espi lovyangfx; do
        quiet "glue, $name" g++ -std=gnu++11 $glue_flags -Itests/packages/$name -Itests/packages/arduino -o "$work/glue" \
            port/examples/glue/$name.cpp tests/packages/$name/glue.cpp "$work/example.o" "$work/display.o" $glue_libraries &&
            quiet "glue, $name runs" timeout 60 "$work/glue"
    done
fi
# What pushes pixels reads them by 16 or 32 bits: at -Os the compiler aligns no array of bytes by itself.
if has arm-none-eabi-g++ "alignment of the glue's memory"; then
    for name in tft_espi lovyangfx; do
        quiet "glue, $name, Cortex-M0+" arm-none-eabi-g++ -std=gnu++11 -mcpu=cortex-m0plus -mthumb -Os -ffreestanding -fdata-sections -Icore/include \
            -Iport/include -Itests/packages/$name -Itests/packages/arduino -c -o "$work/glue.o" port/examples/glue/$name.cpp &&
            arm-none-eabi-objdump -h "$work/glue.o" | grep 'lineMemory.*2\*\*[2-9]' >/dev/null || fail "glue, $name: lineMemory is not aligned"
    done
fi

# CMake -----------------------------------------------------------------------------------------------------------------

# consumer WAY OPTION...: configures, builds and runs it
consumer()
{
    way=$1
    shift
    quiet "cmake, $way, configured" cmake -S tests/packages/cmake -B "$work/cmake-$way" -DWAY="$way" -DQTRI="$root" "$@" &&
        quiet "cmake, $way, built" cmake --build "$work/cmake-$way" -j "$jobs" --target consumer
}

# By Ninja, where it is, the whole takes 74 seconds in place of 98.
command -v ninja >/dev/null 2>&1 && export CMAKE_GENERATOR=Ninja
if has cmake "CMake, ESP-IDF, Pico SDK and Zephyr"; then
    # What is installed is compiled without optimisation, as the levels of a Release are CMake's own and take a minute.
    quiet "cmake, configured" cmake -S . -B "$work/cmake" -DCMAKE_INSTALL_PREFIX="$work/cmake-prefix" -DCMAKE_C_FLAGS_RELEASE=-O0 &&
        quiet "cmake, built" cmake --build "$work/cmake" -j "$jobs" --target install
    grep -q '^CMAKE_BUILD_TYPE:STRING=Release$' "$work/cmake/CMakeCache.txt" || fail "cmake: not a Release without a type of build"
    consumer package -DCMAKE_PREFIX_PATH="$work/cmake-prefix" -DWANTED="$(sh port/packages/version.sh)" &&
        same "find_package" "$work/cmake-package/consumer"
    # Another minor version must not be found.
    cmake -S tests/packages/cmake -B "$work/cmake-newer" -DWAY=package -DCMAKE_PREFIX_PATH="$work/cmake-prefix" -DWANTED=99.0 >/dev/null 2>&1 &&
        fail "find_package found a version that there is not"
    # Without an option: the same picture, which needs nothing that is left out.
    consumer subdirectory && same "add_subdirectory" "$work/cmake-subdirectory/consumer"
    # These compile the same files: that they are configured, what with, and that the application compiles.
    for way in fetch pico esp zephyr; do
        quiet "cmake, $way" cmake -S tests/packages/cmake -B "$work/cmake-$way" -DWAY="$way" -DQTRI="$root" -DCMAKE_EXPORT_COMPILE_COMMANDS=ON || continue
        commands=$work/cmake-$way/compile_commands.json
        [ "$(grep -c '"file": .*/core/' "$commands")" = "$(ls core/*/*.c | wc -l)" ] || fail "cmake, $way: not all files of core/"
        case $way in
        esp | zephyr) off=QTRI_WITH_BROUGHT_PIPELINES ;;
        *) continue ;;
        esac
        [ "$(grep -c "D$off=0" "$commands")" = "$(grep -c '"file":' "$commands")" ] || fail "cmake, $way: $off=0 does not reach all files"
    done
    # The Pico's project as port/README.md builds it, with a model and without.
    for model in "" "$work/model.h"; do
        quiet "Pico, configured" env PICO_SDK_PATH="$root/tests/packages/pico" cmake -S port/packages/pico -B "$work/pico" \
            -DMODEL="$model" -DGLUE_LIBRARIES="$(printf %s "$glue_libraries" | sed "s:build/:$root/build/:g; s/ /;/g")" &&
            quiet "Pico, built" cmake --build "$work/pico" -j "$jobs" && quiet "Pico, runs" timeout 60 "$work/pico/mesh"
    done
fi
finish $status
