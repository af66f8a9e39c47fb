/* SPDX-License-Identifier: MIT */
/*
 * What statements of scene files draw, with the core and in double precision: poses, windows,
 * meshes that are computed or mixed, texels with alpha, hidden lines. Each picture is also drawn in
 * bands.
 */
#define _POSIX_C_SOURCE 200809L
#include "support/io.h"

#include "reference/reference.h"
#include "tools/accuracy.h"
#include "tools/demo_waves.h"
#include "tools/scene_draw.h"

#define STATE                                                                                      \
    "depth less\nlight .4 .6 .7 .2 .8\nmode projection\nperspective 60 1.33333333 .1 50\n"         \
    "mode modelview\n"
#define STAGE "viewport 100 75\nclear .1 .12 .2\n" STATE
#define LOOK  "lookat 0 .5 3  0 0 0  0 1 0\n"
#define CARD                                                                                       \
    "trit -1.5 -1.2 0 1 1 1 1 0 2  1.5 -1.2 0 1 1 .8 1 2 2  1.5 1.2 0 1 1 1 .8 2 0\n"              \
    "trit -1.5 -1.2 0 1 1 1 1 0 2  1.5 1.2 0 1 1 1 .8 2 0  -1.5 1.2 0 1 .8 1 1 0 0\n"
#define BACK                                                                                       \
    "tri -2 -.2 -.5 1 1 .3 .3  2 -.3 -.5 1 1 .9 .3  2 .2 -.5 1 .3 1 .3\n"                          \
    "tri -2 -.9 .5 1 .1 .3 .3  2 -.3 -.5 1 1 .9 .3  0 .9 .2 1 .3 1 .3\n"
#define GLASS "texture 16 16 4 255 200 60 40 120 255\n"

/* coverage: pixels in one picture only; off: pixels of a triangle whose colour is off by more than
   1 of 255. Both against the reference whose vertices are on the core's grid, textures against the
   exact one. */
