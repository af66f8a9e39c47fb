# SPDX-License-Identifier: MIT
# The report's tables, as HTML: awk -v part=figures|math|matrix|peers -f tables.awk FILE...

BEGIN { FS = "\t" }
/^#/ { next }

function escaped(t) { gsub(/&/, "\\&amp;", t); gsub(/</, "\\&lt;", t); return t }
function number(t) { return t == "" ? "<td>" : "<td class=\"n\">" t }

# README's figures beside their sources: what figures.awk prints.
part == "figures" {
    if (NR == 1) {
        print "<table><caption>README's figures and what their sources say</caption><thead><tr><th scope=\"col\">row<th scope=\"col\">figure<th scope=\"col\">README<th scope=\"col\">source<th scope=\"col\">status<th scope=\"col\">command</thead>"
    }
    s = $4 ~ /\.[0-9][0-9][0-9]/ ? sprintf("%.3f", $4) : $4
    printf "<tr class=\"%s\"><th scope=\"row\">%s<td>%s%s%s<td>%s<td><code>%s</code>\n", $5, escaped($1), escaped($2), number($3), number(s), \
        $5, escaped($6)
}

# The error of each function: build/math.tsv.
part == "math" {
    if (FNR == 1) {
        print "<table><caption>Largest errors found, and the share of correctly rounded results</caption><thead><tr><th scope=\"col\">function<th scope=\"col\">domain<th scope=\"col\">inputs<th scope=\"col\">largest error, ULP<th scope=\"col\"><span class=\"hidden\">as a bar up to 1 ULP</span><th scope=\"col\">at (raw)<th scope=\"col\">correctly rounded, %</thead>"
        next
    }
    w = $4 > 1 ? 1 : $4
    split($5, at, ",")
    printf "<tr><th scope=\"row\">%s<td>%s%s%s<td><span class=\"bar%s\" style=\"width:%.0fpx\"></span>%s%s\n", escaped($1), escaped($2), number($3), number($4), \
        ($4 > .5 ? " over" : ""), 100 * w, number(at[1] (at[2] != "" ? ", " at[2] : "") (at[3] != "" ? ", ..." : "")), number($6)
}

