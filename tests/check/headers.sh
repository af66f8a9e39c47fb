#!/bin/sh
# SPDX-License-Identifier: MIT
# A public header compiles alone, in C99 and in C++11, and a C++ program links with all it declares.
gate=headers
. tests/check/files.sh
need gcc clang g++ clang++ nm

flags='-Wall -Wextra -Wpedantic -Wconversion -Wshadow -Wundef -Werror -Icore/include -Iport/include'
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
status=0

headers=$(c_files core/include port/include | sed 's,^.*/include/,,')
for header in $headers; do
    echo "#include \"$header\"" >"$work/one.c"
    echo "#include \"$header\"" >>"$work/one.c" # twice: its guard
    echo "extern int one;" >>"$work/one.c"        # config.h declares nothing
    for compiler in gcc clang; do
        $compiler -std=c99 $flags -x c -fsyntax-only "$work/one.c" || { echo "$header: $compiler"; status=1; }
    done
    for compiler in g++ clang++; do
        $compiler -std=c++11 $flags -x c++ -fsyntax-only "$work/one.c" || { echo "$header: $compiler"; status=1; }
    done
done

# A step of a panel with 16 parameters compiles, one with 17 does not, in neither language.
for count in 16 17; do
    echo '#include "qtri_port/panel.h"' >"$work/step.c"
    echo "extern const qtri_panel_step step; const qtri_panel_step step = QTRI_STEP(0xE0, 0$(seq -s '' -f ', %g' $count));" >>"$work/step.c"
    for compiler in 'gcc -std=c99 -x c' 'g++ -std=c++11 -x c++'; do
        $compiler $flags -fsyntax-only "$work/step.c" 2>/dev/null && compiles=16 || compiles=17
        [ "$compiles" = "$count" ] || { echo "qtri_port/panel.h: a step of $count parameters, ${compiler%% *}"; status=1; }
    done
done

# The address of every function that both a header and the library name; a header without extern "C" does not link.
library=${BUILD:-build}/libqtri.a
plain_build "$library" || finish 1
{
    for header in $headers; do
        echo "#include \"$header\""
    done
    echo 'static const void *volatile sink; int main() {'
    nm -g --defined-only "$library" | awk 'NF == 3 { print $3 }' | sort -u >"$work/defined"
    cat $(c_files core/include port/include) | tr -c 'A-Za-z0-9_' '\n' | sort -u >"$work/words"
    comm -12 "$work/defined" "$work/words" | sed 's/.*/sink = (const void *)\&&;/'
    echo '}'
} >"$work/all.cc"
g++ -std=c++11 -Icore/include -Iport/include -c -o "$work/all.oo" "$work/all.cc" &&
    g++ -o "$work/all" "$work/all.oo" "$library" || status=1
grep -q sink.=. "$work/all.cc" || { echo "no public function found"; status=1; }
finish $status
