/* SPDX-License-Identifier: MIT */
/*
 * Pipelines of random options (tests/tools/random_pipelines.awk): what the compiler makes of the
 * body where options are constant has the bits of the generic pipeline, of tiles and of bands.
 */
#include "support/core.h"
#include "support/layouts.h"

#include "qtri/pipeline.h"
#include "raster/draw_state.h"
#include "raster/samples.h"

enum { WIDTH = 150, HEIGHT = 110, TILE_WIDTH = 41, TILE_HEIGHT = 17, BAND = 13 };
enum {
    RINGS = 9,
    SIDES = 8,
    VERTICES = RINGS * SIDES,
    TRIANGLES = 2 * VERTICES,
    SHAPES = 4,
    LEVELS = 9
};

extern const qtri_pipeline *const random_pipelines[];

bool random_fragment(qtri_fragment *fragment);

/* Waves over what would be drawn. */
bool random_fragment(qtri_fragment *f)
{
    f->color ^= (f->u >> 8 & 0x00F000u) ^ (f->v >> 24) ^ (f->depth_16p16 >> 20) ^ (uint32_t)f->x;
    f->color = (f->color & 0xFF00FFu) | ((f->color >> 8 & 255) * f->light_q8 & 0xFF00u);
    return ((f->x ^ f->y) & 7) != 3;
}

/* A format of one's own, five bits a channel, red the lowest; and texels that are 0x00RRGGBB. */
uint32_t random_encode(uint32_t color);
uint32_t random_decode(uint32_t stored);
uint32_t random_fetch(const qtri_texture *texture, uint32_t number);
extern const qtri_format random_format;
extern const qtri_texel_format random_texels;

uint32_t random_encode(uint32_t color)
{
    return (color >> 19 & 31) | (color >> 11 & 31) << 5 | (color >> 3 & 31) << 10;
}

uint32_t random_decode(uint32_t stored)
{
    const uint32_t r = stored & 31, g = stored >> 5 & 31, b = stored >> 10 & 31;
    return (r << 3 | r >> 2) << 16 | (g << 3 | g >> 2) << 8 | (b << 3 | b >> 2);
}

static void encode_words(uint32_t *color, int32_t count)
{
    for (int32_t i = 0; i < count; i++) {
        color[i] = random_encode(color[i]);
    }
}

const qtri_format random_format = {
    &qtri_pixels_16, &qtri_colors_888, encode_words, random_decode, NULL, QTRI_OTHER_FORMAT};

static bool has_texels(const qtri_texture *texture)
{
    return texture->texels != NULL;
}

static void fetch_words(uint32_t *texel, const qtri_texture *texture, int32_t count)
{
    for (int32_t i = 0; i < count; i++) {
        texel[i] = ((const uint32_t *)texture->texels)[texel[i]] & 0xFFFFFF;
    }
}

uint32_t random_fetch(const qtri_texture *texture, uint32_t number)
{
    return ((const uint32_t *)texture->texels)[number] | 0xFF000000;
}

const qtri_texel_format random_texels = {&qtri_colors_888, 0xFFFFFF, has_texels,
                                         fetch_words,      NULL,     QTRI_NO_TEXEL};

static const qtri_rgb palette[256] = {{1, 2, 3}, {255, 255, 255}, {200, 10, 90}, {9, 99, 255}};
static const uint16_t palette565[256] = {0x0001, 0xFFFF, 0xC84B, 0x0B1F};

static struct world {
    qtri_vec3 positions[VERTICES];
    qtri_normal normals[VERTICES];
    qtri_vec2 uvs[VERTICES];
    qtri_rgb colors[VERTICES];
    uint8_t alphas[VERTICES];
    uint16_t triangles[TRIANGLES][3];
    qtri_vertex vertices[QTRI_LIT_VERTICES(VERTICES)];
    uint32_t vertex_count; /* of these */
    uint32_t texels[1 << 18];
    qtri_mesh mesh;
    qtri_view view;
    qtri_transform pose;
    qtri_light light;
    qtri_light lights;
    qtri_light_source sources[3];
    qtri_shininess shininess;
    qtri_reflection reflection;
    qtri_texture texture;
    const void *levels[LEVELS];
    qtri_fog fog;
    qtri_material material;
} w;

