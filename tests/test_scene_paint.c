/* SPDX-License-Identifier: MIT */
/*
 * Flat shapes, text and pictures in scene files: against the reference, in bands, and messages; and
 * `qtri font` as a user meets it.
 */
#define _POSIX_C_SOURCE 200809L

#include "support/io.h"

#include <sys/wait.h>

#include "io/scene.h"
#include "reference/reference.h"
#include "reference/reference_picture.h"
#include "tools/scene_draw.h"

#define FONT                                                                                       \
    "STARTFONT 2.1\nFONT_ASCENT 5\nFONT_DESCENT 1\nSTARTCHAR a\nENCODING 65\nDWIDTH 6 0\n"         \
    "BBX 5 4 0 -1\nBITMAP\nF8\n88\nA8\nF0\nENDCHAR\nENDFONT\n"

static void read_scene(const char *text, struct scene *scene)
{
    struct text_error error;
    const char *path = io_write_text("s.scene", text);
    if (!scene_read(path, scene, &error)) {
        fail_msg("%s", error.message);
    }
}

/*
 * The largest difference of a channel between the core and the reference, but for two
 * pixels: a turned picture's pixel at the border of two may be either.
 */
static int difference(const struct scene *scene, const qtri_format *format,
                      enum reference_format expected_format)
{
    struct picture is;
    struct picture expected;
    struct picture bands;
    struct reference_image image;
    int worst = 0;
    int spare = 6;
    assert_true(scene_render(scene, format, 0, false, &is));
    assert_true(scene_render(scene, format, 5, false, &bands));
    assert_true(reference_render(scene, 0, &image));
    assert_true(reference_picture(&image, expected_format, &expected));
    const size_t bytes = 3 * (size_t)is.width * (size_t)is.height;
    assert_memory_equal(is.rgb, bands.rgb, bytes);
    for (size_t i = 0; i < bytes; i++) {
        const int error = abs(is.rgb[i] - expected.rgb[i]);
        if (error > 17 && spare > 0) {
            spare--;
            continue;
        }
        worst = error > worst ? error : worst;
    }
    reference_free(&image);
    picture_free(&is);
    picture_free(&bands);
    picture_free(&expected);
    return worst;
}

static void write_image(void)
{
    char bytes[64] = "P6\n4 3\n255\n";
    const size_t head = strlen(bytes);
    for (size_t i = 0; i < 36; i++) {
        bytes[head + i] = (char)(i < 3 ? 9 : 37 * i);
    }
    io_write("i.ppm", bytes, head + 36);
}

static const char *const shapes[] = {
    "rect 3.3 4.25 40.8 30.1",      "rect 3 4 40 30 2.5",
    "roundrect 5 5 50 41 8",        "roundrect 5.5 5 50 41.2 8 2.2",
    "circle 30.3 24.1 17.7",        "circle 30 24 17 4",
    "arc 30 24 20 6 30 200",        "arc 30 24 20 30 -50 -120",
    "area 5 5 55 12 40 44 21 20",   "area 30 2 58 44 3 40",
    "stroke 5 5 55 40 3.5",         "stroke 5 30 55 30 1",
    "font f.bdf\ntext 10 20 AA A",  "image i.ppm 20 10",
    "image i.ppm 30.7 24.2 33 7.5", "imagekey 9 9 9\nimage i.ppm 30 24 120 6",
};

TEST(as_the_reference)
{
    io_write_text("f.bdf", FONT);
    write_image();
    for (size_t i = 0; i < ARRAY_LENGTH(shapes); i++) {
        for (int n = 0; n < 4; n++) {
            char text[512];
            struct scene scene;
            snprintf(text, sizeof text,
                     "viewport 60 48\nclear .2 .3 .1\n"
                     "tri -1 -1 0 1 .1 .9 .3  1 -1 0 1 .8 .1 .2  1 1 0 1 .1 .2 1\n"
                     "edges %s\nink 1 .6 .2 %s\n%s\n",
                     n % 2 ? "smooth" : "hard", n / 2 ? ".4" : "1", shapes[i]);
            read_scene(text, &scene);
            const int most = n % 2 ? 8 : 1;
            int worst = difference(&scene, &qtri_xrgb8888, REFERENCE_RGB888);
            if (worst > most) {
                fail_msg("%s: off by %d of 255", text, worst);
            }
            worst = difference(&scene, &qtri_rgb565, REFERENCE_RGB565);
            assert_true(worst <= (n % 2 ? 17 : 9));
            scene_free(&scene);
        }
    }
}

