/* SPDX-License-Identifier: MIT */
#define _XOPEN_SOURCE 700
#include "scene.h"

#include <stdlib.h>
#include <string.h>

#include "scene_parser.h"

/* clang-format off */
static const struct scene_statement statements[] = {
    {"viewport",    {2, 2},    scene_statement_viewport,      0, "W H"},
    {"clear",       {3, 3},    scene_statement_clear,         0, "R G B"},
    {"cleardepth",  {1, 1},    scene_statement_cleardepth,    0, "Z"},
    {"depth",       {1, 1},    scene_statement_depth,         0,
     "off|less|lequal|greater|gequal|always|equal|notequal|never"},
    {"depthformat", {1, 1},    scene_statement_depthformat,   0,
     "linear16|float16|linear24|linear32"},
    {"depthmask",   {1, 1},    scene_statement_depthmask,     0, "on|off"},
    {"depthrange",  {2, 2},    scene_statement_depthrange,    0, "NEAR FAR"},
    {"cull",        {1, 1},    scene_statement_cull,          0, "none|back|front"},
    {"shade",       {1, 2},    scene_statement_shade,         0, "smooth|flat|pixel [first|last]"},
    {"texture",     {1, 9},    scene_statement_texture,       0,
     "off, texture FILE.ppm or texture W H CELLS r g b r g b"},
    {"texmode",     {1, 1},    scene_statement_texmode,       0, "replace|modulate"},
    {"texwrap",     {1, 2},    scene_statement_texwrap,       0, "repeat|clamp [repeat|clamp]"},
    {"texfilter",   {1, 2},    scene_statement_texfilter,     0, "nearest|bilinear [mipmaps]"},
    {"texformat",   {1, 1},    scene_statement_texformat,     0, 
     "xrgb8888|rgb565|palette|gray8|argb4444|argb1555|argb8888|alpha8"},
    {"texalpha",    {1, 2},    scene_statement_texalpha,      0, "off, texalpha FILE.ppm or texalpha A B"},
    {"alphatest",   {1, 1},    scene_statement_alphatest,     0, "off|LEAST"},
    {"texkey",      {1, 3},    scene_statement_texkey,        0, "off or texkey r g b"},
    {"interpolate", {1, 1},    scene_statement_interpolate,   0, "perspective|linear"},
    {"blend",       {1, 2},    scene_statement_blend,         0,
     "off|alpha|add|multiply|none|replace|screendoor [ALPHA]"},
    {"colormask",   {3, 3},    scene_statement_colormask,     0, "on|off on|off on|off"},
    {"vertexalpha", {1, 3},    scene_statement_vertexalpha,   0, "off or vertexalpha A0 A1 A2"},
    {"depthbias",   {1, 1},    scene_statement_depthbias,     0, "B"},
    {"depthslope",  {1, 1},    scene_statement_depthslope,    0, "S"},
    {"fog",         {1, 8},    scene_statement_fog,           0,
     "off or fog linear NEAR FAR r g b START END"},
    {"fogdensity",  {7, 7},    scene_statement_fogdensity,    0,
     "exp|exp2 NEAR FAR r g b DENSITY"},
    {"polygon",     {1, 2},    scene_statement_polygon,       0, "fill|line|smooth|wide|hidden [BIAS]"},
    {"light",       {5, SCENE_ANY}, scene_statement_light,    0,
     "x y z ambient diffuse, light directional x y z r g b, light point x y z r g b [constant linear "
     "quadratic] or light spot x y z dx dy dz inner outer r g b [constant linear quadratic "
     "[exponent]]"},
    {"ambient",     {3, 3},    scene_statement_ambient,       0, "r g b"},
    {"material",    {4, 5},    scene_statement_material,      0,
     "ambient r g b, material emission r g b or material specular r g b shininess"},
    {"twosided",    {1, 1},    scene_statement_twosided,      0, "off|on"},
    {"texgen",      {1, 1},    scene_statement_texgen,        0, "off|sphere"},
    {"antialias",   {1, 1},    scene_statement_antialias,     0, "off|edges|ssaa|fxaa|temporal|msaa"},
    {"mode",        {1, 1},    scene_statement_mode,          0, "projection|modelview"},
    {"identity",    {0, 0},    scene_statement_numbers,       SCENE_IDENTITY, ""},
    {"load",        {16, 16},  scene_statement_numbers,       SCENE_LOAD, "m0..m15"},
    {"mult",        {16, 16},  scene_statement_numbers,       SCENE_MULT, "m0..m15"},
    {"lookat",      {9, 9},    scene_statement_numbers,       SCENE_LOOKAT,
     "ex ey ez cx cy cz ux uy uz"},
    {"perspective", {4, 4},    scene_statement_numbers,       SCENE_PERSPECTIVE,
     "fovy aspect near far"},
    {"frustum",     {6, 6},    scene_statement_numbers,       SCENE_FRUSTUM, "l r b t near far"},
    {"ortho",       {6, 6},    scene_statement_numbers,       SCENE_ORTHO, "l r b t near far"},
    {"translate",   {3, 3},    scene_statement_numbers,       SCENE_TRANSLATE, "x y z"},
    {"rotate",      {4, 4},    scene_statement_numbers,       SCENE_ROTATE, "degrees x y z"},
    {"scale",       {3, 3},    scene_statement_numbers,       SCENE_SCALE, "x y z"},
    {"rotateabout", {7, 7},    scene_statement_numbers,       SCENE_ROTATE_ABOUT,
     "degrees ax ay az px py pz"},
    {"rotatetriangle", {10, 10}, scene_statement_numbers,     SCENE_ROTATE_TRIANGLE,
     "degrees (x y z) x3"},
    {"quaternion",  {4, 4},    scene_statement_numbers,       SCENE_QUATERNION, "w x y z"},
    {"orbit",       {6, 6},    scene_statement_numbers,       SCENE_ORBIT,
     "cx cy cz distance azimuth elevation"},
    {"lookatd3d",   {9, 9},    scene_statement_numbers,       SCENE_LOOKAT_D3D,
     "ex ey ez cx cy cz ux uy uz"},
    {"perspectived3d", {4, 4}, scene_statement_numbers,       SCENE_PERSPECTIVE_D3D,
     "fovy aspect near far"},
    {"frustumd3d",  {6, 6},    scene_statement_numbers,       SCENE_FRUSTUM_D3D, "l r b t near far"},
    {"orthod3d",    {6, 6},    scene_statement_numbers,       SCENE_ORTHO_D3D, "l r b t near far"},
    {"orthonormalize", {0, 0}, scene_statement_numbers,       SCENE_ORTHONORMALIZE, ""},
    {"camera",      {0, 0},    scene_statement_camera,        SCENE_CAMERA, ""},
    {"billboard",   {0, 1},    scene_statement_billboard,     SCENE_BILLBOARD, "[upright]"},
    {"key",         {11, 11},  scene_statement_key,           0,
     "time x y z degrees ax ay az sx sy sz"},
    {"keys",        {1, 1},    scene_statement_keys,          SCENE_KEYS, "time"},
    {"joint",       {1, 1},    scene_statement_joint,         SCENE_JOINT, "none|PARENT"},
    {"atjoint",     {1, 1},    scene_statement_atjoint,       SCENE_AT_JOINT, "JOINT"},
    {"window",      {4, 5},    scene_statement_window,        SCENE_WINDOW, "X Y W H [bottom]"},
    {"push",        {0, 0},    scene_statement_push,          SCENE_PUSH, ""},
    {"pop",         {0, 0},    scene_statement_pop,           SCENE_POP, ""},
    {"tri",         {21, 21},  scene_statement_triangle,      SCENE_TRIANGLE, "(x y z w r g b) x3"},
    {"trit",        {27, 27},  scene_statement_triangle,      SCENE_TRIANGLE,
     "(x y z w r g b u v) x3"},
    {"trin",        {30, 30},  scene_statement_triangle,      SCENE_TRIANGLE,
     "(x y z w r g b nx ny nz) x3"},
    {"tritn",       {36, 36},  scene_statement_triangle,      SCENE_TRIANGLE,
     "(x y z w r g b u v nx ny nz) x3"},
    {"linewidth",   {1, 1},    scene_statement_linewidth,     0, "PIXELS"},
    {"linesmooth",  {1, 1},    scene_statement_linesmooth,    0, "on|off"},
    {"linecap",     {1, 1},    scene_statement_linecap,       0, "round|butt|square"},
    {"linealpha",   {1, 1},    scene_statement_linealpha,     0, "A"},
    {"line",        {14, 14},  scene_statement_line,          0, "(x y z w r g b) x2"},
    {"polyline",    {1, 1},    scene_statement_polyline,      0, "open|closed"},
    {"vertex",      {7, 7},    scene_statement_vertex,        0, "x y z w r g b"},
    {"pointsize",   {1, 2},    scene_statement_pointsize,     0, "SIZE [space]"},
    {"point",       {7, 7},    scene_statement_point,         0, "x y z w r g b"},
    {"mesh",        {1, -7},   scene_statement_mesh,          SCENE_MESH, "FILE.obj [fit SIZE | scale FACTOR] [color r g b]"},
    {"shape",       {4, SCENE_ANY}, scene_statement_shape,    SCENE_MODEL,
     "box HX HY HZ, shape sphere R SLICES ROWS, shape cylinder R H SLICES, shape cone R H SLICES, "
     "shape torus R TUBE SLICES RINGS or shape grid HX HZ COLUMNS ROWS, [color r g b]"},
    {"morph",       {3, 7},    scene_statement_morph,         SCENE_MODEL,
     "T FROM.obj TO.obj [color r g b]"},
    {"frames",      {3, SCENE_ANY}, scene_statement_frames,   SCENE_MODEL,
     "AT FILE.obj x2 to x16 [color r g b]"},
    {"targets",     {3, SCENE_ANY}, scene_statement_targets,  SCENE_MODEL,
     "BASE.obj (WEIGHT FILE.obj) x1 to x15 [color r g b]"},
    {"frustumcull", {1, 1},    scene_statement_frustumcull,   0, "off|box|ball"},
    {"ink",         {3, 4},    scene_statement_ink,           0, "R G B [ALPHA]"},
    {"edges",       {1, 1},    scene_statement_edges,         0, "hard|smooth"},
    {"rect",        {4, 5},    scene_statement_rect,          SCENE_PAINT, "x0 y0 x1 y1 [WIDTH]"},
    {"roundrect",   {5, 6},    scene_statement_roundrect,     SCENE_PAINT, "x0 y0 x1 y1 RADIUS [WIDTH]"},
    {"circle",      {3, 4},    scene_statement_circle,        SCENE_PAINT, "x y RADIUS [WIDTH]"},
    {"arc",         {6, 6},    scene_statement_arc,           SCENE_PAINT, "x y RADIUS WIDTH FROM SWEEP"},
    {"area",        {6, -16},  scene_statement_area,          SCENE_PAINT, "(x y) x3 to x8"},
    {"stroke",      {5, 5},    scene_statement_stroke,        SCENE_PAINT, "x0 y0 x1 y1 WIDTH"},
    {"font",        {1, 1},    scene_statement_font,          0, "FILE.bdf"},
    {"text",        {3, -27},  scene_statement_text,          SCENE_PAINT, "x y WORD ..."},
    {"imagekey",    {1, 3},    scene_statement_imagekey,      0, "off or imagekey r g b"},
    {"image",       {3, 5},    scene_statement_image,         SCENE_PAINT, "FILE.ppm x y [DEGREES SCALE]"},
};
/* clang-format on */

