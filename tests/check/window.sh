#!/bin/sh
# SPDX-License-Identifier: MIT
# The window without a screen: what it shows of scenes and examples is, pixel by pixel, what `qtri render` and the examples
# write, enlarged by whole pixels. Skipped where there is no SDL2.
gate=window
. tests/check/files.sh
need make
pkg-config --exists sdl2 2>/dev/null || {
    echo "check: $gate skipped, it needs libsdl2-dev and pkg-config, which \`make setup-all\` installs"
    exit 0
}

build=${BUILD:-build}
export SDL_VIDEODRIVER=dummy
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
make -s "$build/qtri" "$build/window/scene" "$build/window/example-mesh" "$build/window/example-attitude" \
    "$build/examples/mesh/host" "$build/examples/attitude/host" || finish 1
status=0

# scene FILE KEYS ARGUMENT...: the arguments of `qtri render` that draw what the keys ask for
scene()
{
    file=$1 keys=$2
    shift 2
    "$build/window/scene" "$file" ${keys:+--keys "$keys"} --shot "$work/seen.ppm" &&
        "$build/qtri" render "$file" "$@" -o "$work/drawn.ppm" && cmp "$work/seen.ppm" "$work/drawn.ppm" ||
        { echo "$file, keys '$keys': not the picture of render $*"; status=1; }
}
scene host/scenes/09-floor.scene '' --format rgb565
scene host/scenes/09-floor.scene f --format gray8
scene host/scenes/12-fog.scene bff --format rgb888
scene host/scenes/05-crossing.scene m --format rgb565 --reference
scene host/scenes/02-line-triangle.scene '' --format rgb565

for example in mesh:lcd attitude:oled; do
    name=${example%:*}
    mkdir "$work/$name"
    "$build/examples/$name/host" "${example#*:}" "$work/$name" >"$work/log" &&
        "$build/window/example-$name" "${example#*:}" 2 "$work/seen.ppm" && cmp "$work/seen.ppm" "$work/$name/2-$name.ppm" ||
        { echo "example $name: not the frame that it writes"; status=1; }
done

# Mistakes end with one line and a status; keys and options are told.
"$build/window/scene" none.scene --shot "$work/seen.ppm" 2>"$work/log"
[ $? = 1 ] && [ "$(wc -l <"$work/log")" = 1 ] && grep -q none.scene "$work/log" || { echo "a missing scene"; status=1; }
"$build/window/scene" 2>"$work/log"
[ $? = 2 ] || { echo "no scene at all"; status=1; }
"$build/window/scene" --help | grep -q wireframe || { echo "--help"; status=1; }
SDL_VIDEODRIVER=none "$build/window/scene" host/scenes/09-floor.scene 2>"$work/log"
[ $? = 1 ] && grep -q 'no display' "$work/log" || { echo "no display"; status=1; }
finish $status
