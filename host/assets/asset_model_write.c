/* SPDX-License-Identifier: MIT */
#include <inttypes.h>
#include <stdio.h>

#include "asset_header.h"
#include "asset_model.h"
#include "asset_write.h"

/* @ is the model's name, $ its name in capitals. */
static void write_template(FILE *out, const char *text, const char *name, const char *capitals)
{
    for (; *text != '\0'; text++) {
        if (*text == '@' || *text == '$') {
            fputs(*text == '@' ? name : capitals, out);
        } else {
            fputc(*text, out);
        }
    }
}

/* ---- The program in the comment ---- */

static const char program_begin[] =
    " *\n"
    " * It turns, in bands of 16 rows, on a display of 320x240; C99:\n"
    " *\n"
    " *     #include <qtri_port/ili9341.h>\n"
    " *     #include <qtri_port/screen.h>\n"
    " *     #include \"@.h\"\n"
    " *\n"
    " *     static uint8_t band_memory[QTRI_SCREEN_BYTES(320, 16, QTRI_RGB565_BYTES)];\n"
    " *     static uint8_t @_memory[$_BYTES(240, 16)];\n"
    " *     static qtri_prepared prepared[$_PARTS];\n";

static const char program_show[] =
    " *\n"
    " *     void show(const qtri_bus *bus)\n"
    " *     {\n"
    " *         const qtri_light light = {.towards = {Q16(0.4), Q16(0.6), Q16(0.7)},\n"
    " *                                   .ambient = Q16(0.25), .diffuse = Q16(0.75)};\n"
    " *         const qtri_vec3 center = $_CENTER, up = {0, Q16(1), 0};\n"
    " *         const qtri_vec3 eye = {center.x, center.y,\n"
    " *                                center.z + q16_mul($_RADIUS, Q16(2.5))};\n"
    " *         uint8_t *memory = @_memory;\n"
    " *         qtri_screen screen;\n"
    " *         qtri_surface band;\n"
    " *         qtri_view view;\n"
    " *         qtri_screen_init(&screen, &qtri_ili9341, bus, QTRI_ROTATE_90, &qtri_rgb565, 16,\n"
    " *                          band_memory, sizeof band_memory);\n"
    " *         for (int i = 0; i < $_PARTS; i++) {\n"
    " *             const size_t bytes = QTRI_PREPARED_BYTES(\n"
    " *                 @[i].mesh->vertex_count, @[i].mesh->triangle_count, 240, 16);\n"
    " *             qtri_prepared_init(&prepared[i], memory, bytes);\n"
    " *             memory += bytes;\n"
    " *         }\n"
    " *         qtri_view_init(&view, 320, 240);\n"
    " *         qtri_view_look_at(&view, eye, center, up);\n"
    " *         qtri_view_perspective(&view, Q16(50), q16_mul($_RADIUS, Q16(0.5)),\n"
    " *                               q16_mul($_RADIUS, Q16(5)));\n"
    " *         view.light = &light;\n"
    " *         for (q16 angle = 0;; angle = q16_mod(angle + Q16(2), Q16(360))) {\n";

static const char program_at_rest[] =
    " *             qtri_transform pose[1];\n"
    " *             qtri_transform_identity(&pose[0]);\n"
    " *             qtri_transform_rotate_about(&pose[0], angle, up, center);\n";

static const char program_moving[] =
    " *             static q16 seconds;\n"
    " *             qtri_transform pose[$_NODES];\n"
    " *             seconds = q16_mod(seconds + Q16(0.0333), $_SECONDS);\n"
    " *             for (int i = 0; i < $_NODES; i++) {\n"
    " *                 const qtri_key key = qtri_keys_at(\n"
    " *                     &@_keys[@_first_keys[i]], @_first_keys[i + 1] - @_first_keys[i],\n"
    " *                     seconds);\n"
    " *                 qtri_transform_identity(&pose[i]);\n"
    " *                 qtri_transform_key(&pose[i], &key);\n"
    " *             }\n"
    " *             qtri_transform_identity(&pose[0]);\n"
    " *             qtri_transform_rotate_about(&pose[0], angle, up, center);\n"
    " *             qtri_poses_compose(pose, pose, @_parents, $_NODES);\n";

