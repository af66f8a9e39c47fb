/* SPDX-License-Identifier: MIT */
/*
 * PPM files and dumps.
 */
#define _XOPEN_SOURCE 700 /* setrlimit */
#include "support/io.h"

#include <signal.h>
#include <sys/resource.h>

#include "io/picture.h"

#define LITERAL(text) text, sizeof(text) - 1

static void read_all(const char *path, uint8_t *bytes, size_t length)
{
    FILE *file = fopen(path, "rb");
    assert_non_null(file);
    assert_int_equal(fread(bytes, 1, length, file), length);
    assert_int_equal(fgetc(file), EOF);
    (void)fclose(file);
}

static struct picture gradient(int width, int height, bool with_dump)
{
    struct picture picture;
    assert_true(picture_create(&picture, width, height, with_dump));
    for (int i = 0; i < width * height * 3; i++) {
        picture.rgb[i] = (uint8_t)(i * 7);
    }
    return picture;
}

TEST(create_zeroes_or_refuses)
{
    struct picture picture;
    assert_true(picture_create(&picture, 3, 2, true));
    for (int i = 0; i < 6; i++) {
        assert_int_equal(picture.rgb[3 * i] | picture.rgb[3 * i + 1] | picture.rgb[3 * i + 2], 0);
        assert_int_equal(picture.id[i], 0);
        assert_true(picture.depth[i] == 0.0);
    }
    picture_free(&picture);
    assert_null(picture.rgb);
    assert_true(picture_create(&picture, 1, 1, false));
    assert_null(picture.id);
    assert_null(picture.depth);
    picture_free(&picture);
    assert_false(picture_create(&picture, 0, 1, false));
    assert_false(picture_create(&picture, 1, -1, false));
    assert_false(picture_create(&picture, INT32_MAX, INT32_MAX, true));
    assert_null(picture.rgb);
}

TEST_WITH(ppm_bytes, NULL, io_remove_files)
{
    struct picture picture = gradient(2, 1, false);
    struct text_error error;
    assert_true(picture_write_ppm(io_path("a.ppm"), &picture, &error));
    uint8_t bytes[17];
    read_all(io_path("a.ppm"), bytes, sizeof bytes);
    assert_memory_equal(bytes, "P6\n2 1\n255\n\0\7\16\25\34\43", 17);
    assert_int_equal(io_count_files(), 1);
    picture_free(&picture);
}

TEST_WITH(ppm_round_trip, NULL, io_remove_files)
{
    struct picture written = gradient(31, 17, false);
    struct picture read;
    struct text_error error;
    assert_true(picture_write_ppm(io_path("b.ppm"), &written, &error));
    assert_true(picture_read_ppm(io_path("b.ppm"), &read, &error));
    assert_int_equal(read.width, 31);
    assert_int_equal(read.height, 17);
    assert_memory_equal(read.rgb, written.rgb, 31 * 17 * 3);
    assert_null(read.id);
    assert_null(read.depth);
    picture_free(&read);
    picture_free(&written);
}

TEST_WITH(ppm_headers, NULL, io_remove_files)
{
    struct picture picture;
    struct text_error error;
    const char *path =
        io_write("c.ppm", LITERAL("P6# one\n#two\r\n 1\t# three\n2 #four\n15\n\0\1\7\10\16\17"));
    assert_true(picture_read_ppm(path, &picture, &error));
    assert_int_equal(picture.width, 1);
    assert_int_equal(picture.height, 2);
    const uint8_t expected[6] = {0, 17, 119, 136, 238, 255};
    assert_memory_equal(picture.rgb, expected, 6);
    picture_free(&picture);

    /* The first sample may look like white space or a comment; one above maxval is cut. */
    path = io_write("c.ppm", LITERAL("P6 1 1 100\n\n#\377trailing"));
    assert_true(picture_read_ppm(path, &picture, &error));
    assert_int_equal(picture.rgb[0], 26); /* 10 * 2.55 = 25.5 */
    assert_int_equal(picture.rgb[1], 89); /* 35 * 2.55 = 89.25 */
    assert_int_equal(picture.rgb[2], 255);
    picture_free(&picture);
}

static void assert_bad_ppm(const char *bytes, size_t length, const char *problem)
{
    struct picture picture;
    struct text_error error;
    char expected[PATH_SIZE + 100];
    const char *path = io_write("bad.ppm", bytes, length);
    assert_false(picture_read_ppm(path, &picture, &error));
    (void)snprintf(expected, sizeof expected, "%s: %s", path, problem);
    assert_string_equal(error.message, expected);
    assert_null(picture.rgb);
}

