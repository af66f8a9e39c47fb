/* SPDX-License-Identifier: MIT */
#include "../io/mipmap.h"
#include "asset_header.h"
#include "texture.h"

#include <inttypes.h>

/* How the formats are written. */
static const struct {
    const char *type, *description;
    int digits, in_row;
} formats[TEXTURE_FORMATS] = {
    [TEXTURE_RGB565] = {"uint16_t", "qtri_texel_rgb565", 4, 12},
    [TEXTURE_PALETTE] = {"uint8_t", "qtri_texel_palette8", 2, 16},
    [TEXTURE_GRAY8] = {"uint8_t", "qtri_texel_gray8", 2, 16},
    [TEXTURE_XRGB8888] = {"uint32_t", "qtri_texel_xrgb8888", 8, 8},
    [TEXTURE_PALETTE565] = {"uint8_t", "qtri_texel_palette565", 2, 16},
};

static void write_texels(const struct texture *texture, const char *name, FILE *out)
{
    size_t count = texture_level_at(texture, texture->level_count + 1);
    int in_row = formats[texture->format].in_row;
    fprintf(out, "static const %s %s_texels[] = {", formats[texture->format].type, name);
    for (size_t i = 0; i < count; i++) {
        fprintf(out, "%s0x%0*" PRIX32 ",", i % (size_t)in_row == 0 ? "\n    " : " ",
                formats[texture->format].digits, texture->texels[i]);
    }
    fputs("\n};\n\n", out);
}

static void write_levels(const struct texture *texture, const char *name, FILE *out)
{
    fprintf(out, "static const void *const %s_levels[] = {", name);
    for (int i = 1; i <= texture->level_count; i++) {
        fprintf(out, "%s%s_texels + %zu,", i % 4 == 1 ? "\n    " : " ", name,
                texture_level_at(texture, i));
    }
    fputs("\n};\n\n", out);
}

static void write_palette(const struct texture *texture, const char *name, FILE *out)
{
    const bool is_565 = texture->format == TEXTURE_PALETTE565;
    fprintf(out, "static const %s %s_palette[256] = {", is_565 ? "uint16_t" : "qtri_rgb", name);
    for (int i = 0; i < 256; i++) {
        const uint8_t *c = texture->palette[i];
        const int color[3] = {c[0], c[1], c[2]};
        fputs(i % (is_565 ? 12 : 5) == 0 ? "\n    " : " ", out);
        if (is_565) {
            fprintf(out, "0x%04" PRIX32 ",", texture_rgb565(color));
        } else {
            fprintf(out, "{%d, %d, %d},", c[0], c[1], c[2]);
        }
    }
    fputs("\n};\n\n", out);
}

/* Every member by its place: C++11 has no names in initialisers. */
void texture_write_data(const struct texture *texture, const char *name, const char *linkage,
                        FILE *out)
{
    bool palette = texture->palette_count > 0;
    write_texels(texture, name, out);
    if (palette) {
        write_palette(texture, name, out);
    }
    if (texture->level_count > 0) {
        write_levels(texture, name, out);
    }
    fprintf(out, "%sconst qtri_texture %s = {\n", linkage, name);
    fprintf(out, "    %s_texels, &%s,\n", name, formats[texture->format].description);
    fprintf(out, "    %d, %d, /* width_log2, height_log2: %d x %d */\n",
            mipmap_log2(texture->width), mipmap_log2(texture->height), texture->width,
            texture->height);
    fputs("    0, {{0, 0, 0}, {0, 0, 0}}, /* fields, color: of checkers */\n", out);
    fprintf(out, "    %s, %s, %s, /* wrap_u, wrap_v, filter */\n",
            texture->clamp_u ? "QTRI_CLAMP" : "QTRI_REPEAT",
            texture->clamp_v ? "QTRI_CLAMP" : "QTRI_REPEAT",
            texture->level_count > 0 ? "&qtri_mipmapped" : "NULL");
    fprintf(out, "    %s%s, /* palette */\n", palette ? name : "NULL", palette ? "_palette" : "");
    fprintf(out, "    %s, 0x%" PRIX32 "u, /* has_key, key */\n",
            texture->has_key ? "true" : "false", texture->key);
    fprintf(out, "    %s%s, %d, /* levels, level_count */\n};\n",
            texture->level_count > 0 ? name : "NULL", texture->level_count > 0 ? "_levels" : "",
            texture->level_count);
}

static void write_summary(FILE *out, const void *thing, const struct asset_names *names)
{
    const struct texture *texture = thing;
    fprintf(out,
            "/*\n * %s: %d x %d texels, %s, %zu bytes of flash. Made by `qtri texture`.\n */\n",
            names->name, texture->width, texture->height, texture_format_names[texture->format],
            texture_flash_bytes(texture));
}

static void write_data(FILE *out, const void *thing, const struct asset_names *names)
{
    texture_write_data(thing, names->name, names->linkage, out);
}

static void write_declarations(FILE *out, const void *thing, const struct asset_names *names)
{
    (void)thing;
    fprintf(out, "extern const qtri_texture %s;\n", names->name);
}

const struct asset_header asset_header_texture = {"TEXTURE", write_summary, NULL, write_data,
                                                  write_declarations};
