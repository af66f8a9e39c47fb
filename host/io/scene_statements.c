/* SPDX-License-Identifier: MIT */
/*
 * The statements of the scene language: a table, and the reader of arguments that it directs.
 */
#include "scene_parser.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "expression.h"
#include "number.h"

#define COUNT_OF(array) (sizeof(array) / sizeof(array)[0])

/*
 * Kinds of values. Besides these: `w` a word of the usage text, `t` a token that the handler reads.
 * A number in front repeats what follows; behind `?` values may be left out, all up to the next
 * `?`, and are 0 then, or 1.0 of `g`; behind `*` the handler reads as many as there are.
 */
static const struct kind {
    char letter;
    bool is_whole;
    int low, high;
    const char *problem; /* where it is not whole */
} kinds[] = {
    {'n', false, INT16_MIN, 32768, ""},
    {'f', false, 0, 1, "does not lie in 0..1"},
    {'g', false, 0, 1, "does not lie in 0..1"},
    {'l', false, 0, 16, "does not lie in 0..16"},
    {'e', false, 1, 1024, "does not lie in 1..1024"},
    {'z', false, 0, 32768, "must not be below 0"},
    {'a', false, 0, 180, "is not an angle of 0..180 degrees"},
    {'b', true, 0, 255, NULL},
    {'s', true, 1, SCENE_MAX_SIZE, NULL},
    {'o', true, -SCENE_MAX_SIZE, SCENE_MAX_SIZE, NULL},
    {'i', true, 1, 1024, NULL},
    {'j', true, 2, 1024, NULL},
    {'k', true, 3, 1024, NULL},
};

/* Where a value is stored: in the pass, or in the parser. */
#define SCENE(field)  offsetof(struct scene, field)
#define IN_PARSER     ((size_t)1 << 30)
#define PARSER(field) (offsetof(struct scene_parser, field) | IN_PARSER)