static const struct {
    const char *name, *text;
    unsigned coverage, off;
} cases[] = {
    {"box", STAGE LOOK "rotate 30 1 1 0\nshape box .8 .5 1 color 1 .6 .3\n", 0, 0},
    {"box inside out", STAGE LOOK "cull back\nshape box .8 -.5 1\n", 0, 0},
    {"sphere", STAGE LOOK "shape sphere 1 20 14 color .3 .6 1\n", 0, 0},
    {"least sphere", STAGE LOOK "shape sphere 1 3 2\n", 0, 0},
    {"cylinder", STAGE LOOK "cull back\nshape cylinder .8 .7 13\n", 0, 0},
    {"cone", STAGE LOOK "cull back\nrotate 130 1 0 0\nshape cone .8 .7 17\n", 0, 0},
    {"torus", STAGE LOOK "cull back\nrotate 50 1 0 0\nshape torus .8 .35 24 12\n", 0, 0},
    {"grid", STAGE LOOK "shape grid 2 3 7 5 color .4 .8 .4\n", 0, 0},
    {"textured shapes", STAGE GLASS LOOK "shape grid 2 3 2 2\nshape sphere .7 16 12\n", 2, 20},
    {"flat shapes", STAGE LOOK "shade flat\nshape torus .8 .35 24 12\n", 0, 0},
    {"shapes by box",
     STAGE "frustumcull box\n" LOOK
           "shape sphere .5 16 12\npush\ntranslate 9 0 0\nshape sphere .5 16 12\n"
           "pop\ntranslate 1.5 0 0\nshape sphere .5 16 12\n",
     0, 0},
    {"shapes by ball",
     STAGE "frustumcull ball\n" LOOK
           "shape sphere .5 16 12\npush\ntranslate 0 0 9\nshape sphere .5 16 12\n"
           "pop\ntranslate 1.9 0 0\nshape sphere .5 16 12\n",
     0, 0},
    {"orbit", STAGE "orbit .2 .1 0 3 40 25\nshape box .6 .6 .6\n", 0, 0},
    {"orbit past the pole", STAGE "orbit .2 .1 0 3 200 120\nshape box .6 .6 .6\n", 0, 0},
    {"about a point", STAGE LOOK "rotateabout 50 1 2 3 .5 .2 0\nshape box .6 .6 .6\n", 0, 0},
    {"about a triangle",
     STAGE LOOK "rotatetriangle 70 0 0 0 1 .2 .1 .3 1 -.2\nshape box .6 .6 .6\n", 0, 0},
    {"quaternion", STAGE LOOK "quaternion 2 1 -.5 .3\nshape box .6 .6 .6\n", 0, 0},
    {"orthonormalize",
     STAGE "load .9 .1 .02 0 -.1 1.1 0 0 .05 .1 .8 0 0 0 -3 1\northonormalize\n"
           "shape box .6 .6 .6\n",
     0, 0},
    {"orthonormalize a mirror",
     STAGE "load -.9 .1 .02 0 .1 1.1 0 0 -.05 .1 .8 0 0 0 -3 1\northonormalize\n"
           "shape box .6 .6 .6\n",
     0, 0},
    {"billboard", STAGE "orbit 0 0 0 3 40 35\ncamera\ntranslate .3 0 .2\nbillboard\n" CARD, 0, 0},
    {"upright", STAGE "orbit 0 0 0 3 -70 35\ncamera\ntranslate .3 0 .2\nbillboard upright\n" CARD,
     0, 0},
    {"keys",
     STAGE LOOK "key 0 -1 0 0 0 0 0 1 .5 .5 .5\nkey 2 1 .5 -1 200 1 1 0 .3 .8 .5\npush\n"
                "keys .7\nshape box .6 .6 .6\npop\npush\nkeys -1\nshape box .6 .6 .6\npop\n"
                "keys 2.5\nshape box .6 .6 .6\n",
     0, 0},
    {"joints",
     STAGE "push\nidentity\nrotate 20 0 0 1\njoint none\nidentity\ntranslate .9 .1 0\n"
           "rotate 40 0 1 0\njoint 0\nidentity\ntranslate .5 .5 0\njoint 1\npop\n" LOOK
           "push\natjoint 0\nshape box .5 .2 .2\npop\npush\natjoint 2\n"
           "shape sphere .3 12 8\npop\natjoint 1\nshape box .4 .1 .1\n",
     0, 0},
    {"Direct3D",
     "viewport 100 75\ndepth less\nlight .4 .6 -.7 .2 .8\nmode projection\n"
     "perspectived3d 60 1.33333333 .1 50\nmode modelview\n"
     "lookatd3d 1 1 -3  0 0 0  0 1 0\nshape box .6 .6 .6\n",
     0, 0},
    {"Direct3D's frustum",
     "viewport 100 75\ndepth less\nmode projection\n"
     "frustumd3d -.1 .07 -.06 .05 .1 50\nmode modelview\n"
     "lookatd3d 0 3 0  0 0 0  0 1 0\nshape box .6 .6 .9\n",
     0, 0},
    {"Direct3D's parallel projection",
     "viewport 100 75\ndepth less\nmode projection\n"
     "orthod3d -2 1.5 -1 1.2 -4 9\nmode modelview\n"
     "rotate 40 1 1 0\nshape box .6 .6 .9\n",
     0, 0},
    {"windows",
     STAGE LOOK "window 0 0 50 75\nshape torus .8 .3 24 12\nwindow 30 -10 90 60\n"
                "shape box .7 .7 .7\nwindow 50 5 45 30 bottom\n"
                "shape sphere 3 16 12 color .4 .8 1\n",
     0, 0},
    {"lines in windows",
     STAGE LOOK "window 10 20 51 33\npolygon line\nshape box 2 .7 .7\n"
                "linewidth 5\nlinesmooth off\n"
                "line -3 -2 0 1 1 0 0  3 2 0 1 0 1 0\n",
     2, 0},
    {"smooth lines",
     STAGE "polygon smooth\n" LOOK "cull back\nrotate 50 1 0 0\nshape torus .8 .4 9 6\n", 8, 49},
    {"wide lines", STAGE "linewidth 3\npolygon wide\n" LOOK "cull back\nshape box .8 .6 1\n", 0, 5},
    {"wide hard lines of a soup",
     STAGE "linewidth 2.5\nlinesmooth off\nlinecap square\npolygon wide\n" LOOK
           "shade flat\ncull back\nrotate 50 1 0 0\nshape torus .8 .4 9 6 color 1 .6 .3\n",
     3, 0},
    {"hidden lines", STAGE "polygon hidden .003\n" LOOK "rotate 50 1 0 0\nshape torus .8 .4 16 8\n",
     2, 2},
    {"hidden lines, farther is nearer",
     "viewport 100 75\ncleardepth 0\ndepth greater\npolygon hidden .01\nmode projection\n"
     "ortho -1.5 1.5 -1.2 1.2 -2 2\nmode modelview\nrotate 30 1 1 0\nshape torus .8 .3 12 6\n",
     2, 2},
    {"colours of vertices", STAGE LOOK "mesh colors.obj color 0 0 0\n", 0, 0},
    {"colours of first vertices", STAGE "shade flat first\n" LOOK "mesh colors.obj\n", 0, 0},
    {"passes",
     STAGE GLASS "cull back\nwindow 0 0 70 75\n" LOOK "shape grid 2 3 2 2\n"
                 "pass\nblend alpha .5\ntexture 8 8 2 255 0 0 0 255 0\n" STATE LOOK CARD
                 "pass\n" STATE LOOK
                 "mesh colors.obj\ntri -1 0 .5 1 1 0 0 1 0 .5 1 1 0 0 0 1 .5 1 0 1 0\n",
     2, 20},
    {"morph", STAGE LOOK "morph .3 wave-0.obj wave-1.obj color 1 .7 .4\n", 0, 60},
    {"an end of a morph", STAGE LOOK "morph 1 wave-0.obj wave-1.obj\n", 0, 60},
    {"textured morph", STAGE GLASS LOOK "morph .3 wave-0.obj wave-1.obj\n", 1, 60},
    {"frames", STAGE LOOK "frames 2.5 wave-0.obj wave-1.obj wave-2.obj wave-3.obj\n", 0, 60},
    {"frames before the first", STAGE LOOK "frames -.25 wave-0.obj wave-1.obj wave-2.obj\n", 0, 60},
    {"targets", STAGE LOOK "targets wave-0.obj 1.5 wave-1.obj -.5 wave-2.obj\n", 0, 60},
    {"flat targets", STAGE LOOK "shade flat\ntargets wave-0.obj 40 wave-1.obj -30 wave-2.obj\n", 24,
     60},
    {"morph hidden lines", STAGE "polygon hidden .003\n" LOOK "morph .3 wave-0.obj wave-1.obj\n", 2,
     4},
    {"argb4444", STAGE GLASS "texformat argb4444\ntexalpha 200 30\nblend alpha .8\n" LOOK BACK CARD,
     0, 6},
    {"argb1555", STAGE GLASS "texformat argb1555\ntexalpha 200 30\nblend alpha\n" LOOK BACK CARD, 0,
     6},
    {"argb8888", STAGE GLASS "texformat argb8888\ntexalpha 99 190\nblend add .9\n" LOOK BACK CARD,
     0, 110},
    {"alpha8", STAGE GLASS "texformat alpha8\ntexalpha 99 190\nblend alpha\n" LOOK BACK CARD, 0, 6},
    {"filtered alpha",
     STAGE GLASS
     "texformat argb8888\ntexalpha 255 0\nblend alpha\ntexfilter bilinear\n" LOOK BACK CARD,
     0, 0},
    {"filtered alpha, multiplied",
     STAGE GLASS
     "texformat argb8888\ntexalpha 255 10\nblend multiply\ntexfilter bilinear\n" LOOK BACK CARD,
     0, 0},
    {"mipmaps with alpha",
     STAGE GLASS "texformat argb4444\ntexalpha 255 40\nblend alpha\n"
                 "texfilter bilinear mipmaps\n" LOOK BACK "rotate 70 1 0 0\n" CARD,
     0, 48},
    {"alpha test",
     STAGE GLASS "texformat argb8888\ntexalpha 100 99\nalphatest 100\n" LOOK BACK CARD, 5, 0},
    /* Row 37 lies on the edge of texels, where alpha is half: any error shows. */
    {"filtered alpha test",
     STAGE GLASS
     "texformat alpha8\ntexalpha 0 255\nalphatest 128\ntexfilter bilinear\n" LOOK BACK CARD,
     17, 0},
    {"alpha test with a blend",
     STAGE GLASS "texformat argb4444\ntexalpha 20 200\nalphatest 100\nblend alpha\n" LOOK BACK CARD,
     5, 0},
    {"screen door of texels",
     STAGE GLASS "texformat argb8888\ntexalpha 60 200\nblend screendoor .9\n" LOOK BACK CARD, 3, 0},
    {"alpha without a blend",
     STAGE GLASS "texformat argb1555\ntexalpha 0 255\ntexfilter bilinear\n" LOOK BACK CARD, 0, 1},
};

