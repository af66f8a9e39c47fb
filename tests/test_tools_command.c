/* SPDX-License-Identifier: MIT */
/*
 * The command as a user meets it: exit statuses, messages, and what is left on disk.
 */
#define _POSIX_C_SOURCE 200809L

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include "support/test.h"

#ifdef __SANITIZE_ADDRESS__
#define SANITIZED
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define SANITIZED
#endif
#endif

static char folder[512];

/* Runs `qtri ARGUMENTS` in the test's folder, standard error into the file `messages`. */
static int run(const char *arguments)
{
    char line[2048];
    const char *command = getenv("QTRI_COMMAND");
    snprintf(line, sizeof line, "cd '%s' && '%s' %s >output 2>messages", folder, command,
             arguments);
    int status = system(line); /* NOLINT(cert-env33-c): a test of the command line */
    assert_true(WIFEXITED(status));
    return WEXITSTATUS(status);
}

static void path_of(char *path, size_t size, const char *name)
{
    snprintf(path, size, "%s/%s", folder, name);
}

static void write_file(const char *name, const char *text)
{
    char path[1024];
    path_of(path, sizeof path, name);
    FILE *file = fopen(path, "wb");
    assert_non_null(file);
    assert_true(fputs(text, file) >= 0);
    assert_int_equal(fclose(file), 0);
}

static bool exists(const char *name)
{
    char path[1024];
    path_of(path, sizeof path, name);
    return access(path, F_OK) == 0;
}

static bool file_contains(const char *name, const char *text)
{
    char path[1024];
    char content[4096];
    path_of(path, sizeof path, name);
    FILE *file = fopen(path, "rb");
    assert_non_null(file);
    size_t length = fread(content, 1, sizeof content - 1, file);
    content[length] = '\0';
    fclose(file);
    return strstr(content, text) != NULL;
}

static bool messages_contain(const char *text)
{
    return file_contains("messages", text);
}

static const char triangle[] = "viewport 64 48\ndepth less\n"
                               "tri -.5 -.5 0 1 1 0 0  .5 -.5 0 1 0 1 0  0 .5 0 1 0 0 1\n";

TEST(usage_errors)
{
    assert_int_equal(run(""), 2);
    assert_int_equal(run("nonsense"), 2);
    assert_int_equal(run("render"), 2);
    assert_int_equal(run("render a.scene"), 2);
    assert_int_equal(run("render a.scene -o"), 2);
    assert_int_equal(run("render a.scene -o x --format cmyk"), 2);
    assert_int_equal(run("render a.scene -o x --rows -1"), 2);
    assert_int_equal(run("render a.scene -o x --snap 17 --reference"), 2);
    assert_int_equal(run("render a.scene -o x --frobnicate"), 2);
    assert_true(messages_contain("--frobnicate"));
    assert_int_equal(run("pipelines"), 2);
    assert_int_equal(run("pipelines a.scene --format cmyk"), 2);
    assert_int_equal(run("compare one.ppm"), 2);
    assert_int_equal(run("mesh knot"), 2);
    assert_int_equal(run("mesh dodo -o x.obj"), 2);
    assert_int_equal(run("neighbours x.obj"), 2);
    assert_int_equal(run("demo --frobnicate"), 2);
    assert_false(exists("x.obj"));
}

TEST(help)
{
    assert_int_equal(run("--help"), 0);
    assert_int_equal(run("render --help"), 0);
    assert_true(file_contains("output", "texfilter    nearest|bilinear [mipmaps]\n"));
    assert_int_equal(run("pipelines --help"), 0);
    assert_int_equal(run("compare --help"), 0);
    assert_int_equal(run("mesh --help"), 0);
    assert_int_equal(run("neighbours --help"), 0);
    assert_int_equal(run("demo --help"), 0);
}

TEST(bad_input)
{
    write_file("bad.scene", "viewport 64 48\ntri 1 2 3\n");
    assert_int_equal(run("render bad.scene -o bad --dump"), 1);
    assert_true(messages_contain("bad.scene:2"));
    assert_false(exists("bad.ppm"));
    assert_false(exists("bad.id"));
    assert_int_equal(run("render missing.scene -o bad"), 1);
    assert_int_equal(run("pipelines bad.scene"), 1);
    assert_int_equal(run("pipelines missing.scene"), 1);
    assert_int_equal(run("compare missing.ppm missing.ppm"), 1);
    write_file("good.scene", triangle);
    assert_int_equal(run("render good.scene -o no/such/folder/x"), 1);
    assert_int_equal(run("mesh knot -o no/such/folder/x.obj"), 1);
    assert_int_equal(run("demo --scenes no/such/folder -o demo"), 1);
}

