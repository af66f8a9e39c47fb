/* SPDX-License-Identifier: MIT */
/*
 * What becomes of texels: replace and modulate, the bilinear filter, palettes, gray texels, fields
 * and colour keys, against double arithmetic.
 */
#include "support/texture.h"

enum { NOISE_LOG2 = 5, NOISE = 1 << NOISE_LOG2 };

/* The same noise in every format: grays of few levels, so that all can hold them exactly. */
static uint8_t levels[NOISE * NOISE];
static uint16_t texels565[NOISE * NOISE];
static uint32_t texels8888[NOISE * NOISE];
static uint32_t colors8888[NOISE * NOISE]; /* any colour */
static uint8_t numbers[NOISE * NOISE];     /* of palette entries */
static qtri_rgb palette[256];

static int fill_textures(void **state)
{
    (void)state;
    uint64_t seed = 700;
    for (int i = 0; i < 256; i++) {
        palette[i].r = (uint8_t)random64(&seed);
        palette[i].g = (uint8_t)random64(&seed);
        palette[i].b = (uint8_t)random64(&seed);
    }
    for (size_t i = 0; i < LENGTH_OF(numbers); i++) {
        numbers[i] = (uint8_t)random64(&seed);
        levels[i] = (uint8_t)(random_in(&seed, 0, 3) * 85);
        texels8888[i] = levels[i] * 0x010101u | 0xAB000000u; /* the X byte is ignored */
        uint32_t third = levels[i] / 85u;
        texels565[i] = (uint16_t)(third * 10 << 11 | third * 21 << 5 | third * 10);
        colors8888[i] = (uint32_t)random64(&seed) & 0xFFFFFFu;
        if (i % 3 == 0) {
            colors8888[i] = i % 2 ? 0xFFFFFFu : 0; /* the largest steps */
        }
    }
    return 0;
}

static qtri_texture noise_texture(const void *texels, const qtri_texel_format *format)
{
    qtri_texture t = {
        .texels = texels, .format = format, .width_log2 = NOISE_LOG2, .height_log2 = NOISE_LOG2};
    return t;
}

/* ---- Colours ---- */

TEST(modulates)
{
    double worst = 0;
    uint64_t seed = 96;
    canvas c = canvas_new(&qtri_xrgb8888, WIDTH, HEIGHT);
    for (int n = 0; n < 3000; n++) {
        uint32_t one_texel = (uint32_t)random64(&seed) & 0xFFFFFFu;
        uint16_t one_565 = (uint16_t)random64(&seed);
        bool narrow = n % 2 != 0;
        if (n % 7 == 0) {
            one_texel = 0xFFFFFFu;
            one_565 = 0xFFFF;
        }
        qtri_texture texture = {.texels = &one_texel, .format = &qtri_texel_xrgb8888};
        if (narrow) {
            texture.texels = &one_565;
            texture.format = &qtri_texel_rgb565;
        }
        qtri_material m = plain_material();
        m.texture = &texture;
        int level[3] = {random_in(&seed, 0, 255), random_in(&seed, 0, 255), n % 256};
        draw_quad(&c, &m, level);
        uint32_t drawn = stored_pixel(&c.surface, 7, 9);
        int texel[3] = {(int)(one_texel >> 16), (int)(one_texel >> 8 & 255),
                        (int)(one_texel & 255)};
        if (narrow) {
            texel[0] = ((one_565 >> 11) * 255 + 15) / 31;
            texel[1] = ((one_565 >> 5 & 63) * 255 + 31) / 63;
            texel[2] = ((one_565 & 31) * 255 + 15) / 31;
        }
        for (int i = 0; i < 3; i++) {
            double is = drawn >> (16 - 8 * i) & 255;
            worst = fmax(worst, fabs(is - level[i] * texel[i] / 255.));
            assert_true(texel[i] != 255 || is == level[i]); /* white changes nothing */
        }
        m.texture_mode = QTRI_REPLACE;
        draw_quad(&c, &m, level);
        assert_int_equal(stored_pixel(&c.surface, 7, 9),
                         (uint32_t)(texel[0] << 16 | texel[1] << 8 | texel[2]));
    }
    print_message("modulate: %.4f of 255\n", worst);
    assert_true(worst <= 1);
    canvas_free(&c);
}