bool scene_statement_usage(size_t i, const char **name, const char **arguments)
{
    if (i >= sizeof statements / sizeof statements[0]) {
        return false;
    }
    *name = statements[i].name;
    *arguments = statements[i].usage;
    return true;
}

/* ---- Statements ---- */

static const struct scene_statement *find_statement(const struct token *keyword)
{
    for (size_t i = 0; i < sizeof statements / sizeof statements[0]; i++) {
        if (token_equals(keyword, statements[i].name)) {
            return &statements[i];
        }
    }
    return NULL;
}

/* Keeps the arguments there is room for and counts them all. */
static void take_arguments(struct scene_parser *parser, struct line *line)
{
    struct token token;
    parser->argument_count = 0;
    while (line_token(line, &token)) {
        if (parser->argument_count < SCENE_MAX_ARGUMENTS) {
            parser->arguments[parser->argument_count] = token;
        }
        parser->argument_count++;
    }
}

static bool check_argument_count(struct scene_parser *parser)
{
    const struct scene_statement *statement = parser->statement;
    if (parser->argument_count == statement->counts[0] ||
        parser->argument_count == statement->counts[1] ||
        (statement->counts[1] == SCENE_ANY && parser->argument_count > statement->counts[0] &&
         parser->argument_count <= SCENE_MAX_ARGUMENTS) ||
        (parser->argument_count > statement->counts[0] &&
         parser->argument_count <= -statement->counts[1])) {
        return true;
    }
    return scene_fail_count(parser);
}