TEST(messages)
{
    static const struct {
        const char *text, *message;
    } cases[] = {
        {"rect 1 2 3\n", "s.scene:1: wrong number of values (3) for rect"},
        {"area 1 2 3 4 5 6 7\n", "s.scene:1: wrong number of values (7) for area (x y) x3 to x8"},
        {"area 1 2 3 4\n", "s.scene:1: wrong number"},
        {"area 1 2 3 4 5 6 7 8 9 1 2 3 4 5 6 7 8 9\n", "s.scene:1: wrong number"},
        {"ink 1 2 3\n", "s.scene:1: ink: '2' does not lie in 0..1"},
        {"edges soft\n", "s.scene:1: 'soft' is unknown here: edges hard|smooth"},
        {"\ntext 1 2 A\n", "s.scene:2: text: needs a font"},
        {"font none.bdf\n", "none.bdf does not exist"},
        {"font i.ppm\n", "i.ppm:1: is not a BDF font"},
        {"image f.bdf 1 2\n", "f.bdf"},
        {"image i.ppm 1 2 30 0\n", "s.scene:1: image: the scale"},
        {"imagekey 1 2 300\n", "s.scene:1: imagekey: '300'"},
        {"circle 1 2 x\n", "s.scene:1: circle: 'x' is not a number"},
        {"font f.bdf\ntext 1 2 A\x01\n", "s.scene:2: text: 'A?' is not text"},
    };
    io_write_text("f.bdf", FONT);
    write_image();
    for (size_t i = 0; i < ARRAY_LENGTH(cases); i++) {
        struct scene scene;
        struct text_error error;
        assert_false(scene_read(io_write_text("s.scene", cases[i].text), &scene, &error));
        if (strstr(error.message, cases[i].message) == NULL) {
            fail_msg("\"%s\", not \"%s\"", error.message, cases[i].message);
        }
    }
}

/* A file is read once, however often it is named. */
TEST(files_once)
{
    struct scene scene;
    io_write_text("f.bdf", FONT);
    write_image();
    read_scene("font f.bdf\nimage i.ppm 1 1\nfont f.bdf\nimage i.ppm 5 5\ntext 1 1 A\n", &scene);
    assert_int_equal(scene.paints.font_count, 1);
    assert_int_equal(scene.paints.image_count, 1);
    assert_int_equal(scene.paints.text_count, 1);
    assert_int_equal(scene.op_count, 3);
    scene_free(&scene);
}

static int run(const char *arguments)
{
    char line[2048];
    snprintf(line, sizeof line, "cd '%s' && '%s' font %s >output 2>messages", io_folder,
             getenv("QTRI_COMMAND"), arguments);
    int status = system(line); /* NOLINT(cert-env33-c): a test of the command line */
    assert_true(WIFEXITED(status));
    return WEXITSTATUS(status);
}

static bool exists(const char *name)
{
    return access(io_path(name), F_OK) == 0;
}

TEST(font_command)
{
    if (getenv("QTRI_COMMAND") == NULL) {
        skip();
    }
    (void)io_remove_files(NULL);
    io_write_text("f.bdf", FONT);
    io_write_text("bad.bdf", "STARTFONT 2.1\nSTARTCHAR a\nENDCHAR\n");
    assert_int_equal(run("--help"), 0);
    assert_int_equal(run(""), 2);
    assert_int_equal(run("f.bdf"), 2);
    assert_int_equal(run("f.bdf -o"), 2);
    assert_int_equal(run("f.bdf g.bdf -o x.h"), 2);
    assert_int_equal(run("f.bdf -o x.h --name a-b"), 2);
    assert_int_equal(run("f.bdf -o x.h --frobnicate"), 2);
    assert_int_equal(run("bad.bdf -o x.h"), 1);
    assert_int_equal(run("missing.bdf -o x.h"), 1);
    assert_int_equal(run("f.bdf -o no/such/folder/x.h"), 1);
    assert_false(exists("x.h"));
    assert_int_equal(run("f.bdf -o tiny_font.h"), 0);
    assert_int_equal(io_count_files(), 5); /* two fonts, output, messages, the header: no more */
    char line[2048];
    io_write_text("use.c", "#include \"tiny_font.h\"\n#include \"tiny_font.h\"\n"
                           "int use(void); int use(void) { return tiny_font.ascent; }\n");
    snprintf(line, sizeof line,
             "cc -std=c99 -Wall -Werror -Icore/include -I'%s' -fsyntax-only '%s'", io_folder,
             io_path("use.c"));
    if (access("core/include/qtri/paint.h", R_OK) == 0) {
        assert_int_equal(system(line), 0); /* NOLINT(cert-env33-c) */
    }
}

int main(void)
{
    return run_all_tests(io_setup, io_teardown);
}