/* Of the weights, which are positions of keys, three are of one track. */
static const char program_weights[] =
    " *             q16 weights[3 * $_TRACKS];\n"
    " *             for (int i = 0; i < $_TRACKS; i++) {\n"
    " *                 const int32_t *first = &@_first_keys[$_NODES + i];\n"
    " *                 const qtri_key key =\n"
    " *                     qtri_keys_at(&@_keys[first[0]], first[1] - first[0], seconds);\n"
    " *                 weights[3 * i] = key.position.x;\n"
    " *                 weights[3 * i + 1] = key.position.y;\n"
    " *                 weights[3 * i + 2] = key.position.z;\n"
    " *             }\n"
    " *             qtri_position16 *shape = shapes;\n"
    " *             for (int i = 0; i < $_PARTS; i++) {\n"
    " *                 const int32_t targets = @_first_targets[i + 1] - @_first_targets[i];\n"
    " *                 meshes[i] = *@[i].mesh;\n"
    " *                 if (targets > 0) {\n"
    " *                     qtri_morph_targets(shape, meshes[i].positions16,\n"
    " *                                        &@_targets[@_first_targets[i]],\n"
    " *                                        &weights[@_first_weights[i]], targets,\n"
    " *                                        meshes[i].vertex_count);\n"
    " *                     meshes[i].positions16 = shape;\n"
    " *                     shape += meshes[i].vertex_count;\n"
    " *                 }\n"
    " *             }\n";

static const char program_memory[] = " *     static qtri_mesh meshes[$_PARTS];\n"
                                     " *     static qtri_position16 shapes[$_SHAPES];\n";

/* What is prepared: its pose, and its mesh. */
static void write_prepare(const struct asset *asset, const char *name, const char *capitals,
                          FILE *out)
{
    char node[120] = "0", mesh[120] = "&meshes[i]";
    if (asset->node_count > 0) {
        (void)snprintf(node, sizeof node, "%s[i].node", name);
    }
    if (asset->track_count == 0) {
        (void)snprintf(mesh, sizeof mesh, "%s[i].mesh", name);
    }
    fprintf(out,
            " *             for (int i = 0; i < %s_PARTS; i++) {\n"
            " *                 qtri_prepare_mesh(&prepared[i], &screen.frame, &view, &pose[%s],\n"
            " *                                   %s, &%s[i].material);\n"
            " *             }\n",
            capitals, node, mesh, name);
}

static const char program_end[] =
    " *             while (qtri_screen_next(&screen, &band)) {\n"
    " *                 for (int i = 0; i < $_PARTS; i++) {\n"
    " *                     qtri_draw_prepared(&band, &prepared[i]);\n"
    " *                 }\n"
    " *             }\n"
    " *         }\n"
    " *     }\n";

/* ---- The comment ---- */

static void write_part_line(const struct asset *asset, size_t i, const char *name, FILE *out)
{
    const struct asset_part *part = &asset->parts[i];
    const uint8_t *c = part->material.color;
    fprintf(out, " * %s[%zu], ", name, i);
    asset_write_comment(out, part->material.name[0] != '\0' ? part->material.name : "unnamed");
    fprintf(out, ": %" PRIu32 " triangles", part->mesh.triangle_count);
    if (part->mesh.colors != NULL) {
        fputs(", colours at its vertices", out);
    } else if (part->texture < 0 || c[0] != 255 || c[1] != 255 || c[2] != 255) {
        fprintf(out, ", colour %d %d %d", c[0], c[1], c[2]);
    }
    if (part->texture >= 0) {
        const struct texture *texture = &asset->textures[part->texture];
        fprintf(out, ", texture %d of %dx%d", part->texture, texture->width, texture->height);
    }
    if (part->material.opacity < 255) {
        fprintf(out, ", %d %% opaque", part->material.opacity * 100 / 255);
    }
    fputs("\n", out);
}

static void write_summary(FILE *out, const void *thing, const struct asset_names *names)
{
    const struct asset *asset = thing;
    const char *name = names->name, *capitals = names->capitals;
    fprintf(out,
            "/*\n * %s: %" PRIu32 " vertices, %" PRIu32
            " triangles, %zu bytes of flash. Made by `qtri model`.\n",
            name, asset_vertex_count(asset), asset_triangle_count(asset), asset_flash_bytes(asset));
    for (size_t i = 0; i < asset->count; i++) {
        write_part_line(asset, i, name, out);
    }
    write_template(out, program_begin, name, capitals);
    if (asset->track_count > 0) {
        write_template(out, program_memory, name, capitals);
    }
    write_template(out, program_show, name, capitals);
    write_template(out, asset->node_count > 0 ? program_moving : program_at_rest, name, capitals);
    if (asset->track_count > 0) {
        write_template(out, program_weights, name, capitals);
    }
    write_prepare(asset, name, capitals, out);
    write_template(out, program_end, name, capitals);
    fputs(" */\n", out);
}

/* ---- Sizes ---- */