TEST(checkers)
{
    canvas c = canvas_new(&qtri_xrgb8888, WIDTH, HEIGHT);
    static const int fields[] = {0, 1, 2, 8, 3, 64, 65535};
    for (size_t n = 0; n < LENGTH_OF(fields); n++) {
        qtri_texture texture = {
            .format = &qtri_texel_checker,
            .width_log2 = 6,
            .height_log2 = 5,
            .fields = (uint16_t)fields[n],
            .color = {{255, 0, 1}, {2, 255, 3}},
        };
        qtri_material m = plain_material();
        const int white[3] = {255, 255, 255};
        m.texture = &texture;
        draw_quad(&c, &m, white);
        for (int32_t i = 0; i < WIDTH * HEIGHT; i++) {
            int x = i % WIDTH;
            int y = i / WIDTH;
            /* texel under the centre, never on a boundary here */
            int column = (2 * x + 1) * 64 / (2 * WIDTH);
            int row = (2 * y + 1) * 32 / (2 * HEIGHT);
            int field = column * fields[n] / 64 + row * fields[n] / 32;
            assert_int_equal(stored_pixel(&c.surface, x, y), field % 2 ? 0x02FF03 : 0xFF0001);
        }
    }
    canvas_free(&c);
}

/* ---- Bilinear ---- */

static int place(int texel, bool clamp)
{
    return clamp ? (texel < 0 ? 0 : (texel >= NOISE ? NOISE - 1 : texel)) : texel & (NOISE - 1);
}

/* u, v in texels: channel `shift` of the four around, weighted. */
static double bilinear_at(const uint32_t *texels, double u, double v, const bool clamp[2],
                          int shift)
{
    double column = floor(u - .5);
    double row = floor(v - .5);
    double along = u - .5 - column;
    double across = v - .5 - row;
    double sum = 0;
    for (int i = 0; i < 4; i++) {
        double weight = (i % 2 ? along : 1 - along) * (i / 2 ? across : 1 - across);
        int x = place((int)column + i % 2, clamp[0]);
        int y = place((int)row + i / 2, clamp[1]);
        sum += weight * (texels[y * NOISE + x] >> shift & 255);
    }
    return sum;
}

