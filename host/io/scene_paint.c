/* SPDX-License-Identifier: MIT */
#include "scene_paint.h"

#include <stdlib.h>
#include <string.h>

#include "array.h"
#include "scene_parser.h"

void scene_paints_free(struct scene_paints *paints)
{
    for (size_t i = 0; i < paints->font_count; i++) {
        bdf_free(&paints->fonts[i]);
    }
    for (size_t i = 0; i < paints->image_count; i++) {
        picture_free(&paints->images[i]);
    }
    for (size_t i = 0; i < paints->text_count; i++) {
        free(paints->texts[i]);
    }
    free(paints->fonts);
    free(paints->images);
    free(paints->texts);
    memset(paints, 0, sizeof *paints);
}

void scene_brush_free(struct scene_brush *brush)
{
    for (size_t i = 0; i < brush->file_count; i++) {
        free(brush->files[i].path);
    }
    free(brush->files);
}

/* ---- Brush ---- */

bool scene_statement_ink(struct scene_parser *parser)
{
    int32_t color[4] = {0, 0, 0, SCENE_ONE};
    if (!scene_fractions(parser, 0, parser->argument_count, color)) {
        return false;
    }
    memcpy(parser->brush.paint.color, color, sizeof parser->brush.paint.color);
    parser->brush.paint.alpha = color[3];
    parser->brush.is_set = true;
    return true;
}

bool scene_statement_edges(struct scene_parser *parser)
{
    static const char *const words[] = {"hard", "smooth"};
    int choice;
    if (!scene_choice(parser, 0, words, 2, &choice)) {
        return false;
    }
    parser->brush.paint.is_smooth = choice == 1;
    return true;
}

bool scene_statement_imagekey(struct scene_parser *parser)
{
    struct scene_paint *paint = &parser->brush.paint;
    if (parser->argument_count == 1) {
        static const char *const words[] = {"off"};
        int choice;
        paint->has_key = 0;
        return scene_choice(parser, 0, words, 1, &choice);
    }
    for (int i = 0; i < 3; i++) {
        int byte;
        if (!scene_integer(parser, i, 0, 255, &byte)) {
            return false;
        }
        paint->key[i] = (uint8_t)byte;
    }
    paint->has_key = 1;
    return true;
}

/* ---- Files: each is read once ---- */

static bool read_font(struct scene_parser *parser, const char *path, uint16_t *index)
{
    struct scene_paints *paints = &parser->scene->paints;
    struct text_error error;
    struct bdf_font *grown =
        array_grow(paints->fonts, paints->font_count, &parser->brush.font_capacity, sizeof *grown);
    if (grown == NULL) {
        return scene_fail(parser, "out of memory");
    }
    paints->fonts = grown;
    if (!bdf_read(path, &grown[paints->font_count], &error)) {
        return scene_fail(parser, error.message);
    }
    *index = (uint16_t)paints->font_count++;
    return true;
}

static bool read_image(struct scene_parser *parser, const char *path, uint16_t *index)
{
    struct scene_paints *paints = &parser->scene->paints;
    struct text_error error;
    struct picture *grown = array_grow(paints->images, paints->image_count,
                                       &parser->brush.image_capacity, sizeof *grown);
    if (grown == NULL) {
        return scene_fail(parser, "out of memory");
    }
    paints->images = grown;
    struct picture *image = &grown[paints->image_count];
    if (!picture_read_ppm(path, image, &error)) {
        return scene_fail(parser, error.message);
    }
    if (image->width > SCENE_MAX_SIZE || image->height > SCENE_MAX_SIZE) {
        picture_free(image);
        return scene_fail(parser, "a side of the picture is longer than 4096");
    }
    *index = (uint16_t)paints->image_count++;
    return true;
}

/* The index of the file that argument 0 names, among the fonts or the images. */
static bool find_file(struct scene_parser *parser, bool is_font, uint16_t *index)
{
    struct scene_brush *brush = &parser->brush;
    char *path = scene_path(parser, 0);
    if (path == NULL) {
        return false;
    }
    for (size_t i = 0; i < brush->file_count; i++) {
        if (brush->files[i].is_font == is_font && strcmp(brush->files[i].path, path) == 0) {
            *index = brush->files[i].index;
            free(path);
            return true;
        }
    }
    struct scene_paint_file *grown =
        array_grow(brush->files, brush->file_count, &brush->file_capacity, sizeof *grown);
    bool ok = grown != NULL && brush->file_count < UINT16_MAX;
    if (grown != NULL) {
        brush->files = grown;
    }
    if (!ok) {
        scene_fail(parser, "too many files");
    }
    ok = ok && scene_inspect(parser, path, NULL) &&
         (is_font ? read_font(parser, path, index) : read_image(parser, path, index));
    if (!ok) {
        free(path);
        return false;
    }
    const struct scene_paint_file file = {path, is_font, *index};
    brush->files[brush->file_count++] = file;
    return true;
}

