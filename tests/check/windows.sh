#!/bin/sh
# SPDX-License-Identifier: MIT
# The command compiles for Windows by MinGW, and under Wine, where that is installed, writes the bytes that it writes here.
# Skipped where there is no MinGW. Both are built without libraries and without optimisation, which takes half the time.
gate=windows
. tests/check/files.sh
need make
command -v x86_64-w64-mingw32-gcc >/dev/null || {
    echo "check: $gate skipped, it needs gcc-mingw-w64-x86-64-win32, which \`make setup-all\` installs"
    exit 0
}
unset MAKEFLAGS
folder=build/check-windows
make -s -j"$jobs" windows WINDOWS_BUILD=$folder/windows \
    CFLAGS='-O0 -Werror=implicit-function-declaration -Werror=int-conversion' || finish 1

# Debian's package does not put it on the path.
for wine in wine64 wine /usr/lib/wine/wine64 ''; do
    command -v "$wine" >/dev/null && break
done
[ -n "$wine" ] || {
    echo "check: $gate: nothing was run, that needs wine64"
    finish 0
    exit 0
}
make -s -j"$jobs" BUILD=$folder/here WITH= CFLAGS=-O0 $folder/here/qtri || finish 1
export WINEPREFIX="$PWD/$folder/wine" WINEDEBUG=-all WINEDLLOVERRIDES='mscoree,mshtml='
rm -rf "$folder/files"
mkdir -p "$folder/files/windows" "$folder/files/here"
status=0

windows()
{
    timeout 60 "$wine" "$folder/windows/qtri.exe" "$@" 2>"$folder/messages"
}

complain()
{
    echo "windows: $*"
    cat "$folder/messages"
    status=1
}

# same FILE ARGUMENT...: both write FILE, the same bytes; @ in an argument is the folder of what is written.
same()
{
    file=$1
    shift
    windows $(echo "$@" | sed "s,@,$folder/files/windows,g") >"$folder/output" &&
        "$folder/here/qtri" $(echo "$@" | sed "s,@,$folder/files/here,g") >"$folder/output.here" 2>/dev/null &&
        cmp "$folder/files/windows/$file" "$folder/files/here/$file" && cmp "$folder/output" "$folder/output.here" ||
        complain "$*"
}

input=$folder/files/m.obj
printf 'mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 .1\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nusemtl red\nf 1/1 2/2 3/3\nf 1/1 3/3 4/2\n' >"$input"
printf 'newmtl red\nKd .8 .1 .1\nmap_Kd m.ppm\n' >"$folder/files/m.mtl"
printf 'P6 2 2 255\n\377\001\001\001\377\001\001\001\377\011\012\015' >"$folder/files/m.ppm"
same gear.h mesh gear -o @/gear.h
same m.h mesh $input -o @/m.h
same m.h mesh $input --scale 2 -o @/m.h # in the place of the one there is
same car.h model $input -o @/car.h --preview @/car.png
same skin.h texture $folder/files/m.ppm -o @/skin.h
same font.h font host/fonts/small.bdf -o @/font.h
same floor.png render host/scenes/09-floor.scene -o @/floor.png
windows model "$(echo "$input" | tr / '\\')" --name car -o - >"$folder/files/windows/car2.h" &&
    "$folder/here/qtri" model "$input" --name car -o - >"$folder/files/here/car2.h" 2>/dev/null &&
    cmp "$folder/files/windows/car2.h" "$folder/files/here/car2.h" || complain 'folders named by \, standard output'
windows mesh "$input" -o "$input" && complain 'an input was written over'
grep -q 'has been read' "$folder/messages" || complain 'not the message of an input that would be written over'
windows --seconds 1 render host/scenes/09-floor.scene --frames 100000 -o "$folder/files/windows/late.y4m"
[ $? = 1 ] && grep -q 'not done after 1 seconds' "$folder/messages" || complain 'no end after a second'
ls -A "$folder/files/windows" | grep -q 'part$' && complain 'an unfinished file is left behind'
finish $status