static struct scene parse(const char *text)
{
    struct scene scene;
    struct text_error error;
    if (!scene_parse(io_path("x.scene"), text, strlen(text), &scene, &error)) {
        fail_msg("%s", error.message);
    }
    return scene;
}

static void assert_same_in_bands(const struct scene *scene, const struct picture *whole)
{
    const size_t pixels = (size_t)scene->width * (size_t)scene->height;
    struct picture banded;
    assert_true(scene_render(scene, &qtri_xrgb8888, 7, true, &banded));
    assert_memory_equal(whole->rgb, banded.rgb, 3 * pixels);
    assert_memory_equal(whole->id, banded.id, pixels * sizeof *whole->id);
    assert_memory_equal(whole->depth, banded.depth, pixels * sizeof *whole->depth);
    picture_free(&banded);
}

TEST(pictures)
{
    int failed = 0;
    for (size_t i = 0; i < ARRAY_LENGTH(cases); i++) {
        struct scene scene = parse(cases[i].text);
        struct reference_image image;
        struct picture picture;
        struct accuracy off = {0};
        assert_true(scene_render(&scene, &qtri_xrgb8888, 0, true, &picture));
        /* Texture coordinates are those of vertices that are not snapped. */
        assert_true(reference_render(&scene, scene.texture.width > 0 ? 0 : 8, &image));
        accuracy_add(&off, &picture, &image, true);
        const unsigned long long seen = off.covered, coverage = off.coverage,
                                 other = off.other_triangle, color = off.color_above_1;
        const bool ok =
            seen >= 200 && coverage + other <= cases[i].coverage && color <= cases[i].off;
        failed += !ok;
        if (!ok || getenv("QTRI_VERBOSE") != NULL) {
            print_message("%s: %llu pixels, %llu in one only, %llu others, %llu off, %d at most\n",
                          cases[i].name, seen, coverage, other, color, off.max_color);
        }
        assert_same_in_bands(&scene, &picture);
        picture_free(&picture);
        reference_free(&image);
        scene_free(&scene);
    }
    assert_int_equal(failed, 0);
}