bool scene_statement_font(struct scene_parser *parser)
{
    parser->brush.has_font = find_file(parser, true, &parser->brush.paint.font);
    return parser->brush.has_font;
}

/* ---- Shapes ---- */

static bool add_paint(struct scene_parser *parser, const struct scene_paint *paint)
{
    struct scene_op *op = scene_add_op(parser, SCENE_PAINT);
    if (op == NULL) {
        return false;
    }
    op->u.paint = *paint;
    return true;
}

/* The brush, and numbers from argument `first` on. */
static bool begin(struct scene_parser *parser, enum scene_paint_kind kind, int first, int count,
                  struct scene_paint *paint)
{
    *paint = parser->brush.paint;
    if (!parser->brush.is_set) {
        paint->color[0] = paint->color[1] = paint->color[2] = paint->alpha = SCENE_ONE;
    }
    paint->kind = kind;
    paint->count = count;
    return scene_numbers(parser, first, count, paint->number);
}

static bool shape(struct scene_parser *parser, enum scene_paint_kind kind)
{
    struct scene_paint paint;
    return begin(parser, kind, 0, parser->argument_count, &paint) && add_paint(parser, &paint);
}

bool scene_statement_rect(struct scene_parser *parser)
{
    return shape(parser, SCENE_PAINT_RECT);
}

bool scene_statement_roundrect(struct scene_parser *parser)
{
    return shape(parser, SCENE_PAINT_ROUNDRECT);
}

bool scene_statement_circle(struct scene_parser *parser)
{
    return shape(parser, SCENE_PAINT_CIRCLE);
}

bool scene_statement_arc(struct scene_parser *parser)
{
    return shape(parser, SCENE_PAINT_ARC);
}

bool scene_statement_stroke(struct scene_parser *parser)
{
    return shape(parser, SCENE_PAINT_STROKE);
}

bool scene_statement_area(struct scene_parser *parser)
{
    if (parser->argument_count % 2 != 0) {
        return scene_fail(parser, "every point needs x and y");
    }
    return shape(parser, SCENE_PAINT_AREA);
}

/* ---- Text and pictures ---- */

/* Words from argument 2 on, with one blank between. */
static char *join_words(const struct scene_parser *parser)
{
    size_t length = 1;
    for (int i = 2; i < parser->argument_count; i++) {
        length += parser->arguments[i].length + 1;
    }
    char *text = malloc(length);
    if (text == NULL) {
        return NULL;
    }
    char *at = text;
    for (int i = 2; i < parser->argument_count; i++) {
        const struct token *word = &parser->arguments[i];
        if (i > 2) {
            *at++ = ' ';
        }
        memcpy(at, word->text, word->length);
        at += word->length;
    }
    *at = '\0';
    return text;
}

bool scene_statement_text(struct scene_parser *parser)
{
    struct scene_paints *paints = &parser->scene->paints;
    struct scene_paint paint;
    if (!parser->brush.has_font) {
        return scene_fail(parser, "needs a font before it: font FILE.bdf");
    }
    for (int i = 2; i < parser->argument_count; i++) {
        if (token_is_binary(&parser->arguments[i])) {
            return scene_fail_argument(parser, i, "is not text");
        }
    }
    if (!begin(parser, SCENE_PAINT_TEXT, 0, 2, &paint)) {
        return false;
    }
    char **grown =
        array_grow(paints->texts, paints->text_count, &parser->brush.text_capacity, sizeof *grown);
    if (grown != NULL) {
        paints->texts = grown;
    }
    char *text = grown != NULL ? join_words(parser) : NULL;
    if (text == NULL) {
        return scene_fail(parser, "out of memory");
    }
    paint.text = (uint32_t)paints->text_count;
    paints->texts[paints->text_count++] = text;
    return add_paint(parser, &paint);
}

bool scene_statement_image(struct scene_parser *parser)
{
    struct scene_paint paint;
    if (!begin(parser, SCENE_PAINT_IMAGE, 1, parser->argument_count - 1, &paint)) {
        return false;
    }
    if (paint.count == 4 && paint.number[3] <= 0) {
        return scene_fail(parser, "the scale must be greater than 0");
    }
    return find_file(parser, false, &paint.image) && add_paint(parser, &paint);
}