TEST_WITH(bad_ppms, NULL, io_remove_files)
{
    assert_bad_ppm(LITERAL(""), "not a binary PPM (P6)");
    assert_bad_ppm(LITERAL("P6"), "not a binary PPM (P6)");
    assert_bad_ppm(LITERAL("P3\n1 1\n255\n0 0 0"), "not a binary PPM (P6)");
    assert_bad_ppm(LITERAL("P61 1 255\nabc"), "not a binary PPM (P6)");
    assert_bad_ppm(LITERAL("P6\n0 1\n255\n"), "bad size in the PPM header");
    assert_bad_ppm(LITERAL("P6\n1 -1\n255\nabc"), "bad size in the PPM header");
    assert_bad_ppm(LITERAL("P6\n1 "), "bad size in the PPM header");
    assert_bad_ppm(LITERAL("P6\n4294967297 1\n255\nabc"), "bad size in the PPM header");
    assert_bad_ppm(LITERAL("P6\n1 1\n0\nabc"), "the PPM's largest value is not in 1..255");
    assert_bad_ppm(LITERAL("P6\n1 1\n65535\nabcdef"), "the PPM's largest value is not in 1..255");
    assert_bad_ppm(LITERAL("P6\n1 1\n255"), "the PPM header does not end");
    assert_bad_ppm(LITERAL("P6\n1 1\n255abc"), "the PPM header does not end");
    assert_bad_ppm(LITERAL("P6\n1 1\n255\nab"), "the PPM ends before its last pixel");
    assert_bad_ppm(LITERAL("P6\n1000000 1000000\n255\nabc"), "the PPM ends before its last pixel");

    struct picture picture;
    struct text_error error;
    assert_false(picture_read_ppm(io_path("missing.ppm"), &picture, &error));
    assert_non_null(strstr(error.message, "missing.ppm: cannot be opened: No such file"));
    assert_false(picture_read_ppm(io_folder, &picture, &error));
    assert_non_null(strstr(error.message, ": cannot be read: Is a directory"));
}

/* ---- Nothing partial ---- */

static void limit_file_size(rlim_t bytes, struct rlimit *before)
{
    (void)signal(SIGXFSZ, SIG_IGN); /* so that writing fails instead */
    assert_int_equal(getrlimit(RLIMIT_FSIZE, before), 0);
    struct rlimit limit = *before;
    limit.rlim_cur = bytes;
    assert_int_equal(setrlimit(RLIMIT_FSIZE, &limit), 0);
}

TEST_WITH(failed_write_leaves_the_target_alone, NULL, io_remove_files)
{
    struct picture small = gradient(2, 1, false);
    struct picture large = gradient(200, 100, true);
    struct text_error error;
    struct rlimit before;
    assert_true(picture_write_ppm(io_path("kept.ppm"), &small, &error));

    limit_file_size(10000, &before);
    bool over = picture_write_ppm(io_path("kept.ppm"), &large, &error);
    struct text_error fresh_error;
    bool fresh = picture_write_ppm(io_path("new.ppm"), &large, &fresh_error);
    struct text_error dump_error;
    bool dump = picture_write_dump(io_path("new"), &large, &dump_error);
    assert_int_equal(setrlimit(RLIMIT_FSIZE, &before), 0);

    assert_false(over);
    assert_false(fresh);
    assert_false(dump);
    assert_non_null(strstr(error.message, "kept.ppm: cannot be written: File too large"));
    assert_non_null(strstr(fresh_error.message, "new.ppm: cannot be written: File too large"));
    assert_non_null(strstr(dump_error.message, "new.id: cannot be written: File too large"));
    assert_int_equal(io_count_files(), 1);
    uint8_t bytes[17];
    read_all(io_path("kept.ppm"), bytes, sizeof bytes);
    picture_free(&small);
    picture_free(&large);
}

TEST_WITH(places_that_cannot_be_written, NULL, io_remove_files)
{
    struct picture picture = gradient(2, 1, false);
    struct text_error error;
    assert_false(picture_write_ppm(io_path("no/such/folder.ppm"), &picture, &error));
    assert_non_null(strstr(error.message, "no/such/folder.ppm: cannot be written: No such file"));
    assert_false(picture_write_ppm(io_folder, &picture, &error));
    assert_non_null(strstr(error.message, ": cannot be written: "));
    assert_true(picture_write_ppm("/dev/null", &picture, &error)); /* as it is */
    assert_int_equal(io_count_files(), 0);
    picture_free(&picture);
}

