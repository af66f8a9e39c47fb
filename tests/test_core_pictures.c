/* SPDX-License-Identifier: MIT */
/*
 * Random draws with options that scene files do not name (support/random_states.h): checksums, as
 * tests/pictures.tsv records them (`make pictures`). Other tests say what is right; these see that
 * nothing else changed.
 */
#include "support/faces.h"
#include "support/random_states.h"
#include "support/recorded.h"

#include "raster/draw_state.h"

enum { GROUPS = 8, PARTED = 600 };

typedef char a_slot_for_each_vertex[(int)FACES_VERTICES <= (int)STATES_VERTICES ? 1 : -1];

static uint8_t memory[STATES_BYTES], resolved[STATES_BYTES];
static random_states states;

static random_states *states_of(int group)
{
    states.seed = recorded_seed(group);
    states.memory = memory;
    states.resolved = resolved;
    return &states;
}

static void record(const char *name, int32_t pictures, random_draw *draw, random_picture *picture)
{
    for (int group = 0; group < GROUPS; group++) {
        char line[RECORDED_NAME_MAX];
        uint32_t hash = RECORDED_BEGIN;
        random_states *w = states_of(group);
        for (int32_t n = 0; n < pictures; n++) {
            hash = picture(w, hash, draw);
        }
        assert_false(w->failed);
        snprintf(line, sizeof line, "core %s %d", name, group);
        recorded_judge(line, hash);
    }
}

/* One that has planes of its faces. */
static void random_faces(random_states *w)
{
    static faces_mesh made;
    faces_mesh_make(&made, &w->seed, random_one_in(w, 2) ? 0 : .05);
    w->mesh = random_one_in(w, 2) ? made.wide : made.compact;
    faces_view(&w->view, &w->seed, STATES_WIDTH, STATES_HEIGHT);
    faces_pose(&w->pose, &w->seed, &w->mesh);
    w->view.light = random_one_in(w, 3) ? NULL : &w->light;
    if (random_one_in(w, 3)) {
        w->view.light = &w->lights;
    }
    give_vertices(&w->view, w->vertices, STATES_VERTICES);
    w->material.cull = random_one_in(w, 3) ? w->material.cull : QTRI_CULL_BACK;
}

static void draw_mesh(random_states *w, const qtri_surface *surface)
{
    if (random_one_in(w, 4)) {
        random_faces(w);
    } else {
        random_mesh(w);
    }
    random_draw_mesh(w, surface);
}

/* Light that changes much from vertex to vertex, on few texels of a texture: light of small
   triangles bends where their coordinates do not. */
static void draw_lit_textures(random_states *w, const qtri_surface *surface)
{
    random_solid(w);
    for (uint32_t i = 0; i < w->mesh.vertex_count; i++) {
        w->normals[i].x = (int16_t)(random_below(w, 32768) - 16384);
        w->normals[i].y = (int16_t)(random_below(w, 32768) - 16384);
        w->normals[i].z = (int16_t)(random_below(w, 32768) - 16384);
        w->uvs[i].x /= 8;
        w->uvs[i].y /= 8;
    }
    w->mesh.normals = w->normals;
    w->mesh.normals8 = NULL;
    w->mesh.uvs = w->uvs;
    w->mesh.uvs16 = NULL;
    w->mesh.colors = NULL;
    w->view.light = &w->light;
    w->light.diffuse = Q16(1);
    w->material.shading = QTRI_SMOOTH;
    w->material.texture = &w->texture;
    w->material.texture_mode = QTRI_MODULATE;
    w->texture.width_log2 = 5;
    w->texture.height_log2 = (uint8_t)(3 + random_below(w, 3));
    w->texture.filter = NULL;
    w->texture.wrap_u = w->texture.wrap_v = QTRI_REPEAT;
    w->texture.has_key = false;
    qtri_draw_mesh(surface, &w->view, &w->pose, &w->mesh, &w->material);
}

/* Triangles of any perspective, whose levels change along their rows. */
static void draw_levels(random_states *w, const qtri_surface *surface)
{
    random_usual(w);
    w->texture.filter = random_one_in(w, 2) ? &qtri_mipmapped : &qtri_mipmapped_bilinear;
    w->texture.level_count = 5;
    w->material.texture = &w->texture;
    w->material.cull = QTRI_CULL_NONE;
    for (int times = 0; times < 3; times++) {
        random_screen(w);
        for (int i = 0; i < STATES_CORNERS; i++) {
            w->screen[i].inv_w_exponent = -random_below(w, 12);
        }
        for (int i = 0; i < STATES_CORNERS; i += 3) {
            qtri_raster_triangle(surface, qtri_pipelines_default, &w->material, w->screen + i);
        }
    }
}