/* Largest error of a channel, of 255, before the reference is rounded. */
static double worst_bilinear(uint64_t seed, int count, int32_t uv_reach)
{
    double worst = 0;
    int pixels = 0;
    canvas c = canvas_new(&qtri_xrgb8888, WIDTH, HEIGHT);
    qtri_texture texture = noise_texture(colors8888, &qtri_texel_xrgb8888);
    texture.filter = &qtri_bilinear;
    for (int n = 0; n < count; n++) {
        bool clamp[2] = {random_flag(&seed), random_flag(&seed)};
        texture.wrap_u = clamp[0] ? QTRI_CLAMP : QTRI_REPEAT;
        texture.wrap_v = clamp[1] ? QTRI_CLAMP : QTRI_REPEAT;
        qtri_material m = plain_material();
        qtri_screen_vertex v[3];
        double color[3];
        m.texture = &texture;
        m.texture_mode = (qtri_texture_mode)(n % 3 == 0);
        m.interpolation = (qtri_interpolation)(n % 2);
        m.depth_compare = QTRI_LESS;
        random_triangle(v, &seed, 12000, uv_reach);
        for (int i = 0; i < 3; i++) {
            v[0].color_8p16[i] = random_in(&seed, 0, 255 << 16);
            color[i] = m.texture_mode == QTRI_REPLACE ? 255 : real(v[0].color_8p16[i]);
        }
        canvas_clear(&c);
        qtri_raster_triangle(&c.surface, qtri_pipelines_default, &m, v);
        for (int32_t i = 0; i < WIDTH * HEIGHT; i++) {
            int32_t x = i % WIDTH;
            int32_t y = i / WIDTH;
            if (stored_depth(&c.surface, x, y) == 65535) {
                continue;
            }
            uint32_t is = stored_pixel(&c.surface, x, y);
            double u = perspective_sum(v, x, y, n % 2 == 0, false) * NOISE;
            double t = perspective_sum(v, x, y, n % 2 == 0, true) * NOISE;
            const double units = coordinate_unit(v, x, y, n % 2 == 0, false, NOISE) +
                                 coordinate_unit(v, x, y, n % 2 == 0, true, NOISE);
            for (int channel = 0; channel < 3; channel++) {
                int shift = 16 - 8 * channel;
                double expected =
                    color[channel] / 255 * bilinear_at(colors8888, u, t, clamp, shift);
                const double off = fabs((is >> shift & 255) - expected) - .75;
                worst = fmax(worst, off / (255 * (units + 2. / 2048)));
            }
            pixels++;
        }
    }
    canvas_free(&c);
    assert_true(pixels > 1000);
    return worst;
}

/*
 * Three quarters of a step where the colour is multiplied and rounded; and in u and in v, with
 * neighbours 255 apart, a weight's step, 255/2048, and what the coordinate may be off: of that the
 * share is printed.
 */
TEST(bilinear_filter)
{
    double small = worst_bilinear(710, 400, Q16(0.5));
    double usual = worst_bilinear(711, 400, Q16(2));
    double many = worst_bilinear(712, 400, Q16(20));
    print_message("bilinear, of the bound: %.3f, 2 repeats %.3f, 20 repeats %.3f\n", small, usual,
                  many);
    assert_true(small <= 1);
    assert_true(usual <= 1);
    assert_true(many <= 1);
    assert_true(fmax(small, fmax(usual, many)) <= 1.2);
}

/* 16 pixels a texel: weights are odd 32nds, which 8 bits hold; only the colour is rounded. */
TEST(bilinear_weights_are_exact)
{
    canvas c = canvas_new(&qtri_xrgb8888, 16 * NOISE, 16 * NOISE);
    static const bool repeat[2] = {false, false};
    qtri_texture texture = noise_texture(colors8888, &qtri_texel_xrgb8888);
    texture.filter = &qtri_bilinear;
    qtri_material m = plain_material();
    m.texture = &texture;
    qtri_screen_vertex q[3] = {screen_at(0, 0), screen_at(32 * NOISE * 256, 0),
                               screen_at(0, 32 * NOISE * 256)};
    q[1].u_q32 = q[2].v_q32 = (int64_t)2 << 32;
    qtri_raster_triangle(&c.surface, qtri_pipelines_default, &m, q);
    double worst = 0;
    for (int32_t y = 0; y < 16 * NOISE; y++) {
        for (int32_t x = 0; x < 16 * NOISE; x++) {
            uint32_t is = stored_pixel(&c.surface, x, y);
            for (int shift = 0; shift <= 16; shift += 8) {
                double expected =
                    bilinear_at(colors8888, (x + .5) / 16, (y + .5) / 16, repeat, shift);
                worst = fmax(worst, fabs((is >> shift & 255) - expected));
            }
        }
    }
    print_message("bilinear, exact weights: %.4f of 255\n", worst);
    assert_true(worst <= .501);
    canvas_free(&c);
}