static bool parse_statement(struct scene_parser *parser, struct line *line)
{
    struct token keyword;
    parser->line = line->number;
    if (!line_token(line, &keyword)) {
        return true;
    }
    parser->statement = find_statement(&keyword);
    if (parser->statement == NULL) {
        char quoted[TOKEN_QUOTE_SIZE];
        text_error_set(parser->error, parser->name, parser->line, "'%s' %s",
                       token_quote(&keyword, quoted),
                       token_is_binary(&keyword) ? "is not text: is this a scene file?"
                                                 : "is not a statement");
        return false;
    }
    take_arguments(parser, line);
    if (!check_argument_count(parser) || !parser->statement->handler(parser)) {
        return false;
    }
    parser->any_statement = true;
    return true;
}

/* ---- Scenes ---- */

static void set_defaults(struct scene *scene)
{
    memset(scene, 0, sizeof *scene);
    scene->width = 256;
    scene->height = 256;
    scene->clear_depth = SCENE_ONE;
    scene->depth_write = true;
    scene->alpha = 65536;
    scene->depth_compare = SCENE_LESS;
    scene->cull = SCENE_CULL_NONE;
    scene->provoking = 2;
    scene->texture_mode = SCENE_MODULATE;
    scene->depth_far = SCENE_ONE;
}

