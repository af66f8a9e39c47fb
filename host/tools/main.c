/* SPDX-License-Identifier: MIT */
#include <qtri/version.h>
#include <stdio.h>
#include <string.h>

#include "../io/file_inputs.h"
#include "../io/system.h"
#include "commands.h"
#include "compare.h"
#include "options.h"
#include "watch.h"

struct command {
    const char *name;
    int (*run)(int argc, char **argv);
    const char *summary;
    long seconds; /* it may take, where --seconds says nothing */
};

static const struct command commands[] = {
    {"render", render_main, "draw a scene file to a picture, PNG or PPM", WATCH_SECONDS},
    {"pipelines", pipelines_main, "print the pipelines that a scene file asks for, as C",
     WATCH_SECONDS},
    {"compare", compare_main, "compare two pictures", WATCH_SECONDS},
    {"demo", demo_main, "render the demo scenes beside their references", 0},
    {"model", model_main, "make C data of a whole model: meshes, textures, materials, motion",
     WATCH_SECONDS},
    {"mesh", mesh_main, "make C data of a model, or of a mesh that it generates", WATCH_SECONDS},
    {"texture", texture_main, "make C data of a picture", WATCH_SECONDS},
    {"neighbours", neighbours_main, "write a mesh's neighbours as C, for smooth outlines",
     WATCH_SECONDS},
    {"font", font_main, "make a font for the core of a BDF file", WATCH_SECONDS},
};

static void help(FILE *out)
{
    fputs("usage: qtri COMMAND [ARGUMENT ...]\n\n", out);
    for (size_t i = 0; i < sizeof commands / sizeof commands[0]; i++) {
        fprintf(out, "  %-10s  %s\n", commands[i].name, commands[i].summary);
    }
    fputs("\n`qtri COMMAND --help` tells more, `qtri --version` which one it is.\n"
          "A command that reads files ends with a message when it is not done after 300 seconds;\n"
          "`qtri --seconds N COMMAND ...` gives it N, 0: as many as it takes.\n",
          out);
}

/* The number behind --seconds; false after a message. */
static bool take_seconds(int argc, char **argv, long *seconds)
{
    const bool ok = argc > 2 && option_whole(argv[2], 0, 1000000, seconds);
    if (!ok) {
        fputs("qtri: --seconds wants a whole number of seconds\n", stderr);
    }
    return ok;
}

static int run(int argc, char **argv)
{
    long seconds = -1;
    if (argc >= 2 && strcmp(argv[1], "--seconds") == 0) {
        if (!take_seconds(argc, argv, &seconds)) {
            return 2;
        }
        argc -= 2;
        argv += 2;
    }
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
            watch_begin(commands[i].name, seconds < 0 ? commands[i].seconds : seconds);
            return commands[i].run(argc - 1, argv + 1);
        }
    }
    fprintf(stderr, "qtri: unknown command '%s'; `qtri --help` lists them\n", argv[1]);
    return 2;
}

/* What did not reach standard output is a failure too: of a full disk, or a pipe nobody reads. */
int main(int argc, char **argv)
{
    system_begin(argc, argv);
    file_inputs_guard();
    int status = run(argc, argv);
    if ((fflush(stdout) != 0 || ferror(stdout)) && status == 0) {
        fputs("qtri: standard output cannot be written\n", stderr);
        status = 1;
    }
    return status;
}
