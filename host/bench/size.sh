#!/bin/sh
# SPDX-License-Identifier: MIT
# Gathers the sizes of applications: size.sh FOLDER OBJECTS TABLE.tsv "APPLICATION..." CORE-OPTIMIZATION...   (called by
# `make size`)
# FOLDER/CORE-OPTIMIZATION/APPLICATION.map tells what was linked, .txt how much stack it used, app_APPLICATION.su below
# OBJECTS how much of that was the application's own functions'.
# APPLICATION-single is APPLICATION with the library in one file; its files are in
# FOLDER/CORE-OPTIMIZATION-single/. Then the table has
#
#   application core optimize code rodata static_ram stack code_core ram_application
#
# code is what the application needs of the library: core/, and what the compiler adds for it (64-bit division, memcpy);
# code_core is core/ alone. rodata and static_ram are of core/. The application's own code, data and buffers, and the
# start-up code, are not counted. stack is the deepest below the application's own frame. ram_application is its
# static memory, which it hands to the library: band, vertices, lists, view.
set -eu
folder=$1 objects=$2 table=$3 applications=$4
shift 4
[ $# -gt 0 ] || exit 0

printf 'application\tcore\toptimize\tcode\trodata\tstatic_ram\tstack\tcode_core\tram_application\n' >"$table"
for application in $applications; do
    for variant; do
        case $application in
        *-single) base=${application%-single} files=$folder/$variant-single ;;
        *) base=$application files=$folder/$variant ;;
        esac
        [ -f "$files/$base.txt" ] || continue # what has its own library is measured on few cores
        awk -v application="$application" -v base="$base" -v core="${variant%-O*}" -v optimize="O${variant##*-O}" '
            function frame_of(name) { return name in frame ? frame[name] : 0 }
            # `app_flat.c:40:6:app_frame 16 static`
            FILENAME ~ /\.su$/ { n = split($1, part, ":"); frame[part[n]] = $2; next }
            FILENAME ~ /\.txt$/ {
                if ($1 == "pixels") { if ($2 == 0) nothing = 1; next }
                used = $2 - frame_of("app_" $1)
                if (used > stack) stack = used
                next
            }
            # The map: ` .text.name  0xADDRESS  0xSIZE  FILE`, or the name alone on a line before the rest.
            /^Linker script and memory map/ { map = 1 }
            !map { next }
            NF == 1 && /^ \./ { section = $1; next }
            NF == 4 && /^ \./ { section = $1; address = $2; size = $3; file = $4; add() }
            NF == 3 && /^ +0x/ && section != "" { address = $1; size = $2; file = $3; add() }
            { section = "" }
            function hexadecimal(text,   i, value) {
                value = 0
                for (i = 3; i <= length(text); i++) value = 16 * value + index("0123456789abcdef", substr(text, i, 1)) - 1
                return value
            }
            function add(   bytes, own, helper) {
                bytes = hexadecimal(size)
                own = file ~ /\/core\/[a-z]+\/[^\/]*\.o$/ || file ~ /\/size\/[^\/]*\/qtri\.o$/
                helper = file ~ /libgcc\.a/ || file ~ /boards\/common\/memory\.o$/
                if (file ~ ("/app_" base "\\.o$") && section ~ /^\.(data|bss)/) ram_application += bytes
                if (!own && !helper) return
                if (section ~ /^\.text/) { code += bytes; if (own) code_core += bytes }
                else if (section ~ /^\.rodata/) rodata += bytes
                else if (section ~ /^\.(data|bss)/) static_ram += bytes
            }
            END {
                if (nothing || code == 0) { print "size: " application " " core ": drew nothing" >"/dev/stderr"; exit 1 }
                printf "%s\t%s\t%s\t%d\t%d\t%d\t%d\t%d\t%d\n", application, core, optimize, code, rodata, static_ram, stack, code_core, ram_application
            }' "$objects/${variant%-O2}/host/bench/app_$base.su" "$files/$base.txt" "$files/$base.map" >>"$table"
    done
done

# PEERS.md: code on the M0+ at -Os, of a library built for the application; for all: stack and static memory. 24 KB: all
# RAM of a mesh of 500 vertices in bands.
awk -F '\t' '
    function show(figure, aim) {
        if (aim == "") return sprintf("%8d%8s", figure, "")
        all++
        if (figure > aim) missed++
        return sprintf("%8d%8s", figure, (figure > aim ? " ! " : " ") "(" aim ")")
    }
    NR == 1 { print "Bytes; code with what the compiler adds. In brackets: the target; ! where it is missed."
        printf "%-16s%-15s%-4s%16s%16s%8s%16s%16s\n", "", "", "", "code+constants ", "code", "rodata", "static RAM", "stack"; next }
    {
        aim = $2 == "cortex-m0plus" && $3 == "Os" && $1 ~ /-only$/ ? ($1 == "flat-only" ? 6144 : 12288) : ""
        printf "%-16s%-15s%-4s%s%s%8d%s%s\n", $1, $2, $3, show($4 + $5, aim), show($4, ""), $5, show($6, 0), show($7, 600)
        if ($1 == "bands") told = told sprintf("%-16s%-15s%-4s  RAM all told: %d static + %d stack = %s\n", $1, $2, $3, $9 + $6, $7, show($9 + $6 + $7, 24576))
    }
    END { printf "%s", told; printf "size: %d of %d targets met\n", all - missed, all }' "$table"