/* RGB565 texels on RGB565, where each tap has a weight of few bits: any colours, each channel. */
TEST(bilinear_of_565)
{
    static uint16_t texels[NOISE * NOISE];
    static uint32_t channel[3][NOISE * NOISE];
    static const bool clamp[2] = {false, false};
    uint64_t seed = 740;
    for (size_t i = 0; i < LENGTH_OF(texels); i++) {
        texels[i] = (uint16_t)random64(&seed);
        channel[0][i] = texels[i] >> 11;
        channel[1][i] = texels[i] >> 5 & 63;
        channel[2][i] = texels[i] & 31;
    }
    canvas c = canvas_new(&qtri_rgb565, 16 * NOISE, 16 * NOISE);
    qtri_texture texture = noise_texture(texels, &qtri_texel_rgb565);
    texture.filter = &qtri_bilinear;
    qtri_material m = plain_material();
    m.texture = &texture;
    m.texture_mode = QTRI_REPLACE;
    qtri_screen_vertex q[3] = {screen_at(0, 0), screen_at(32 * NOISE * 256, 0),
                               screen_at(0, 32 * NOISE * 256)};
    q[1].u_q32 = q[2].v_q32 = (int64_t)2 << 32;
    qtri_raster_triangle(&c.surface, qtri_pipelines_default, &m, q);
    double worst = 0; /* in steps of the channel */
    for (int32_t y = 0; y < 16 * NOISE; y++) {
        for (int32_t x = 0; x < 16 * NOISE; x++) {
            const uint32_t is = stored_pixel(&c.surface, x, y);
            const uint32_t part[3] = {is >> 11, is >> 5 & 63, is & 31};
            for (int k = 0; k < 3; k++) {
                const double should =
                    bilinear_at(channel[k], (x + .5) / 16, (y + .5) / 16, clamp, 0);
                worst = fmax(worst, fabs(part[k] - should));
            }
        }
    }
    print_message("bilinear in 565: %.4f of a step\n", worst);
    assert_true(worst <= .501); /* weights are exact here, only the colour is rounded */
    canvas_free(&c);
}

/* At texel centres, and where all texels are alike, the filter changes nothing. */
TEST(bilinear_at_centres)
{
    canvas c = canvas_new(&qtri_xrgb8888, NOISE, NOISE);
    canvas d = canvas_new(&qtri_xrgb8888, NOISE, NOISE);
    qtri_texture texture = noise_texture(colors8888, &qtri_texel_xrgb8888);
    qtri_material m = plain_material();
    m.texture = &texture;
    qtri_screen_vertex q[3] = {screen_at(0, 0), screen_at(2 * NOISE * 256, 0),
                               screen_at(0, 2 * NOISE * 256)};
    q[1].u_q32 = q[2].v_q32 = (int64_t)2 << 32;
    for (int n = 0; n < 2; n++) {
        texture.filter = NULL;
        qtri_raster_triangle(&c.surface, qtri_pipelines_default, &m, q);
        texture.filter = &qtri_bilinear;
        qtri_raster_triangle(&d.surface, qtri_pipelines_default, &m, q);
        assert_same_picture(&c.surface, &d.surface);
        texture.width_log2 = texture.height_log2 = 0; /* one texel */
    }
    canvas_free(&c);
    canvas_free(&d);
}

/* ---- Formats ---- */

static void draw_full(canvas *c, const qtri_texture *texture, qtri_texture_mode mode)
{
    static const int level[3] = {210, 120, 250};
    qtri_material m = plain_material();
    m.texture = texture;
    m.texture_mode = mode;
    canvas_clear(c);
    draw_quad(c, &m, level);
}

