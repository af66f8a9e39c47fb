/* SPDX-License-Identifier: MIT */
#include "options.h"

#include <stdlib.h>
#include <string.h>

#include "../assets/asset.h"

const char *option_next(struct option_words *words)
{
    return words->at + 1 < words->argc ? words->argv[++words->at] : NULL;
}

bool options_complain(const struct option_list *list, const char *problem, const char *what)
{
    fprintf(stderr, "qtri %s: %s%s\n", list->command, problem, what);
    return false;
}

bool options_ask_help(int argc, char **argv)
{
    for (int i = 1; i < argc; i++) {
        if (strcmp(argv[i], "--help") == 0 || strcmp(argv[i], "-h") == 0) {
            return true;
        }
    }
    return false;
}

static const struct option *find(const struct option_list *list, const char *name)
{
    for (size_t i = 0; i < list->count; i++) {
        if (strcmp(list->options[i].name, name) == 0) {
            return &list->options[i];
        }
    }
    return NULL;
}

static bool set_value(const struct option *option, void *options, const char *value,
                      struct option_words *words)
{
    void *at = (char *)options + option->at;
    if (option->kind == OPTION_SET) {
        return option->set(options, value, words);
    }
    if (option->kind == OPTION_NAME) {
        return option_name(value, (char *)at);
    }
    *(const char **)at = value;
    return *value != '\0';
}

static bool take(const struct option_list *list, const struct option *option, void *options,
                 struct option_words *words)
{
    if (option->kind == OPTION_FLAG) {
        *(bool *)((char *)options + option->at) = true;
        return true;
    }
    const char *value = option_next(words);
    if (value == NULL) {
        return options_complain(list, "a value is missing after ", option->name);
    }
    if (!set_value(option, options, value, words)) {
        fprintf(stderr, "qtri %s: '%s' is no value for %s\n", list->command, value, option->name);
        return false;
    }
    return true;
}

bool options_parse(const struct option_list *list, void *options, int argc, char **argv)
{
    const char **input = (const char **)(void *)((char *)options + list->input_at);
    struct option_words words = {argc, 0, argv};
    for (const char *word = option_next(&words); word != NULL; word = option_next(&words)) {
        const struct option *option = find(list, word);
        if (option != NULL) {
            if (!take(list, option, options, &words)) {
                return false;
            }
        } else if (word[0] == '-' && word[1] != '\0') {
            return options_complain(list, "unknown option ", word);
        } else if (*input != NULL) {
            fprintf(stderr, "qtri %s: one %s at a time, please: %s\n", list->command, list->input,
                    word);
            return false;
        } else {
            *input = word;
        }
    }
    return true;
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

bool option_texture_format(const char *text, enum texture_format *format)
{
    for (int i = 0; i < TEXTURE_FORMATS; i++) {
        if (strcmp(text, texture_format_names[i]) == 0) {
            *format = (enum texture_format)i;
            return true;
        }
    }
    return false;
}

bool option_name(const char *text, char name[OPTION_NAME_SIZE])
{
    size_t length = strlen(text);
    asset_identifier(text, name, OPTION_NAME_SIZE);
    return length > 0 && length < OPTION_NAME_SIZE && strcmp(text, name) == 0;
}

bool options_default_name(const struct option_list *list, const char *input, const char *output,
                          char name[OPTION_NAME_SIZE])
{
    const char *from = strcmp(output, "-") == 0 ? input : output;
    if (name[0] == '\0') {
        asset_identifier(strcmp(from, "-") == 0 ? list->command : from, name, OPTION_NAME_SIZE);
    }
    return name[0] != '\0' || options_complain(list, "--name NAME is needed: ", output);
}