static uint64_t seed;

static q16 between(double low, double high)
{
    return random_in(&seed, fixed(low), fixed(high));
}

static void make_mesh(int shape)
{
    for (int i = 0; i < VERTICES; i++) {
        const double a = 6.2831853 * (i / SIDES) / RINGS;
        const double b = 6.2831853 * (i % SIDES) / SIDES;
        const double r = .8 + .35 * cos(b);
        w.positions[i] = vec3_of(r * cos(a), r * sin(a), .35 * sin(b));
        const qtri_normal n = {(int16_t)lrint(16384 * cos(a) * cos(b)),
                               (int16_t)lrint(16384 * sin(a) * cos(b)),
                               (int16_t)lrint(16384 * sin(b))};
        w.normals[i] = n;
        w.uvs[i].x = between(-1.5, 2.5);
        w.uvs[i].y = between(-1.5, 2.5);
        w.colors[i].r = (uint8_t)random_in(&seed, 0, 255);
        w.colors[i].g = (uint8_t)random_in(&seed, 0, 255);
        w.colors[i].b = (uint8_t)random_in(&seed, 0, 255);
        w.alphas[i] = (uint8_t)random_in(&seed, 0, 255);
        const int up = i % SIDES == SIDES - 1 ? i - SIDES + 1 : i + 1;
        const int next = (i + SIDES) % VERTICES;
        const int quad[6] = {i, next, (up + SIDES) % VERTICES, i, (up + SIDES) % VERTICES, up};
        for (int k = 0; k < 6; k++) {
            w.triangles[2 * i + k / 3][k % 3] = (uint16_t)quad[k];
        }
    }
    memset(&w.mesh, 0, sizeof w.mesh);
    w.vertex_count = random_flag(&seed) ? VERTICES : QTRI_LIT_VERTICES(VERTICES);
    w.mesh.positions = w.positions;
    w.mesh.triangles = (const uint16_t(*)[3])w.triangles;
    w.mesh.vertex_count = VERTICES;
    w.mesh.triangle_count = TRIANGLES;
    qtri_view_init(&w.view, WIDTH, HEIGHT);
    qtri_transform_perspective(&w.view.projection, Q16(60), fixed((double)WIDTH / HEIGHT), Q16(.1),
                               Q16(20));
    qtri_transform_identity(&w.pose);
    /* Small triangles, some large ones, all large with vertices outside, and tiny ones. */
    static const double distance[SHAPES] = {2.6, 1.3, .7, 9};
    qtri_transform_translate(&w.pose, vec3_of(between(-.2, .2) / 65536., 0, -distance[shape]));
    qtri_transform_rotate_x(&w.pose, between(-180, 180));
    qtri_transform_rotate_y(&w.pose, between(-180, 180));
}

static uint32_t stored_bits(uint8_t texel)
{
    switch (texel) {
    case QTRI_TEXEL_XRGB8888:
    case QTRI_TEXEL_ARGB8888:
    case QTRI_OTHER_TEXEL:
        return UINT32_MAX;
    case QTRI_TEXEL_RGB565:
    case QTRI_TEXEL_ARGB4444:
    case QTRI_TEXEL_ARGB1555:
        return 0xFFFF;
    case QTRI_TEXEL_CHECKER:
        return 1;
    default:
        return 0xFF;
    }
}