/* Texels that mean the same colour draw the same pixels, whatever their format. */
TEST(formats_agree)
{
    static const qtri_format *const surfaces[] = {&qtri_rgb565, &qtri_xrgb8888, &qtri_gray8};
    static uint32_t from_palette[NOISE * NOISE];
    for (size_t i = 0; i < LENGTH_OF(from_palette); i++) {
        const qtri_rgb *rgb = &palette[numbers[i]];
        from_palette[i] = (uint32_t)rgb->r << 16 | (uint32_t)rgb->g << 8 | rgb->b;
    }
    qtri_texture pairs[3][2] = {
        {noise_texture(texels8888, &qtri_texel_xrgb8888), noise_texture(levels, &qtri_texel_gray8)},
        {noise_texture(from_palette, &qtri_texel_xrgb8888),
         noise_texture(numbers, &qtri_texel_palette8)},
        {noise_texture(texels8888, &qtri_texel_xrgb8888),
         noise_texture(texels565, &qtri_texel_rgb565)}};
    pairs[1][1].palette = palette;
    for (size_t n = 0; n < LENGTH_OF(pairs) * LENGTH_OF(surfaces) * 4; n++) {
        const qtri_format *format = surfaces[n % 3];
        canvas c = canvas_new(format, WIDTH, HEIGHT);
        canvas d = canvas_new(format, WIDTH, HEIGHT);
        qtri_texture *pair = pairs[n / 12];
        pair[0].filter = pair[1].filter = n / 3 % 2 ? &qtri_bilinear : NULL;
        qtri_texture_mode mode = n / 6 % 2 ? QTRI_REPLACE : QTRI_MODULATE;
        draw_full(&c, &pair[0], mode);
        draw_full(&d, &pair[1], mode);
        /* 10/31 and 21/63 widen to 82 and 85: gray in green only */
        if (pair[1].format != &qtri_texel_rgb565) {
            assert_same_picture(&c.surface, &d.surface);
        } else if (format == &qtri_xrgb8888) {
            for (int32_t i = 0; i < WIDTH * HEIGHT; i++) {
                const int wide = stored_pixel(&c.surface, i % WIDTH, i / WIDTH) >> 8 & 255;
                const int narrow = stored_pixel(&d.surface, i % WIDTH, i / WIDTH) >> 8 & 255;
                /* filtered in units of their own: rounded otherwise */
                assert_true(abs(wide - narrow) <= (pair[0].filter != NULL));
            }
        }
        canvas_free(&c);
        canvas_free(&d);
    }
}

/* c of `most` as one of 255, to nearest. */
static uint32_t channel_of(uint32_t c, uint32_t most)
{
    return (510 * (c & most) + most) / (2 * most);
}

static uint32_t rgb_of(uint32_t r, uint32_t g, uint32_t b)
{
    return r << 16 | g << 8 | b;
}

static uint32_t packed_rgb_of(uint32_t t)
{
    return rgb_of(channel_of(t >> 11, 31), channel_of(t >> 5, 63), channel_of(t, 31));
}

/* The colour of texel i, as texture.h says what is stored. */
static uint32_t color_of(const qtri_texture *texture, uint32_t i)
{
    const uint8_t *bytes = texture->texels;
    const uint16_t *halves = texture->texels;
    const uint32_t *words = texture->texels;
    const uint32_t side = (uint32_t)1 << texture->width_log2;
    const uint32_t fields = i % side * texture->fields / side + i / side * texture->fields / side;
    const qtri_rgb *rgb = texture->format == &qtri_texel_checker ? &texture->color[fields & 1]
                          : texture->format == &qtri_texel_palette8
                              ? (const qtri_rgb *)texture->palette + bytes[i]
                              : NULL;
    switch (texture->format->kind) {
    case QTRI_TEXEL_RGB565:
        return packed_rgb_of(halves[i]);
    case QTRI_TEXEL_PALETTE565:
        return packed_rgb_of(((const uint16_t *)texture->palette)[bytes[i]]);
    case QTRI_TEXEL_ARGB4444:
        return rgb_of(17u * (halves[i] >> 8 & 15u), 17u * (halves[i] >> 4 & 15u),
                      17u * (halves[i] & 15u));
    case QTRI_TEXEL_ARGB1555:
        return rgb_of(channel_of(halves[i] >> 10, 31), channel_of(halves[i] >> 5, 31),
                      channel_of(halves[i], 31));
    case QTRI_TEXEL_GRAY8:
        return rgb_of(bytes[i], bytes[i], bytes[i]);
    case QTRI_TEXEL_ALPHA8:
        return 0xFFFFFF;
    default:
        return rgb != NULL ? rgb_of(rgb->r, rgb->g, rgb->b) : words[i] & 0xFFFFFF;
    }
}