/* ---- Random scenes ---- */

static uint32_t random_state;

/* low..high in steps of 1/1000. */
static double between(double low, double high)
{
    random_state = random_state * 1664525u + 1013904223u;
    return low + (high - low) * (random_state >> 12) / 1048575.0;
}

struct text {
    char bytes[8192];
    size_t length;
};

/* Each % of the format becomes a number of -1..1. */
static void add(struct text *text, const char *format)
{
    for (; *format != '\0'; format++) {
        const size_t room = sizeof text->bytes - text->length;
        assert_true(room > 32);
        text->length +=
            *format == '%'
                ? (size_t)snprintf(text->bytes + text->length, room, "%.3f", between(-1, 1))
                : (size_t)snprintf(text->bytes + text->length, room, "%c", *format);
    }
}

static const char *pick(const char *const *words, int count)
{
    return words[(int)between(0, count - .001)];
}

static void add_object(struct text *text)
{
    static const char *const poses[] = {
        "translate % % %\nquaternion % % % %\n",
        "rotateabout 80 % % % % % %\n",
        "rotatetriangle 130 % % % % % % % % %\n",
        "translate % % %\nbillboard\n",
        "translate % % %\nbillboard upright\n",
        "key 0 % % % 40 % % 1 .8 1 .9\nkey 2 % % % -130 % % 1 1 .7 1\nkeys .7\n",
        "atjoint 0\n",
        "atjoint 1\n",
        "mult 1 .02 0 0 .01 1.1 0 0 0 .03 .9 0 0 0 0 1\northonormalize\n",
    };
    static const char *const shapes[] = {
        "shape box .5 .3 .6 color 1 .6 .2\n",
        "shape sphere .5 14 9 color .3 .6 1\n",
        "shape cylinder .4 .5 12\n",
        "shape cone .5 .6 11 color .8 1 .3\n",
        "shape torus .6 .2 18 8 color 1 1 .5\n",
        "shape grid .8 .9 4 5 color .5 1 .5\n",
        "morph .37 wave-0.obj wave-1.obj\n",
        "frames 2.2 wave-1.obj wave-2.obj wave-3.obj\n",
        "targets wave-0.obj .6 wave-1.obj .7 wave-2.obj\n",
    };
    add(text, "push\n");
    add(text, pick(poses, ARRAY_LENGTH(poses)));
    add(text, pick(shapes, ARRAY_LENGTH(shapes)));
    add(text, "pop\n");
}

