# SPDX-License-Identifier: MIT
# Compares README's figures with their sources: one line a figure, row, column, README's, the source's, status, source.
# Status: ok, differs, absent (no such source here), unknown (figures.tsv does not name the row).
# Reads figures.tsv, budgets.tsv, peers.tsv, what `qtri demo` printed, README.md, in that order.

BEGIN { OFS = "\t" }
FILENAME != file { file = FILENAME; files++ }

files == 1 && !/^#/ { split($0, part, "\t"); source[part[1], part[2]] = $0; next }
files == 2 && /^what\t/ { split($0, core, "\t"); next }
files == 2 && !/^#/ { count = split($0, part, "\t"); for (i = 2; i <= count; i++) if (part[i] != "-") budget[part[1], core[i]] = part[i]; next }
files == 3 && /^name\t/ { split($0, peer_title, "\t"); next }
files == 3 && !/^#/ { count = split($0, part, "\t"); for (i = 3; i <= count; i++) peer[part[1], peer_title[i]] = part[i]; next }
files == 4 && NF == 7 { for (i = 2; i <= 7; i++) demo[$1, i - 1] = $i; next }
files < 5 { next }

/^\|/ {
    count = split($0, cell, / *\| */)
    if (!in_table) {
        in_table = 1
        table = cell[2]
        for (i = 3; i < count; i++) title[i] = cell[i]
    } else if (cell[2] !~ /^-+$/ && table != "") {
        row(count)
    }
    next
}
{ in_table = 0 }

function row(count,    part, i, s) {
    if (!((table, cell[2]) in source)) {
        if (cell[3] ~ /^[0-9.,]+$/) {
            print cell[2], "-", cell[3], "-", "unknown", "host/report/figures.tsv"
        }
        return
    }
    named[table, cell[2]] = 1
    split(source[table, cell[2]], part, "\t")
    for (i = 3; i < count; i++) {
        s = lookup(part, i - 2)
        print cell[2], title[i], cell[i], s, s == "-" ? "absent" : near(cell[i], s) ? "ok" : "differs", command(part)
    }
}

function lookup(part, i,    cores, key) {
    if (part[3] == "budget") {
        split("cortex-m0plus cortex-m3 cortex-m4", cores, " ")
        key = part[4] SUBSEP cores[i]
        return key in budget ? sprintf("%.10g", budget[key] / part[5]) : "-"
    }
    if (part[3] == "size") {
        key = part[4] (i % 2 ? "-Os code" : "-Os stack") SUBSEP (i < 3 ? "cortex-m0plus" : "cortex-m3")
        return key in budget ? budget[key] : "-"
    }
    if (part[3] == "peer") {
        key = title[i + 2]
        sub(/[:,].*/, "", key)
        if (part[4] != "qtri") return (part[4], key) in peer ? peer[part[4], key] : "-"
        return key == "flash" ? budget["textured-Os code", "cortex-m0plus"] / 1000 : budget[key, "cortex-m4"] / 1000000
    }
    key = part[4] SUBSEP i
    return part[3] == "demo" && key in demo ? demo[key] : "-"
}

function command(part) {
    return part[3] == "budget" ? "make bench BENCH_SCENES=" part[4] : part[3] == "size" ? "make size SIZE_APP=" part[4] \
        : part[3] == "peer" ? "host/report/peers.tsv" : "qtri demo --only " part[4]
}

# Whether a figure is what is printed of a number: within half a step of its last digit; what has more digits, to its own.
function near(figure, number,    digits, half, own) {
    gsub(/,/, "", figure)
    digits = index(figure, ".") ? length(figure) - index(figure, ".") : 0
    half = .5 / 10 ^ digits
    own = number ~ /\.[0-9][0-9]$/ && digits < 2 ? .005 : 0
    return figure - number <= half + own + 1e-9 && number - figure <= half + own + 1e-9
}

END {
    for (key in source) {
        if (!(key in named)) {
            split(key, part, SUBSEP)
            print part[2], "-", "-", "-", "unknown", "README.md"
        }
    }
}
