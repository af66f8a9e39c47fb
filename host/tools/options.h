/* SPDX-License-Identifier: MIT */
/*
 * What the commands' command lines have in common: flags, options with values, one input, -o.
 */
#ifndef QTRI_HOST_TOOLS_OPTIONS_H
#define QTRI_HOST_TOOLS_OPTIONS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

#include "../io/text_error.h"

#define OPTION_NAME_SIZE 64 /* of a name in C, with its end */

/* The words behind the one that is looked at. */
struct option_words {
    int argc, at;
    char **argv;
};

/* The next word, or NULL behind the last. */
const char *option_next(struct option_words *words);

/*
 * An option. `at` is where its value stands in the command's options. Those of OPTION_SET call
 * `set`, which may take further words and says whether they are what it wants.
 */
enum option_kind {
    OPTION_FLAG,  /* a bool that becomes true */
    OPTION_TEXT,  /* a const char *, any text but an empty one */
    OPTION_NAME,  /* a char[OPTION_NAME_SIZE], a name in C */
    OPTION_WHOLE, /* an int in a range */
    OPTION_REAL,  /* a double in a range */
    OPTION_BYTES, /* a size_t: 262144 or 256K or 2M */
    OPTION_WORD,  /* an int, the rank of one of some words */
    OPTION_SET
};
struct option {
    const char *name;
    enum option_kind kind;
    size_t at;
    union {
        bool (*set)(void *options, const char *value, struct option_words *more);
        struct {
            double low, high;
        } range;
        struct {
            const char *const *names;
            int count;
        } words;
    } of;
};

/* A command of one input and, mostly, one output; or of a pair of inputs, or of options alone. */
struct option_command {
    const char *name, *summary;
    bool is_unlimited;          /* it may take any time, where `qtri --seconds` says nothing */
    size_t size;                /* of its options */
    const void *defaults;       /* its options where nothing is said; NULL: all zero */
    const char *input;          /* what it is called in messages; NULL: there is none */
    const char *needs;          /* the message where input or output is missing */
    size_t input_at, output_at; /* where in the options they stand: each a const char * */
    bool has_pair;              /* output_at is where the second input stands */
    const struct option *options;
    size_t count;
    const char *usage;
    void (*print_more)(void); /* NULL, or prints what --help says behind it */
    /* NULL, or false after a message: what was asked for does not go together. */
    bool (*check)(const struct option_command *command, void *options);
    bool (*run)(void *options, struct text_error *error); /* with "" in *error: told before */
};

/* Parses, checks and runs, or helps; argv[0] is the command's name. Returns the exit status, 0
 * done, 1 bad input, 2 wrong usage; messages go to standard error. */
int options_run(const struct option_command *command, int argc, char **argv);

/* Values: a whole number, a real one, WxH with sides 1..most. False: it is none. */
bool option_whole(const char *text, long least, long most, long *out);
bool option_real(const char *text, double least, double most, double *out);
bool option_size(const char *text, long most, int *width, int *height);

/*
 * The name in C of what is made, where none was given: the output's, or the input's where the
 * output is a stream. False after a message where that is no name.
 */
bool options_default_name(const struct option_command *command, const char *input,
                          const char *output, char name[OPTION_NAME_SIZE]);

/* "qtri COMMAND: ..." on standard error; false. */
bool options_complain(const struct option_command *command, const char *problem, const char *what);

#endif
