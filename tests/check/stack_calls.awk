# SPDX-License-Identifier: MIT
# The call graph of compilers, from `node` and `edge` lines of their .ci files, and what indirect calls lead to by
# stack.calls: how deep a function goes, and by which calls. For awk -F '"', before a program that has
# complain(text).

BEGIN {
    while ((getline line < "tests/check/stack.calls") > 0) {
        n = split(line, field, " ")
        if (field[1] == "group") for (i = 3; i <= n; i++) group[field[2]] = group[field[2]] " " field[i]
        if (field[1] == "call") for (i = 3; i <= n; i++) targets[field[2]] = targets[field[2]] " " field[i]
        if (field[1] == "never") for (i = 3; i <= n; i++) never[field[2]] = never[field[2]] " " field[i]
        if (field[1] == "limit") { limits++; limit_name[limits] = field[2]; limit_bytes[limits] = field[3] }
    }
}

# "*" is any letters.
function pattern(glob) { gsub(/\./, "[.]", glob); gsub(/\*/, ".*", glob); return "^" glob "([.](part|constprop|isra)[.].*)?$" }
/^node:/ {
    if (split($4, part, "\\\\n") >= 3 && match(part[3], /[0-9]+ bytes/)) {
        frame[$2] = substr(part[3], RSTART) + 0
        file_of[$2] = part[2]; sub(/:.*/, "", file_of[$2])
        if (part[3] ~ /dynamic/) complain($2 ": the size of its frame depends on arguments")
    }
}
/^edge:/ && !(($2, $4) in edge) { edge[$2, $4]; out[$2] = out[$2] " " $4; called[$4] }
# The functions that a word of the list stands for, each with a blank before it.
function expand(word,   t, n, i, list, found) {
    if (word in expanded) return expanded[word]
    found = ""
    if (word in group) {
        n = split(group[word], list, " ")
        for (i = 1; i <= n; i++) found = found expand(list[i])
    } else for (t in frame) if (t ~ pattern(word)) found = found " " t
    return expanded[word] = found
}
function whole(t) { sub(/[.](part|constprop|isra)[.].*$/, "", t); return t }
function indirect(from,   key, n, i, list, found) {
    key = whole(from)
    if (!(key in targets)) key = file_of[from]
    if (!(key in targets)) { complain(from ": its indirect call is in no list"); return "" }
    n = split(targets[key], list, " ")
    found = ""
    for (i = 1; i <= n; i++) {
        if (list[i] != "application" && expand(list[i]) == "") unknown[list[i]]
        found = found expand(list[i])
    }
    return found
}
# `cut`: what is never below the functions that led to t.
function depth(t,   n, i, list, d, best, next_t, outer) {
    if (index(cut " ", " " whole(t) " ")) return 0
    if ((cut, t) in known) return known[cut, t]
    if (t in busy) {
        if (!((t, "met") in busy)) { busy[t, "met"]; complain(t ": calls itself, perhaps through others: " path) }
        return 0
    }
    busy[t]
    sub(/$/, " " t, path)
    best = 0
    outer = cut
    if (whole(t) in never) cut = cut never[whole(t)]
    n = split(out[t] ((t, "__indirect_call") in edge ? indirect(t) : ""), list, " ")
    for (i = 1; i <= n; i++) if (list[i] != "__indirect_call") {
        d = depth(list[i])
        if (d > best) { best = d; next_t = list[i] }
    }
    cut = outer
    sub(/ [^ ]*$/, "", path)
    delete busy[t]
    next_of[cut, t] = next_t
    return known[cut, t] = frame[t] + best
}