static bool parse_all(struct scene_parser *parser, const char *text, size_t length)
{
    struct line_reader reader;
    struct line line;
    lines_begin(&reader, text, length, false);
    while (lines_next(&reader, &line)) {
        if (!parse_statement(parser, &line)) {
            return false;
        }
    }
    return scene_make_texture(parser);
}

/* Takes `root`, which it frees. */
static bool parse(const char *name, const char *text, size_t length, char *root, const char *output,
                  struct scene *scene, struct text_error *error)
{
    struct scene_parser parser;
    memset(&parser, 0, sizeof parser);
    parser.name = name;
    parser.error = error;
    parser.scene = scene;
    parser.root = root;
    parser.output = output;
    parser.mode = 1;
    set_defaults(scene);
    scene_stroke_defaults(&parser);
    bool ok = parse_all(&parser, text, length);
    free(parser.root);
    free(parser.mesh_files);
    free(parser.texture.path);
    free(parser.texalpha.path);
    scene_brush_free(&parser.brush);
    if (!ok) {
        scene_free(scene);
    }
    return ok;
}

bool scene_parse(const char *name, const char *text, size_t length, struct scene *scene,
                 struct text_error *error)
{
    return parse(name, text, length, NULL, NULL, scene, error);
}

/* The folder of `path` without links; NULL when memory runs out or it is gone. */
static char *folder_of(const char *path)
{
    const char *slash = strrchr(path, '/');
    const size_t length = slash == NULL ? 0 : (size_t)(slash - path) + 1;
    char *folder = malloc(length + 2);
    if (folder == NULL) {
        return NULL;
    }
    memcpy(folder, path, length);
    memcpy(folder + length, ".", 2);
    char *real = realpath(folder, NULL);
    free(folder);
    return real;
}

static bool is_same_file(const char *a, const char *b)
{
    struct file_identity one;
    struct file_identity other;
    return file_inspect(a, &one) == FILE_REGULAR && file_inspect(b, &other) == FILE_REGULAR &&
           file_is_same(&one, &other);
}

static bool read_scene(const char *path, bool below, const char *output, struct scene *scene,
                       struct text_error *error)
{
    struct file_content file;
    memset(scene, 0, sizeof *scene);
    if (output != NULL && is_same_file(path, output)) {
        text_error_set(error, path, 0, "would be overwritten by %s", output);
        return false;
    }
    char *root = below ? folder_of(path) : NULL;
    if (below && root == NULL) {
        text_error_set(error, path, 0, "has no folder");
        return false;
    }
    if (!file_read(path, &file, error)) {
        free(root);
        return false;
    }
    bool ok = parse(path, file.bytes, file.length, root, output, scene, error);
    free(file.bytes);
    return ok;
}

bool scene_read(const char *path, struct scene *scene, struct text_error *error)
{
    return read_scene(path, false, NULL, scene, error);
}

bool scene_read_for(const char *path, const char *output, struct scene *scene,
                    struct text_error *error)
{
    return read_scene(path, false, output, scene, error);
}

bool scene_read_below(const char *path, const char *output, struct scene *scene,
                      struct text_error *error)
{
    return read_scene(path, true, output, scene, error);
}

void scene_free(struct scene *scene)
{
    for (size_t i = 0; i < scene->mesh_count; i++) {
        obj_free(&scene->meshes[i]);
    }
    free(scene->meshes);
    free(scene->ops);
    free(scene->stroke_vertices);
    free(scene->keys);
    free(scene->models);
    free(scene->texture.rgb);
    free(scene->texture.alpha);
    for (int i = 0; i < scene->texture.level_count; i++) {
        free(scene->texture.level[i]);
        free(scene->texture.level_alpha[i]);
    }
    scene_paints_free(&scene->paints);
    memset(scene, 0, sizeof *scene);
}
