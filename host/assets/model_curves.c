/* SPDX-License-Identifier: MIT */
#include "model_curves.h"

#ifdef QTRI_HAVE_ASSIMP

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../io/file.h"
#include "model.h"

/* ---- Buffers ---- */

struct gltf {
    const char *path;
    struct json root, accessors, views;
    const char *chunk; /* of a GLB file, NULL: none */
    size_t chunk_length;
    size_t buffer; /* the one that was loaded last */
    char *bytes;
    size_t length;
};

static uint32_t read_little(const char *bytes, int count)
{
    uint32_t value = 0;
    for (int i = count - 1; i >= 0; i--) {
        value = value << 8 | (unsigned char)bytes[i];
    }
    return value;
}

static struct gltf open_gltf(const char *path, const char *text, size_t length)
{
    enum { HEADER = 12, CHUNK = 8 };
    struct gltf file = {.path = path, .buffer = SIZE_MAX};
    if (length < HEADER + CHUNK || memcmp(text, "glTF", 4) != 0) {
        file.root = json_text(text, length);
    } else {
        const size_t json = read_little(text + HEADER, 4), rest = length - HEADER - CHUNK;
        file.root = json_text(text + HEADER + CHUNK, json < rest ? json : rest);
        if (json < rest && rest - json >= CHUNK) {
            const size_t left = rest - json - CHUNK;
            const size_t bytes = read_little(text + HEADER + CHUNK + json, 4);
            file.chunk = text + length - left;
            file.chunk_length = bytes < left ? bytes : left;
        }
    }
    file.accessors = json_member(file.root, "accessors");
    file.views = json_member(file.root, "bufferViews");
    return file;
}

static int base64_digit(char c)
{
    static const char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    const char *at = c != '\0' ? strchr(digits, c) : NULL;
    return at != NULL ? (int)(at - digits) : -1;
}

/* Up to what is no digit. False: no memory. */
static bool decode_base64(struct gltf *file, const char *at, const char *end)
{
    uint32_t bits = 0;
    int count = 0;
    file->bytes = malloc((size_t)(end - at) + 1);
    for (; file->bytes != NULL && at < end && base64_digit(*at) >= 0; at++) {
        bits = bits << 6 | (uint32_t)base64_digit(*at);
        count += 6;
        if (count >= 8) {
            count -= 8;
            file->bytes[file->length++] = (char)(bits >> count & 255);
        }
    }
    return file->bytes != NULL;
}

/* As the library does: what a name has of escapes stays. */
static bool read_beside(struct gltf *file, const char *at, const char *end)
{
    char name[1024], path[2048];
    struct file_content content;
    struct text_error error;
    (void)snprintf(name, sizeof name, "%.*s", (int)(end - at < 1000 ? end - at : 1000), at);
    if (!file_path_beside(path, sizeof path, file->path, name) ||
        !file_read(path, &content, &error)) {
        return false;
    }
    file->bytes = content.bytes;
    file->length = content.length;
    return true;
}

static bool load(struct gltf *file, size_t buffer)
{
    static const char data[] = "data:", base64[] = ";base64,";
    if (buffer == file->buffer) {
        return true;
    }
    free(file->bytes);
    file->bytes = NULL;
    file->length = 0;
    file->buffer = SIZE_MAX;
    const struct json whole = json_element(json_member(file->root, "buffers"), buffer);
    const struct json uri = json_member(whole, "uri");
    bool ok = false;
    if (uri.at == NULL && file->chunk != NULL && buffer == 0) {
        file->bytes = malloc(file->chunk_length + 1);
        ok = file->bytes != NULL;
        if (ok) {
            file->length = file->chunk_length;
            memcpy(file->bytes, file->chunk, file->length);
        }
    } else if (uri.at != NULL && *uri.at == '"') {
        const char *at = uri.at + 1, *end = json_skip(uri.at, uri.end) - 1;
        const bool is_data = (size_t)(end - at) > sizeof data && memcmp(at, data, 5) == 0;
        const char *comma = is_data ? memchr(at, ',', (size_t)(end - at)) : NULL;
        const bool is_base64 =
            comma != NULL && comma - at >= 7 && memcmp(comma - 7, base64, 8) == 0;
        ok = is_base64 ? decode_base64(file, comma + 1, end)
                       : !is_data && read_beside(file, at, end);
    }
    file->buffer = ok ? buffer : SIZE_MAX;
    return ok;
}

/* ---- Accessors ---- */