TEST(formats_and_bands)
{
    static const char *const formats[] = {"rgb888", "rgb565", "gray8"};
    write_file("good.scene", triangle);
    for (size_t i = 0; i < 3; i++) {
        char line[256];
        snprintf(line, sizeof line, "render good.scene -o whole --dump --format %s", formats[i]);
        assert_int_equal(run(line), 0);
        snprintf(line, sizeof line, "render good.scene -o bands --dump --rows 7 --format %s",
                 formats[i]);
        assert_int_equal(run(line), 0);
        assert_int_equal(run("compare whole.ppm bands.ppm"), 0);
        snprintf(line, sizeof line, "render good.scene -o expected --dump --reference --format %s",
                 formats[i]);
        assert_int_equal(run(line), 0);
        assert_int_equal(run("compare whole.ppm expected.ppm --max-color 9 --max-depth .51"), 0);
    }
    assert_int_equal(run("compare whole.ppm expected.ppm --max-depth 0"), 1);
}

/* A model of a few thousandths, as it is and fitted: core and reference draw the same of both. */
TEST(small_models)
{
    write_file("small.obj", "v -4e-5 -3e-5 0\nv 4e-5 -3e-5 0\nv 0 4e-5 0\nv 0 0 5e-5\n"
                            "f 1 2 4\nf 2 3 4\nf 3 1 4\n");
    write_file("one.obj", "v -.8 -.6 0\nv .8 -.6 0\nv 0 .8 0\nv 0 0 1\n"
                          "f 1 2 4\nf 2 3 4\nf 3 1 4\n");
    static const char *const mesh[] = {"one.obj", "small.obj fit 1.6", "small.obj scale 20000",
                                       "small.obj"};
    for (size_t i = 0; i < 4; i++) {
        char text[256];
        snprintf(text, sizeof text,
                 "viewport 64 48\ndepth less\nlight 0 .6 .8 .2 .8\northo -1 1 -1 1 -1 1\nmesh %s\n",
                 mesh[i]);
        write_file("s.scene", text);
        assert_int_equal(
            run(i == 0 ? "render s.scene -o whole --dump" : "render s.scene -o small --dump"), 0);
        assert_int_equal(run("render s.scene -o expected --dump --reference"), 0);
        if (i > 0) {
            assert_int_equal(run("compare whole.ppm small.ppm"), i < 3 ? 0 : 1);
        }
        snprintf(text, sizeof text, "compare %s.ppm expected.ppm --max-depth 8",
                 i == 0 ? "whole" : "small");
        assert_int_equal(run(text), 0);
    }
}

TEST(generated_mesh)
{
    assert_int_equal(run("mesh torus -o torus.obj"), 0);
    write_file("torus.scene", "viewport 80 60\ndepth less\nlight 0 0 1 .2 .8\n"
                              "mode projection\nperspective 60 1.333 .1 100\nmode modelview\n"
                              "translate 0 0 -4\nmesh torus.obj color 1 .5 0\n");
    assert_int_equal(run("render torus.scene -o torus --dump"), 0);
    assert_int_equal(run("render torus.scene -o expected --dump --reference --snap 8"), 0);
    assert_int_equal(run("compare torus.ppm expected.ppm --max-color 1 --max-depth .52"), 0);
}

