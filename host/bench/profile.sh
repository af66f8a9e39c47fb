#!/bin/sh
# SPDX-License-Identifier: MIT
# Where the instructions of one scene go: profile.sh PROGRAM.elf TOOL-PREFIX EMULATOR...  (called by `make bench-profile`)
# PROGRAM draws one scene. The table of instructions is left beside PROGRAM.
set -eu
program=$1 prefix=$2
shift 2
table=${program%.elf}.instructions

"${prefix}objdump" -d --no-show-raw-insn "$program" | sed -n 's/^ *\([0-9a-f]*\):.*/0x\1/p' >"$table.addresses"
"${prefix}addr2line" -a -f -i -e "$program" <"$table.addresses" >"$table.lines"
# A symbol's address has bit 0 set where the code is Thumb, but nm leaves it out.
"${prefix}nm" -n "$program" | awk '$2 ~ /[tTwW]/ && $3 !~ /^\$/ { print $1, $3 }' >"$table.symbols"

# For each address addr2line prints the address, then `function`, `file:line` for it and for each it is inlined in.
awk '
    function stage_of(file, name,   r) {
        for (r = 1; r <= rules; r++) if (file ~ rule_file[r] && name ~ rule_name[r]) return rule_stage[r]
        return "other"
    }
    function finish() {
        if (address == "") return
        while (next_symbol <= symbols && symbol_at[next_symbol] <= key) symbol = symbol_name[next_symbol++]
        if (stage == "") stage = "-"
        if (symbol == "") symbol = "?"
        print substr(address, 3), stage, symbol, outer_file, inner == "??" || inner == "" ? symbol : inner
    }
    FILENAME == ARGV[1] { if ($0 !~ /^#/) { rule_file[++rules] = $1; rule_name[rules] = $2; rule_stage[rules] = $3 } next }
    FILENAME == ARGV[2] { symbol_at[++symbols] = $1; symbol_name[symbols] = $2; if (symbols == 1) next_symbol = 1; next }
    /^0x[0-9a-f]*$/ {
        finish()
        address = $1; key = substr("00000000" substr($1, 3), length($1) - 1)
        stage = inner = ""
        lines = 0
        next
    }
    ++lines % 2 == 1 { name = $1 == "" ? "??" : $1; if (lines == 1) inner = name; next }
    {
        # A path from its folder in the repository on; what has none comes from the library of the compiler.
        outer_file = "libgcc"
        if (match($1, /(^|\/)(core|host|port|build\/bench)\/[a-z_0-9]+\/[^:]*/)) outer_file = substr($1, RSTART, RLENGTH)
        sub(/^\//, "", outer_file)
        if (stage == "" || stage == "-") stage = stage_of(outer_file, name)
    }
    END { finish() }
' host/bench/stages.tsv "$table.symbols" "$table.lines" >"$table"
rm -f "$table.addresses" "$table.symbols" "$table.lines"

"$@" -display none -monitor none -serial null -d in_asm,exec,nochain -D /dev/stdout -kernel "$program" </dev/null 2>/dev/null |
    awk -f host/bench/profile.awk -v counts="${program%.elf}.counts" "$table" -

# FUNCTIONS: their disassembly, with how often each instruction ran.
for name in ${FUNCTIONS:-}; do
    printf '\n%12s  %s\n' executed "$name"
    "${prefix}objdump" -d --no-show-raw-insn --disassemble="$name" "$program" | awk '
        NR == FNR { count[$1] = $2; next }
        /^ *[0-9a-f]+:/ { address = $1; sub(/:.*/, "", address); printf "%12s  %s\n", count[address], $0; next }
        /^[0-9a-f]+ </ { print "              " $0 }' "${program%.elf}.counts" -
done