/* clang-format off */
static const struct scene_statement statements[] = {
    {"pass",        "", "", scene_statement_pass, 0},
    {"viewport",    "W H", "2s", scene_statement_viewport, 0},
    {"clear",       "R G B", "3f", scene_store, SCENE(clear)},
    {"cleardepth",  "Z", "f", scene_store, SCENE(clear_depth)},
    {"depth",       "off|less|lequal|greater|gequal|always|equal|notequal|never", "w", scene_statement_depth, 0},
    {"depthformat", "linear16|float16|linear24|linear32", "w", scene_store, SCENE(depth_format)},
    {"depthmask",   "on|off", "w", scene_store_on, SCENE(depth_write)},
    {"depthrange",  "NEAR FAR", "2f", scene_store, SCENE(depth_near)},
    {"depthbias",   "B", "n", scene_statement_depthbias, 0},
    {"depthslope",  "S", "n", scene_store, PARSER(depth_slope)},
    {"cull",        "none|back|front", "w", scene_store, SCENE(cull)},
    {"frustumcull", "off|box|ball", "w", scene_store, SCENE(frustum_cull)},
    {"shade",       "smooth|flat|pixel [first|last]", "w?w", scene_statement_shade, 0},
    {"texture",     "off", "w", scene_statement_texture, SCENE_OF_NOTHING},
    {"texture",     "FILE.ppm", "t", scene_statement_texture, SCENE_OF_FILE},
    {"texture",     "W H CELLS r g b r g b", "2it6b", scene_statement_texture, SCENE_OF_CHECKERS},
    {"texmode",     "replace|modulate", "w", scene_store, SCENE(texture_mode)},
    {"texwrap",     "repeat|clamp [repeat|clamp]", "w?w", scene_statement_texwrap, 0},
    {"texfilter",   "nearest|bilinear [mipmaps]", "w?w", scene_store_flags, SCENE(texture_bilinear)},
    {"texformat",   "xrgb8888|rgb565|palette|gray8|palette565|argb4444|argb1555|argb8888|alpha8", "w", scene_statement_texformat, SCENE(texel_format)},
    {"texalpha",    "off", "w", scene_statement_texalpha, SCENE_OF_NOTHING},
    {"texalpha",    "FILE.ppm", "t", scene_statement_texalpha, SCENE_OF_FILE},
    {"texalpha",    "A B", "2b", scene_statement_texalpha, SCENE_OF_CHECKERS},
    {"alphatest",   "off", "w", scene_statement_alphatest, 0},
    {"alphatest",   "LEAST", "b", scene_statement_alphatest, 1},
    {"texkey",      "off", "w", scene_statement_texkey, SCENE(texture_keyed)},
    {"texkey",      "r g b", "3b", scene_statement_texkey, SCENE(texture_keyed)},
    {"texgen",      "off|sphere", "w", scene_store_flags, SCENE(texture_sphere)},
    {"interpolate", "perspective|linear", "w", scene_store_flags, SCENE(screen_linear)},
    {"blend",       "off|alpha|add|multiply|none|replace|screendoor [ALPHA]", "w?g", scene_store, SCENE(blend)},
    {"colormask",   "on|off on|off on|off", "3w", scene_store_flags, SCENE(keep)},
    {"vertexalpha", "off", "w", scene_statement_vertexalpha, 0},
    {"vertexalpha", "A0 A1 A2", "3f", scene_statement_vertexalpha, 0},
    {"fog",         "off", "w", scene_store, SCENE(fog.kind)},
    {"fog",         "linear NEAR FAR r g b START END", "w2n3f2n", scene_statement_fog, SCENE_FOG_LINEAR},
    {"fogdensity",  "exp|exp2 NEAR FAR r g b DENSITY", "w2n3fn", scene_statement_fog, SCENE_FOG_EXP},
    {"polygon",     "fill|line|smooth|wide|hidden [BIAS]", "w?f", scene_statement_polygon, 0},
    {"light",       "x y z ambient diffuse", "3n2f", scene_statement_one_light, 0},
    {"light",       "directional x y z r g b", "w3n3l", scene_statement_light, SCENE_DIRECTIONAL},
    {"light",       "point x y z r g b [constant linear quadratic]", "w3n3l?3z", scene_statement_light, SCENE_POINT},
    {"light",       "spot x y z dx dy dz inner outer r g b [constant linear quadratic [exponent]]",
     "w6n2a3l?3z?e", scene_statement_light, SCENE_SPOT},
    {"ambient",     "r g b", "3l", scene_statement_ambient, 0},
    {"material",    "ambient r g b", "w3f", scene_statement_material, SCENE(reflection.ambient)},
    {"material",    "emission r g b", "w3f", scene_statement_material, SCENE(reflection.emission)},
    {"material",    "specular r g b shininess", "w3fe", scene_statement_material, SCENE(reflection.specular)},
    {"twosided",    "off|on", "w", scene_store_flags, SCENE(reflection.two_sided)},
    {"antialias",   "off|edges|ssaa|fxaa|temporal|msaa", "w", scene_store, SCENE(antialias)},
    {"mode",        "projection|modelview", "w", scene_statement_mode, 0},
    {"identity",    "", "", scene_statement_numbers, SCENE_IDENTITY},
    {"load",        "m0..m15", "16n", scene_statement_numbers, SCENE_LOAD},
    {"mult",        "m0..m15", "16n", scene_statement_numbers, SCENE_MULT},
    {"lookat",      "ex ey ez cx cy cz ux uy uz", "9n", scene_statement_numbers, SCENE_LOOKAT},
    {"perspective", "fovy aspect near far", "4n", scene_statement_numbers, SCENE_PERSPECTIVE},
    {"frustum",     "l r b t near far", "6n", scene_statement_numbers, SCENE_FRUSTUM},
    {"ortho",       "l r b t near far", "6n", scene_statement_numbers, SCENE_ORTHO},
    {"translate",   "x y z", "3n", scene_statement_numbers, SCENE_TRANSLATE},
    {"rotate",      "degrees x y z", "4n", scene_statement_numbers, SCENE_ROTATE},
    {"scale",       "x y z", "3n", scene_statement_numbers, SCENE_SCALE},
    {"rotateabout", "degrees ax ay az px py pz", "7n", scene_statement_numbers, SCENE_ROTATE_ABOUT},
    {"rotatetriangle", "degrees (x y z) x3", "10n", scene_statement_numbers, SCENE_ROTATE_TRIANGLE},
    {"quaternion",  "w x y z", "4n", scene_statement_numbers, SCENE_QUATERNION},
    {"orbit",       "cx cy cz distance azimuth elevation", "6n", scene_statement_numbers, SCENE_ORBIT},
    {"lookatd3d",   "ex ey ez cx cy cz ux uy uz", "9n", scene_statement_numbers, SCENE_LOOKAT_D3D},
    {"perspectived3d", "fovy aspect near far", "4n", scene_statement_numbers, SCENE_PERSPECTIVE_D3D},
    {"frustumd3d",  "l r b t near far", "6n", scene_statement_numbers, SCENE_FRUSTUM_D3D},
    {"orthod3d",    "l r b t near far", "6n", scene_statement_numbers, SCENE_ORTHO_D3D},
    {"orthonormalize", "", "", scene_statement_numbers, SCENE_ORTHONORMALIZE},
    {"camera",      "", "", scene_statement_camera, 0},
    {"billboard",   "[upright]", "?w", scene_statement_billboard, 0},
    {"key",         "time x y z degrees ax ay az sx sy sz", "11n", scene_statement_key, 0},
    {"keys",        "time", "n", scene_statement_keys, 0},
    {"joint",       "none|PARENT", "t", scene_statement_joint, 0},
    {"atjoint",     "JOINT", "t", scene_statement_atjoint, 0},
    {"window",      "X Y W H [bottom]", "2o2s?w", scene_statement_window, 0},
    {"push",        "", "", scene_statement_push, 0},
    {"pop",         "", "", scene_statement_pop, 0},
    {"tri",         "(x y z w r g b) x3", "4n3f4n3f4n3f", scene_statement_triangle, 0},
    {"trit",        "(x y z w r g b u v) x3", "4n3f2n4n3f2n4n3f2n", scene_statement_triangle, 0},
    {"trin",        "(x y z w r g b nx ny nz) x3", "4n3f3n4n3f3n4n3f3n", scene_statement_triangle, 0},
    {"tritn",       "(x y z w r g b u v nx ny nz) x3", "4n3f5n4n3f5n4n3f5n", scene_statement_triangle, 0},
    {"linewidth",   "PIXELS", "n", scene_store, PARSER(stroke.width)},
    {"linesmooth",  "on|off", "w", scene_store_on, PARSER(stroke.smooth)},
    {"linecap",     "round|butt|square", "w", scene_store, PARSER(stroke.cap)},
    {"linealpha",   "A", "f", scene_store, PARSER(stroke.alpha)},
    {"line",        "(x y z w r g b) x2", "4n3f4n3f", scene_statement_line, 0},
    {"polyline",    "open|closed", "w", scene_statement_polyline, 0},
    {"vertex",      "x y z w r g b", "4n3f", scene_statement_vertex, 0},
    {"pointsize",   "SIZE [space]", "n?w", scene_store, PARSER(point_size)},
    {"point",       "x y z w r g b", "4n3f", scene_statement_point, 0},
    {"mesh",        "FILE.obj [fit SIZE | scale FACTOR] [color r g b]", "t*", scene_statement_mesh, 0},
    {"shape",       "box HX HY HZ [color r g b]", "w3n?w3f", scene_statement_shape, SCENE_BOX},
    {"shape",       "sphere R SLICES ROWS [color r g b]", "wnkj?w3f", scene_statement_shape, SCENE_SPHERE},
    {"shape",       "cylinder R H SLICES [color r g b]", "w2nk?w3f", scene_statement_shape, SCENE_CYLINDER},
    {"shape",       "cone R H SLICES [color r g b]", "w2nk?w3f", scene_statement_shape, SCENE_CONE},
    {"shape",       "torus R TUBE SLICES RINGS [color r g b]", "w2n2k?w3f", scene_statement_shape, SCENE_TORUS},
    {"shape",       "grid HX HZ COLUMNS ROWS [color r g b]", "w2n2i?w3f", scene_statement_shape, SCENE_GRID},
    {"morph",       "T FROM.obj TO.obj [color r g b]", "f2t?w3f", scene_statement_morph, 0},
    {"frames",      "AT FILE.obj x2 to x16 [color r g b]", "n2t*", scene_statement_frames, 0},
    {"targets",     "BASE.obj (WEIGHT FILE.obj) x1 to x15 [color r g b]", "tnt*", scene_statement_targets, 0},
    {"ink",         "R G B [ALPHA]", "3f?g", scene_store, PARSER(brush.paint.color)},
    {"edges",       "hard|smooth", "w", scene_store_flags, PARSER(brush.paint.is_smooth)},
    {"rect",        "x0 y0 x1 y1 [WIDTH]", "4n?n", scene_statement_paint, SCENE_PAINT_RECT},
    {"roundrect",   "x0 y0 x1 y1 RADIUS [WIDTH]", "5n?n", scene_statement_paint, SCENE_PAINT_ROUNDRECT},
    {"circle",      "x y RADIUS [WIDTH]", "3n?n", scene_statement_paint, SCENE_PAINT_CIRCLE},
    {"arc",         "x y RADIUS WIDTH FROM SWEEP", "6n", scene_statement_paint, SCENE_PAINT_ARC},
    {"area",        "(x y) x3 to x8", "6n?2n?2n?2n?2n?2n", scene_statement_paint, SCENE_PAINT_AREA},
    {"stroke",      "x0 y0 x1 y1 WIDTH", "5n", scene_statement_paint, SCENE_PAINT_STROKE},
    {"font",        "FILE.bdf", "t", scene_statement_font, 0},
    {"text",        "x y WORD ...", "2nt*", scene_statement_text, 0},
    {"imagekey",    "off", "w", scene_store_key, PARSER(brush.paint.has_key)},
    {"imagekey",    "r g b", "3b", scene_store_key, PARSER(brush.paint.has_key)},
    {"image",       "FILE.ppm x y [DEGREES SCALE]", "t2n?2n", scene_statement_image, 0},
};
/* clang-format on */