/* The output's name says which format; what shows nothing says so. */
TEST(pictures)
{
    write_file("good.scene", triangle);
    assert_int_equal(run("render good.scene -o named.ppm --dump"), 0);
    assert_true(exists("named.ppm") && exists("named.id") && exists("named.depth"));
    assert_false(exists("named.ppm.ppm"));
    assert_false(messages_contain("background"));
    assert_int_equal(run("render good.scene -o plain"), 0);
    assert_int_equal(run("compare named.ppm plain.ppm"), 0);
    if (run("render good.scene -o named.png --dump") != 0) {
        assert_true(messages_contain("was built without libpng"));
    } else {
        assert_int_equal(run("compare named.ppm named.png --max-depth 0 -o difference.png"), 0);
        assert_true(exists("difference.png"));
        assert_int_equal(run("compare named.png - -o - <named.ppm"), 0);
        assert_true(messages_contain("pixels-differing     0"));
        assert_true(file_contains("output", "P6\n64 48\n255\n"));
    }
    static const char *const ways[] = {"", "--format rgb565", "--format gray8", "--reference"};
    write_file("empty.scene", "viewport 64 48\nclear .3 .7 .2\n"
                              "tri 5 5 0 1 1 0 0  6 5 0 1 0 1 0  5 6 0 1 0 0 1\n");
    for (size_t i = 0; i < sizeof ways / sizeof ways[0]; i++) {
        char line[128];
        snprintf(line, sizeof line, "render empty.scene -o empty %s", ways[i]);
        assert_int_equal(run(line), 0);
        assert_true(messages_contain("empty.scene: nothing is seen in the picture"));
    }
}

/* A mesh's neighbours as C. */
TEST(neighbours)
{
    write_file("two.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\n");
    assert_int_equal(run("neighbours two.obj -o two.h"), 0);
    assert_true(
        file_contains("two.h", "two_neighbours[2][3] = {\n    {2, 2, 1},\n    {0, 2, 2},\n"));
    assert_int_equal(run("neighbours - -o - --name other <two.obj"), 0);
    assert_true(file_contains("output", "other_neighbours[2][3] = {"));
    assert_int_equal(run("neighbours none.obj -o none.h"), 1);
    assert_false(exists("none.h"));
}

/* Every texel format, wrapped, filtered and with holes: as the reference draws it. */
TEST(textures)
{
    static const char *const formats[] = {"xrgb8888", "rgb565", "palette", "palette565", "gray8"};
    for (int n = 0; n < 20; n++) {
        char text[1024];
        snprintf(text, sizeof text,
                 "viewport 90 70\ndepth less\ntexture 8 16 4 255 40 0 20 90 200\n"
                 "texformat %s\ntexfilter %s\ntexwrap repeat clamp\ntexkey %s\n"
                 "tri -.9 -.5 .3 1 1 0 0  .5 -.9 .3 1 0 1 0  0 .8 .3 1 0 0 1\n"
                 "trit -1 -1 0 1 1 .5 0 -.4 -.3   1.8 -1 .2 2 0 1 1 1.1 -.2"
                 "   0 1 0 1 1 1 1 .3 1.4\n",
                 formats[n % 5], n / 5 % 2 ? "bilinear" : "nearest", n / 10 ? "20 90 200" : "off");
        write_file("t.scene", text);
        assert_int_equal(run("render t.scene -o t --dump"), 0);
        assert_int_equal(run("render t.scene -o expected --dump --reference --snap 8"), 0);
        assert_int_equal(
            run("compare t.ppm expected.ppm --max-color 1 --max-pixels 3 --max-depth .52"), 0);
    }
}

/* Runs a line of the shell in the test's folder; $qtri is the command. Returns its status. */
static int shell(const char *line)
{
    char all[2048];
    snprintf(all, sizeof all, "cd '%s' && qtri='%s' && { %s; } 2>messages", folder,
             getenv("QTRI_COMMAND"), line);
    int status = system(all); /* NOLINT(cert-env33-c): a test of the command line */
    assert_true(WIFEXITED(status));
    return WEXITSTATUS(status);
}

/* What a picture is drawn from is never replaced by it. */
TEST(inputs_are_kept)
{
    write_file("in.ppm", triangle);
    assert_int_equal(run("render in.ppm -o in"), 1);
    assert_true(messages_contain("would be overwritten"));
    assert_true(file_contains("in.ppm", "viewport 64 48"));
    write_file("good.scene", triangle);
    assert_int_equal(shell("ln -sf good.scene link.ppm; $qtri render good.scene -o link"), 1);
    assert_true(file_contains("good.scene", "viewport 64 48"));
    assert_int_equal(run("render good.scene -o image"), 0);
    write_file("t.scene", "viewport 8 8\ntexture image.ppm\n");
    assert_int_equal(shell("printf 'P6 2 2 255 123456789012' >image.ppm; cp image.ppm before.ppm;"
                           "$qtri render t.scene -o image"),
                     1);
    assert_int_equal(shell("cmp image.ppm before.ppm"), 0);
    assert_int_equal(run("render t.scene -o other"), 0);
    /* A link is followed: the picture behind it is replaced, and not the link. */
    assert_int_equal(shell("ln -sf other.ppm alias.ppm; $qtri render good.scene -o alias"), 0);
    assert_int_equal(shell("test -L alias.ppm && cmp alias.ppm other.ppm"), 0);
}

