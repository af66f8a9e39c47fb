# SPDX-License-Identifier: MIT
# Where the instructions of one draw call go: awk -f profile.awk -v counts=COUNTS TABLE - < LOG  (called by profile.sh)
#
# LOG is what `qemu-system-arm -d in_asm,exec,nochain` writes: the addresses of every translation block, once, and a line
# for each execution of one. TABLE has a line `address stage symbol file function` (address in hexadecimal) for every
# instruction of the program: the symbol it lies in, and the function of the source it comes from, which may be inlined.
# A stage `-` means that of whoever called: helpers of arithmetic and memory.
#
# COUNTS gets a line `address count` for every instruction that was executed. Counted is what runs from the first
# instruction of bench_draw to the next of board_ticks.

function fail(message) {
    print "profile: " message >"/dev/stderr"
    failed = 1
    exit 1
}

function plain(address) { # without 0x, zeros in front and a colon behind
    sub(/^(0x)?0*/, "", address)
    sub(/:$/, "", address)
    return address
}

# A number for each name, in the order in which they come.
function number_of(kind, name) {
    if (!((kind, name) in number)) {
        number[kind, name] = ++names[kind]
        name_of[kind, names[kind]] = name
    }
    return number[kind, name]
}

# What was executed in a block that is entered at a stage; returns the stage that it leaves behind.
function stage_behind(block, stage,   list, i, n) {
    if (!((block, stage) in behind)) {
        n = split(addresses[block], list, " ")
        behind[block, stage] = stage
        for (i = n; i >= 1 && behind[block, stage] == stage; i--) {
            if (stage_at[list[i]] != "-") behind[block, stage] = stage_at[list[i]]
        }
    }
    return behind[block, stage]
}

# Adds up all executions of a block that were entered at a stage.
function add_up(block, stage, often,   list, i, n) {
    n = split(addresses[block], list, " ")
    for (i = 1; i <= n; i++) {
        if (!(list[i] in stage_at)) fail("an instruction was executed that the table does not know")
        if (stage_at[list[i]] != "-") stage = stage_at[list[i]]
        count[list[i]] += often
        instructions["stage", number_of("stage", stage)] += often
        instructions["symbol", number_of("symbol", symbol_at[list[i]])] += often
        instructions["function", number_of("function", function_at[list[i]])] += often
        if (i == 1 && begins[list[i]]) calls[number_of("symbol", symbol_at[list[i]])] += often
    }
    total += n * often
}

# The 25 names with the most instructions; of equal ones those that come first in the table.
function show(kind, title,   i, most, shown, at, tab, name) {
    printf "\n%12s%8s%s  %s\n", "instructions", "%", kind == "symbol" ? "     calls  per call" : "", title
    for (shown = 0; shown < 25; shown++) {
        most = 0
        for (i = 1; i <= names[kind]; i++) if (instructions[kind, i] > instructions[kind, most]) most = i
        if (most == 0) return
        at = instructions[kind, most]
        printf "%12d%8.1f", at, 100 * at / total
        if (kind == "symbol") printf "%10d%10.1f", calls[most], (calls[most] > 0 ? at / calls[most] : 0)
        name = name_of[kind, most]
        tab = index(name, "\t")
        if (tab == 0) printf "  %s \n", name
        else printf "  %-36s %s\n", substr(name, 1, tab - 1), substr(name, tab + 1)
        instructions[kind, most] = 0
    }
}

BEGIN { number_of("stage", "-") }

FILENAME != "-" {
    address = plain($1)
    in_order[++known] = address
    stage_at[address] = $2
    symbol_at[address] = $3 "\t" $4
    function_at[address] = $5 "\t" $4
    begins[address] = symbol_at[address] != last_symbol
    last_symbol = symbol_at[address]
    number_of("stage", $2)
    number_of("symbol", $3 "\t" $4)
    number_of("function", $5 "\t" $4)
    if (begins[address] && $3 == "bench_draw") draw = address
    if (begins[address] && $3 == "board_ticks") ticks = address
    next
}

/^0x/ { translated = translated plain($1) " "; next }
/^IN:/ { translated = ""; next }

# `Trace 0: 0x7f1e400053c0 [flags/pc/flags/cflags] symbol`: the address, and this translation of it
/^Trace/ {
    split(substr($0, index($0, "[") + 1), field, /[\/\]]/)
    pc = plain(field[2])
    key = pc "/" field[4]
    if (index(translated, pc " ") == 1) {
        if (addresses[block_of[key]] != translated) block_of[key] = ++blocks
        addresses[block_of[key]] = translated
        translated = ""
    }
    if (pc == draw) counting = 1
    if (pc == ticks) {
        counting = 0
        if (last != "") { ended = 1; exit }
    }
    if (counting) {
        if (!(key in block_of)) fail("a block was executed that was not translated")
        last = block_of[key]
        before = stage == "" ? "-" : stage
        times[last, before]++
        stage = stage_behind(last, before)
    }
    next
}

/^Stopped/ && counting && last != "" { times[last, before]--; stage = before } # it will run later

END {
    if (failed) exit 1
    if (draw == "" || ticks == "") fail("the program has no bench_draw or no board_ticks")
    if (!ended) fail("the log ends before bench_draw does")
    for (i in times) {
        split(i, part, SUBSEP)
        add_up(part[1], part[2], times[i])
    }
    for (i = 1; i <= known; i++) if (count[in_order[i]] > 0) print in_order[i], count[in_order[i]] >counts
    printf "%d instructions\n", total
    show("stage", "stage")
    show("symbol", "function, with what is inlined in it")
    show("function", "function of the source, inlined or not")
}
