# SPDX-License-Identifier: MIT
# Joins files of C into one; see dist.sh.   awk -v mode=header|source -v version=1.2.3 -f amalgamate.awk FILE...
#
# header: the files, and what they include from the project in its place, each once.
# source: the .c files, private headers in place of their first #include and .inc files in place of each. The public
#   headers are qtri.h. Names of file scope without the project's prefix (static functions, types, constants) get that
#   of their file, `line` of raster/small.c is small_line, so that no two files mean different things by one name; macros
#   of a file end with it.
#   Headers of public folders are read once, so a file that is compiled with QTRI_PIPELINE_IS_ANY gets inline functions
#   of its own: QTRI_BODY ones of what it includes, and their macros, once more.

BEGIN {
    split("auto break case char const continue default do double else enum extern float for goto if inline int long register " \
          "restrict return short signed sizeof static struct switch typedef union unsigned void volatile while " \
          "__attribute__ __may_alias__ always_inline noinline bool", list, " ")
    for (i in list) keyword[list[i]]
    if (mode == "header") {
        print "/* SPDX-License-Identifier: MIT */"
        print "/* qtri " version ", made of many files by `make dist`; qtri.c goes with it. */"
        print "#ifndef QTRI_AMALGAMATION_H\n#define QTRI_AMALGAMATION_H\n"
        for (i = 1; i < ARGC; i++) header(ARGV[i])
        print "\n#endif"
    } else {
        print "/* SPDX-License-Identifier: MIT */"
        print "/* qtri " version ", made of many files by `make dist`; qtri.h goes with it. */"
        print "#define QTRI_AMALGAMATION 1\n#include \"qtri.h\"\n\n#ifdef __clang__\n#pragma clang diagnostic ignored \"-Wunused-function\" /* what only some files of the library use */\n#endif\n\n#include <limits.h>\n#include <string.h>"
        for (i = 1; i < ARGC; i++) source(ARGV[i])
    }
    exit failed
}

function complain(text)
{
    print "amalgamate: " text >"/dev/stderr"
    failed = 1
}

function exists(path,   line, ok)
{
    ok = (getline line <path) >= 0
    close(path)
    return ok
}

