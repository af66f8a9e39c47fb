/* SPDX-License-Identifier: MIT */
#include <qtri/version.h>
#include <stdio.h>
#include <string.h>

#include "commands.h"
#include "compare.h"

struct command {
    const char *name;
    int (*run)(int argc, char **argv);
    const char *summary;
};

static const struct command commands[] = {
    {"render", render_main, "draw a scene file to a PPM picture"},
    {"compare", compare_main, "compare two pictures"},
    {"demo", demo_main, "render the demo scenes beside their references"},
    {"mesh", mesh_main, "generate a mesh as an OBJ file"},
};

static void help(FILE *out)
{
    fputs("usage: qtri COMMAND [ARGUMENT ...]\n\n", out);
    for (size_t i = 0; i < sizeof commands / sizeof commands[0]; i++) {
        fprintf(out, "  %-8s  %s\n", commands[i].name, commands[i].summary);
    }
    fputs("\n`qtri COMMAND --help` tells more, `qtri --version` which one it is.\n", out);
}

int main(int argc, char **argv)
{
    if (argc < 2) {
        help(stderr);
        return 2;
    }
    if (strcmp(argv[1], "--help") == 0 || strcmp(argv[1], "-h") == 0) {
        help(stdout);
        return 0;
    }
    if (strcmp(argv[1], "--version") == 0) {
        puts("qtri " QTRI_VERSION_TEXT);
        return 0;
    }
    for (size_t i = 0; i < sizeof commands / sizeof commands[0]; i++) {
        if (strcmp(argv[1], commands[i].name) == 0) {
            return commands[i].run(argc - 1, argv + 1);
        }
    }
    fprintf(stderr, "qtri: unknown command '%s'; `qtri --help` lists them\n", argv[1]);
    return 2;
}