static void make_texture(const qtri_options *o)
{
    static const qtri_texel_format *const formats[] = {NULL,
                                                       &qtri_texel_rgb565,
                                                       &qtri_texel_xrgb8888,
                                                       &qtri_texel_gray8,
                                                       &qtri_texel_palette8,
                                                       &qtri_texel_palette565,
                                                       &qtri_texel_checker,
                                                       &qtri_texel_argb8888,
                                                       &qtri_texel_argb4444,
                                                       &qtri_texel_argb1555,
                                                       &qtri_texel_alpha8,
                                                       &random_texels};
    memset(&w.texture, 0, sizeof w.texture);
    w.texture.texels = w.texels;
    w.texture.format = formats[o->texel];
    w.texture.width_log2 = (uint8_t)(o->large_texture ? 9 : 1 + random_in(&seed, 0, 5));
    w.texture.height_log2 = (uint8_t)(o->large_texture ? 9 : 1 + random_in(&seed, 0, 5));
    w.texture.fields = 5;
    w.texture.color[0] = w.colors[0];
    w.texture.color[1] = w.colors[1];
    w.texture.wrap_u = (qtri_wrap)o->wrap_u;
    w.texture.wrap_v = (qtri_wrap)o->wrap_v;
    w.texture.filter = o->mipmapped  ? (o->bilinear ? &qtri_mipmapped_bilinear : &qtri_mipmapped)
                       : o->bilinear ? &qtri_bilinear
                                     : NULL;
    for (int i = 0; i < LEVELS; i++) {
        w.levels[i] = w.texels + 1000 * (i + 1);
    }
    w.texture.levels = w.levels;
    w.texture.level_count = LEVELS;
    w.texture.palette = o->texel == QTRI_TEXEL_PALETTE565 ? (const void *)palette565 : palette;
    w.texture.has_key = o->key;
    w.texture.key = w.texels[0] & stored_bits(o->texel);
}

static void make_material(const qtri_options *o)
{
    static const qtri_blend *const blends[] = {NULL,
                                               &qtri_blend_alpha,
                                               &qtri_blend_add,
                                               &qtri_blend_multiply,
                                               &qtri_blend_none,
                                               &qtri_blend_screen_door};
    const qtri_rgb white = {255, 255, 255};
    qtri_material *m = &w.material;
    memset(m, 0, sizeof *m);
    m->color = o->shade == QTRI_WHITE_LIGHT ? white : w.colors[2];
    m->color.r &= o->shade == QTRI_WHITE_LIGHT ? 255 : 254;
    m->shading = o->shade >= QTRI_LIGHT ? QTRI_SMOOTH : QTRI_FLAT_LAST;
    m->interpolation = random_in(&seed, 0, 4) == 0 ? QTRI_SCREEN_LINEAR : QTRI_PERSPECTIVE;
    m->texture = o->texel != QTRI_NO_TEXEL ? &w.texture : NULL;
    m->texture_mode =
        o->shade == QTRI_FLAT && o->texel != QTRI_NO_TEXEL ? QTRI_REPLACE : QTRI_MODULATE;
    m->cull = (qtri_cull)random_in(&seed, 0, 1);
    m->depth_compare = (qtri_compare)o->compare;
    m->depth_read_only = o->read_only;
    m->depth_shift = random_in(&seed, 0, 5) == 0 ? &qtri_slope_bias : NULL;
    m->depth_slope = between(-2, 2);
    m->blend = o->vertex_alpha && o->blend == QTRI_ALPHA ? &qtri_blend_vertex_alpha
               : o->vertex_alpha                         ? &qtri_blend_vertex_add
               : o->keep && o->blend == QTRI_STORE       ? &qtri_blend_replace
                                                         : blends[o->blend];
    m->alphas = o->vertex_alpha ? w.alphas : NULL;
    m->alpha = (uint8_t)random_in(&seed, 1, 254);
    m->keep = (uint8_t)(o->keep ? random_in(&seed, 1, 6) : 0);
    m->least_alpha = o->alpha_test ? 100 : 0;
    m->fragment = o->fragment;
    if (o->fog) {
        const qtri_fog_range range = {Q16(.1), Q16(20), false};
        if (random_flag(&seed)) {
            qtri_fog_linear(&w.fog, w.colors[3], range, Q16(.5), Q16(4));
        } else {
            qtri_fog_exp(&w.fog, w.colors[3], range, Q16(.3));
        }
        m->fog = &w.fog;
    }
    const bool is_lit = o->shade == QTRI_LIGHT || o->shade == QTRI_WHITE_LIGHT;
    w.mesh.normals = is_lit ? w.normals : NULL;
    w.mesh.colors = o->shade == QTRI_COLORS ? w.colors : NULL;
    w.mesh.uvs = o->texel != QTRI_NO_TEXEL ? w.uvs : NULL;
    w.view.light = &w.light;
}