TEST_WITH(permissions_follow_the_umask, NULL, io_remove_files)
{
    struct picture picture = gradient(1, 1, false);
    struct text_error error;
    struct stat status;
    mode_t before = umask(027);
    assert_true(picture_write_ppm(io_path("m.ppm"), &picture, &error));
    (void)umask(before);
    assert_int_equal(stat(io_path("m.ppm"), &status), 0);
    assert_int_equal(status.st_mode & 0777, 0640);
    picture_free(&picture);
}

/* ---- Dumps ---- */

TEST_WITH(dump_bytes, NULL, io_remove_files)
{
    struct picture picture;
    struct text_error error;
    assert_true(picture_create(&picture, 2, 1, true));
    picture.id[0] = 0x04030201;
    picture.id[1] = 0xFFFFFFFE;
    picture.depth[0] = 1.0;
    picture.depth[1] = 0.1;
    assert_true(picture_write_dump(io_path("d"), &picture, &error));
    uint8_t ids[8], depths[16];
    read_all(io_path("d.id"), ids, sizeof ids);
    read_all(io_path("d.depth"), depths, sizeof depths);
    assert_memory_equal(ids, "\1\2\3\4\xFE\xFF\xFF\xFF", 8);
    assert_memory_equal(depths, "\0\0\0\0\0\0\xF0\x3F\x9A\x99\x99\x99\x99\x99\xB9\x3F", 16);
    picture_free(&picture);
}

TEST_WITH(dump_round_trip, NULL, io_remove_files)
{
    struct picture written, read = {.width = 13, .height = 7};
    struct text_error error;
    assert_true(picture_create(&written, 13, 7, true));
    for (uint32_t i = 0; i < 91; i++) {
        written.id[i] = i * 48271;
        written.depth[i] = (double)i / 90;
    }
    assert_true(picture_write_dump(io_path("e"), &written, &error));
    assert_true(picture_read_dump(io_path("e"), &read, &error));
    assert_true(picture_read_dump(io_path("e"), &read, &error)); /* replaces what is there */
    assert_memory_equal(read.id, written.id, 91 * sizeof *read.id);
    assert_memory_equal(read.depth, written.depth, 91 * sizeof *read.depth);

    read.width = 14;
    assert_false(picture_read_dump(io_path("e"), &read, &error));
    assert_non_null(strstr(error.message, "e.id: 364 bytes, but 14 x 7 pixels need 392"));
    read.width = 12;
    assert_false(picture_read_dump(io_path("e"), &read, &error));
    assert_non_null(strstr(error.message, "e.id: 364 bytes, but 12 x 7 pixels need 336"));
    read.width = 13;
    assert_int_equal(remove(io_path("e.id")), 0);
    assert_true(picture_read_dump(io_path("e"), &read, &error));
    assert_null(read.id);
    assert_non_null(read.depth);
    (void)io_write_text("e.depth", "short");
    assert_false(picture_read_dump(io_path("e"), &read, &error));
    assert_non_null(strstr(error.message, "e.depth: 5 bytes, but 13 x 7 pixels need 728"));
    assert_int_equal(remove(io_path("e.depth")), 0);
    assert_int_equal(mkdir(io_path("e.id"), 0777), 0);
    assert_false(picture_read_dump(io_path("e"), &read, &error));
    assert_non_null(strstr(error.message, "e.id: cannot be read: Is a directory"));
    picture_free(&read);
    picture_free(&written);
}

TEST_WITH(dump_of_what_there_is, NULL, io_remove_files)
{
    struct picture picture = gradient(2, 2, true);
    struct text_error error;
    free(picture.depth);
    picture.depth = NULL;
    assert_true(picture_write_dump(io_path("f"), &picture, &error));
    assert_int_equal(io_count_files(), 1);
    assert_int_equal(access(io_path("f.id"), F_OK), 0);
    picture_free(&picture);
}

/* ---- Messages ---- */

TEST(messages_are_cut_and_printable)
{
    struct text_error error;
    char name[2000];
    memset(name, 'n', sizeof name - 1);
    name[sizeof name - 1] = '\0';
    text_error_set(&error, name, 2147483647, "%s", "the reason");
    assert_int_equal(strlen(error.message), 3 + 200 + 1 + 10 + 2 + 10);
    assert_non_null(strstr(error.message, "nnn:2147483647: the reason"));
    text_error_set(&error, "x", 0, "%s", name);
    assert_int_equal(strlen(error.message), sizeof error.message - 1);
    text_error_set(&error, "a\x1B[2Jb", 3, "c\nd\x7F");
    assert_string_equal(error.message, "a?[2Jb:3: c?d?");
}

int main(void)
{
    return run_all_tests(io_setup, io_teardown);
}
