/* SPDX-License-Identifier: MIT */
/*
 * The commands of `qtri`.
 */
#ifndef QTRI_HOST_TOOLS_COMMANDS_H
#define QTRI_HOST_TOOLS_COMMANDS_H

#include "options.h"

extern const struct option_command render_command, pipelines_command, compare_command, demo_command,
    model_command, mesh_command, texture_command, neighbours_command, font_command;

#endif