/* What the other commands read, what a scene names, and what comes by standard input, is kept as
   well: by its own name, beside the picture, or as a preview. */
TEST(inputs_of_all_commands_are_kept)
{
    static const char *const lines[] = {
        "mesh m.obj -o m.obj",        "mesh m.obj -o n.h --preview link.ppm",
        "texture t.ppm -o t.ppm",     "font f.h -o f.h",
        "neighbours m.obj -o m.obj",  "compare t.ppm t.ppm -o t.ppm",
        "render s.scene -o d --dump", "render e.scene -o e --dump",
        "render - -o t.ppm <t.ppm",
    };
    assert_int_equal(shell("mkdir kept; cd kept; $qtri mesh cube -o m.obj"), 0);
    write_file("kept/e.scene", triangle);
    write_file("kept/s.scene", "viewport 8 8\nmesh d.id\n");
    write_file("kept/f.h",
               "STARTFONT 2.1\nFONT_ASCENT 8\nFONT_DESCENT 2\nSTARTCHAR x\nENCODING 65\n"
               "DWIDTH 6 0\nBBX 3 1 0 0\nBITMAP\nFF\nENDCHAR\nENDFONT\n");
    assert_int_equal(
        shell("cd kept; cp m.obj d.id; ln e.scene e.depth; ln -s m.obj link.ppm;"
              "$qtri render e.scene -o t.ppm; mkdir copy; cp m.obj d.id e.scene t.ppm f.h copy"),
        0);
    for (size_t i = 0; i < sizeof lines / sizeof lines[0]; i++) {
        char line[512];
        /* The last is a scene that comes from the file its picture would replace. */
        snprintf(line, sizeof line, "cd kept; %s $qtri %s", i == 8 ? "cp e.scene t.ppm;" : "",
                 lines[i]);
        assert_int_equal(shell(line), 1);
        assert_true(messages_contain("would be overwritten"));
        assert_int_equal(shell(i == 8 ? "cmp kept/t.ppm kept/e.scene"
                                      : "cd kept/copy; for f in *; do cmp $f ../$f || exit; done"),
                         0);
        assert_false(exists("kept/e.id"));
        assert_false(exists("kept/n.h"));
    }
}

/* Each frame is the picture of its moment; one file of all; what was drawn when Ctrl-C came. */
TEST(animations)
{
    write_file("turn.scene", "viewport 32 24\nclear $t 0 0\nrotate 90*$t 0 0 1\n"
                             "tri -.5 -.5 0 1 1 0 0  .5 -.5 0 1 0 1 0  0 .5 0 1 0 0 1\n");
    assert_int_equal(run("render turn.scene -o t.ppm --frames 5"), 0);
    for (int i = 0; i < 5; i++) {
        char line[256];
        snprintf(line, sizeof line,
                 "$qtri render turn.scene -o one --at %g && cmp one.ppm t-%04d.ppm", i / 4.0, i);
        assert_int_equal(shell(line), 0);
    }
    assert_false(exists("t-0005.ppm"));
    assert_int_equal(shell("$qtri render turn.scene -o - --frames 3 --fps 50 >v.y4m && "
                           "head -n 1 v.y4m | grep -q '^YUV4MPEG2 W32 H24 F50:1 ' && "
                           "test $(wc -c <v.y4m) = $(($(head -n 1 v.y4m | wc -c) + "
                           "3 * (6 + 3 * 32 * 24)))"),
                     0);
    assert_int_equal(run("render turn.scene -o a.apng --frames 4"), 0);
    assert_int_equal(shell("head -c 45 a.apng | tail -c 12 | od -An -tx1 | tr -d ' \\n' | "
                           "grep -q 6163544c00000004"), /* acTL, 4 frames */
                     0);
    assert_int_equal(shell("$qtri render turn.scene -o one.png && $qtri texture one.png -o one.h"),
                     0);
    assert_int_equal(run("render turn.scene -o a --frames 0"), 2);
    assert_int_equal(run("render turn.scene -o a --frames 2 --dump"), 2);
    assert_int_equal(run("render - -o a --frames 2"), 2);
    assert_int_equal(run("render turn.scene -o a.gif --frames 2"), 2);
    assert_int_equal(run("render turn.scene -o a --at 1.5"), 2);
    assert_int_equal(run("render turn.scene -o no/such/folder/x.png --frames 2"), 1);
    write_file("bad.scene", "rotate 1/(1-2*$t) 0 0 1\n");
    assert_int_equal(run("render bad.scene -o bad.apng --frames 3"), 1);
    assert_true(messages_contain("bad.scene:1: rotate: '1/(1-2*$t)' is divided by 0 (column 18)"));
    assert_int_equal(shell("timeout --preserve-status -s INT 1 $qtri render turn.scene -o i.apng "
                           "--frames 100000; test $? = 1 && test -s i.apng && tail -c 8 i.apng | "
                           "head -c 4 | grep -q IEND"),
                     0);
    assert_true(messages_contain("of 100000 frames"));
}

