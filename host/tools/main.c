/* SPDX-License-Identifier: MIT */
#include <qtri/version.h>
#include <stdio.h>
#include <string.h>

#include "../io/file_inputs.h"
#include "../io/system.h"
#include "commands.h"
#include "watch.h"

static const struct option_command *const commands[] = {
    &render_command, &pipelines_command, &compare_command,    &demo_command, &model_command,
    &mesh_command,   &texture_command,   &neighbours_command, &font_command,
};

static void help(FILE *out)
{
    fputs("usage: qtri COMMAND [ARGUMENT ...]\n\n", out);
    for (size_t i = 0; i < sizeof commands / sizeof commands[0]; i++) {
        fprintf(out, "  %-10s  %s\n", commands[i]->name, commands[i]->summary);
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
        const struct option_command *command = commands[i];
        if (strcmp(argv[1], command->name) == 0) {
            watch_begin(command->name, seconds >= 0            ? seconds
                                       : command->is_unlimited ? 0
                                                               : WATCH_SECONDS);
            return options_run(command, argc - 1, argv + 1);
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
