/* SPDX-License-Identifier: MIT */
/*
 * The command `qtri` run in a folder of the test's own. Includers define _POSIX_C_SOURCE.
 */
#ifndef QTRI_TESTS_SUPPORT_COMMAND_H
#define QTRI_TESTS_SUPPORT_COMMAND_H

#include <dirent.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include "test.h"

static char folder[512], root[512];

/* Runs a command line in the test's folder. */
static inline int shell(const char *command)
{
    char line[4096];
    snprintf(line, sizeof line, "cd '%s' && %s", folder, command);
    int status = system(line); /* NOLINT(cert-env33-c): a test of the command line */
    assert_true(WIFEXITED(status));
    return WEXITSTATUS(status);
}

static inline int run(const char *arguments)
{
    char line[2048];
    snprintf(line, sizeof line, "'%s' %s >output 2>messages </dev/null", getenv("QTRI_COMMAND"),
             arguments);
    return shell(line);
}

static inline void write_bytes(const char *name, const void *bytes, size_t length)
{
    char path[1024];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    FILE *file = fopen(path, "wb");
    assert_non_null(file);
    assert_int_equal(fwrite(bytes, 1, length, file), length);
    assert_int_equal(fclose(file), 0);
}

static inline void write_text(const char *name, const char *text)
{
    write_bytes(name, text, strlen(text));
}

static inline size_t read_text(const char *name, char *text, size_t size)
{
    char path[1024];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    FILE *file = fopen(path, "rb");
    assert_non_null(file);
    size_t length = fread(text, 1, size - 1, file);
    text[length] = '\0';
    fclose(file);
    return length;
}

static inline bool contains(const char *name, const char *needle)
{
    static char text[65536];
    read_text(name, text, sizeof text);
    return strstr(text, needle) != NULL;
}

static inline bool exists(const char *name)
{
    char path[1024];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    return access(path, F_OK) == 0;
}

/* Files that writing leaves where it fails half-way. */
static inline bool has_parts(void)
{
    bool found = false;
    DIR *directory = opendir(folder);
    assert_non_null(directory);
    for (struct dirent *entry = readdir(directory); entry != NULL; entry = readdir(directory)) {
        found = found || strncmp(entry->d_name, ".qtri", 5) == 0;
    }
    closedir(directory);
    return found;
}

/* Removes a file that need not be there. */
static inline void discard(const char *name)
{
    char path[1024];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    (void)remove(path);
}

/* Exit 1, one line that begins as it should, no output. */
static inline void assert_refused(const char *arguments, const char *message)
{
    char text[4096];
    discard("bad.h");
    discard("bad.c");
    assert_int_equal(run(arguments), 1);
    read_text("messages", text, sizeof text);
    if (strncmp(text, message, strlen(message)) != 0) {
        fail_msg("%s: says '%s', not '%s'", arguments, text, message);
    }
    assert_ptr_equal(strchr(text, '\n'), text + strlen(text) - 1);
    assert_false(exists("bad.h"));
    assert_false(exists("bad.c"));
    assert_false(has_parts());
}

/* Compiles a file of the folder as C99, and as C++11 unless it is C alone, without a warning. */
static inline void assert_file_compiles(const char *file, bool is_c)
{
    static const char *const compilers[] = {"gcc -std=c99 -x c", "g++ -std=c++11 -x c++",
                                            "clang -std=c99 -x c", "clang++ -std=c++11 -x c++"};
    char line[2048];
    for (size_t i = 0; i < sizeof compilers / sizeof compilers[0]; i++) {
        if (is_c && strstr(compilers[i], "c++") != NULL) {
            continue;
        }
        snprintf(
            line, sizeof line,
            "! command -v %.*s >/dev/null || %s -Wall -Wextra -Wpedantic -Wconversion "
            "-Wshadow -Wundef -Werror -I'%s/core/include' -I'%s/port/include' -fsyntax-only '%s'",
            (int)strcspn(compilers[i], " "), compilers[i], compilers[i], root, root, file);
        assert_int_equal(shell(line), 0);
    }
}

/* Compiles a header that defines `object`. */
static inline void assert_compiles(const char *header, const char *object)
{
    char text[256];
    snprintf(text, sizeof text,
             "#include \"%s\"\n#include \"%s\"\nextern const void *object;\n"
             "const void *object = &%s;\n",
             header, header, object);
    write_text("user.c", text);
    assert_file_compiles("user.c", false);
}

/* The program in a model's comment, as printed: it compiles. */
static inline void assert_program_compiles(const char *header)
{
    char line[512];
    snprintf(line, sizeof line,
             "{ echo 'struct qtri_bus; void show(const struct qtri_bus *bus);'; "
             "sed -n 's/^ \\*     //p' %s; } >program.c && grep -q 'void show' program.c",
             header);
    assert_int_equal(shell(line), 0);
    assert_int_equal(shell("sed -i '1s/.*/#include <qtri_port\\/bus.h>\\n&/' program.c"), 0);
    assert_file_compiles("program.c", true);
}

/* A group's setup: the folder. */
static inline int make_folder(void **state)
{
    (void)state;
    const char *base = getenv("QTRI_TMP");
    snprintf(folder, sizeof folder, "%s/qtri-command-XXXXXX", base != NULL ? base : "/tmp");
    return mkdtemp(folder) == NULL || getcwd(root, sizeof root) == NULL;
}

static inline bool command_is_known(void)
{
    if (getenv("QTRI_COMMAND") == NULL) {
        puts("QTRI_COMMAND is not set: run `make test-plain TESTS=...`");
        return false;
    }
    return true;
}

#endif