# a/b/../c -> a/c
function plain(path)
{
    while (sub(/[^\/]+\/\.\.\//, "", path)) {}
    return path
}

# The project's file that a line of `from` includes; "" for the system's.
function included(text, from,   name, place, i)
{
    if (text !~ /^ *# *include *"/) return ""
    name = text
    sub(/^[^"]*"/, "", name)
    sub(/".*/, "", name)
    sub(/[^\/]*$/, "", from)
    split(plain(from name) " core/include/" name " port/include/" name, place, " ")
    for (i = 1; i <= 3; i++) if (exists(place[i])) return place[i]
    complain(from ": no file " name)
    return ""
}

# Lines of a file into text[path, 1..]; how many.
function read(path,   line, n)
{
    if (path in lines) return lines[path]
    while ((getline line <path) > 0) text[path, ++n] = line
    close(path)
    return lines[path] = n + 0
}

function is_licence(line)
{
    return line ~ /SPDX-License-Identifier/
}

function header(path,   n, i, inner)
{
    if (path in done) return
    done[path]
    n = read(path)
    print "\n/* " path " */"
    for (i = 1; i <= n; i++) {
        inner = included(text[path, i], path)
        if (inner != "") header(inner)
        else if (!is_licence(text[path, i])) print text[path, i]
    }
}

function private_header(path)
{
    if (path in done) return
    done[path]
    print "\n/* " path " */"
    body(path, "")
}

# QTRI_BODY functions that a header has or includes, with the names of a .c file's own, and macros as they are there.
function again(path, prefix,   n, i, line, name, inside_it, directive, conditions)
{
    if (path in is_again) return
    is_again[path]
    n = read(path)
    for (i = 1; i <= n; i++) {
        line = text[path, i]
        if (included(line, path) != "") {
            again(included(line, path), prefix)
            in_comment = 0
        } else if (directive || line ~ /^#/) {
            if (!directive && match(line, /^#(define|ifndef) +[A-Z0-9_]+/)) {
                name = substr(line, RSTART, RLENGTH)
                sub(/^.* /, "", name)
                if (line ~ /^#define/ || name ~ /_H$/) print "#undef " name
            }
            conditions += line ~ /^#if/ ? 1 : line ~ /^#endif/ ? -1 : 0
            print line
            directive = line ~ /\\$/
        } else if (conditions > 1 && line ~ /^enum/) {
            complain(path ": an enum that a condition chooses is read only once; a macro is read again")
        } else if (inside_it || line ~ /^QTRI_BODY/) {
            if (!inside_it && match(line, /qtri_[a-z0-9_]+\(/)) own[substr(line, RSTART, RLENGTH - 1)]
            inside_it = line !~ /^}/
            print renamed(line, prefix)
        }
    }
}

# A private header, or a part of a .c file where `prefix` is not "".
function body(path, prefix,   n, i, inner)
{
    n = read(path)
    for (i = 1; i <= n; i++) {
        inner = included(text[path, i], path)
        if (inner ~ /\.h$/ && prefix != "" && ("QTRI_PIPELINE_IS_ANY" in macro)) again(inner, prefix)
        if (inner ~ /\/include\//) continue
        if (inner ~ /\.inc$/) {
            body(inner, prefix)
        } else if (inner != "") {
            private_header(inner)
        } else if (!is_licence(text[path, i])) {
            print prefix == "" ? text[path, i] : renamed(text[path, i], prefix)
        }
    }
}

function source(path,   prefix, name, folder, n)
{
    n = split(path, folder, "/")
    prefix = folder[n]
    sub(/\.c$/, "", prefix)
    prefix = (folder[1] == "port" ? "port_" : "") prefix "_"
    split("", own)
    split("", macro)
    scan(path)
    print "\n/* " path " " substr("------------------------------------------------------------------------", 1, 90 - length(path)) " */"
    in_comment = 0
    before = ""
    depth = 0
    split("", is_struct)
    split("", is_again)
    for (n = 1; n <= lines[path]; n++) {
        name = included(text[path, n], path)
        if (name ~ /\.h$/ && name !~ /\/include\//) private_header(name)
    }
    body(path, prefix)
    for (name in macro) if (name !~ /^QTRI_/ || name ~ /_IS_(ANY|ALONE)/) print "#undef " name
}

# Tokens -----------------------------------------------------------------------------------------------------------------

# The next token of `rest`, which loses it; blanks, strings and comments are tokens. in_comment: one is open.
function next_token(   token)
{
    if (in_comment) {
        match(rest, /\*\//)
        if (RSTART) in_comment = 0
        token = RSTART ? substr(rest, 1, RSTART + 1) : rest
    } else if (match(rest, /^[A-Za-z_][A-Za-z0-9_]*/) || match(rest, /^[0-9][A-Za-z0-9_.]*/) || match(rest, /^[ \t]+/) ||
               match(rest, /^"([^"\\]|\\.)*"/) || match(rest, /^'([^'\\]|\\.)*'/) || match(rest, /^(->|\.\.\.)/)) {
        token = substr(rest, 1, RLENGTH)
    } else if (substr(rest, 1, 2) == "/*") {
        token = "/*"
        in_comment = 1
    } else {
        token = substr(rest, 1, 1)
    }
    rest = substr(rest, length(token) + 1)
    return token
}

function is_word(token)
{
    return token ~ /^[A-Za-z_]/
}

function is_blank(token)
{
    return token ~ /^[ \t]/ || token ~ /^\/\*/ || in_comment
}

# A line with the file's own names under their prefix. Members of structs keep theirs.
function renamed(line, prefix,   out, token, was_comment, following)
{
    rest = line
    out = ""
    while (rest != "") {
        was_comment = in_comment
        token = next_token()
        if (was_comment || is_blank(token)) {
            out = out token
            continue
        }
        if ((token in own) && before != "." && before != "->") {
            following = rest
            sub(/^[ \t]+/, "", following)
            if (!(depth in is_struct) || (following !~ /^[;,:[]/ && !(before == "*" && following ~ /^\)/)))
                out = out prefix token
            else
                out = out token
        } else {
            out = out token
        }
        if (token == "{") {
            depth++
            if (opens_struct) is_struct[depth]
            opens_struct = 0
        } else if (token == "}") {
            delete is_struct[depth]
            depth--
        } else if (token == "struct" || token == "union") {
            opens_struct = 1
        } else if (!is_word(token) || before !~ /^(struct|union)$/) {
            opens_struct = 0
        }
        before = token
    }
    return out
}

function own_name(name)
{
    if (is_word(name) && name !~ /^(qtri_|q16_|QTRI_)/ && !(name in keyword) && !(name in macro)) own[name]
}

# The names of file scope of a .c file and its .inc files, into own[]; their macros into macro[].
function scan(path,   n, i, token, inner)
{
    scan_depth = 0
    count = 0
    parentheses = 0
    scan_lines(path)
    if (scan_depth != 0) complain(path ": braces do not match")
}

function scan_lines(path,   n, i, line, name, directive, token, was_comment)
{
    n = read(path)
    in_comment = 0
    for (i = 1; i <= n; i++) {
        line = text[path, i]
        if (directive || (!in_comment && line ~ /^ *#/)) {
            if (!directive && line ~ /^ *# *define /) {
                name = line
                sub(/^ *# *define +/, "", name)
                sub(/[^A-Za-z0-9_].*/, "", name)
                macro[name]
            }
            if (!directive && included(line, path) ~ /\.inc$/) {
                scan_lines(included(line, path))
                in_comment = 0
            }
            directive = line ~ /\\$/
            continue
        }
        rest = line
        while (rest != "") {
            was_comment = in_comment
            token = next_token()
            if (!was_comment && !is_blank(token)) take(token)
        }
    }
}

# One token of file scope or of what braces hold.
function take(token,   i)
{
    if (scan_depth > 0) {
        if (token == "{") scan_depth++
        else if (token == "}" && --scan_depth == 0) {
            if (inside == "function") count = 0
            else statement[++count] = "{}"
        } else if (inside == "enum" && scan_depth == 1) {
            if (expect_constant && is_word(token)) own_name(token)
            expect_constant = token == ","
        }
        return
    }
    if (token == "{") {
        scan_depth = 1
        inside = "function"
        for (i = 1; i <= count; i++) {
            if (statement[i] == "=") { inside = "value"; return }
        }
        if (statement[count] == ")") { declare_function(); return }
        for (i = 1; i <= count; i++) if (statement[i] ~ /^(struct|union|enum)$/) inside = statement[i]
        expect_constant = 1
        own_name(statement[count])
        return
    }
    statement[++count] = token
    if (token == "=") declare_variable()
    else if (token == ";") {
        declare_variable()
        count = 0
    }
}

function declare_function(   i)
{
    for (i = 2; i <= count; i++) {
        if (statement[i] == "(" && is_word(statement[i - 1]) && !(statement[i - 1] in keyword)) {
            own_name(statement[i - 1])
            return
        }
    }
}

# What a statement without a body declares: up to its `=` or `;`, without what brackets hold.
function declare_variable(   i, name)
{
    for (i = 1; i < count; i++) if (statement[i] == "=") return
    for (i = 2; i < count; i++) {
        if (statement[i] == "(" && statement[i + 1] == "*" && is_word(statement[i + 2])) {
            own_name(statement[i + 2])
            return
        }
        if (statement[i] == "(" && is_word(statement[i - 1]) && !(statement[i - 1] in keyword)) {
            own_name(statement[i - 1])
            return
        }
    }
    for (i = 2; i <= count; i++) {
        if (statement[i] ~ /^[[=;]$/) {
            name = statement[i - 1]
            if (name != "{}") own_name(name)
            return
        }
    }
}