bool scene_statement_usage(size_t i, const char **name, const char **arguments)
{
    if (i >= COUNT_OF(statements)) {
        return false;
    }
    *name = statements[i].name;
    *arguments = statements[i].usage;
    return true;
}

/* ---- Errors ---- */

bool scene_fail(struct scene_parser *parser, const char *sentence)
{
    return text_error_set(parser->error, parser->name, parser->line, "%s: %s",
                          parser->statement->name, sentence);
}

bool scene_fail_argument(struct scene_parser *parser, int argument, const char *problem)
{
    char quoted[TOKEN_QUOTE_SIZE];
    return text_error_set(parser->error, parser->name, parser->line, "%s: '%s' %s",
                          parser->statement->name,
                          token_quote(&parser->arguments[argument], quoted), problem);
}

static bool has_name(size_t i, const char *name)
{
    return i < COUNT_OF(statements) && strcmp(statements[i].name, name) == 0;
}

#define USAGE_SIZE 400

/* "NAME one form, NAME another or NAME a third": the rows of a name follow each other. */
static const char *usage_of(const char *name, char out[USAGE_SIZE])
{
    size_t used = 0;
    for (size_t i = 0; i < COUNT_OF(statements); i++) {
        if (!has_name(i, name)) {
            continue;
        }
        const char *before = used == 0 ? "" : has_name(i + 1, name) ? ", " : " or ";
        const int length = snprintf(out + used, USAGE_SIZE - used, "%s%s%s%s", before, name,
                                    statements[i].usage[0] == '\0' ? "" : " ", statements[i].usage);
        used += length < 0 ? 0 : (size_t)length;
        used = used < USAGE_SIZE ? used : USAGE_SIZE - 1;
    }
    return out;
}