static void add_scene(struct text *text)
{
    static const char *const cameras[] = {
        "mode projection\nperspective 60 1.33333333 .2 50\nmode modelview\norbit 0 0 0 3.5 25 30\n",
        "mode projection\nperspectived3d 50 1.33333333 .2 50\nmode modelview\n"
        "lookatd3d 1 1.5 -3  0 0 0  0 1 0\n",
        "mode projection\nfrustumd3d -.2 .16 -.13 .12 .2 50\nmode modelview\n"
        "lookatd3d 1 -1 3  0 0 0  0 1 0\n",
        "mode projection\northod3d -2 2 -1.5 1.5 -9 9\nmode modelview\norbit 0 0 0 0 200 70\n",
    };
    static const char *const states[] = {"cull back\n", "shade flat\n", "frustumcull box\n",
                                         "frustumcull ball\n", "twosided on\n"};
    static const char *const windows[] = {"", "window 10 5 70 60\n", "window -20 8 90 60 bottom\n"};
    add(text, "viewport 100 75\nclear .1 .12 .2\ndepth less\nlight .4 .6 .7 .2 .8\n");
    add(text, pick(states, ARRAY_LENGTH(states)));
    add(text, pick(windows, ARRAY_LENGTH(windows)));
    add(text, "push\nidentity\ntranslate % % %\nrotate 50 % % 1\njoint none\nidentity\n"
              "rotate 70 1 % %\ntranslate % % 0\njoint 0\npop\n");
    add(text, pick(cameras, ARRAY_LENGTH(cameras)));
    add(text, "camera\n");
    for (int i = 0; i < 6; i++) {
        add_object(text);
    }
}

/*
 * With vertices on the core's grid: what differs are pixels where surfaces cross, edges of vertices
 * that were rounded the other way, and the light of morphed normals, which have 8 bits.
 */
