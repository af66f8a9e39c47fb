/* SPDX-License-Identifier: MIT */
/*
 * What the files of statements share: arguments as numbers and words, and what is wrong with them.
 */
#include "scene_parser.h"

#include "number.h"

bool scene_fail(struct scene_parser *parser, const char *sentence)
{
    text_error_set(parser->error, parser->name, parser->line, "%s: %s", parser->statement->name,
                   sentence);
    return false;
}

bool scene_fail_argument(struct scene_parser *parser, int argument, const char *problem)
{
    char quoted[TOKEN_QUOTE_SIZE];
    text_error_set(parser->error, parser->name, parser->line, "%s: '%s' %s",
                   parser->statement->name, token_quote(&parser->arguments[argument], quoted),
                   problem);
    return false;
}

bool scene_numbers(struct scene_parser *parser, int first, int count, int32_t *numbers)
{
    for (int i = 0; i < count; i++) {
        const struct token *token = &parser->arguments[first + i];
        enum number_result result = number_parse_q16(token->text, token->length, &numbers[i]);
        if (result != NUMBER_OK) {
            return scene_fail_argument(parser, first + i, number_problem(result));
        }
    }
    return true;
}

bool scene_fractions(struct scene_parser *parser, int first, int count, int32_t *numbers)
{
    if (!scene_numbers(parser, first, count, numbers)) {
        return false;
    }
    for (int i = 0; i < count; i++) {
        if (numbers[i] < 0 || numbers[i] > SCENE_ONE) {
            return scene_fail_argument(parser, first + i, "does not lie in 0..1");
        }
    }
    return true;
}

bool scene_integer(struct scene_parser *parser, int argument, int minimum, int maximum, int *value)
{
    const struct token *token = &parser->arguments[argument];
    int64_t parsed;
    if (number_parse_integer(token->text, token->length, minimum, maximum, &parsed) != NUMBER_OK) {
        char quoted[TOKEN_QUOTE_SIZE];
        text_error_set(parser->error, parser->name, parser->line,
                       "%s: '%s' is not a whole number in %d..%d", parser->statement->name,
                       token_quote(token, quoted), minimum, maximum);
        return false;
    }
    *value = (int)parsed;
    return true;
}

bool scene_choice(struct scene_parser *parser, int argument, const char *const *words, int count,
                  int *choice)
{
    for (int i = 0; i < count; i++) {
        if (token_equals(&parser->arguments[argument], words[i])) {
            *choice = i;
            return true;
        }
    }
    char quoted[TOKEN_QUOTE_SIZE];
    text_error_set(parser->error, parser->name, parser->line, "'%s' is unknown here: %s %s",
                   token_quote(&parser->arguments[argument], quoted), parser->statement->name,
                   parser->statement->usage);
    return false;
}

bool scene_fail_count(struct scene_parser *parser)
{
    const struct scene_statement *statement = parser->statement;
    text_error_set(parser->error, parser->name, parser->line,
                   "wrong number of values (%d) for %s%s%s", parser->argument_count,
                   statement->name, statement->usage[0] != '\0' ? " " : "", statement->usage);
    return false;
}
