# SPDX-License-Identifier: MIT
# Doxygen's input filter: turns the plain comments of a public header into those that Doxygen reads, and keeps the
# number of each line. A comment documents
#   - in front of a declaration: the declarations up to the next blank line, and inline functions that follow without
#     a comment of their own; a comment that stands alone: what follows until the next comment;
#   - behind a member, an enumerator or a macro: that one. A member that has none belongs to the text of its structure.
# "Internal" at the beginning hides what it documents. Underlined comments are headings and document nothing.

{ sub(/\r$/, ""); line[NR] = $0 }

END {
    for (i = 1; i <= NR; i = next_line) {
        next_line = i + 1
        if (line[i] ~ /^#include "body\//) {
            out[i] = "" # internal
        } else if (line[i] ~ /^\/\*/) {
            top_comment(i)
        } else if (line[i] ~ /^(typedef )?(struct|union|enum)( [a-z0-9_]+)? \{/) {
            structure(i)
        } else if (line[i] ~ /^extern .*[^{]$/) {
            declarators(i)
        } else if (line[i] ~ /^(#define .*[^ ]|[a-z].*;) +\/\*.*\*\/$/) {
            out[i] = line[i]
            trailing(i, 0)
        } else {
            out[i] = line[i]
        }
        close_scope(next_line - 1)
    }
    for (i = 1; i <= NR; i++) {
        print out[i]
    }
}

function comment_end(i) {
    while (i < NR && line[i] !~ /\*\//) {
        i++
    }
    return i
}

# Doxygen's special characters, quoted.
function quoted(text) {
    gsub(/\\/, "\\\\", text)
    gsub(/[<>@#%&*~]/, "\\\\&", text)
    gsub(/\.\. /, "..\\ ", text) # does not end the first sentence
    return text
}

# Sets text[1..lines]: what a comment says, one element a line.
function read_comment(i, last,    k, t) {
    lines = 0
    for (k = i; k <= last; k++) {
        t = line[k]
        if (k == i) {
            sub(/^.*\/\*/, "", t)
        }
        sub(/ *\*\/.*$/, "", t)
        if (k > i) {
            sub(/^ *\* ?/, " ", t)
            sub(/^ +$/, "", t)
        }
        text[++lines] = t
    }
    text[lines + 1] = ""
}

# As text of Doxygen: lines that are indented behind a blank one are code, an error at the beginning of a line is one of
# the values returned.
function written(is_member,    k, t, all, is_code, codes) {
    codes = ""
    is_code = 0
    for (k = 1; k <= lines; k++) {
        t = text[k]
        if (!is_member && t ~ /^   / && k > 1 && (is_code || text[k - 1] == "")) {
            if (!is_code) {
                result[k - 1] = " @code{.unparsed}"
                is_code = 1
            }
            result[k] = t
            continue
        }
        if (is_code && (t != "" || text[k + 1] !~ /^   /)) {
            is_code = 0
            result[k] = " @endcode"
        } else {
            result[k] = ""
        }
        t = quoted(t)
        if (!is_member && match(t, /^ QTRI_ERROR_[A-Z]+: /) && !index(codes, substr(t, 1, RLENGTH))) {
            codes = codes substr(t, 1, RLENGTH)
            sub(/: /, " ", t)
            sub(/^ /, " @retval ", t)
        }
        result[k] = result[k] t
    }
    all = result[1]
    for (k = 2; k <= lines; k++) {
        all = all "\n" result[k]
    }
    return all (is_code ? "\n @endcode" : "")
}

function put(first, all,    parts, count, k) {
    count = split(all, parts, "\n")
    for (k = 1; k <= count; k++) {
        out[first + k - 1] = parts[k]
    }
}

function top_comment(i,    last, all, scope, is_internal) {
    if (scope_end) {
        out[scope_end] = out[scope_end] " " scope_close
        scope_end = 0
    }
    last = comment_end(i)
    next_line = last + 1
    read_comment(i, last)
    all = written(0)
    if (line[i] ~ /SPDX-License-Identifier/ || all ~ /-----/) {
        copy(i, last)
        return
    }
    if (!has_file) {
        has_file = 1
        put(i, "/** @file" all " */")
        return
    }
    scope_end = line[last + 1] == "" ? to_comment(last + 1) : to_paragraph(last + 1)
    if (all ~ /(^|\n) Internal[.:]/) {
        put(i, "/** @cond */ /*" all " */")
        scope_close = "/** @endcond */ "
    } else if (declarations(last + 1, scope_end) > 1) {
        put(i, "/**@{*/ /**" all " */")
        scope_close = "/**@}*/ "
    } else {
        put(i, "/**" all " */")
        scope_end = 0
    }
}

# How many declarations and macros stand in these lines.
function declarations(i, last,    depth, count) {
    for (; i <= last; i++) {
        depth += gsub(/\{/, "{", line[i]) - gsub(/\}/, "}", line[i])
        count += depth == 0 && line[i - 1] !~ /\\$/ && line[i] ~ /(;( *\/\*.*)?|^\})$/ || line[i] ~ /^#define/
        count += line[i] ~ /^extern [^(]*,/
    }
    return count
}

function copy(i, last) {
    for (; i <= last; i++) {
        out[i] = line[i]
    }
}

# The last line of a paragraph of declarations; blank lines in braces do not end it.
function to_paragraph(i,    depth, is_inline, last) {
    depth = 0
    last = i - 1
    for (; i <= NR; i++) {
        if (line[i] == "" && depth == 0) {
            if (is_inline && line[i + 1] ~ /^static inline/) {
                continue
            }
            break
        }
        if (line[i] ~ /^\/\*/ || line[i] ~ /^#ifdef __cplusplus/) {
            break
        }
        if (line[i] ~ /^static inline/) {
            is_inline = 1
        }
        depth += gsub(/\{/, "{", line[i]) - gsub(/\}/, "}", line[i])
        last = i
    }
    return last
}

# The last line before the next comment.
function to_comment(i,    last) {
    last = i
    for (; i <= NR && line[i] !~ /^\/\*/ && line[i] !~ /^#ifdef __cplusplus/; i++) {
        if (line[i] != "") {
            last = i
        }
    }
    return last
}

function close_scope(i) {
    if (scope_end && i > scope_end) {
        out[scope_end + 1] = scope_close out[scope_end + 1]
        scope_end = 0
    }
}

# extern const T a, b; as two declarations.
function declarators(i,    all, parts, count, k, type) {
    all = line[i]
    for (next_line = i + 1; all !~ /;/; next_line++) {
        sub(/^ +/, " ", line[next_line])
        all = all line[next_line]
    }
    k = index(all, ";")
    type = substr(all, k + 1)
    all = substr(all, 1, k - 1)
    count = split(all, parts, /, */)
    if (count == 1 || all ~ /\(/) {
        out[i] = all ";" type
    } else {
        # The type ends before the last word of the first declarator.
        k = match(parts[1], /[A-Za-z0-9_\[\]]+$/)
        out[i] = parts[1] ";"
        for (count = 2; count in parts; count++) {
            out[i] = out[i] " " substr(parts[1], 1, k - 1) parts[count] ";"
        }
        out[i] = out[i] type
    }
    trailing(i, 0)
}

# A declaration with a comment behind it, in one line or more, becomes one with the comment in front.
function trailing(i, is_member,    k, last, code, comment) {
    code = out[i]
    k = index(code, "/*")
    if (k == 0) {
        return 0
    }
    last = i
    if (code !~ /\*\//) {
        last = comment_end(i)
    }
    read_comment(i, last)
    comment = written(1)
    code = substr(out[i], 1, k - 1)
    sub(/ +$/, "", code)
    if (is_member && code ~ /,/) {
        put(i, "/**@{*/ /**" comment " */ " code " /**@}*/")
    } else {
        put(i, code " /**<" comment " */")
    }
    if (last + 1 > next_line) {
        next_line = last + 1
    }
    return 1
}

# Members and enumerators up to the closing brace.
function structure(i,    last, is_enum, above, hidden) {
    is_enum = line[i] ~ /enum/
    if (line[i] ~ /\}/) {
        out[i] = one_line_enum(line[i])
        return
    }
    out[i] = line[i]
    above = 0
    hidden = 0
    for (i++; line[i] !~ /^\}/; i = next_line) {
        next_line = i + 1
        out[i] = line[i]
        if (line[i] ~ /^ *\/\*/) {
            last = comment_end(i)
            next_line = last + 1
            read_comment(i, last)
            above = written(1)
            copy(i, last)
            if (above ~ /^ *Internal[.:]/) {
                out[i] = "/** @cond */" out[i]
                hidden = 1
            } else if (is_enum) {
                put(i, "/**" above " */")
            }
        } else if (line[i] == "") {
            above = 0
        } else if (hidden) {
            continue
        } else if (is_enum) {
            enumerator(i, above)
            above = 0
        } else {
            member(i, above)
        }
    }
    out[i] = (hidden ? "/** @endcond */ " : "") line[i]
    next_line = i + 1
}

function member(i, above,    all) {
    all = line[i]
    while (all !~ /;/ && all !~ /\/\*/) {
        sub(/^ +/, " ", line[next_line])
        all = all line[next_line++]
    }
    out[i] = all
    line[i] = all
    if (!trailing(i, 1)) {
        above = above ? one_line(above) : "See the type, and the description of the structure."
        out[i] = all ~ /,.*;/ && all !~ /\(/ ? "/**@{*/ /** " above " */ " all " /**@}*/" : all " /**< " above " */"
    }
}

function enumerator(i, above,    k, last) {
    k = index(line[i], "/*")
    if (k) {
        last = comment_end(i)
        read_comment(i, last)
        put(i, substr(line[i], 1, k - 1) "/**<" written(1) " */")
        next_line = last + 1
    } else if (!above) {
        out[i] = line[i] " /**< See the description of the enumeration. */"
    }
}

function one_line_enum(t,    head, body, tail, parts, count, k, all) {
    head = substr(t, 1, index(t, "{"))
    tail = substr(t, index(t, "}"))
    body = substr(t, length(head) + 1, index(t, "}") - length(head) - 1)
    count = split(body, parts, ",")
    all = head
    for (k = 1; k <= count; k++) {
        all = all parts[k] (k < count ? "," : "") " /**< See the description of the enumeration. */"
    }
    return all tail
}

function one_line(t) {
    gsub(/\n/, " ", t)
    return t
}
