/* SPDX-License-Identifier: MIT */
/*
 * What the commands' command lines have in common: flags, options with values, one input, -o.
 */
#ifndef QTRI_HOST_TOOLS_OPTIONS_H
#define QTRI_HOST_TOOLS_OPTIONS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

#include "../assets/texture.h"

#define OPTION_NAME_SIZE 64 /* of a name in C, with its end */

/* The words behind the one that is looked at. */
struct option_words {
    int argc, at;
    char **argv;
};

/* The next word, or NULL behind the last. */
const char *option_next(struct option_words *words);

/*
 * An option. `at` is where it stands in the command's options: a bool that becomes true; a
 * const char * to any text but an empty one; a name in C. Others call `set` with their value, which
 * may take further words and says whether they are what it wants.
 */
enum option_kind { OPTION_FLAG, OPTION_TEXT, OPTION_NAME, OPTION_SET };
struct option {
    const char *name;
    enum option_kind kind;
    size_t at;
    bool (*set)(void *options, const char *value, struct option_words *more);
};

/* A command: what its one input is called in messages, and where in its options that stands. */
struct option_list {
    const char *command, *input;
    size_t input_at; /* a const char * */
    const struct option *options;
    size_t count;
};

/* Fills in what the words say. "-" is an input. False after a message on standard error. */
bool options_parse(const struct option_list *list, void *options, int argc, char **argv);

/* Whether --help or -h is among the words. */
bool options_ask_help(int argc, char **argv);

/* Values: a whole number, a real one, WxH with sides 1..most, a name in C. False: it is none. */
bool option_whole(const char *text, long least, long most, long *out);
bool option_real(const char *text, double least, double most, double *out);
bool option_size(const char *text, long most, int *width, int *height);
bool option_texture_format(const char *text, enum texture_format *format);
bool option_name(const char *text, char name[OPTION_NAME_SIZE]);

/*
 * The name in C of what is made, where none was given: the output's, or the input's where the
 * output is a stream. False after a message where that is no name.
 */
bool options_default_name(const struct option_list *list, const char *input, const char *output,
                          char name[OPTION_NAME_SIZE]);

/* "qtri COMMAND: ..." on standard error; false. */
bool options_complain(const struct option_list *list, const char *problem, const char *what);

#endif
