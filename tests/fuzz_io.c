/* SPDX-License-Identifier: MIT */
/*
 * Fuzz target: scene, OBJ and BDF text of any content is parsed or refused with a message, never
 * more. The first byte chooses the language.
 */
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "io/bdf.h"
#include "io/obj.h"
#include "io/palette.h"
#include "io/scene.h"

/* Nothing is there, so that relative names in a scene do not reach the machine's files. */
#define NAME "/nonexistent/fuzz"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static void require(int condition)
{
    if (!condition) {
        abort();
    }
}

static void check_message(const struct text_error *error)
{
    require(memchr(error->message, '\0', sizeof error->message) != NULL);
    require(strncmp(error->message, NAME ":", sizeof NAME) == 0);
}

static void check_mesh(const struct obj_mesh *mesh)
{
    require(mesh->triangle_count > 0 && mesh->vertex_count > 0);
    for (size_t i = 0; i < mesh->triangle_count; i++) {
        for (int j = 0; j < 3; j++) {
            require(mesh->triangles[i][j] < mesh->vertex_count);
        }
    }
}

static void check_scene(const struct scene *scene)
{
    uint32_t id = 0;
    require(scene->width >= 1 && scene->width <= SCENE_MAX_SIZE);
    require(scene->height >= 1 && scene->height <= SCENE_MAX_SIZE);
    require((scene->texture.width > 0) == (scene->texture.rgb != NULL));
    require(scene->texel_format <= SCENE_TEXEL_ALPHA8);
    if (scene_texel_has_palette(scene->texel_format)) {
        struct palette palette;
        size_t count = (size_t)scene->texture.width * (size_t)scene->texture.height;
        require(palette_make(&palette, scene->texture.rgb, count, NULL));
    }
    for (size_t i = 0; i < scene->op_count; i++) {
        if (scene->ops[i].kind == SCENE_TRIANGLE) {
            require(scene->ops[i].id == ++id);
        }
    }
    require(scene->mesh_count > 0 || id == scene->triangle_count);
}

static void check_font(const struct bdf_font *font)
{
    require(font->glyph_count > 0 && font->missing < font->glyph_count);
    for (size_t i = 0; i < font->glyph_count; i++) {
        const struct bdf_glyph *glyph = &font->glyphs[i];
        size_t bytes = ((size_t)glyph->width + 7) / 8 * (size_t)glyph->height;
        require(glyph->first + bytes <= font->row_bytes);
        require(i == 0 || glyph->character > glyph[-1].character);
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    struct text_error error;
    if (size == 0) {
        return 0;
    }
    const char *text = (const char *)data + 1;
    if (data[0] % 3 == 2) {
        struct bdf_font font;
        if (bdf_parse(NAME, text, size - 1, &font, &error)) {
            check_font(&font);
            bdf_free(&font);
        } else {
            check_message(&error);
        }
    } else if (data[0] % 3 == 0) {
        struct scene scene;
        if (scene_parse(NAME, text, size - 1, &scene, &error)) {
            check_scene(&scene);
            scene_free(&scene);
        } else {
            check_message(&error);
        }
    } else {
        struct obj_mesh mesh;
        if (obj_parse(NAME, text, size - 1, &mesh, &error)) {
            check_mesh(&mesh);
            obj_free(&mesh);
        } else {
            check_message(&error);
        }
    }
    return 0;
}
