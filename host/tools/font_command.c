/* SPDX-License-Identifier: MIT */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../assets/truetype.h"
#include "../io/file.h"
#include "commands.h"
#include "font_build.h"

static const char usage[] =
    "usage: qtri font IN -o OUT.h [OPTION ...]\n"
    "\n"
    "Makes a font for qtri/paint.h, constant data, a `static const qtri_font NAME`, of a BDF file, "
    "or\n"
    "of a scalable font named .ttf, .otf or .ttc. IN - is standard input, a BDF file, -o - "
    "standard\n"
    "output. An OUT that ends in .c defines a font that other files declare themselves.\n"
    "\n"
    "  --name NAME   what the font is called in C (default: the file name of OUT)\n"
    "  --size N      pixels of an em, of a scalable font (default 16)\n"
    "  --range A-B   its characters from A to B, as in 32-126 or 0x400-0x44F (default: ASCII and\n"
    "                Latin 1)\n";

struct options {
    const char *in, *out;
    char name[OPTION_NAME_SIZE];
    bool is_scalable;
    struct truetype_wanted wanted;
};

static void put_rows(FILE *out, const struct options *options, const struct bdf_font *bdf)
{
    fprintf(out, "static const uint8_t %s_rows[] = {", options->name);
    for (size_t i = 0; i < bdf->row_bytes; i++) {
        fprintf(out, "%s0x%02X,", i % 16 == 0 ? "\n    " : " ", bdf->rows[i]);
    }
    fprintf(out, "%s};\n\n", bdf->row_bytes == 0 ? "0" : "\n");
}

static void put_glyphs(FILE *out, const struct options *options, const struct font_build *build,
                       const struct bdf_font *bdf)
{
    fprintf(out, "static const qtri_glyph %s_glyphs[] = {\n", options->name);
    for (size_t i = 0; i < build->glyph_count; i++) {
        const qtri_glyph *g = &build->glyphs[i];
        fprintf(out, "    {%u, %u, %u, %d, %d, %u}, /* U+%04X */\n", (unsigned)g->first,
                (unsigned)g->width, (unsigned)g->height, g->left, g->top, (unsigned)g->advance,
                (unsigned)bdf->glyphs[i].character);
    }
    fprintf(out, "};\n\nstatic const qtri_glyph_range %s_ranges[] = {\n", options->name);
    for (size_t i = 0; i < build->font.range_count; i++) {
        const qtri_glyph_range *r = &build->ranges[i];
        fprintf(out, "    {0x%04X, %u, %u},\n", (unsigned)r->first, (unsigned)r->count,
                (unsigned)r->glyph);
    }
    fprintf(out, "};\n\n");
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
    FILE *out = output.stream;
    fprintf(out, "/* Made of %.200s by `qtri font`. */\n", slash != NULL ? slash + 1 : options->in);
    if (is_source(options)) {
        fprintf(out, "#include \"qtri/paint.h\"\n\n/* clang-format off */\n");
    } else {
        fprintf(out,
                "#ifndef QTRI_FONT_OF_%s\n#define QTRI_FONT_OF_%s\n\n#include <qtri/paint.h>\n\n"
                "/* clang-format off */\n",
                options->name, options->name);
    }
    put_rows(out, options, bdf);
    put_glyphs(out, options, build, bdf);
    fprintf(out,
            "%sconst qtri_font %s = {\n    %s_rows, %s_glyphs, %s_ranges, %u, %u, %u, %u,\n};\n"
            "/* clang-format on */\n",
            is_source(options) ? "" : "static ", options->name, options->name, options->name,
            options->name, (unsigned)build->font.range_count, (unsigned)build->font.missing,
            (unsigned)build->font.ascent, (unsigned)build->font.descent);
    if (!is_source(options)) {
        fprintf(out, "\n#endif\n");
    }
    return file_output_commit(&output, error);
}

/* ---- Arguments ---- */

#define AT(member) offsetof(struct options, member)

/* Two numbers, decimal or after 0x hexadecimal. */
static bool set_range(void *options, const char *value, struct option_words *more)
{
    struct truetype_wanted *wanted = &((struct options *)options)->wanted;
    char *end = NULL;
    (void)more;
    const unsigned long first = strtoul(value, &end, 0);
    if (*value < '0' || *value > '9' || *end != '-' || end[1] < '0' || end[1] > '9') {
        return false;
    }
    const unsigned long last = strtoul(end + 1, &end, 0);
    wanted->first = (uint32_t)first;
    wanted->last = (uint32_t)last;
    return *end == '\0' && first <= last && last <= 0x10FFFF && first > 0;
}

static const struct option all[] = {
    {"-o", OPTION_TEXT, AT(out), {NULL}},
    {"--size", OPTION_WHOLE, AT(wanted.size), {.range = {4, 127}}},
    {"--range", OPTION_SET, 0, {.set = set_range}},
    {"--name", OPTION_NAME, AT(name), {NULL}},
};

static bool check(const struct option_command *command, void *given)
{
    struct options *options = given;
    options->is_scalable = file_name_ends_in(options->in, ".ttf") ||
                           file_name_ends_in(options->in, ".otf") ||
                           file_name_ends_in(options->in, ".ttc");
    if (!options->is_scalable && (options->wanted.size > 0 || options->wanted.last > 0)) {
        return options_complain(
            command, "--size and --range want a font named .ttf, .otf or .ttc: ", options->in);
    }
    options->wanted.size = options->wanted.size > 0 ? options->wanted.size : 16;
    return options_default_name(command, options->in, options->out, options->name);
}

static bool run(void *given, struct text_error *error)
{
    const struct options *options = given;
    struct bdf_font bdf;
    struct font_build build;
    if (!(options->is_scalable ? truetype_read(options->in, &options->wanted, &bdf, error)
                               : bdf_read(options->in, &bdf, error))) {
        return false;
    }
    font_build_create(&build, &bdf);
    const bool ok = write_font(options, &bdf, &build, error);
    font_build_free(&build);
    bdf_free(&bdf);
    return ok;
}

const struct option_command font_command = {
    .name = "font",
    .summary = "make a font for the core of a BDF file",
    .size = sizeof(struct options),
    .input = "font",
    .needs = "a font and -o are needed",
    .input_at = AT(in),
    .output_at = AT(out),
    .options = all,
    .count = sizeof all / sizeof all[0],
    .usage = usage,
    .check = check,
    .run = run,
};
