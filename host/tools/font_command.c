/* SPDX-License-Identifier: MIT */
#include <ctype.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "../io/file.h"
#include "commands.h"
#include "font_build.h"

static const char usage[] =
    "usage: qtri font IN.bdf -o OUT.h [--name NAME]\n"
    "\n"
    "Makes a font for qtri/font.h of a BDF file: constant data, a `static const qtri_font NAME`.\n"
    "An OUT that ends in .c defines a font that other files declare themselves.\n"
    "\n"
    "  --name NAME   what the font is called in C (default: the file name of OUT)\n";

struct options {
    const char *in, *out;
    char name[64];
};

/* Formats into the file. */
#if defined(__GNUC__)
__attribute__((format(printf, 2, 3)))
#endif
static void
put(struct file_output *output, const char *format, ...)
{
    char text[512];
    va_list arguments;
    va_start(arguments, format);
    int length = vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    file_output_write(output, text, length > 0 ? (size_t)length : 0);
}

static void put_rows(struct file_output *output, const struct options *options,
                     const struct bdf_font *bdf)
{
    put(output, "static const uint8_t %s_rows[] = {", options->name);
    for (size_t i = 0; i < bdf->row_bytes; i++) {
        put(output, "%s0x%02X,", i % 16 == 0 ? "\n    " : " ", bdf->rows[i]);
    }
    put(output, "%s};\n\n", bdf->row_bytes == 0 ? "0" : "\n");
}

static void put_glyphs(struct file_output *output, const struct options *options,
                       const struct font_build *build, const struct bdf_font *bdf)
{
    put(output, "static const qtri_glyph %s_glyphs[] = {\n", options->name);
    for (size_t i = 0; i < build->glyph_count; i++) {
        const qtri_glyph *g = &build->glyphs[i];
        put(output, "    {%u, %u, %u, %d, %d, %u}, /* U+%04X */\n", (unsigned)g->first,
            (unsigned)g->width, (unsigned)g->height, g->left, g->top, (unsigned)g->advance,
            (unsigned)bdf->glyphs[i].character);
    }
    put(output, "};\n\nstatic const qtri_glyph_range %s_ranges[] = {\n", options->name);
    for (size_t i = 0; i < build->font.range_count; i++) {
        const qtri_glyph_range *r = &build->ranges[i];
        put(output, "    {0x%04X, %u, %u},\n", (unsigned)r->first, (unsigned)r->count,
            (unsigned)r->glyph);
    }
    put(output, "};\n\n");
}

static bool is_source(const struct options *options)
{
    const size_t length = strlen(options->out);
    return length > 2 && strcmp(options->out + length - 2, ".c") == 0;
}

static bool write_font(const struct options *options, const struct bdf_font *bdf,
                       const struct font_build *build, struct text_error *error)
{
    struct file_output output;
    const char *slash = strrchr(options->in, '/');
    if (!file_output_open(&output, options->out, error)) {
        return false;
    }
    put(&output, "/* Made of %.200s by `qtri font`. */\n", slash != NULL ? slash + 1 : options->in);
    if (is_source(options)) {
        put(&output, "#include \"qtri/font.h\"\n\n/* clang-format off */\n");
    } else {
        put(&output,
            "#ifndef QTRI_FONT_OF_%s\n#define QTRI_FONT_OF_%s\n\n#include <qtri/font.h>\n\n"
            "/* clang-format off */\n",
            options->name, options->name);
    }
    put_rows(&output, options, bdf);
    put_glyphs(&output, options, build, bdf);
    put(&output,
        "%sconst qtri_font %s = {\n    %s_rows, %s_glyphs, %s_ranges, %u, %u, %u, %u,\n};\n"
        "/* clang-format on */\n",
        is_source(options) ? "" : "static ", options->name, options->name, options->name,
        options->name, (unsigned)build->font.range_count, (unsigned)build->font.missing,
        (unsigned)build->font.ascent, (unsigned)build->font.descent);
    if (!is_source(options)) {
        put(&output, "\n#endif\n");
    }
    return file_output_commit(&output, error);
}

/* ---- Arguments ---- */

static bool is_identifier(const char *name)
{
    for (size_t i = 0; name[i] != '\0'; i++) {
        const unsigned char c = (unsigned char)name[i];
        if (c >= 128 || (c != '_' && !isalpha(c) && !(i > 0 && isdigit(c)))) {
            return false;
        }
    }
    return name[0] != '\0';
}

/* The file name up to its last dot. */
static void name_of_file(struct options *options)
{
    const char *slash = strrchr(options->out, '/');
    const char *name = slash != NULL ? slash + 1 : options->out;
    const char *dot = strrchr(name, '.');
    const size_t length = dot != NULL ? (size_t)(dot - name) : strlen(name);
    snprintf(options->name, sizeof options->name, "%.*s",
             length < sizeof options->name ? (int)length : 0, name);
}

static bool parse(int argc, char **argv, struct options *options)
{
    const char *name = NULL;
    for (int i = 1; i < argc; i++) {
        const char **value = strcmp(argv[i], "-o") == 0       ? &options->out
                             : strcmp(argv[i], "--name") == 0 ? &name
                                                              : NULL;
        if (value != NULL && i + 1 == argc) {
            fprintf(stderr, "qtri font: %s needs a value\n", argv[i]);
            return false;
        }
        if (value == NULL && (argv[i][0] == '-' || options->in != NULL)) {
            fprintf(stderr, "qtri font: '%s' is not understood\n", argv[i]);
            return false;
        }
        if (value != NULL) {
            *value = argv[++i];
        } else {
            options->in = argv[i];
        }
    }
    if (options->in == NULL || options->out == NULL) {
        fprintf(stderr, "qtri font: a BDF file and -o are needed\n");
        return false;
    }
    name_of_file(options);
    if (name != NULL) {
        snprintf(options->name, sizeof options->name, "%s",
                 strlen(name) < sizeof options->name ? name : "");
    }
    if (!is_identifier(options->name)) {
        fprintf(stderr, "qtri font: '%.60s' is not a name in C; --name gives one\n",
                name != NULL ? name : options->name);
        return false;
    }
    return true;
}

int font_main(int argc, char **argv)
{
    struct options options = {0};
    struct bdf_font bdf;
    struct font_build build;
    struct text_error error;
    if (argc == 2 && (strcmp(argv[1], "--help") == 0 || strcmp(argv[1], "-h") == 0)) {
        fputs(usage, stdout);
        return 0;
    }
    if (!parse(argc, argv, &options)) {
        fputs("Try `qtri font --help`.\n", stderr);
        return 2;
    }
    if (!bdf_read(options.in, &bdf, &error)) {
        fprintf(stderr, "qtri font: %s\n", error.message);
        return 1;
    }
    bool ok = font_build_create(&build, &bdf);
    if (!ok) {
        text_error_set(&error, options.in, 0, "out of memory");
    } else {
        ok = write_font(&options, &bdf, &build, &error);
        font_build_free(&build);
    }
    bdf_free(&bdf);
    if (!ok) {
        fprintf(stderr, "qtri font: %s\n", error.message);
    }
    return ok ? 0 : 1;
}