/* Each format's texels are drawn as the colours that they stand for. */
TEST(texels_are_drawn_as_their_format_says)
{
    static const struct {
        const qtri_texel_format *format;
        const void *texels;
    } all[] = {{&qtri_texel_rgb565, texels565},   {&qtri_texel_xrgb8888, colors8888},
               {&qtri_texel_gray8, levels},       {&qtri_texel_palette8, numbers},
               {&qtri_texel_checker, NULL},       {&qtri_texel_argb4444, texels565},
               {&qtri_texel_argb1555, texels565}, {&qtri_texel_argb8888, colors8888},
               {&qtri_texel_alpha8, numbers},     {&qtri_texel_palette565, numbers}};
    static uint32_t read[NOISE * NOISE];
    for (size_t n = 0; n < LENGTH_OF(all); n++) {
        const qtri_texel_format *format = all[n].format;
        qtri_texture texture = noise_texture(all[n].texels, format);
        texture.palette = format == &qtri_texel_palette565 ? (const void *)texels565 : palette;
        texture.fields = 5;
        texture.color[0] = palette[1];
        texture.color[1] = palette[2];
        for (uint32_t i = 0; i < NOISE * NOISE; i++) {
            read[i] = color_of(&texture, i);
        }
        const qtri_texture as_read = noise_texture(read, &qtri_texel_xrgb8888);
        canvas c = canvas_new(&qtri_xrgb8888, WIDTH, HEIGHT);
        canvas d = canvas_new(&qtri_xrgb8888, WIDTH, HEIGHT);
        draw_full(&c, &texture, QTRI_REPLACE);
        draw_full(&d, &as_read, QTRI_REPLACE);
        assert_same_picture(&c.surface, &d.surface);
        canvas_free(&c);
        canvas_free(&d);
    }
}

/* ---- Colour key ---- */

/* Where the key lies, neither colour nor depth changes; elsewhere both do. Any filter. */
TEST(keys_leave_holes)
{
    static uint8_t from_levels[NOISE * NOISE]; /* numbers whose palette repeats colours */
    static const qtri_rgb grays[256] = {{0, 0, 0}, {85, 85, 85}, {170, 170, 170}, {85, 85, 85}};
    for (size_t i = 0; i < LENGTH_OF(levels); i++) {
        from_levels[i] = levels[i] / 85;
    }
    const struct {
        qtri_texture texture;
        uint32_t key;
    } cases[] = {
        {noise_texture(levels, &qtri_texel_gray8), 85},
        {noise_texture(texels8888, &qtri_texel_xrgb8888), 0xFF555555u},
        {noise_texture(texels565, &qtri_texel_rgb565), 10 << 11 | 21 << 5 | 10},
        {noise_texture(from_levels, &qtri_texel_palette8), 1},
    };
    canvas c = canvas_new(&qtri_xrgb8888, WIDTH, HEIGHT);
    for (size_t n = 0; n < LENGTH_OF(cases) * 4; n++) {
        qtri_texture texture = cases[n / 4].texture;
        texture.palette = grays;
        texture.has_key = true;
        texture.key = cases[n / 4].key;
        texture.filter = n % 2 ? &qtri_bilinear : NULL;
        qtri_material m = plain_material();
        const int white[3] = {255, 255, 255};
        m.texture = &texture;
        m.depth_compare = n / 2 % 2 ? QTRI_ALWAYS : QTRI_LESS;
        qtri_rgb sky = {1, 2, 3};
        qtri_surface_clear(&c.surface, sky);
        draw_quad(&c, &m, white);
        for (int32_t i = 0; i < WIDTH * HEIGHT; i++) {
            int32_t x = i % WIDTH;
            int32_t y = i / WIDTH;
            int column = (2 * x + 1) * NOISE / (2 * WIDTH);
            int row = (2 * y + 1) * NOISE / (2 * HEIGHT);
            bool hole = levels[row * NOISE + column] == 85;
            uint32_t pixel = stored_pixel(&c.surface, x, y);
            assert_int_equal(stored_depth(&c.surface, x, y), hole ? 65535 : 0);
            assert_int_equal(pixel == 0x010203, hole);
            if (!hole && texture.filter == NULL) {
                assert_int_equal(pixel >> 8 & 255, texture.format == &qtri_texel_palette8
                                                       ? grays[from_levels[row * NOISE + column]].g
                                                       : levels[row * NOISE + column]);
            }
        }
    }
    canvas_free(&c);
}