/* Standard input and output, pipes and devices. */
TEST(streams)
{
    write_file("good.scene", triangle);
    assert_int_equal(run("render good.scene -o wanted"), 0);
    assert_int_equal(shell("$qtri render good.scene -o - >a && cmp a wanted.ppm"), 0);
    assert_int_equal(shell("$qtri render good.scene -o /dev/stdout | cmp - wanted.ppm"), 0);
    assert_int_equal(shell("$qtri render good.scene -o /dev/stdout >b && cmp b wanted.ppm"), 0);
    assert_int_equal(shell("$qtri render - -o c <good.scene && cmp c.ppm wanted.ppm"), 0);
    assert_int_equal(shell("mkfifo in out; cat good.scene >in & cat out >d &"
                           "$qtri render in -o out && wait && cmp d wanted.ppm"),
                     0);
    assert_int_equal(shell("$qtri mesh knot -o - >e && test -s e"), 0);
    assert_int_equal(run("render good.scene -o - --dump"), 2);
    assert_int_equal(run("mesh knot -o no/such/folder.obj"), 1);
}

/* A pipe that nobody writes to is an error after some seconds, and no reason to wait for ever. */
TEST(silent_pipe)
{
    assert_int_equal(shell("mkfifo silent; timeout 30 $qtri render silent -o x"), 1);
    assert_true(messages_contain("silent: cannot be read"));
}

/* Status 1 where standard output is full. */
TEST(full_output)
{
    if (access("/dev/full", W_OK) != 0) {
        skip();
    }
    write_file("good.scene", triangle);
    assert_int_equal(shell("$qtri --help >/dev/full"), 1);
    assert_true(messages_contain("standard output"));
    assert_int_equal(shell("$qtri render --help >/dev/full"), 1);
    assert_int_equal(shell("$qtri render good.scene -o - >/dev/full"), 1);
    assert_int_equal(shell("$qtri render good.scene -o /dev/full"), 1);
    assert_int_equal(shell("$qtri mesh knot -o - >/dev/full"), 1);
    assert_int_equal(shell("$qtri render good.scene -o p && $qtri compare p.ppm p.ppm >/dev/full"),
                     1);
}

/* Ended by a signal in the middle of a file: neither a part nor half a picture is left. */
TEST(ended_by_signals)
{
    write_file("large.scene", "viewport 4096 4096\n");
    static const char *const signals[] = {"TERM", "INT", "HUP"};
    for (int n = 0; n < 12; n++) {
        char line[512];
        /* The shell's background jobs ignore INT: env gives it back. */
        snprintf(line, sizeof line,
                 "rm -f large.ppm; timeout --preserve-status -s %s .%02d $qtri render large.scene "
                 "-o large; test -z \"$(find . -name '.qtri-*.part')\" && "
                 "{ test ! -e large.ppm || test $(wc -c <large.ppm) = 50331665; }",
                 signals[n % 3], 6 * n + 2);
        assert_int_equal(shell(line), 0);
    }
    /* For certain: the disk is slower than any limit on a file's size. */
    assert_int_equal(shell("rm -f large.ppm; (ulimit -f 64; $qtri render large.scene -o large);"
                           "test ! -e large.ppm && test -z \"$(find . -name '.qtri-*.part')\""),
                     0);
}