/*
 * A large triangle around a pixel, and its coordinates. Some pixels are where lines of the texture
 * meet: steps are far shorter there than elsewhere.
 */
static void random_around(random_states *w, int32_t x, int32_t y, int64_t uv[3][2])
{
    static const int32_t side[3][2] = {{0, -1}, {-1, 1}, {1, 1}};
    const int32_t reach = random_one_in(w, 2) ? 3000 : 300000;
    qtri_screen_vertex *v = w->screen;
    for (int i = 0; i < 3; i++) {
        memset(&v[i], 0, sizeof v[i]);
        v[i].x_24p8 = x * 256 + 128 + side[i][0] * (1000 + random_below(w, 3 * reach));
        v[i].y_24p8 = y * 256 + 128 + side[i][1] * (1000 + random_below(w, reach));
        v[i].inv_w_q31 = 0x40000000u + ((uint32_t)random_bits32(&w->seed) >> 2);
        v[i].inv_w_exponent = -random_below(w, 12);
        uv[i][0] = random_between(w, INT32_MIN / 2, INT32_MAX / 2);
        uv[i][1] = random_between(w, INT32_MIN / 2, INT32_MAX / 2);
    }
    if (random_one_in(w, 2)) {
        v[0].x_24p8 = x * 256 + 128 + random_below(w, 9) - 4;
        v[0].y_24p8 = y * 256 + 127 - random_below(w, 512);
        v[1].inv_w_exponent = v[2].inv_w_exponent = 0;
        v[1].inv_w_q31 = v[2].inv_w_q31;
        v[1].x_24p8 = 2 * v[0].x_24p8 - v[2].x_24p8;
        v[1].y_24p8 = v[2].y_24p8;
        uv[0][0] = uv[0][1] = uv[1][1] = uv[2][1] = 0;
        uv[1][0] = -uv[2][0];
    }
}

/* By how much the coordinates have to be scaled for the pixel to leave level 0. */
static uint32_t level_bound(random_states *w, uint32_t hash, random_draw *draw)
{
    static const uint32_t dark[32 * 32 / 2];
    static uint32_t bright[16 * 16 / 2];
    const qtri_texture texture = {.format = &qtri_texel_rgb565,
                                  .texels = dark,
                                  .width_log2 = 5,
                                  .height_log2 = 5,
                                  .filter = &qtri_mipmapped,
                                  .levels = w->levels,
                                  .level_count = 4};
    const qtri_rgb black = {0, 0, 0};
    const int32_t x = random_below(w, STATES_WIDTH), y = random_below(w, STATES_HEIGHT);
    const qtri_rect pixel = {x, y, x + 1, y + 1};
    uint32_t low = 0, high = (uint32_t)1 << 31;
    int64_t uv[3][2];
    qtri_surface s;
    (void)draw;
    memset(bright, 0xFF, sizeof bright);
    for (size_t i = 0; i < LENGTH_OF(w->levels); i++) {
        w->levels[i] = bright;
    }
    w->failed |= qtri_surface_init(&s, &qtri_rgb565, STATES_WIDTH, STATES_HEIGHT, 0, STATES_HEIGHT,
                                   w->memory, STATES_BYTES) != QTRI_OK;
    s.scissor = pixel;
    qtri_surface_clear(&s, black);
    w->material = qtri_material_default();
    w->material.texture = &texture;
    w->material.texture_mode = QTRI_REPLACE;
    w->material.cull = QTRI_CULL_NONE;
    w->material.depth_compare = QTRI_DEPTH_OFF;
    random_around(w, x, y, uv);
    while (high - low > 1) {
        const uint32_t middle = low + (high - low) / 2;
        for (int i = 0; i < 3; i++) {
            w->screen[i].u_q32 = uv[i][0] * (int64_t)middle / (1 << 24);
            w->screen[i].v_q32 = uv[i][1] * (int64_t)middle / (1 << 24);
        }
        qtri_raster_triangle(&s, qtri_pipelines_default, &w->material, w->screen);
        if (s.pixels[y * s.pitch + 2 * x] != 0) {
            high = middle;
        } else {
            low = middle;
        }
    }
    return random_hash(hash, high, 4);
}