/* A key that no texel can equal, and a key that is off, change nothing. */
TEST(keys_that_match_nothing)
{
    canvas c = canvas_new(&qtri_xrgb8888, WIDTH, HEIGHT);
    canvas d = canvas_new(&qtri_xrgb8888, WIDTH, HEIGHT);
    qtri_texture plain = noise_texture(levels, &qtri_texel_gray8);
    qtri_texture off = plain;
    qtri_texture wide = plain;
    off.key = 85;
    wide.has_key = true;
    wide.key = 256 + 85;
    draw_full(&c, &plain, QTRI_MODULATE);
    draw_full(&d, &off, QTRI_MODULATE);
    assert_same_picture(&c.surface, &d.surface);
    draw_full(&d, &wide, QTRI_MODULATE);
    assert_same_picture(&c.surface, &d.surface);
    canvas_free(&c);
    canvas_free(&d);
}

/* The key's colour is seen nowhere, not even at the borders that the filter blends. */
TEST(keys_do_not_bleed)
{
    static uint32_t texels[NOISE * NOISE];
    uint64_t seed = 720;
    for (size_t i = 0; i < LENGTH_OF(texels); i++) {
        texels[i] = random_flag(&seed) ? 0xFF00FFu : 0x204060u;
    }
    canvas c = canvas_new(&qtri_xrgb8888, 300, 280);
    qtri_texture texture = noise_texture(texels, &qtri_texel_xrgb8888);
    texture.filter = &qtri_bilinear;
    texture.has_key = true;
    texture.key = 0xFF00FFu;
    qtri_material m = plain_material();
    m.texture = &texture;
    m.depth_compare = QTRI_LESS;
    qtri_screen_vertex v[3] = {screen_at(0, 0), screen_at(600 * 256, 0), screen_at(0, 560 * 256)};
    v[1].u_q32 = v[2].v_q32 = (int64_t)2 << 32;
    v[1].inv_w_q31 >>= 1;
    qtri_raster_triangle(&c.surface, qtri_pipelines_default, &m, v);
    int drawn = 0;
    for (int32_t i = 0; i < 300 * 280; i++) {
        uint32_t pixel = stored_pixel(&c.surface, i % 300, i / 300);
        assert_true(pixel == 0 || pixel == 0x204060u);
        drawn += pixel != 0;
    }
    assert_in_range(drawn, 30000, 54000);
    canvas_free(&c);
}

