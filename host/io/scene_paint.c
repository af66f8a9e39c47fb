/* SPDX-License-Identifier: MIT */
#include "scene_paint.h"

#include <stdlib.h>
#include <string.h>

#include "array.h"
#include "scene_parser.h"
#include "xalloc.h"

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

void scene_brush_defaults(struct scene_brush *brush)
{
    struct scene_paint *paint = &brush->paint;
    paint->color[0] = paint->color[1] = paint->color[2] = paint->alpha = SCENE_ONE;
}

/* ---- Files: each is read once ---- */

static bool read_font(struct scene_parser *parser, const char *path, uint16_t *index)
{
    struct scene_paints *paints = &parser->scene->paints;
    struct text_error error;
    struct bdf_font *font =
        array_add(&paints->fonts, &paints->font_count, &parser->brush.font_capacity, sizeof *font);
    *index = (uint16_t)(paints->font_count - 1);
    return bdf_read(path, font, &error) || scene_fail(parser, error.message);
}

static bool read_image(struct scene_parser *parser, const char *path, uint16_t *index)
{
    struct scene_paints *paints = &parser->scene->paints;
    struct text_error error;
    struct picture *image = array_add(&paints->images, &paints->image_count,
                                      &parser->brush.image_capacity, sizeof *image);
    *index = (uint16_t)(paints->image_count - 1);
    if (!picture_read_ppm(path, image, &error)) {
        return scene_fail(parser, error.message);
    }
    return (image->width <= SCENE_MAX_SIZE && image->height <= SCENE_MAX_SIZE) ||
           scene_fail(parser, "a side of the picture is longer than 4096");
}

/* The index of the file that argument 0 names, among the fonts or the images. */
static bool find_file(struct scene_parser *parser, bool is_font, uint16_t *index)
{
    struct scene_brush *brush = &parser->brush;
    char *path = scene_path(parser, 0, NULL);
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
    if (brush->file_count == UINT16_MAX) {
        free(path);
        return scene_fail(parser, "too many files");
    }
    struct scene_paint_file *file =
        array_add(&brush->files, &brush->file_count, &brush->file_capacity, sizeof *file);
    file->path = path;
    file->is_font = is_font;
    const bool ok = is_font ? read_font(parser, path, index) : read_image(parser, path, index);
    file->index = *index;
    return ok;
}

bool scene_statement_font(struct scene_parser *parser, const int32_t *value)
{
    (void)value;
    parser->brush.has_font = find_file(parser, true, &parser->brush.paint.font);
    return parser->brush.has_font;
}

/* ---- What is painted ---- */

/* The brush's paint, and `count` numbers. */
static bool add_paint(struct scene_parser *parser, enum scene_paint_kind kind,
                      const int32_t *number, int count)
{
    struct scene_op *op = scene_add_op(parser, SCENE_PAINT);
    op->u.paint = parser->brush.paint;
    op->u.paint.kind = kind;
    op->u.paint.count = count;
    memcpy(op->u.paint.number, number, (size_t)count * sizeof *number);
    return true;
}

/* A shape, whose kind is `into`. */
bool scene_statement_paint(struct scene_parser *parser, const int32_t *value)
{
    return add_paint(parser, (enum scene_paint_kind)parser->statement->into, value,
                     parser->argument_count);
}

/* Words from argument 2 on, with one blank between. */
static char *join_words(const struct scene_parser *parser)
{
    size_t length = 1;
    for (int i = 2; i < parser->argument_count; i++) {
        length += parser->arguments[i].length + 1;
    }
    char *text = xcalloc(length, 1);
    char *at = text;
    for (int i = 2; i < parser->argument_count; i++) {
        const struct token *word = &parser->arguments[i];
        if (i > 2) {
            *at++ = ' ';
        }
        memcpy(at, word->text, word->length);
        at += word->length;
    }
    return text;
}

bool scene_statement_text(struct scene_parser *parser, const int32_t *value)
{
    struct scene_paints *paints = &parser->scene->paints;
    if (!parser->brush.has_font) {
        return scene_fail(parser, "needs a font before it: font FILE.bdf");
    }
    for (int i = 2; i < parser->argument_count; i++) {
        if (token_is_binary(&parser->arguments[i])) {
            return scene_fail_argument(parser, i, "is not text");
        }
    }
    char **text =
        array_add(&paints->texts, &paints->text_count, &parser->brush.text_capacity, sizeof *text);
    *text = join_words(parser);
    parser->brush.paint.text = (uint32_t)(paints->text_count - 1);
    return add_paint(parser, SCENE_PAINT_TEXT, value, 2);
}

bool scene_statement_image(struct scene_parser *parser, const int32_t *value)
{
    if (parser->argument_count == 5 && value[4] <= 0) {
        return scene_fail(parser, "the scale must be greater than 0");
    }
    return find_file(parser, false, &parser->brush.paint.image) &&
           add_paint(parser, SCENE_PAINT_IMAGE, value + 1, parser->argument_count - 1);
}
