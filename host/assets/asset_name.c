/* SPDX-License-Identifier: MIT */
/*
 * Names in C of what files are called.
 */
#include "asset.h"

#include <string.h>

/* Words of C99 and C++11 that cannot be names. */
static const char *const taken[] = {
    "alignas",      "alignof",  "and",       "and_eq",    "asm",      "auto",     "bitand",
    "bitor",        "bool",     "break",     "case",      "catch",    "char",     "class",
    "compl",        "const",    "constexpr", "continue",  "decltype", "default",  "delete",
    "do",           "double",   "else",      "enum",      "explicit", "export",   "extern",
    "false",        "float",    "for",       "friend",    "goto",     "if",       "inline",
    "int",          "long",     "mutable",   "namespace", "new",      "noexcept", "not",
    "not_eq",       "nullptr",  "operator",  "or",        "or_eq",    "private",  "protected",
    "public",       "register", "restrict",  "return",    "short",    "signed",   "sizeof",
    "static",       "struct",   "switch",    "template",  "this",     "throw",    "true",
    "try",          "typedef",  "typeid",    "typename",  "union",    "unsigned", "using",
    "virtual",      "void",     "volatile",  "while",     "xor",      "xor_eq",   "static_assert",
    "thread_local", "wchar_t",  "char16_t",  "char32_t",  "main",
};

static bool is_taken(const char *name)
{
    for (size_t i = 0; i < sizeof taken / sizeof taken[0]; i++) {
        if (strcmp(taken[i], name) == 0) {
            return true;
        }
    }
    return false;
}

void asset_identifier(const char *path, char *out, size_t size)
{
    const char *slash = strrchr(path, '/');
    const char *name = slash != NULL ? slash + 1 : path;
    size_t length = 0;
    if (strcmp(name, "-") == 0) {
        name = "mesh";
    }
    if (name[0] >= '0' && name[0] <= '9' && size > 8) {
        memcpy(out, "mesh_", 5);
        length = 5;
    }
    for (; *name != '\0' && *name != '.' && length + 1 < size; name++) {
        bool letter = (*name >= 'a' && *name <= 'z') || (*name >= 'A' && *name <= 'Z') ||
                      (*name >= '0' && *name <= '9');
        out[length++] = (char)(letter ? *name : '_');
    }
    out[length] = '\0';
    if (is_taken(out) && length + 1 < size) {
        memcpy(out + length, "_", 2);
    }
}
