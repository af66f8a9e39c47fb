#!/bin/sh
# SPDX-License-Identifier: MIT
# A public header compiles alone, in C99 and in C++11, and a C++ program links with all it declares.
gate=headers
. tests/check/files.sh
need gcc g++ clang-tidy nm

flags='-Wall -Wextra -Wpedantic -Wconversion -Wshadow -Wundef -Werror -Icore/include -Iport/include'
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
status=0

headers=$(c_files core/include port/include | sed 's,^.*/include/,,')
mkdir -p $(for header in $headers; do echo "$work/one/${header%/*}"; done)
for header in $headers; do
    one=$work/one/$header.c
    echo "#include \"$header\"" >"$one"
    echo "#include \"$header\"" >>"$one" # twice: its guard
    echo "extern int one;" >>"$one"        # config.h declares nothing
done
# As C and as C++, by gcc and by clang's front end in clang-tidy, which is begun once for all of them.
for language in 'c -std=c99' 'c++ -std=c++11'; do
    find "$work/one" -name '*.c' | xargs gcc -x $language $flags -fsyntax-only || status=1
    find "$work/one" -name '*.c' | tidy "$diagnostics" "-x $language $flags" || status=1
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
