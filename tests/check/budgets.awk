# SPDX-License-Identifier: MIT
# Prints what is more than 2 % above its budget, or has none: awk -v target=budgets -f budgets.awk TABLE NOW, both as
# host/bench/budgets.sh prints them; `target` is what writes TABLE. Counts repeat exactly with one compiler; with another
# version, differences are told but are no failure.
BEGIN { FS = "\t" }
function compiler(core) { return core ~ /^rv32/ ? "riscv" : "arm" }
# `# arm arm-none-eabi-gcc ... 12.2.1`: the compiler that the figures are of
/^#/ { split($0, part, " "); if (NR == FNR) version[part[2]] = $0; else if ($0 != version[part[2]]) other[part[2]] = $0; next }
$1 == "what" { for (c = 2; c <= NF; c++) core[c] = $c; next }
NR == FNR { for (c = 2; c <= NF; c++) if ($c != "-") budget[$1, core[c]] = $c; next }
{
    for (c = 2; c <= NF; c++) {
        if ($c == "-") continue
        if (!(($1, core[c]) in budget)) { print $1 ", " core[c] ": no budget (make " target ")"; failed = 1; continue }
        most = budget[$1, core[c]]
        compared++
        used[compiler(core[c])]
        if ($c < .98 * most) better++
        if ($c <= 1.02 * most) continue
        notice = compiler(core[c]) in other
        if (!notice) failed = 1
        printf "%s%s, %s: %d, the budget is %d (%+.1f %%)\n", notice ? "notice: " : "", $1, core[c], $c, most, most ? 100 * ($c / most - 1) : 100
    }
}
END {
    for (c in other) if (c in used) print "notice: the budgets are of another compiler: " substr(version[c], 3) "; here: " substr(other[c], 3)
    if (better) print "notice: " better " figures are more than 2 % below their budgets: make " target
    if (!compared) { print "nothing was compared with a budget"; failed = 1 }
    exit failed
}
