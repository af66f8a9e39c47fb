/* SPDX-License-Identifier: MIT */
#include <stdio.h>
#include <string.h>

#include "commands.h"
#include "mesh_generate.h"

static const char usage[] = "usage: qtri mesh NAME -o FILE.obj\n"
                            "\n"
                            "Generates a mesh with normals and texture coordinates.\n"
                            "\n"
                            "NAME is one of:";

static void help(FILE *out)
{
    fputs(usage, out);
    for (int i = 0; mesh_names[i] != NULL; i++) {
        fprintf(out, " %s", mesh_names[i]);
    }
    fputc('\n', out);
}

int mesh_main(int argc, char **argv)
{
    if (argc == 2 && (strcmp(argv[1], "--help") == 0 || strcmp(argv[1], "-h") == 0)) {
        help(stdout);
        return 0;
    }
    if (argc != 4 || strcmp(argv[2], "-o") != 0) {
        help(stderr);
        return 2;
    }
    bool known = false;
    for (int i = 0; mesh_names[i] != NULL; i++) {
        known = known || strcmp(argv[1], mesh_names[i]) == 0;
    }
    if (!known) {
        fprintf(stderr, "qtri mesh: there is no mesh '%s'\n", argv[1]);
        return 2;
    }
    FILE *out = fopen(argv[3], "w");
    if (out == NULL) {
        fprintf(stderr, "qtri mesh: %s: cannot be written\n", argv[3]);
        return 1;
    }
    bool ok = mesh_generate(argv[1], out);
    ok = fclose(out) == 0 && ok;
    if (!ok) {
        fprintf(stderr, "qtri mesh: %s: writing failed\n", argv[3]);
        remove(argv[3]);
    }
    return ok ? 0 : 1;
}
