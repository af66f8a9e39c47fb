/* SPDX-License-Identifier: MIT */
/*
 * The crate of app_textured.c by someone who configures nothing: a view with the default list of
 * pipelines, and a mesh of any kind.
 */
#define APP_DEFAULT
#include "app_textured.c" // NOLINT(bugprone-suspicious-include): the program but for its list
