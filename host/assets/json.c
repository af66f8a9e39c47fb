/* SPDX-License-Identifier: MIT */
#include "json.h"

#include <string.h>

#include "../io/number.h"

static const struct json none = {NULL, NULL};

static struct json skip_space(const char *at, const char *end)
{
    while (at < end && (*at == ' ' || *at == '\t' || *at == '\r' || *at == '\n')) {
        at++;
    }
    const struct json value = {at, end};
    return at < end ? value : none;
}

struct json json_text(const char *text, size_t length)
{
    const bool has_mark = length >= 3 && memcmp(text, "\xEF\xBB\xBF", 3) == 0;
    return skip_space(text + (has_mark ? 3 : 0), text + length);
}

const char *json_skip(const char *from, const char *end)
{
    int depth = 0;
    bool is_text = false;
    for (; from < end; from++) {
        if (is_text) {
            const bool is_escape = *from == '\\' && from + 1 < end;
            is_text = is_escape || *from != '"';
            from += is_escape ? 1 : 0;
        } else if (*from == '"') {
            is_text = true;
        } else if (*from == '[' || *from == '{') {
            depth++;
            continue;
        } else if (*from == ']' || *from == '}') {
            depth--;
        }
        if (!is_text && depth <= 0) {
            return from + 1;
        }
    }
    return end;
}

/* Behind a value: strings, objects and arrays as a whole, others up to what cannot be of them. */
static struct json behind(struct json value)
{
    if (strchr("\"[{", *value.at) != NULL && *value.at != '\0') {
        return skip_space(json_skip(value.at, value.end), value.end);
    }
    while (value.at < value.end && strchr(",]} \t\r\n", *value.at) == NULL) {
        value.at++;
    }
    return skip_space(value.at, value.end);
}

/* The element that begins here, or the member's value, whose name is set. */
static struct json enter(struct json at, struct json *name)
{
    if (name != NULL && at.at != NULL) {
        *name = at;
        const struct json colon = *at.at == '"' ? behind(at) : none;
        at = colon.at != NULL && *colon.at == ':' ? skip_space(colon.at + 1, at.end) : none;
    }
    return at.at != NULL && strchr(",]}:", *at.at) == NULL ? at : none;
}

struct json json_first(struct json whole, struct json *name)
{
    const bool is_whole = whole.at != NULL && *whole.at == (name != NULL ? '{' : '[');
    return is_whole ? enter(skip_space(whole.at + 1, whole.end), name) : none;
}

struct json json_next(struct json value, struct json *name)
{
    const struct json comma = value.at != NULL ? behind(value) : none;
    const bool goes_on = comma.at != NULL && *comma.at == ',';
    return goes_on ? enter(skip_space(comma.at + 1, comma.end), name) : none;
}

struct json json_member(struct json object, const char *name)
{
    struct json at = none;
    struct json value = json_first(object, &at);
    while (value.at != NULL && !json_is(at, name)) {
        value = json_next(value, &at);
    }
    return value;
}

struct json json_element(struct json array, size_t index)
{
    struct json value = json_first(array, NULL);
    for (size_t i = 0; value.at != NULL && i < index; i++) {
        value = json_next(value, NULL);
    }
    return value;
}

bool json_is(struct json value, const char *text)
{
    const size_t length = strlen(text);
    return value.at != NULL && (size_t)(value.end - value.at) >= length + 2 && *value.at == '"' &&
           memcmp(value.at + 1, text, length) == 0 && value.at[length + 1] == '"';
}

double json_number(struct json value, double otherwise)
{
    double number = otherwise;
    if (value.at != NULL) {
        const char *end = value.at;
        while (end < value.end && *end != '\0' && strchr("+-.0123456789eE", *end) != NULL) {
            end++;
        }
        const size_t length = (size_t)(end - value.at);
        number = number_parse_real(value.at, length, &number) == NUMBER_OK ? number : otherwise;
    }
    return number;
}

size_t json_index(struct json value, size_t otherwise)
{
    const double number = json_number(value, -1.0);
    return number >= 0.0 && number < 4294967296.0 ? (size_t)number : otherwise;
}