bool scene_fail_count(struct scene_parser *parser)
{
    char usage[USAGE_SIZE];
    return text_error_set(parser->error, parser->name, parser->line,
                          "wrong number of values (%d) for %s", parser->argument_count,
                          usage_of(parser->statement->name, usage));
}

static bool fail_word(struct scene_parser *parser, int argument)
{
    char quoted[TOKEN_QUOTE_SIZE];
    char usage[USAGE_SIZE];
    return text_error_set(parser->error, parser->name, parser->line, "'%s' is unknown here: %s",
                          token_quote(&parser->arguments[argument], quoted),
                          usage_of(parser->statement->name, usage));
}

/* ---- Values ---- */

/* The value of an argument that is an expression; false with the error. */
static bool evaluate(struct scene_parser *parser, int argument, double *value)
{
    const struct token *token = &parser->arguments[argument];
    struct expression_error error;
    char quoted[TOKEN_QUOTE_SIZE];
    if (expression_evaluate(token, parser->time, value, &error)) {
        return true;
    }
    return text_error_set(parser->error, parser->name, parser->line, "%s: '%s' %s (column %d)",
                          parser->statement->name, token_quote(token, quoted), error.problem,
                          (int)((size_t)(token->text - parser->line_text) + error.column));
}

static bool is_expression(const struct scene_parser *parser, int argument)
{
    return expression_is(&parser->arguments[argument]);
}

