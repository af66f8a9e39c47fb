#!/bin/sh
# SPDX-License-Identifier: MIT
# The accuracy report as one page without any other file: report.sh BUILD [MODELS]   (`make report` calls it)
# Needs BUILD/qtri; build/math.tsv and build/plots/*.svg where they are there.
set -eu
build=$1
models=${2:-}
here=host/report
work=$build/report
mkdir -p "$work"

"$build/qtri" demo -o "$build/demo" ${models:+--models "$models"} --report "$work/scenes.html" >"$work/demo.txt"
sh $here/figures.sh "$build" "$models" >"$work/figures.tsv"
differs=$(awk -F '\t' '$5 == "differs" || $5 == "unknown"' "$work/figures.tsv" | wc -l)
compared=$(awk -F '\t' '$5 == "ok"' "$work/figures.tsv" | wc -l)

# A table of a part: table PART TITLE-ID FILE...
table()
{
    part=$1
    shift
    echo '<div class="scroll" tabindex="0" role="region" aria-label="'"$part"'">'
    awk -v part="$part" -f $here/tables.awk "$@"
    echo '</div>'
}

{
    cat $here/head.html
    cat <<END
<h1>qtri: the accuracy report</h1>
<nav aria-label="parts"><a href="#scenes">scenes</a><a href="#functions">functions</a><a href="#cost">cost</a><a href="#peers">peers</a><a href="#figures">README's figures</a></nav>
<p>Written by <code>make report</code>. Every number stands with the command that prints it.</p>
<section id="scenes"><h2>Scenes: fixed point over double precision</h2>
<p><code>qtri demo --report FILE</code> draws each scene with the core and with an independent renderer in double precision. Left of the line is the core's picture; the slider, or the arrow keys on it, move the line.
Bars: how many pixels are off by so much of 255 in their worst channel, what only one of the two covers included; their height is logarithmic. Tables: as <code>qtri demo</code> prints them, <i>mismatch</i> and <i>snapped</i> being pixels that only one of the two covers, before and after vertices are put on the core's grid of 1/256 pixel; <i>colour</i> and <i>off by &gt; 1</i> where both show the same triangle; <i>depth</i> in steps of 1/65535.</p>
END
    cat "$work/scenes.html"
    echo '</section><section id="functions"><h2>Functions: the error over the whole domain</h2>'
    echo '<p><code>make plot-math</code>: least, mean and largest error of a column of inputs, against correctly rounded references.</p>'
    for name in sin atan2 sqrt; do
        [ ! -s "$build/plots/$name.svg" ] || printf '<p><img class="math-plot" width="960" height="900" alt="The error of q16_%s over its domain, in three panels; the largest is in the table below" src="data:image/svg+xml;base64,%s"></p>\n' "$name" "$(base64 <"$build/plots/$name.svg" | tr -d '\n')"
    done
    if [ -s "$build/math.tsv" ]; then
        echo '<p><code>make verify-math VERIFY=quick</code>: strata of the inputs; all of them take <code>make verify-math</code>, whose results are in core/math/README.md. 1 ULP is 1/65536; of rows that say so, relative.</p>'
        table math "$build/math.tsv"
    else
        echo '<p>Not there: <code>make verify-math VERIFY=quick</code> needs MPFR.</p>'
    fi
    echo '</section><section id="cost"><h2>Cost: every combination of options</h2>'
    echo '<p><code>make bench-matrix</code>, as host/bench/matrix-budgets.tsv has it: what a draw call takes on emulated cores.</p>'
    table matrix host/bench/matrix-budgets.tsv
    echo '</section><section id="peers"><h2>Flash against speed, beside others</h2>'
    echo '<p>Figures of others are those of ../shared/PEERS.md: measured side by side at commit c9cb230, and not anew since. qtri is as its budgets are now: <code>make size SIZE_APP=textured</code>, <code>make bench BENCH_CORES=cortex-m4</code>. TinyGL and rlsw are not in the plot: their flash was not measured.</p>'
    table peers host/bench/budgets.tsv $here/peers.tsv
    echo '</section><section id="figures"><h2>README'"'"'s figures</h2>'
    echo "<p><code>make check-figures</code>: $compared figures are those of their sources, $differs differ.</p>"
    table figures "$work/figures.tsv"
    echo '</section>'
    cat $here/slider.html
    echo '</html>'
} >"$work/report.html"
mv "$work/report.html" "$build/report.html"
rm -r "$work"
echo "report: $build/report.html, $compared of README's figures compared, $differs differ"
[ "$differs" = 0 ]