/* One of CHECKER's two colours. */
TEST(checker_with_a_key)
{
    canvas c = canvas_new(&qtri_xrgb8888, 8, 4);
    qtri_texture texture = {.format = &qtri_texel_checker,
                            .width_log2 = 2,
                            .height_log2 = 2,
                            .fields = 4,
                            .color = {{0, 0, 0}, {255, 255, 255}},
                            .has_key = true,
                            .key = 0};
    qtri_material m = plain_material();
    m.texture = &texture;
    qtri_screen_vertex v[3] = {screen_at(0, 0), screen_at(16 * 256, 0), screen_at(0, 8 * 256)};
    v[1].u_q32 = v[2].v_q32 = (int64_t)2 << 32;
    texture.color[0] = texture.color[1];
    qtri_raster_triangle(&c.surface, qtri_pipelines_default, &m, v);
    assert_raster(&c.surface, "..##..##", "##..##..", "..##..##", "##..##..");
    canvas_free(&c);
}

/* Nothing to read from: untextured. Words that are none: the zero ones. */
TEST(textures_without_texels)
{
    canvas c = canvas_new(&qtri_xrgb8888, WIDTH, HEIGHT);
    canvas d = canvas_new(&qtri_xrgb8888, WIDTH, HEIGHT);
    qtri_texture none[] = {noise_texture(numbers, &qtri_texel_palette8),
                           noise_texture(NULL, &qtri_texel_palette8),
                           noise_texture(NULL, &qtri_texel_gray8), noise_texture(levels, NULL)};
    none[1].palette = palette;
    for (size_t i = 0; i < LENGTH_OF(none); i++) {
        none[i].has_key = true;
        draw_full(&c, &none[i], QTRI_REPLACE);
        assert_int_equal(stored_pixel(&c.surface, 3, 3), 210 << 16 | 120 << 8 | 250);
    }
    qtri_texture usual = noise_texture(texels8888, &qtri_texel_xrgb8888);
    qtri_texture unknown = usual;
    unknown.wrap_u = (qtri_wrap)2;
    unknown.wrap_v = (qtri_wrap)3;
    draw_full(&c, &usual, QTRI_MODULATE);
    draw_full(&d, &unknown, QTRI_MODULATE);
    assert_same_picture(&c.surface, &d.surface);
    canvas_free(&c);
    canvas_free(&d);
}

/* Sums that lie on the half that is rounded up, and the last below it: nothing is added to them. */
TEST(bilinear_rounds_at_the_half)
{
    static const struct {
        uint8_t texel[4];
        int32_t along, across; /* of 2048 */
        uint32_t wanted;
    } cases[] = {{{152, 9, 176, 146}, 1343, 465, 80},
                 {{194, 33, 10, 118}, 1777, 1003, 78},
                 {{71, 92, 170, 171}, 1248, 512, 106}};
    canvas c = canvas_new(&qtri_xrgb8888, 8, 8);
    for (size_t n = 0; n < LENGTH_OF(cases); n++) {
        uint32_t texels[4];
        for (int i = 0; i < 4; i++) {
            texels[i] = cases[n].texel[i] * 0x010101u;
        }
        qtri_texture texture = {.texels = texels,
                                .format = &qtri_texel_xrgb8888,
                                .width_log2 = 1,
                                .height_log2 = 1,
                                .filter = &qtri_bilinear};
        qtri_material m = plain_material();
        m.texture = &texture;
        m.texture_mode = QTRI_REPLACE;
        qtri_screen_vertex v[3] = {screen_at(0, 0), screen_at(16 * 256, 0), screen_at(0, 16 * 256)};
        for (int i = 0; i < 3; i++) { /* shares count from the first texel's centre */
            v[i].u_q32 = (int64_t)(cases[n].along + 1024) << 20;
            v[i].v_q32 = (int64_t)(cases[n].across + 1024) << 20;
        }
        canvas_clear(&c);
        qtri_raster_triangle(&c.surface, qtri_pipelines_default, &m, v);
        for (int32_t i = 0; i < 64; i++) {
            assert_int_equal(stored_pixel(&c.surface, i % 8, i / 8), cases[n].wanted * 0x010101u);
        }
    }
    canvas_free(&c);
}

int main(void)
{
    return run_all_tests(fill_textures, NULL);
}
