/* SPDX-License-Identifier: MIT */
#include "options.h"

#include <stdlib.h>
#include <string.h>

#include "../assets/asset.h"
#include "../io/xalloc.h"

const char *option_next(struct option_words *words)
{
    return words->at + 1 < words->argc ? words->argv[++words->at] : NULL;
}

bool options_complain(const struct option_command *command, const char *problem, const char *what)
{
    fprintf(stderr, "qtri %s: %s%s\n", command->name, problem, what);
    return false;
}

static bool asks_help(int argc, char **argv)
{
    for (int i = 1; i < argc; i++) {
        if (strcmp(argv[i], "--help") == 0 || strcmp(argv[i], "-h") == 0) {
            return true;
        }
    }
    return false;
}

static const struct option *find(const struct option_command *command, const char *name)
{
    for (size_t i = 0; i < command->count; i++) {
        if (strcmp(command->options[i].name, name) == 0) {
            return &command->options[i];
        }
    }
    return NULL;
}

static bool is_name(const char *text, char name[OPTION_NAME_SIZE])
{
    size_t length = strlen(text);
    asset_identifier(text, name, OPTION_NAME_SIZE);
    return length > 0 && length < OPTION_NAME_SIZE && strcmp(text, name) == 0;
}

static bool find_word(const struct option *option, const char *value, int *rank)
{
    int i = 0;
    while (i < option->of.words.count && strcmp(value, option->of.words.names[i]) != 0) {
        i++;
    }
    *rank = i;
    return i < option->of.words.count;
}

/* 262144 or 256K or 2M bytes. */
static bool option_bytes(const char *value, size_t *bytes)
{
    char digits[16];
    const size_t count = strspn(value, "0123456789");
    const char unit = value[count];
    const int shift = unit == 'K' ? 10 : unit == 'M' ? 20 : 0;
    long number = 0;
    (void)snprintf(digits, sizeof digits, "%.*s", (int)(count < 15 ? count : 15), value);
    if (!option_whole(digits, 1, 1L << 30 >> shift, &number) || (shift == 0 && unit != '\0') ||
        (shift != 0 && value[count + 1] != '\0')) {
        return false;
    }
    *bytes = (size_t)number << shift;
    return true;
}

static bool set_value(const struct option *option, void *options, const char *value,
                      struct option_words *words)
{
    void *at = (char *)options + option->at;
    long whole = 0;
    switch (option->kind) {
    case OPTION_SET:
        return option->of.set(options, value, words);
    case OPTION_NAME:
        return is_name(value, (char *)at);
    case OPTION_WHOLE:
        if (!option_whole(value, (long)option->of.range.low, (long)option->of.range.high, &whole)) {
            return false;
        }
        *(int *)at = (int)whole;
        return true;
    case OPTION_REAL:
        return option_real(value, option->of.range.low, option->of.range.high, (double *)at);
    case OPTION_BYTES:
        return option_bytes(value, (size_t *)at);
    case OPTION_WORD:
        return find_word(option, value, (int *)at);
    default:
        *(const char **)at = value;
        return *value != '\0';
    }
}

static bool take(const struct option_command *command, const struct option *option, void *options,
                 struct option_words *words)
{
    if (option->kind == OPTION_FLAG) {
        *(bool *)((char *)options + option->at) = true;
        return true;
    }
    const char *value = option_next(words);
    if (value == NULL) {
        return options_complain(command, "a value is missing after ", option->name);
    }
    if (!set_value(option, options, value, words)) {
        fprintf(stderr, "qtri %s: '%s' is no value for %s\n", command->name, value, option->name);
        return false;
    }
    return true;
}

/* A word that is no option goes to the first input that has none. */
static bool take_input(const struct option_command *command, void *options, const char *word)
{
    const char **first = (const char **)(void *)((char *)options + command->input_at);
    const char **second = (const char **)(void *)((char *)options + command->output_at);
    const char **input = *first != NULL && command->has_pair ? second : first;
    if (command->input == NULL) {
        return options_complain(command, "unknown argument ", word);
    }
    if (*input != NULL) {
        fprintf(stderr, "qtri %s: one %s at a time, please: %s\n", command->name, command->input,
                word);
        return false;
    }
    *input = word;
    return true;
}

static bool parse(const struct option_command *command, void *options, int argc, char **argv)
{
    struct option_words words = {argc, 0, argv};
    bool ok = true, only_inputs = false; /* behind -- */
    for (const char *word = option_next(&words); ok && word != NULL; word = option_next(&words)) {
        const struct option *option = only_inputs ? NULL : find(command, word);
        if (option != NULL) {
            ok = take(command, option, options, &words);
        } else if (!only_inputs && strcmp(word, "--") == 0) {
            only_inputs = true;
        } else if (!only_inputs && word[0] == '-' && word[1] != '\0') {
            ok = options_complain(command, "unknown option ", word);
        } else {
            ok = take_input(command, options, word);
        }
    }
    return ok;
}

static const char *text_at(const void *options, size_t at)
{
    return *(const char *const *)(const void *)((const char *)options + at);
}

static bool check(const struct option_command *command, void *options)
{
    if (command->input != NULL && (text_at(options, command->input_at) == NULL ||
                                   text_at(options, command->output_at) == NULL)) {
        return options_complain(command, command->needs, "");
    }
    return command->check == NULL || command->check(command, options);
}

static int run(const struct option_command *command, void *options, int argc, char **argv)
{
    struct text_error error = {""};
    if (!parse(command, options, argc, argv) || !check(command, options)) {
        fprintf(stderr, "Try `qtri %s --help`.\n", command->name);
        return 2;
    }
    if (command->run(options, &error)) {
        return 0;
    }
    if (error.message[0] != '\0') {
        fprintf(stderr, "qtri %s: %s\n", command->name, error.message);
    }
    return 1;
}

int options_run(const struct option_command *command, int argc, char **argv)
{
    if (asks_help(argc, argv)) {
        fputs(command->usage, stdout);
        if (command->print_more != NULL) {
            command->print_more();
        }
        return 0;
    }
    void *options = xcalloc(1, command->size);
    if (command->defaults != NULL) {
        memcpy(options, command->defaults, command->size);
    }
    const int status = run(command, options, argc, argv);
    free(options);
    return status;
}

bool option_whole(const char *text, long least, long most, long *out)
{
    char *end = NULL;
    long value = strtol(text, &end, 10);
    if (*text < '0' || *text > '9' || *end != '\0' || value < least || value > most) {
        return false;
    }
    *out = value;
    return true;
}

bool option_real(const char *text, double least, double most, double *out)
{
    char *end = NULL;
    double value = strtod(text, &end);
    if (end == text || *end != '\0' || !(value >= least && value <= most)) {
        return false;
    }
    *out = value;
    return true;
}

bool option_size(const char *text, long most, int *width, int *height)
{
    char *end = NULL;
    long first = strtol(text, &end, 10);
    long second = 0;
    if (*text < '0' || *text > '9' || *end != 'x' || first < 1 || first > most ||
        !option_whole(end + 1, 1, most, &second)) {
        return false;
    }
    *width = (int)first;
    *height = (int)second;
    return true;
}

bool options_default_name(const struct option_command *command, const char *input,
                          const char *output, char name[OPTION_NAME_SIZE])
{
    const char *from = strcmp(output, "-") == 0 ? input : output;
    if (name[0] == '\0') {
        asset_identifier(strcmp(from, "-") == 0 ? command->name : from, name, OPTION_NAME_SIZE);
    }
    return name[0] != '\0' || options_complain(command, "--name NAME is needed: ", output);
}
