#!/bin/sh
# SPDX-License-Identifier: MIT
# The first command of all: what `make demo` needs and this machine lacks is installed (Debian and its descendants, as
# root), or named; then the demo is built and drawn. Arguments go to make: sh host/demo.sh MODELS=~/models
set -eu
# A folder of models is named from where this is called, the demo is built where it lies.
for word; do
    case $word in
    MODELS=/* | MODELS=) ;;
    MODELS=*) word=MODELS=$PWD/${word#MODELS=} ;;
    esac
    shift
    set -- "$@" "$word"
done
cd "$(dirname "$0")/.."

have()
{
    command -v "$1" >/dev/null 2>&1
}

# A compiler without its headers, or without the linker's libraries, is none.
compiles()
{
    try=$(mktemp -d) || return 1
    printf '#include <math.h>\n#include <stdint.h>\n#include <stdio.h>\nint main(int n, char **v) { return (int)sin(n); }\n' >"$try/try.c"
    if ${CC:-cc} -o "$try/try" "$try/try.c" -lm >/dev/null 2>&1; then
        rm -rf "$try"
        return 0
    fi
    rm -rf "$try"
    return 1
}

# Packages by Debian's names, and for everybody what they are.
missing= named=
need()
{
    missing="$missing $1"
    named="$named${named:+, }$2"
}

look()
{
    missing= named=
    have make || need make 'make'
    compiles || need 'gcc libc6-dev' 'a C compiler with its headers and libraries (cc, or the one that CC names)'
}

look
if [ -n "$missing" ]; then
    echo "demo: missing: $named"
    if ! have apt-get; then
        echo "demo: install it and run this again"
        exit 1
    fi
    if [ "$(id -u)" != 0 ]; then
        echo "demo: as root this installs it; or run: sudo apt-get install$missing"
        exit 1
    fi
    echo "demo: installing$missing"
    export DEBIAN_FRONTEND=noninteractive
    log=$(mktemp)
    if ! { apt-get update -qq && apt-get install -y -qq --no-install-recommends $missing; } >"$log" 2>&1; then
        cat "$log"
        rm -f "$log"
        exit 1
    fi
    rm -f "$log"
    look
    if [ -n "$missing" ]; then
        echo "demo: still missing: $named"
        exit 1
    fi
fi
exec make -j"$(getconf _NPROCESSORS_ONLN 2>/dev/null || echo 1)" demo "$@"