TEST(random_statements)
{
    struct accuracy off = {0};
    for (uint32_t seed = 1; seed <= 40; seed++) {
        struct text text = {{0}, 0};
        struct reference_image image;
        struct picture picture;
        random_state = seed * 2654435761u;
        add_scene(&text);
        struct scene scene = parse(text.bytes);
        assert_true(scene_render(&scene, &qtri_xrgb8888, 0, true, &picture));
        assert_true(reference_render(&scene, 8, &image));
        accuracy_add(&off, &picture, &image, true);
        assert_same_in_bands(&scene, &picture);
        picture_free(&picture);
        reference_free(&image);
        scene_free(&scene);
    }
    print_message("%llu pixels, %llu in one only, %llu others, %llu colours off, %d at most\n",
                  (unsigned long long)off.covered, (unsigned long long)off.coverage,
                  (unsigned long long)off.other_triangle, (unsigned long long)off.color_above_1,
                  off.max_color);
    assert_true(off.covered > 40000);
    assert_true(off.coverage * 5000 <= off.covered);
    assert_true(off.other_triangle * 5000 <= off.covered);
    assert_true(off.color_above_1 * 2000 <= off.covered);
}

/* Direct3D's forms show what OpenGL's do, in windows counted from either end. */
TEST(both_conventions)
{
    static const char *const texts[2] = {
        "viewport 100 75\ndepth less\nwindow 20 10 60 45\nmode projection\n"
        "perspective 50 1.3 .5 20\nmode modelview\nlookat 1 1 4  0 .2 0  0 1 0\n"
        "tri -1 -1 0 1 1 0 0  1 -1 .5 1 0 1 0  0 1 -.5 1 0 0 1\n"
        "tri -1 0 .5 1 1 1 0  1 .2 -1 1 0 1 1  0 1 1 1 1 0 1\n",
        "viewport 100 75\ndepth less\nwindow 20 20 60 45 bottom\nmode projection\n"
        "perspectived3d 50 1.3 .5 20\nmode modelview\nlookatd3d 1 1 -4  0 .2 0  0 1 0\n"
        "tri -1 -1 0 1 1 0 0  1 -1 -.5 1 0 1 0  0 1 .5 1 0 0 1\n"
        "tri -1 0 -.5 1 1 1 0  1 .2 1 1 0 1 1  0 1 -1 1 1 0 1\n"};
    struct picture picture[2];
    for (int i = 0; i < 2; i++) {
        struct scene scene = parse(texts[i]);
        assert_true(scene_render(&scene, &qtri_rgb565, 0, true, &picture[i]));
        scene_free(&scene);
    }
    assert_memory_equal(picture[0].rgb, picture[1].rgb, 3 * 100 * 75);
    assert_memory_equal(picture[0].id, picture[1].id, sizeof *picture[0].id * 100 * 75);
    picture_free(&picture[0]);
    picture_free(&picture[1]);
}

TEST(windows_are_clipped)
{
    struct scene scene = parse("viewport 60 40\nwindow 10 5 20 30\nmode modelview\n"
                               "tri -9 -9 0 1 1 1 1  9 -9 0 1 1 1 1  0 9 0 1 1 1 1\n"
                               "linewidth 9\nline -1 -1 0 1 1 1 1  1 1 0 1 1 1 1\n");
    struct picture picture;
    assert_true(scene_render(&scene, &qtri_xrgb8888, 0, false, &picture));
    for (int y = 0; y < 40; y++) {
        for (int x = 0; x < 60; x++) {
            const bool inside = x >= 10 && x < 30 && y >= 5 && y < 35;
            assert_int_equal(picture.rgb[3 * (60 * y + x)], inside ? 255 : 0);
        }
    }
    picture_free(&picture);
    scene_free(&scene);
}

static const char colored[] = "v -1 -1 0 1 0 0\nv 1 -1 0 0 1 0\nv 1 1 .5 0 0 1\nv -1 1 0\n"
                              "f 1 2 3\nf 1 3 4\n";

static int setup(void **state)
{
    struct text_error error;
    if (io_setup(state) != 0 || !demo_write_waves(io_folder, &error)) {
        return -1;
    }
    io_write("colors.obj", colored, sizeof colored - 1);
    return 0;
}

int main(void)
{
    return run_all_tests(setup, io_teardown);
}