static void write_bytes(const struct asset *asset, const char *capitals, FILE *out)
{
    fprintf(out,
            "/* Memory to draw it in bands of a frame: of all parts, one after the other. */\n"
            "#define %s_BYTES(height, rows) \\\n    (",
            capitals);
    for (size_t i = 0; i < asset->count; i++) {
        const qtri_mesh *mesh = &asset->parts[i].mesh;
        fprintf(out, "%sQTRI_PREPARED_BYTES(%" PRIu32 ", %" PRIu32 ", height, rows)",
                i > 0 ? " + \\\n     " : "", mesh->vertex_count, mesh->triangle_count);
    }
    fputs(")\n\n", out);
}

static void write_sizes(FILE *out, const void *thing, const struct asset_names *names)
{
    const struct asset *asset = thing;
    const char *capitals = names->capitals;
    const qtri_vec3 c = asset->center;
    fprintf(out, "#define %s_PARTS %zu\n\n", capitals, asset->count);
    write_bytes(asset, capitals, out);
    fprintf(out,
            "/* The middle of its box, and how far from there it reaches%s. */\n"
            "#define %s_CENTER {%" PRId32 ", %" PRId32 ", %" PRId32 "}\n"
            "#define %s_RADIUS %" PRId32 "\n\n",
            asset->node_count > 0 ? " while it moves" : "", capitals, c.x, c.y, c.z, capitals,
            asset->radius);
    if (asset->node_count > 0) {
        fprintf(out,
                "/* What moves by itself: poses, node 0 being the whole model; until the last key. "
                "*/\n"
                "#define %s_NODES %zu\n#define %s_SECONDS %" PRId32 "\n\n",
                capitals, asset->node_count, capitals,
                asset->seconds > 0 ? asset->seconds : Q16(1));
    }
    if (asset->track_count > 0) {
        uint32_t vertices = 0;
        for (size_t i = 0; i < asset->count; i++) {
            const struct asset_part *part = &asset->parts[i];
            vertices += part->target_count > 0 ? part->mesh.vertex_count : 0;
        }
        fprintf(
            out,
            "/* Weights of morph targets, three a track, and the vertices that they move. Normals "
            "stay. */\n"
            "#define %s_TRACKS %zu\n#define %s_SHAPES %" PRIu32 "\n\n",
            capitals, asset->track_count, capitals, vertices > 0 ? vertices : 1);
    }
}

/* ---- Data ---- */

static void write_keys(const struct asset *asset, const char *name, const char *capitals,
                       const char *linkage, FILE *out)
{
    const size_t lists = asset->node_count + asset->track_count;
    const size_t count = asset->first_keys[lists];
    fprintf(out, "%sconst qtri_key %s_keys[%zu] = {\n", linkage, name, count);
    for (size_t i = 0; i < count; i++) {
        const qtri_key *k = &asset->keys[i];
        fprintf(out,
                "    {%" PRId32 ", {%" PRId32 ", %" PRId32 ", %" PRId32 "}, {%" PRId32 ", %" PRId32
                ", %" PRId32 ", %" PRId32 "}, {%" PRId32 ", %" PRId32 ", %" PRId32 "}},\n",
                k->time, k->position.x, k->position.y, k->position.z, k->orientation.w,
                k->orientation.x, k->orientation.y, k->orientation.z, k->scale.x, k->scale.y,
                k->scale.z);
    }
    fprintf(out, "};\n\n%sconst int32_t %s_first_keys[%zu] = {", linkage, name, lists + 1);
    for (size_t i = 0; i <= lists; i++) {
        fprintf(out, "%s%zu,", i % 12 == 0 ? "\n    " : " ", asset->first_keys[i]);
    }
    fprintf(out, "\n};\n\n%sconst int16_t %s_parents[%s_NODES] = {", linkage, name, capitals);
    for (size_t i = 0; i < asset->node_count; i++) {
        fprintf(out, "%s%d,", i % 12 == 0 ? "\n    " : " ", asset->parents[i]);
    }
    fputs("\n};\n\n", out);
}

/* The targets of all parts, and where those of each begin, and their weights. */
static void write_targets(const struct asset *asset, const char *name, const char *capitals,
                          const char *linkage, FILE *out)
{
    size_t first = 0;
    fprintf(out, "%sconst qtri_position16 *const %s_targets[] = {\n", linkage, name);
    for (size_t i = 0; i < asset->count; i++) {
        const struct asset_writer writer = {out, name, i, asset->count};
        for (size_t j = 0; j < asset->parts[i].target_count; j++) {
            char target[160];
            asset_target_name(&writer, j, target);
            fprintf(out, "    %s,\n", target);
        }
    }
    fprintf(out, "    NULL,\n};\n\n%sconst int32_t %s_first_targets[%s_PARTS + 1] = {0", linkage,
            name, capitals);
    for (size_t i = 0; i < asset->count; i++) {
        first += asset->parts[i].target_count;
        fprintf(out, ", %zu", first);
    }
    fprintf(out, "};\n\n%sconst int32_t %s_first_weights[%s_PARTS] = {", linkage, name, capitals);
    for (size_t i = 0; i < asset->count; i++) {
        fprintf(out, "%s%zu", i > 0 ? ", " : "", asset->parts[i].first_weight);
    }
    fputs("};\n\n", out);
}