bool scene_integer(struct scene_parser *parser, int argument, int minimum, int maximum,
                   int32_t *value)
{
    const struct token *token = &parser->arguments[argument];
    int64_t parsed;
    double real;
    enum number_result result =
        number_parse_integer(token->text, token->length, minimum, maximum, &parsed);
    if (result == NUMBER_MALFORMED && is_expression(parser, argument)) {
        if (!evaluate(parser, argument, &real)) {
            return false;
        }
        real = round(real);
        result = real < minimum || real > maximum ? NUMBER_OUT_OF_RANGE : NUMBER_OK;
        parsed = result == NUMBER_OK ? (int64_t)real : 0;
    }
    if (result != NUMBER_OK) {
        char problem[60];
        (void)snprintf(problem, sizeof problem, "is not a whole number in %d..%d", minimum,
                       maximum);
        return scene_fail_argument(parser, argument, problem);
    }
    *value = (int32_t)parsed;
    return true;
}

/* A number to the nearest Q16.16. */
static bool read_q16(struct scene_parser *parser, int argument, int32_t *value)
{
    const struct token *token = &parser->arguments[argument];
    double real;
    enum number_result result = number_parse_q16(token->text, token->length, value);
    if (result == NUMBER_MALFORMED && is_expression(parser, argument)) {
        if (!evaluate(parser, argument, &real)) {
            return false;
        }
        real = round(real * SCENE_ONE);
        result = real < INT32_MIN || real > INT32_MAX ? NUMBER_OUT_OF_RANGE : NUMBER_OK;
        *value = result == NUMBER_OK ? (int32_t)real : 0;
    }
    return result == NUMBER_OK || scene_fail_argument(parser, argument, number_problem(result));
}

static bool read_number(struct scene_parser *parser, int argument, const struct kind *kind,
                        int32_t *value)
{
    if (!read_q16(parser, argument, value)) {
        return false;
    }
    if (*value < (int64_t)kind->low * SCENE_ONE || *value > (int64_t)kind->high * SCENE_ONE) {
        return scene_fail_argument(parser, argument, kind->problem);
    }
    return true;
}

bool scene_word(struct scene_parser *parser, int argument, const char *word)
{
    return token_equals(&parser->arguments[argument], word) || fail_word(parser, argument);
}

/* The rank of a token among the choices of word `index` of the usage text, from 1 where it may be
   left out; or -1. */
static int32_t find_word(const char *usage, int index, const struct token *token)
{
    const char *at = usage;
    for (int i = 0; i < index; i++) {
        at += strcspn(at, " ");
        at += strspn(at, " ");
    }
    for (int32_t rank = *at == '['; *at != '\0' && *at != ' '; rank++) {
        at += strspn(at, "[|");
        const size_t length = strcspn(at, "|] ");
        if (token->length == length && memcmp(token->text, at, length) == 0) {
            return rank;
        }
        at += length + strspn(at + length, "]");
    }
    return -1;
}

bool scene_read_values(struct scene_parser *parser, int first, int count, char letter,
                       int32_t *value)
{
    const struct kind *kind = kinds;
    while (kind->letter != letter) {
        kind++;
    }
    for (int i = 0; i < count; i++) {
        if (kind->is_whole ? !scene_integer(parser, first + i, kind->low, kind->high, &value[i])
                           : !read_number(parser, first + i, kind, &value[i])) {
            return false;
        }
    }
    return true;
}

static bool read_value(struct scene_parser *parser, int argument, char letter, int32_t *value)
{
    switch (letter) {
    case 'w':
        *value = find_word(parser->statement->usage, argument, &parser->arguments[argument]);
        return *value >= 0 || fail_word(parser, argument);
    case 't':
        return true;
    default:
        return scene_read_values(parser, argument, 1, letter, value);
    }
}

