#!/bin/sh
# SPDX-License-Identifier: MIT
# Doxygen reads every public header without a warning, every public name is documented, and every function is in the
# pages, build/reference. Skipped where there is no Doxygen.
gate=reference
. tests/check/files.sh
command -v doxygen >/dev/null 2>&1 || {
    echo "check: $gate skipped, it needs doxygen, which \`make setup-all\` installs"
    exit 0
}
need awk sed grep

out=build/reference
rm -rf $out
mkdir -p $out
for image in $(sed -n 's,.*](\([^)]*\.\(png\|gif\)\)).*,\1,p' README.md); do
    mkdir -p "$out/$(dirname "$image")"
    cp "$image" "$out/$image"
done
number=$(awk '/define QTRI_VERSION_(MAJOR|MINOR|PATCH) /{ printf "%s%s", dot, $3; dot = "." }' core/include/qtri/version.h)
status=0
{
    cat tests/reference/Doxyfile
    echo "PROJECT_NUMBER = $number"
} | doxygen - 2>&1 | sed "s,^$PWD/,,; /^\$/d" >$out/warnings.txt
[ ! -s $out/warnings.txt ] || { cat $out/warnings.txt; status=1; }

# What a filter or the preprocessor loses is no warning.
grep -hoE '^[a-z][a-z0-9_ *]*\b(qtri|q16)_[a-z0-9_]+\(' $(c_files core/include/qtri port/include | grep -v /body/) | grep -v 'void qtri_fault(' |
    sed 's/($//; s/.*[ *]//' | LC_ALL=C sort -u >$out/declared.txt
sed -n 's,.*<name>\(.*\)</name>,\1,p' $out/qtri.tag | LC_ALL=C sort -u >$out/documented.txt
[ "$(wc -l <$out/declared.txt)" -gt 300 ] || { echo "fewer functions than there were"; status=1; }
LC_ALL=C comm -23 $out/declared.txt $out/documented.txt | sed 's/$/: not in the reference/' | grep . && status=1
rm -f $out/declared.txt $out/documented.txt $out/warnings.txt
[ $status != 0 ] || echo "reference: $out/index.html"
finish $status