TEST(levels)
{
    record("lit textures of samples", 40, draw_lit_textures, random_on_samples);
    record("levels", 60, draw_levels, random_on_surface);
    record("bounds of levels", 60, NULL, level_bound);
}

TEST(usual)
{
    memset(&states, 0, sizeof states); /* of parts, which sanitizers try fewer of */
    record("usual", 90, random_draw_usual, random_on_surface);
    record("usual on screen", 120, random_draw_usual_screen, random_on_surface);
}

TEST(solids)
{
    record("solids", 60, random_draw_solid, random_on_surface);
    record("solids of samples", 60, random_draw_solid, random_on_samples);
}

TEST(meshes)
{
    record("meshes", 120, draw_mesh, random_on_surface);
    record("meshes of samples", 50, draw_mesh, random_on_samples);
}

TEST(corners)
{
    record("corners", 120, random_draw_corners, random_on_surface);
    record("corners of samples", 50, random_draw_corners, random_on_samples);
}

TEST(on_screen)
{
    record("screen", 120, random_draw_screen, random_on_surface);
    record("screen of samples", 50, random_draw_screen, random_on_samples);
}

TEST(passes)
{
    record("outlines", 60, random_draw_outlined, random_on_surface);
    record("bands", 60, NULL, random_in_bands);
    record("fours", 60, NULL, random_by_fours);
}

static uint32_t in_parts(const random_kind *kind, int n, int32_t band_rows, int32_t tile_columns)
{
    random_states *w = states_of(n);
    w->band_rows = band_rows;
    w->tile_columns = tile_columns;
    w->other_depths = RANDOM_HASH_BEGIN;
    const uint32_t hash = kind->picture(w, RANDOM_HASH_BEGIN, kind->draw);
    w->band_rows = w->tile_columns = 0;
    return random_hash(hash, w->other_depths, 4);
}

/* A band has the rows of the whole picture, a scissor its columns, both what they have in common.
 */
TEST(parts_have_the_pixels_of_the_whole)
{
    for (const random_kind *kind = random_kinds; kind->name != NULL; kind++) {
        for (int n = 0; kind->in_bands && n < random_cases(PARTED); n++) {
            const int32_t rows = 1 + n % 19, columns = 5 + n % 31;
            const uint32_t whole = in_parts(kind, n, 0, 0);
            if (in_parts(kind, n, rows, 0) != whole) {
                fail_msg("%s, seed %d: bands of %d rows differ", kind->name, n, (int)rows);
            }
            if (in_parts(kind, n, n % 2 == 0 ? 0 : 9 + rows, columns) != whole) {
                fail_msg("%s, seed %d: scissors of %d columns differ", kind->name, n, (int)columns);
            }
        }
    }
}

/* The generic pipeline's loop for all options: a draw that asks for what no other loop has tells
   which. */
static qtri_pixels_loop *loop_for_all(void)
{
    qtri_draw_state state;
    memset(&state, 0, sizeof state);
    state.options.alpha_test = 1;
    (void)qtri_pipeline_any.choose(&qtri_pipeline_any, &state);
    return state.loop;
}

static const qtri_pipeline *choose_loop_for_all(const qtri_pipeline *generic,
                                                qtri_draw_state *state)
{
    (void)qtri_draw_state_ask(generic, state);
    state->loop = loop_for_all();
    return generic;
}

/* Pipelines of the default list, those of effects, and the generic one's loops. */
TEST(all_loops_draw_what_the_loop_for_all_options_draws)
{
    qtri_pipeline for_all = qtri_pipeline_any;
    const qtri_pipeline *const list[] = {&for_all, NULL};
    for_all.choose = choose_loop_for_all;
    for (const random_kind *kind = random_kinds; kind->name != NULL; kind++) {
        for (int n = 0; kind->picture == random_on_surface && n < random_cases(4 * PARTED); n++) {
            const uint32_t by_default = in_parts(kind, n, 0, 0);
            states.pipelines = list;
            const uint32_t by_one = in_parts(kind, n, 0, 0);
            states.pipelines = NULL;
            if (by_default != by_one) {
                fail_msg("%s, seed %d: differs", kind->name, n);
            }
        }
    }
}

int main(void)
{
    return run_all_tests(NULL, NULL);
}