/* Members by their places, as C++11 has no names in initialisers. */
static void write_material(const struct asset_part *part, const char *name, FILE *out)
{
    const qtri_material material = asset_material(part);
    const bool is_blended = material.blend != NULL;
    char texture[100] = "NULL";
    if (part->texture >= 0) {
        (void)snprintf(texture, sizeof texture, "&%s_texture_%d", name, part->texture);
    }
    fprintf(out, "        {{%d, %d, %d}, &qtri_smooth, QTRI_PERSPECTIVE, %s, QTRI_MODULATE,\n",
            material.color.r, material.color.g, material.color.b, texture);
    fprintf(out, "         %s, NULL, QTRI_LESS, %s, 0, %s, %d,\n",
            material.cull == QTRI_CULL_NONE ? "QTRI_CULL_NONE" : "QTRI_CULL_BACK",
            material.depth_read_only ? "true" : "false", is_blended ? "&qtri_blend_alpha" : "NULL",
            material.alpha);
    fputs("         0, 0, NULL, NULL, NULL, NULL, 0, NULL}, /* material */\n", out);
}

static void write_data(FILE *out, const void *thing, const struct asset_names *names)
{
    const struct asset *asset = thing;
    const char *name = names->name, *linkage = names->linkage, *capitals = names->capitals;
    for (size_t i = 0; i < asset->texture_count; i++) {
        char texture[100];
        (void)snprintf(texture, sizeof texture, "%s_texture_%zu", name, i);
        texture_write_data(&asset->textures[i], texture, "static ", out);
        fputc('\n', out);
    }
    for (size_t i = 0; i < asset->count; i++) {
        const struct asset_writer writer = {out, name, i, asset->count};
        asset_write_arrays(&writer, &asset->parts[i].mesh);
        asset_write_targets(&writer, &asset->parts[i]);
    }
    if (asset->node_count > 0) {
        write_keys(asset, name, capitals, linkage, out);
    }
    if (asset->track_count > 0) {
        write_targets(asset, name, capitals, linkage, out);
    }
    fprintf(out, "static const qtri_mesh %s_meshes[%s_PARTS] = {\n", name, capitals);
    for (size_t i = 0; i < asset->count; i++) {
        const struct asset_writer writer = {out, name, i, asset->count};
        fputs("    {\n", out);
        asset_write_mesh(&writer, &asset->parts[i].mesh);
        fputs("    },\n", out);
    }
    fprintf(out, "};\n\n%sconst qtri_part %s[%s_PARTS] = {\n", linkage, name, capitals);
    for (size_t i = 0; i < asset->count; i++) {
        fprintf(out, "    {\n        &%s_meshes[%zu],\n", name, i);
        write_material(&asset->parts[i], name, out);
        fprintf(out, "        %d, /* node */\n    },\n", asset->parts[i].material.node);
    }
    fputs("};\n", out);
}

static void write_declarations(FILE *out, const void *thing, const struct asset_names *names)
{
    const struct asset *asset = thing;
    const char *name = names->name, *capitals = names->capitals;
    fprintf(out, "extern const qtri_part %s[%s_PARTS];\n", name, capitals);
    if (asset->node_count > 0) {
        fprintf(out,
                "extern const qtri_key %s_keys[%zu];\n"
                "extern const int32_t %s_first_keys[%zu];\n"
                "extern const int16_t %s_parents[%s_NODES];\n",
                name, asset->first_keys[asset->node_count + asset->track_count], name,
                asset->node_count + asset->track_count + 1, name, capitals);
    }
    if (asset->track_count > 0) {
        fprintf(out,
                "extern const qtri_position16 *const %s_targets[];\n"
                "extern const int32_t %s_first_targets[%s_PARTS + 1];\n"
                "extern const int32_t %s_first_weights[%s_PARTS];\n",
                name, name, capitals, name, capitals);
    }
}

/*
 * Textures, meshes and materials as `const qtri_part NAME[NAME_PARTS]`, the keys of what moves, and
 * at the top, as a comment, a program that draws all of it.
 */
const struct asset_header asset_header_model = {"MODEL", write_summary, write_sizes, write_data,
                                                write_declarations};
