/* SPDX-License-Identifier: MIT */
/*
 * The commands of `qtri`. Each takes its own arguments, argv[0] being its name, and returns the
 * exit status: 0 done, 1 bad input, 2 wrong usage; messages go to stderr.
 */
#ifndef QTRI_HOST_TOOLS_COMMANDS_H
#define QTRI_HOST_TOOLS_COMMANDS_H

int render_main(int argc, char **argv);
int pipelines_main(int argc, char **argv);
int demo_main(int argc, char **argv);
int model_main(int argc, char **argv);
int mesh_main(int argc, char **argv);
int texture_main(int argc, char **argv);
int neighbours_main(int argc, char **argv);
int font_main(int argc, char **argv);

#endif
