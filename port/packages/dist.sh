#!/bin/sh
# SPDX-License-Identifier: MIT
# Makes from the tree what is handed out in other shapes:   dist.sh FOLDER
#   FOLDER/single/qtri.h qtri.c      the amalgamation: core and panels in two files
#   FOLDER/arduino/qtri/             a library for the Arduino IDE, as the Library Manager wants it
# Where the library can be had, for library.properties: QTRI_URL, or what the manifests say (url.sh), or the checkout's
# origin, where it is https.
set -eu
out=${1:?usage: dist.sh FOLDER}
version=$(sh port/packages/version.sh)
url=${QTRI_URL:-$(sh port/packages/url.sh)}
url=${url:-$(git config --get remote.origin.url 2>/dev/null | grep '^https://' || true)}
part=$out.part
rm -rf "$part"
mkdir -p "$part/single" "$part/arduino/qtri"

# The amalgamation -----------------------------------------------------------------------------------------------------

# In any order: private headers come where the first file includes them.
sources=$(LC_ALL=C ls core/*/*.c port/panels/*.c)
headers=$(LC_ALL=C ls core/include/qtri/*.h port/include/qtri_port/*.h)
awk -v mode=header -v version="$version" -f port/packages/amalgamate.awk core/include/qtri.h $headers >"$part/single/qtri.h"
awk -v mode=source -v version="$version" -f port/packages/amalgamate.awk $sources >"$part/single/qtri.c"
cp LICENSE "$part/single/"

# The Arduino library --------------------------------------------------------------------------------------------------

library=$part/arduino/qtri
mkdir -p "$library/src/qtri" "$library/src/qtri_port" "$library/examples"
cp LICENSE CHANGELOG.md "$library/"
cp port/packages/arduino/README.md "$library/"
cp core/include/qtri.h "$library/src/"
mkdir -p "$library/src/qtri/body"
cp core/include/qtri/*.h "$library/src/qtri/"
cp core/include/qtri/body/*.h "$library/src/qtri/body/"
# The IDE looks for headers in src/ alone, so both folders of public ones go there; the core's files name each other
# by `../bits/bits.h` and need no folder to search.
cp port/include/qtri_port/*.h "$library/src/qtri_port/"
mkdir -p "$library/src/core" "$library/src/core/panels"
for folder in core/*/; do
    folder=${folder%/}
    [ "$folder" != core/include ] || continue
    mkdir -p "$library/src/$folder"
    cp "$folder"/*.[ch] "$library/src/$folder/"
    for file in "$folder"/*.inc; do
        [ ! -f "$file" ] || cp "$file" "$library/src/$folder/"
    done
done
cp port/panels/*.[ch] "$library/src/core/panels/"
for example in port/packages/arduino/*/*.ino; do
    name=$(basename "$example" .ino)
    mkdir -p "$library/examples/$name"
    cp "$example" "$library/examples/$name/"
done
# What the Library Manager reads. Architectures are those whose int has 32 bits: qtri/config.h refuses AVR and megaAVR.
cat >"$library/library.properties" <<END
name=qtri
version=$version
author=the qtri authors
maintainer=the qtri authors
sentence=Fixed-point 3D renderer for microcontroller displays.
paragraph=Meshes, textures, lines and light, drawn in bands of a few rows into RGB565 or gray: no malloc, no float. With drivers for ILI9341, ST7789, SSD1306 and others, or into TFT_eSPI and LVGL.
category=Display
url=$url
architectures=esp32,esp8266,rp2040,mbed,mbed_rp2040,mbed_nano,mbed_giga,mbed_portenta,samd,sam,stm32,STM32F1,STM32F4,teensy,nrf52,renesas_uno,renesas_portenta,silabs
includes=qtri.h
END
[ -n "$url" ] || sed -i '/^url=$/d' "$library/library.properties"

# Types and functions of the public headers, for the editor's colours; fields are separated by tabs.
cat $headers | awk '
    /^ *(\/\*|\*)/ { next }
    /^typedef .*[ *]qtri_[a-z0-9_]+;/ { name = $NF; sub(/;.*/, "", name); type[name]; next }
    /^\} qtri_[a-z0-9_]+;/ { name = $2; sub(/;.*/, "", name); type[name]; next }
    /^typedef (struct|enum|union) qtri_/ { type[$3]; next }
    match($0, /(qtri|q16)_[a-z0-9_]+\(/) && /^[a-z]/ { word[substr($0, RSTART, RLENGTH - 1)] }
    match($0, /^#define Q(TRI)?[A-Z0-9_]+/) { literal[substr($2, 1, index($2 "(", "(") - 1)] }
    END {
        for (w in type) printf "%s\tKEYWORD1\n", w
        for (w in word) if (!(w in type)) printf "%s\tKEYWORD2\n", w
        for (w in literal) if (w !~ /_H$/) printf "%s\tLITERAL1\n", w
    }' | LC_ALL=C sort >"$library/keywords.txt"

rm -rf "$out"
mv "$part" "$out"
echo "$out/single/qtri.h $out/single/qtri.c $out/arduino/qtri: version $version"