/* Files that a scene names, and where they may be. */
TEST(files_below)
{
    write_file("image.ppm", "P6 2 2 255 123456789012");
    assert_int_equal(shell("mkdir -p sub/deep && cp image.ppm sub/deep/"), 0);
    write_file("sub/up.scene", "viewport 8 8\ntexture ../image.ppm\n");
    write_file("sub/down.scene", "viewport 8 8\ntexture deep/../deep/image.ppm\n");
    write_file("sub/link.scene", "viewport 8 8\ntexture link.ppm\n");
    write_file("sub/any.scene", "viewport 8 8\nmesh /etc/passwd\n");
    assert_int_equal(run("render sub/up.scene -o x"), 1);
    assert_true(messages_contain("not below the scene's folder"));
    assert_int_equal(run("render sub/up.scene -o x --allow-files"), 0);
    assert_int_equal(run("render sub/down.scene -o x"), 0);
    assert_int_equal(shell("ln -sf ../image.ppm sub/link.ppm; $qtri render sub/link.scene -o x"),
                     1);
    assert_int_equal(run("render sub/any.scene -o x"), 1);
    assert_true(messages_contain("not below the scene's folder"));
    assert_int_equal(shell("cd sub && $qtri render up.scene -o x"), 1);
    assert_int_equal(shell("cd sub && $qtri render down.scene -o x"), 0);
}

/* What 31 bytes can ask for. */
TEST(memory_of_references)
{
    write_file("large.scene", "viewport 4096 4096\n");
    assert_int_equal(run("render large.scene -o x --reference"), 1);
    assert_true(messages_contain("--large"));
    write_file("within.scene", "viewport 4096 1024\n");
    assert_int_equal(run("render within.scene -o x --reference"), 0);
}

/* Scenes of one folder share meshes that are made for each of them: no input is overwritten. */
TEST(demo_makes_its_meshes_anew)
{
    assert_int_equal(shell("mkdir none && $qtri demo --scenes none --only 12- -o waves"), 0);
    assert_true(exists("waves/12-morph.ppm"));
    assert_true(exists("waves/12-targets.ppm"));
    assert_int_equal(shell("rm -r none waves"), 0);
}

/* One page with all pictures in it, and what scenes say of themselves; nothing is fetched. */
TEST(demo_page)
{
    char text[400];
    (void)snprintf(text, sizeof text, "# Less < more & none.\r\n# crop 3 4\n# qtri render it\n%s",
                   triangle);
    assert_int_equal(shell("mkdir page"), 0);
    write_file("page/good.scene", text);
    write_file("page/bare.scene", "#");
    assert_int_equal(shell("$qtri demo --scenes page -o page --only bare.s"), 0);
    assert_true(file_contains("page/index.html", "<!DOCTYPE html>"));
    assert_int_equal(shell("cd page && test $(grep -c '<section' index.html) = 1 && "
                           "! grep -q 'http' index.html && grep -q 'id=\"bare\"' index.html && "
                           "test $(grep -o 'src=\"data:image/png;base64,' index.html | wc -l) = 3"),
                     0);
    assert_int_equal(shell("$qtri demo --scenes page -o page --only good.s && cd page && "
                           "grep -q '<p> Less &lt; more &amp; none.' index.html && "
                           "! grep -q 'qtri render it' index.html && "
                           "grep -q 'left:-18px;top:-24px' index.html && "
                           "grep -o 'base64,[^\"]*' index.html | head -n 1 | cut -c 8- | "
                           "base64 -d | head -c 4 | grep -q PNG && rm -r ../page"),
                     0);
}

