/* SPDX-License-Identifier: MIT */
/*
 * JSON text, looked up where it stands: as much of it as glTF needs, without memory of its own.
 */
#ifndef QTRI_HOST_ASSETS_JSON_H
#define QTRI_HOST_ASSETS_JSON_H

#include <stdbool.h>
#include <stddef.h>

/* A value begins at `at`, or there is none: NULL. The text ends at `end`, which need not be 0. */
struct json {
    const char *at, *end;
};

struct json json_text(const char *text, size_t length);

/* Of what is no object or array, or is broken: none. Names are compared as they are written. */
struct json json_member(struct json object, const char *name);
struct json json_element(struct json array, size_t index);

/* The first element or member, and the one behind; of members `name` is where the name begins. */
struct json json_first(struct json whole, struct json *name);
struct json json_next(struct json value, struct json *name);

/* Whether it is a string of these characters. */
bool json_is(struct json value, const char *text);

/* Of what is no number, or none that fits: `otherwise`. */
double json_number(struct json value, double otherwise);
size_t json_index(struct json value, size_t otherwise);

/* One past the end of what begins at `from`, a string, an object or an array, or `end`. */
const char *json_skip(const char *from, const char *end);

#endif