static double component(const char *bytes, size_t type)
{
    const uint32_t bits = read_little(bytes, type >= 5125 ? 4 : type >= 5122 ? 2 : 1);
    float real;
    memcpy(&real, &bits, sizeof real);
    switch (type) { /* whole numbers are parts of the largest */
    case 5120:
        return fmax((double)(int8_t)bits / 127.0, -1.0);
    case 5121:
        return (double)bits / 255.0;
    case 5122:
        return fmax((double)(int16_t)bits / 32767.0, -1.0);
    case 5123:
        return (double)bits / 65535.0;
    default:
        return (double)real;
    }
}

/* NULL: it is broken, sparse, of another type, or not there. */
static double *read_accessor(struct gltf *file, size_t index, size_t width, size_t *count)
{
    const struct json accessor = json_element(file->accessors, index);
    const struct json view =
        json_element(file->views, json_index(json_member(accessor, "bufferView"), SIZE_MAX));
    const size_t type = json_index(json_member(accessor, "componentType"), 0);
    const size_t size = (type == 5126 ? 4u : type >= 5122 ? 2u : 1u) * width;
    const size_t stride = json_index(json_member(view, "byteStride"), size);
    const size_t offset = json_index(json_member(accessor, "byteOffset"), 0) +
                          json_index(json_member(view, "byteOffset"), 0);
    *count = json_index(json_member(accessor, "count"), 0);
    if (view.at == NULL || json_member(accessor, "sparse").at != NULL || *count == 0 ||
        stride < size || (type != 5126 && (type < 5120 || type > 5123)) ||
        !load(file, json_index(json_member(view, "buffer"), 0)) || offset > file->length ||
        size > file->length - offset || *count - 1 > (file->length - offset - size) / stride) {
        return NULL;
    }
    double *values = malloc(*count * width * sizeof *values);
    for (size_t i = 0; values != NULL && i < *count * width; i++) {
        const char *at = file->bytes + offset + i / width * stride + i % width * (size / width);
        values[i] = component(at, type);
    }
    return values;
}

/* ---- Curves ---- */

static bool find_path(struct json target, enum motion_path *path)
{
    static const char *const names[] = {"translation", "rotation", "scale", "weights"};
    const struct json name = json_member(target, "path");
    unsigned i = 0;
    while (i < 4 && !json_is(name, names[i])) {
        i++;
    }
    *path = (enum motion_path)i;
    return i < 4;
}

/* In order, finite, and as many values as keys want. */
static bool is_whole(const struct motion_curve *curve, size_t value_count)
{
    const size_t wanted = curve->count * (curve->is_cubic ? 3 : 1);
    bool ok = curve->times != NULL && curve->values != NULL && curve->width > 0 &&
              value_count == wanted * (curve->path == MOTION_WEIGHTS ? curve->width : 1);
    for (size_t i = 0; ok && i < curve->count; i++) {
        ok = isfinite(curve->times[i]) && (i == 0 || curve->times[i] > curve->times[i - 1]);
    }
    for (size_t i = 0; ok && i < wanted * curve->width; i++) {
        ok = fabs(curve->values[i]) <= MODEL_MAX_VALUE;
    }
    return ok;
}

static bool read_curve(struct gltf *file, struct json sampler, struct motion_curve *curve)
{
    static const size_t widths[] = {3, 4, 3, 1};
    size_t value_count = 0;
    curve->times =
        read_accessor(file, json_index(json_member(sampler, "input"), SIZE_MAX), 1, &curve->count);
    curve->width = widths[curve->path];
    curve->values = read_accessor(file, json_index(json_member(sampler, "output"), SIZE_MAX),
                                  curve->width, &value_count);
    if (curve->path == MOTION_WEIGHTS && curve->count > 0) {
        curve->width = value_count / curve->count / (curve->is_cubic ? 3 : 1);
    }
    return is_whole(curve, value_count) &&
           (curve->name.at == NULL ||
            memchr(curve->name.at, '\\',
                   (size_t)(json_skip(curve->name.at, curve->name.end) - curve->name.at)) == NULL);
}

static void free_curve(struct motion_curve *curve)
{
    free(curve->times);
    free(curve->values);
}