/* A program in a folder below its sources finds their scenes wherever it is called. */
/* Two pictures, the line between them and a histogram of all 3,072 pixels, in sections alone. */
TEST(demo_report)
{
    assert_int_equal(shell("mkdir -p report"), 0);
    write_file("report/one.scene", triangle);
    assert_int_equal(
        shell("$qtri demo --scenes report -o report --only one. --report report/parts"), 0);
    assert_int_equal(shell("cd report && test $(grep -c '<section id=\"one\"' parts) = 1 && "
                           "! grep -q '<html' parts && grep -q 'type=\"range\"' parts && "
                           "test $(grep -o 'src=\"data:image/png;base64,' parts | wc -l) = 2"),
                     0);
    assert_int_equal(
        shell("cd report && grep -o 'error of colour:[^\"]*' parts | "
              "awk '{ for (i = 5; i <= NF; i += 2) sum += $i } END { exit sum != 64 * 48 }'"),
        0);
    assert_int_equal(run("demo --scenes report -o report --only one. --report report/none/parts"),
                     1);
    assert_true(messages_contain("report/none/parts"));
    assert_int_equal(shell("rm -r report"), 0);
}

TEST(demo_from_any_folder)
{
    char line[4096];
    write_file("one.scene", triangle);
    snprintf(
        line, sizeof line,
        "cd '%s' && mkdir -p tree/build/deep tree/host/scenes && cp '%s' tree/build/deep/qtri && "
        "mv one.scene tree/host/scenes/ && cd / && '%s/tree/build/deep/qtri' demo --only one "
        ">'%s/output' 2>'%s/messages'",
        folder, getenv("QTRI_COMMAND"), folder, folder, folder);
    assert_int_equal(system(line), 0); /* NOLINT(cert-env33-c): a test of the command line */
    assert_true(file_contains("output", "\none  "));
    assert_true(exists("tree/build/demo/one-difference.ppm"));
    assert_false(exists("tree/build/demo/12-morph.ppm"));
    snprintf(line, sizeof line, "rm -rf '%s/tree'", folder);
    assert_int_equal(system(line), 0); /* NOLINT(cert-env33-c) */
}

/* A few lines that ask for minutes end when they are told to, and leave nothing behind. */
TEST(work_without_end)
{
    char text[16384] = "viewport 4096 4096\nantialias temporal\n";
    for (int i = 0; i < 200; i++) {
        strcat(text, "tri -1 -1 0 1 1 0 0  1 -1 0 1 0 1 0  0 1 0 1 0 0 1\n");
    }
    write_file("long.scene", text);
    assert_int_equal(run("--seconds 1 render long.scene -o long.ppm"), 1);
    assert_true(messages_contain("qtri render: not done after 1 seconds"));
    assert_false(exists("long.ppm"));
    assert_int_equal(run("--seconds"), 2);
    assert_int_equal(run("--seconds -1 render long.scene -o x"), 2);
    assert_true(messages_contain("--seconds wants a whole number"));
    assert_int_equal(run("--seconds 0 --help"), 0);
    assert_true(file_contains("output", "after 300 seconds"));
}

/*
 * Statements that make meshes hold one at a time: 40 spheres of 65,536 vertices, 5 MB each. Where a
 * sanitizer keeps what is freed nothing is measured.
 */
TEST(memory_of_many_shapes)
{
    char text[2048] = "viewport 8 8\n";
    for (int i = 0; i < 40; i++) {
        strcat(text, "shape sphere 1 255 255\n");
    }
    write_file("shapes.scene", text);
#ifdef SANITIZED
    assert_int_equal(run("render shapes.scene -o shapes.ppm"), 0);
#else
    char line[2048];
    snprintf(line, sizeof line,
             "ulimit -v 98304; cd '%s' && '%s' render shapes.scene -o shapes.ppm", folder,
             getenv("QTRI_COMMAND"));
    assert_int_equal(system(line), 0); /* NOLINT(cert-env33-c): in 96 MB, libraries among them */
#endif
}

static int make_folder(void **state)
{
    (void)state;
    const char *base = getenv("QTRI_TMP");
    snprintf(folder, sizeof folder, "%s/qtri-command-XXXXXX", base != NULL ? base : "/tmp");
    return mkdtemp(folder) == NULL;
}

int main(void)
{
    if (getenv("QTRI_COMMAND") == NULL) {
        puts("QTRI_COMMAND is not set: run `make test-plain TESTS=test_command`");
        return 1;
    }
    return run_all_tests(make_folder, NULL);
}