# The cost matrix: a row a combination, a column a geometry and core; matrix-budgets.tsv.
part == "matrix" {
    if ($1 == "what") { next }
    geometry = $1
    sub(/.*\//, "", geometry)
    name = substr($1, 1, length($1) - length(geometry) - 1)
    if (!(name in known)) { known[name] = 1; order[++rows] = name }
    if (!(geometry in column)) { column[geometry] = 1; geometries[++columns] = geometry }
    for (core = 2; core <= 3; core++) {
        cost[name, geometry, core] = $core
        if (!((geometry, core) in least) || $core < least[geometry, core]) least[geometry, core] = $core
    }
}

# Others: peers.tsv, after budgets.tsv.
part == "peers" && $1 == "what" { for (i = 2; i <= NF; i++) core_of[i] = $i; next }
part == "peers" && NR == FNR { for (i = 2; i <= NF; i++) budget[$1, core_of[i]] = $i; next }
part == "peers" {
    peers++
    for (i = 1; i <= NF; i++) peer[peers, i] = $i
    width = NF
}

END {
    if (part == "figures" || part == "math") print "</table>"
    if (part == "matrix") matrix()
    if (part == "peers") { peers_table(); peers_plot() }
}

function matrix(    r, c, core, v, share) {
    printf "<table class=\"heat\"><caption>Millions of instructions a frame; the more colour, the more times the column's least</caption><thead><tr><th scope=\"col\" rowspan=\"2\">format / depth test / source / texels / filter / wrap"
    for (core = 2; core <= 3; core++) printf "<th scope=\"colgroup\" colspan=\"%d\">%s", columns, core == 2 ? "Cortex-M0+" : "Cortex-M3"
    printf "<tr>"
    for (core = 2; core <= 3; core++) for (c = 1; c <= columns; c++) printf "<th scope=\"col\">%s", geometries[c]
    print "</thead>"
    for (r = 1; r <= rows; r++) {
        printf "<tr><th scope=\"row\">%s", order[r]
        for (core = 2; core <= 3; core++) for (c = 1; c <= columns; c++) {
            v = cost[order[r], geometries[c], core]
            if (v == "") { printf "<td>"; continue }
            # From 1 to 40 times the least: a share of the colour.
            share = log(v / least[geometries[c], core]) / log(40)
            printf "<td class=\"n\" style=\"--heat:%.2f\" title=\"%.1f times the least\">%.2f", (share > 1 ? 1 : share), v / least[geometries[c], core], v / 1e6
        }
        print ""
    }
    print "</table>"
}

# qtri's own row, of today's budgets.
function own(i,    title) {
    title = peer[1, i]
    if (i == 1) return "qtri"
    if (i == 2) return "this one"
    if (title == "flash") return sprintf("%.1f", budget["textured-Os code", "cortex-m0plus"] / 1000)
    return (title, "cortex-m4") in budget ? sprintf("%.3g", budget[title, "cortex-m4"] / 1e6) : ""
}

function peers_table(    p, i) {
    print "<table><caption>Flash in KB, millions of instructions a frame on a Cortex-M4F, wrong texels of 100,000</caption><thead><tr>"
    for (i = 1; i <= width; i++) printf "<th scope=\"col\">%s", peer[1, i]
    printf "</thead>\n<tr class=\"own\"><th scope=\"row\">qtri"
    for (i = 2; i <= width; i++) printf "%s", number(own(i))
    print ""
    for (p = 2; p <= peers; p++) {
        printf "<tr><th scope=\"row\">%s", peer[p, 1]
        for (i = 2; i <= width; i++) printf "%s", number(peer[p, i])
        print ""
    }
    print "</table>"
}

# Of S6: those of which both numbers are known. From 4 to 64 KB and from 2 to 16 million, logarithmic.
function peers_plot(    p, i, flash, speed, x, y, k) {
    for (i = 1; i <= width; i++) { if (peer[1, i] == "flash") flash = i; if (peer[1, i] == "S6") speed = i }
    print "<svg class=\"plot\" viewBox=\"0 0 520 330\" role=\"img\" aria-label=\"Flash against instructions a frame of spot, lit and textured: the table above has the numbers\">"
    for (k = 4; k <= 64; k *= 2) printf "<line class=\"grid\" x1=\"%d\" y1=\"20\" x2=\"%d\" y2=\"280\"/><text x=\"%d\" y=\"298\">%d</text>\n", px(k), px(k), px(k), k
    for (k = 2; k <= 16; k *= 2) printf "<line class=\"grid\" x1=\"60\" y1=\"%d\" x2=\"500\" y2=\"%d\"/><text x=\"45\" y=\"%d\">%d</text>\n", py(k), py(k), py(k) + 4, k
    print "<text x=\"280\" y=\"322\">flash, KB (-Os, M0+, lit textured crate)</text><text transform=\"translate(16 150) rotate(-90)\">millions a frame, S6 on M4F</text>"
    for (p = 1; p <= peers; p++) {
        x = p == 1 ? own(flash) : peer[p, flash]
        y = p == 1 ? own(speed) : peer[p, speed]
        if (x == "" || y == "") continue
        printf "<circle class=\"%s\" cx=\"%.1f\" cy=\"%.1f\" r=\"6\"/><text x=\"%.1f\" y=\"%.1f\">%s</text>\n", p == 1 ? "own" : "", px(x), py(y), px(x), py(y) - 12, p == 1 ? "qtri" : peer[p, 1]
    }
    print "</svg>"
}

function px(x) { return 60 + 440 * log(x / 4) / log(16) }
function py(y) { return 280 - 260 * log(y / 2) / log(8) }