static bool add_curve(struct gltf *file, struct json animation, struct json channel,
                      double per_second, struct motion_curves *curves)
{
    const struct json target = json_member(channel, "target");
    const struct json sampler = json_element(json_member(animation, "samplers"),
                                             json_index(json_member(channel, "sampler"), SIZE_MAX));
    const struct json way = json_member(sampler, "interpolation");
    struct motion_curve curve = {.is_cubic = json_is(way, "CUBICSPLINE"), .per_second = per_second};
    if ((!curve.is_cubic && !json_is(way, "STEP")) || !find_path(target, &curve.path)) {
        return true;
    }
    curve.node = json_index(json_member(target, "node"), SIZE_MAX);
    curve.name = json_member(json_element(json_member(file->root, "nodes"), curve.node), "name");
    if (json_is(curve.name, "")) {
        curve.name.at = NULL;
    }
    if (!read_curve(file, sampler, &curve)) {
        free_curve(&curve);
        curves->lost++;
        return true;
    }
    for (size_t i = 0; i < curve.count; i++) {
        curve.times[i] *= per_second;
    }
    struct motion_curve *items =
        realloc(curves->items, (curves->count + 1) * sizeof *curves->items);
    if (items == NULL) {
        free_curve(&curve);
        return false;
    }
    curves->items = items;
    items[curves->count++] = curve;
    return true;
}

bool motion_curves_read(const char *path, const char *text, size_t length, double per_second,
                        struct motion_curves *curves)
{
    struct gltf file = open_gltf(path, text, length);
    const struct json animation = json_element(json_member(file.root, "animations"), 0);
    bool ok = true;
    memset(curves, 0, sizeof *curves);
    for (struct json channel = json_first(json_member(animation, "channels"), NULL);
         ok && channel.at != NULL; channel = json_next(channel, NULL)) {
        ok = add_curve(&file, animation, channel, per_second, curves);
    }
    free(file.bytes);
    return ok;
}

void motion_curves_free(struct motion_curves *curves)
{
    for (size_t i = 0; i < curves->count; i++) {
        free_curve(&curves->items[i]);
    }
    free(curves->items);
    memset(curves, 0, sizeof *curves);
}

const struct motion_curve *motion_curve_of(const struct motion_curves *curves, const char *name,
                                           enum motion_path path)
{
    const struct motion_curve *found = NULL;
    for (size_t i = 0; found == NULL && i < curves->count; i++) {
        const struct motion_curve *curve = &curves->items[i];
        char index[40];
        (void)snprintf(index, sizeof index, "nodes[%zu]", curve->node);
        if (curve->path == path &&
            (curve->name.at != NULL ? json_is(curve->name, name) : strcmp(index, name) == 0)) {
            found = curve;
        }
    }
    return found;
}

/* Cubic Hermite (glTF 2.0, appendix C): tangents are a second's. */
static void cubic_at(const struct motion_curve *curve, size_t i, double time, double *value)
{
    const size_t w = curve->width;
    const double span = curve->times[i + 1] - curve->times[i], t = (time - curve->times[i]) / span;
    const double seconds = span / curve->per_second;
    const double *from = &curve->values[3 * w * i], *to = from + 3 * w;
    for (size_t j = 0; j < w; j++) {
        const double p0 = from[w + j], p1 = to[w + j], m0 = from[2 * w + j], m1 = to[j];
        value[j] = p0 * (1 + 2 * t) * (1 - t) * (1 - t) + p1 * (3 - 2 * t) * t * t +
                   (m0 * (1 - t) - m1 * t) * t * (1 - t) * seconds;
    }
}

void motion_curve_at(const struct motion_curve *curve, double time, bool is_before, double *value)
{
    const size_t w = curve->width, of_key = curve->is_cubic ? 3 * w : w;
    size_t i = 0;
    while (i + 1 < curve->count &&
           (is_before ? curve->times[i + 1] < time : curve->times[i + 1] <= time)) {
        i++;
    }
    memcpy(value, &curve->values[of_key * i + (curve->is_cubic ? w : 0)], w * sizeof *value);
    if (curve->is_cubic && i + 1 < curve->count && time > curve->times[i]) {
        cubic_at(curve, i, time, value);
    }
    if (curve->path == MOTION_ORIENTATION) {
        const double q[4] = {value[3], value[0], value[1], value[2]};
        const double length = sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
        for (int j = 0; j < 4; j++) {
            value[j] = length > 0.0 ? q[j] / length : j == 0 ? 1.0 : 0.0;
        }
    }
}

/* A line over 1/128 of a curve is off by |f''| / (8 * 128^2), 1e-4 of what it changes by. */
size_t motion_curve_moments(const struct motion_curve *curve, struct motion_moment *moments)
{
    const size_t parts = curve->is_cubic ? 128 : 2;
    const size_t count = (curve->count - 1) * parts + 1;
    for (size_t i = 0; moments != NULL && i < count; i++) {
        const size_t key = i / parts, part = i % parts;
        const double next = curve->times[key + (part > 0 ? 1 : 0)];
        const double share = curve->is_cubic ? (double)part / (double)parts : 1.0;
        moments[i].time = curve->times[key] + share * (next - curve->times[key]);
        moments[i].is_before = !curve->is_cubic && part > 0;
    }
    return count;
}

#endif