/* Some lights, where colours vary: of vertices, with normals and without, and of pixels. */
static void make_lights(const qtri_options *o)
{
    static const qtri_light_kind *const kinds[] = {&qtri_directional_light, &qtri_point_light,
                                                   &qtri_spot_light};
    const qtri_light_color dim = {Q16(.1), Q16(.15), Q16(.1)};
    const bool may = o->shade == QTRI_COLORS ||
                     (o->shade == QTRI_FLAT && o->texel == QTRI_NO_TEXEL) || o->shade == QTRI_TINT;
    w.material.reflection = NULL;
    if (!o->per_pixel && (!may || random_flag(&seed))) {
        return;
    }
    for (int i = 0; i < 3; i++) {
        qtri_light_source *s = &w.sources[i];
        memset(s, 0, sizeof *s);
        s->kind = kinds[random_in(&seed, 0, 2)];
        s->position = vec3_of(.5 - i, .7, 1.2 * i - .5);
        s->color.r = between(.1, 1.2);
        s->color.g = between(.1, 1.2);
        s->color.b = between(.1, 1.2);
        s->constant = Q16(1);
        s->quadratic = Q16(.2);
        s->direction = vec3_of(0, -.5, -1);
        s->inner = Q16(20);
        s->outer = Q16(50);
    }
    memset(&w.reflection, 0, sizeof w.reflection);
    qtri_shininess_init(&w.shininess, Q16(20));
    w.reflection.specular = w.colors[7];
    w.reflection.shininess = random_flag(&seed) ? &w.shininess : NULL;
    w.reflection.two_sided = random_flag(&seed);
    w.material.reflection = &w.reflection;
    assert_ok(qtri_light_init(&w.lights, w.sources, (uint32_t)random_in(&seed, 1, 3), dim));
    w.view.light = &w.lights;
    w.mesh.normals = random_flag(&seed) ? w.normals : NULL;
    w.mesh.colors = random_flag(&seed) ? w.colors : NULL;
    if (o->per_pixel) {
        w.material.shading = &qtri_per_pixel;
    }
}

/* A picture, all bytes of colour and depth, by one pipeline. -------------------------------------
 */

typedef struct picture {
    qtri_surface surface;
    uint8_t *memory;
    size_t bytes;
} picture;

static bool depths_are_apart; /* words of depths begin where those of pixels do not */

static picture new_picture(const qtri_options *o)
{
    static const qtri_format *const formats[] = {
        &random_format, &qtri_rgb565,   &qtri_rgb565_swapped, &qtri_rgb565_exact, &qtri_rgb888,
        &qtri_bgr888,   &qtri_xrgb8888, &qtri_gray8,          &qtri_depth_only};
    static const qtri_depth_format *const depths[] = {NULL, &qtri_depth_linear16,
                                                      &qtri_depth_float16, &qtri_depth_linear24,
                                                      &qtri_depth_linear32};
    static const qtri_format *const four[] = {
        NULL, &qtri_rgb565_x4,   &qtri_rgb565_swapped_x4, NULL, &qtri_rgb888_x4,
        NULL, &qtri_xrgb8888_x4, &qtri_gray8_x4};
    const qtri_format *format = o->samples != 0 ? four[o->format] : formats[o->format];
    const qtri_depth_format *depth =
        o->depth == QTRI_NO_DEPTH ? &qtri_depth_linear16 : depths[o->depth];
    const qtri_rgb sky = {90, 130, 170};
    picture p;
    p.bytes = QTRI_BAND_BYTES_DEPTH(WIDTH, HEIGHT, format->pixels->bytes, depth->bytes) + 2;
    p.memory = (uint8_t *)calloc(1, p.bytes);
    assert_non_null(p.memory);
    assert_ok(
        surface_with_depth(&p.surface, format, depth, WIDTH, HEIGHT, 0, HEIGHT, p.memory, p.bytes));
    p.surface.depth += depths_are_apart && depth->bytes == 2 ? 1 : 0;
    qtri_samples_clear(&p.surface, sky);
    if (o->compare == QTRI_GREATER || o->compare == QTRI_GREATER_EQUAL) {
        qtri_samples_clear_depth(&p.surface, Q16(.9));
    }
    return p;
}