/* How often the next letter is repeated; *values is moved to it. */
static int take_repeat(const char **values)
{
    int repeat = 0;
    while (**values >= '0' && **values <= '9') {
        repeat = 10 * repeat + (*(*values)++ - '0');
    }
    return repeat > 0 ? repeat : 1;
}

/* Those that may be left out, too. */
static bool read_values(struct scene_parser *parser, int32_t *value)
{
    int next = 0;
    for (const char *at = parser->statement->values; *at != '\0' && *at != '*'; at++) {
        if (*at == '?') {
            continue;
        }
        for (int repeat = take_repeat(&at); repeat > 0; repeat--, next++) {
            value[next] = *at == 'g' ? SCENE_ONE : 0;
            if (next < parser->argument_count && !read_value(parser, next, *at, &value[next])) {
                return false;
            }
        }
    }
    parser->value_count = next;
    return true;
}

/* ---- Choice of the row ---- */

static bool takes_count(const struct scene_statement *statement, int count)
{
    int least = 0;
    for (const char *at = statement->values; *at != '\0'; at++) {
        if (*at == '*') {
            return count >= least && count <= SCENE_MAX_ARGUMENTS;
        }
        if (*at == '?') {
            if (count == least) {
                return true;
            }
            continue;
        }
        least += take_repeat(&at);
    }
    return count == least;
}

/* Whether a row is for a first argument that is one certain word. */
static bool begins_with_word(const struct scene_statement *statement)
{
    return statement->values[0] == 'w' && statement->usage[strcspn(statement->usage, "| ")] != '|';
}

/*
 * Of the rows of a name, the one whose word the first argument is; else one that has room for so
 * many values; else any.
 */
static const struct scene_statement *choose(const struct scene_parser *parser, size_t first)
{
    const struct scene_statement *fits = NULL;
    for (size_t i = first; has_name(i, statements[first].name); i++) {
        const struct scene_statement *one = &statements[i];
        const bool is_word = begins_with_word(one);
        if (is_word && parser->argument_count > 0 &&
            find_word(one->usage, 0, &parser->arguments[0]) == 0) {
            return one;
        }
        if (takes_count(one, parser->argument_count) && (fits == NULL || !is_word)) {
            fits = one;
        }
    }
    return fits != NULL ? fits : &statements[first];
}

bool scene_parse_statement(struct scene_parser *parser, const struct token *keyword)
{
    int32_t value[SCENE_MAX_ARGUMENTS] = {0};
    size_t first = 0;
    while (first < COUNT_OF(statements) && !token_equals(keyword, statements[first].name)) {
        first++;
    }
    if (first == COUNT_OF(statements)) {
        char quoted[TOKEN_QUOTE_SIZE];
        return text_error_set(
            parser->error, parser->name, parser->line, "'%s' %s", token_quote(keyword, quoted),
            token_is_binary(keyword) ? "is not text: is this a scene file?" : "is not a statement");
    }
    parser->statement = choose(parser, first);
    if (!takes_count(parser->statement, parser->argument_count)) {
        return scene_fail_count(parser);
    }
    return read_values(parser, value) && parser->statement->handler(parser, value);
}

/* ---- Handlers that store ---- */

static void *destination(struct scene_parser *parser)
{
    const size_t into = parser->statement->into;
    return (into & IN_PARSER) != 0 ? (char *)parser + (into & ~IN_PARSER)
                                   : (char *)parser->scene + into;
}

bool scene_store(struct scene_parser *parser, const int32_t *value)
{
    memcpy(destination(parser), value, (size_t)parser->value_count * sizeof *value);
    return true;
}

static bool store_flags(struct scene_parser *parser, const int32_t *value, bool of_first)
{
    bool *flags = destination(parser);
    for (int i = 0; i < parser->value_count; i++) {
        flags[i] = (value[i] == 0) == of_first;
    }
    return true;
}

bool scene_store_flags(struct scene_parser *parser, const int32_t *value)
{
    return store_flags(parser, value, false);
}

bool scene_store_on(struct scene_parser *parser, const int32_t *value)
{
    return store_flags(parser, value, true);
}

bool scene_store_key(struct scene_parser *parser, const int32_t *value)
{
    uint8_t *key = destination(parser);
    *key++ = parser->value_count == 3;
    for (int i = 0; i < 3; i++) {
        key[i] = (uint8_t)value[i];
    }
    return true;
}