static void draw(const qtri_surface *surface, const qtri_pipeline *pipeline)
{
    const qtri_pipeline *const list[] = {pipeline, NULL};
    w.view.pipelines = list;
    give_vertices(&w.view, w.vertices, w.vertex_count);
    qtri_draw_mesh(surface, &w.view, &w.pose, &w.mesh, &w.material);
    w.view.pipelines = NULL;
}

static void draw_tiles(qtri_surface *surface, const qtri_pipeline *pipeline)
{
    for (int32_t y = 0; y < HEIGHT; y += TILE_HEIGHT) {
        for (int32_t x = 0; x < WIDTH; x += TILE_WIDTH) {
            const qtri_rect tile = {x, y, x + TILE_WIDTH, y + TILE_HEIGHT};
            surface->scissor = tile;
            draw(surface, pipeline);
        }
    }
}

/* Bands of the same memory. */
static void draw_bands(const qtri_surface *surface, const qtri_pipeline *pipeline)
{
    const size_t depth_bytes =
        surface->depth_format != NULL ? surface->depth_format->bytes : sizeof(uint16_t);
    for (int32_t y = 0; y < HEIGHT; y += BAND) {
        qtri_surface band = *surface;
        band.first_row = y;
        band.rows = y + BAND < HEIGHT ? BAND : HEIGHT - y;
        band.pixels += y * surface->pitch;
        band.depth = (uint16_t *)(void *)((uint8_t *)surface->depth +
                                          (size_t)(y * surface->depth_pitch) * depth_bytes);
        draw(&band, pipeline);
    }
}

static int differences(const picture *a, const picture *b)
{
    int count = 0;
    for (size_t i = 0; i < a->bytes; i++) {
        count += a->memory[i] != b->memory[i];
    }
    return count;
}

/* What a material asks for that a pipeline with these options is to draw. */
static qtri_options options_asked(const qtri_options *of_pipeline)
{
    qtri_options o = *of_pipeline;
    if (o.compare == QTRI_ANY) {
        o.compare = (uint8_t)random_in(&seed, QTRI_LESS, QTRI_ALWAYS);
    }
    if (o.read_only == QTRI_ANY) {
        o.read_only = random_flag(&seed);
    }
    return o;
}

/* Nearly no depth is equal to what a cleared picture has, and some options write nothing at all. */
static bool may_show(const qtri_options *o)
{
    return o->compare != QTRI_EQUAL &&
           ((o->blend != QTRI_KEEP_PIXEL && o->format != QTRI_DEPTH_ONLY) ||
            (o->depth != QTRI_NO_DEPTH && !o->read_only));
}

TEST(specialised_is_generic_is_tiles_is_bands)
{
    int drawn = 0, pictures = 0, bad = 0;
    for (size_t i = 0; i < LENGTH_OF(w.texels); i++) {
        w.texels[i] = (uint32_t)random_bits32(&seed);
        w.texels[i] = i % 5 == 0 ? w.texels[0] : w.texels[i]; /* the key, often */
    }
    for (int n = 0; random_pipelines[n] != NULL; n++) {
        const qtri_pipeline *pipeline = random_pipelines[n];
        for (int shape = 0; shape < SHAPES; shape++) {
            seed = (uint64_t)(1000 + n * SHAPES + shape);
            const qtri_options asked = options_asked(&pipeline->options), *o = &asked;
            depths_are_apart = shape % 2 != 0;
            make_mesh(shape);
            make_texture(o);
            make_material(o);
            make_lights(o);
            w.light.towards = vec3_of(.3, .6, .7);
            w.light.ambient = Q16(.2);
            w.light.diffuse = Q16(.8);
            picture empty = new_picture(o), by[4];
            for (int k = 0; k < 4; k++) {
                by[k] = new_picture(o);
            }
            draw(&by[0].surface, pipeline);
            draw(&by[1].surface, &qtri_pipeline_any);
            draw_tiles(&by[2].surface, pipeline);
            draw_bands(&by[3].surface, pipeline);
            drawn += differences(&by[0], &empty) != 0;
            pictures += may_show(o);
            static const char *const names[] = {"", "generic", "tiles", "bands"};
            for (int k = 1; k < 4; k++) {
                const int count = differences(&by[0], &by[k]);
                if (count != 0) {
                    print_error("pipeline %d, shape %d: %s differ in %d bytes\n", n, shape,
                                names[k], count);
                    bad++;
                }
            }
            for (int k = 0; k < 4; k++) {
                free(by[k].memory);
            }
            free(empty.memory);
        }
    }
    print_message("%d of %d pictures that may show something do\n", drawn, pictures);
    assert_int_equal(bad, 0);
    assert_true(drawn > pictures * 3 / 4);
}

/* Each draws what it was made for: nothing is left to another way. */
TEST(every_pipeline_fits_what_it_was_made_for)
{
    for (int n = 0; random_pipelines[n] != NULL; n++) {
        const qtri_pipeline *const list[] = {random_pipelines[n], NULL};
        qtri_draw_state found;
        seed = (uint64_t)n;
        const qtri_options asked = options_asked(&random_pipelines[n]->options), *o = &asked;
        make_mesh(0);
        make_texture(o);
        make_material(o);
        picture p = new_picture(o);
        qtri_draw_state_init(&found, &p.surface, list, &w.material, w.material.texture,
                             o->per_pixel                                         ? QTRI_BY_PIXEL
                             : o->shade == QTRI_WHITE_LIGHT                       ? QTRI_LIGHT
                             : o->shade == QTRI_FLAT && o->texel == QTRI_NO_TEXEL ? QTRI_TINT
                                                                                  : o->shade);
        if (found.pipeline != random_pipelines[n]) {
            fail_msg("pipeline %d does not fit", n);
        }
        free(p.memory);
    }
}

/* What one's own formats, or functions, are not those of is drawn by another pipeline; nor is one
   taken for samples where there are none. */
TEST(pipelines_of_other_formats_do_not_fit)
{
    static qtri_format other_format;
    static qtri_texel_format other_texels;
    int apart = 0;
    other_format = random_format;
    other_texels = random_texels;
    for (int n = 0; random_pipelines[n] != NULL; n++) {
        for (int change = 0; change < 5; change++) {
            qtri_pipeline copy = *random_pipelines[n];
            const qtri_pipeline *const list[] = {&copy, &qtri_pipeline_any, NULL};
            qtri_options *of_copy = &copy.options;
            qtri_draw_state found;
            seed = (uint64_t)n;
            const qtri_options asked = options_asked(of_copy), *o = &asked;
            bool fits = true;
            if (o->per_pixel || o->shade == QTRI_WHITE_LIGHT) {
                continue;
            }
            if (change == 1 && o->format == QTRI_OTHER_FORMAT) {
                of_copy->own_format = &other_format;
                fits = false;
            } else if (change == 2 && o->format == QTRI_OTHER_FORMAT) {
                of_copy->pixel_bytes++;
                fits = false;
            } else if (change == 3 && o->texel == QTRI_OTHER_TEXEL) {
                of_copy->own_texel = &other_texels;
                fits = false;
            } else if (change == 4) {
                of_copy->fragment = o->fragment != NULL ? NULL : random_fragment;
                fits = false;
            }
            make_mesh(0);
            make_texture(o);
            make_material(o);
            picture p = new_picture(o);
            qtri_draw_state_init(&found, &p.surface, list, &w.material, w.material.texture,
                                 o->shade == QTRI_FLAT && o->texel == QTRI_NO_TEXEL ? QTRI_TINT
                                                                                    : o->shade);
            assert_true((found.pipeline == &copy) == fits);
            apart += !fits;
            free(p.memory);
        }
    }
    assert_true(apart > 50);
    qtri_draw_state found;
    const qtri_pipeline *const list[] = {&qtri_pipeline_any_x4, &qtri_pipeline_any, NULL};
    const qtri_options plain = {.format = QTRI_RGB565};
    make_material(&plain);
    picture p = new_picture(&plain);
    qtri_draw_state_init(&found, &p.surface, list, &w.material, NULL, QTRI_TINT);
    assert_ptr_equal(found.pipeline, &qtri_pipeline_any);
    free(p.memory);
}

int main(void)
{
    return run_all_tests(NULL, NULL);
}
