/* SPDX-License-Identifier: MIT */
/*
 * The command `qtri compare`.
 */
#include "compare.h"
#include "../assets/image.h"
#include "../io/file.h"

#include <errno.h>
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { STATUS_SAME = 0, STATUS_DIFFERENT = 1, STATUS_USAGE = 2 };

struct options {
    const char *path[2];
    const char *difference_path;
    double max_color, max_pixels, max_coverage, max_depth;
    bool help;
};

#define AT(member) offsetof(struct options, member)

static const struct {
    const char *name;
    size_t at;
    bool is_whole;
} limits[] = {
    {"--max-color", AT(max_color), true},
    {"--max-pixels", AT(max_pixels), true},
    {"--max-coverage", AT(max_coverage), true},
    {"--max-depth", AT(max_depth), false},
};

enum { LIMITS = sizeof limits / sizeof limits[0] };

static void print_usage(FILE *file)
{
    fputs(
        "usage: qtri compare [OPTION]... A B\n"
        "\n"
        "Compares two pictures, PPM or PNG (-: PPM of standard input), and the dumps beside them\n"
        "(A.id, A.depth of A.ppm) where both have them.\n"
        "Prints one measure a line. Exit status 0: the same within the limits below; 1: "
        "different,\n"
        "or a file cannot be read; 2: wrong usage.\n"
        "\n"
        "  --max-color N     colour difference a pixel may have in its worst channel (default 0)\n"
        "  --max-pixels N    how many pixels may exceed that (default 0)\n"
        "  --max-coverage N  how many pixels may be covered in one picture only (default 0)\n"
        "  --max-depth X     greatest depth difference, in 1/65535 (default 0); where there are\n"
        "                    ids, of the pixels that show the same triangle in both\n"
        "  -o FILE           write a picture of the differences: dark grey where there is none,\n"
        "                    64 + 16 times the difference in each channel where there is one,\n"
        "                    red where only one picture is covered\n"
        "  --help            print this\n",
        file);
}

static bool parse_number(const char *option, const char *text, double *out)
{
    char *end;

    errno = 0;
    *out = strtod(text, &end);
    if (end != text && *end == '\0' && errno == 0 && *out >= 0.0 && *out <= 1e15)
        return true;
    fprintf(stderr, "qtri compare: %s: not a number that is 0 or more: %s\n", option, text);
    return false;
}

/* The value of a limit, or the path behind -o. */
static bool parse_value(const char *option, int limit, const char *text, struct options *out)
{
    if (limit == LIMITS) {
        out->difference_path = text;
        return true;
    }
    double *number = (double *)(void *)((char *)out + limits[limit].at);
    if (!parse_number(option, text, number))
        return false;
    if (!limits[limit].is_whole || *number == floor(*number))
        return true;
    fprintf(stderr, "qtri compare: %s: not a whole number: %s\n", option, text);
    return false;
}

/* The limit of this name; LIMITS: none. */
static int find_limit(const char *name)
{
    int i = 0;

    while (i < LIMITS && strcmp(name, limits[i].name) != 0)
        i++;
    return i;
}

static bool parse_options(int argc, char **argv, struct options *out)
{
    int paths = 0;
    bool only_paths = false; /* after -- */

    *out = (struct options){0};
    for (int i = 1; i < argc; i++) {
        const char *word = argv[i];
        if (only_paths || word[0] != '-' || word[1] == '\0') {
            if (paths < 2)
                out->path[paths] = word;
            paths++;
        } else if (strcmp(word, "--") == 0) {
            only_paths = true;
        } else if (strcmp(word, "--help") == 0 || strcmp(word, "-h") == 0) {
            out->help = true;
            return true;
        } else if (find_limit(word) == LIMITS && strcmp(word, "-o") != 0) {
            fprintf(stderr, "qtri compare: unknown option: %s\n", word);
            return false;
        } else if (i + 1 == argc) {
            fprintf(stderr, "qtri compare: %s needs a value\n", word);
            return false;
        } else if (!parse_value(word, find_limit(word), argv[++i], out)) {
            return false;
        }
    }
    if (paths == 2)
        return true;
    fprintf(stderr, "qtri compare: two pictures are needed, %d given\n", paths);
    return false;
}

/* PNG, where this was built with its library, or PPM. */
static bool read_pixels(const char *path, struct picture *picture, struct text_error *error)
{
    struct image image;

    if (!file_name_ends_in(path, ".png"))
        return picture_read_ppm(path, picture, error);
    if (!image_read(path, &image, error))
        return false;
    bool made = picture_create(picture, image.width, image.height, false);
    for (size_t i = 0; made && i < (size_t)image.width * (size_t)image.height; i++)
        memcpy(&picture->rgb[3 * i], &image.rgba[4 * i], 3);
    image_free(&image);
    if (!made)
        text_error_set(error, path, 0, "out of memory");
    return made;
}

/* Reads the picture and the dumps beside it: PREFIX.id and PREFIX.depth of PREFIX.ppm. */
static bool read_picture(const char *path, struct picture *picture)
{
    struct text_error error;
    size_t length = strlen(path);

    if (!read_pixels(path, picture, &error)) {
        fprintf(stderr, "%s\n", error.message);
        return false;
    }
    char *prefix = malloc(length + 1);
    if (!prefix) {
        fprintf(stderr, "qtri compare: out of memory\n");
        picture_free(picture);
        return false;
    }
    memcpy(prefix, path, length + 1);
    if (file_name_ends_in(path, ".ppm") || file_name_ends_in(path, ".png"))
        prefix[length - 4] = '\0';
    bool read = picture_read_dump(prefix, picture, &error);
    free(prefix);
    if (!read) {
        fprintf(stderr, "%s\n", error.message);
        picture_free(picture);
    }
    return read;
}

static void print_count(FILE *out, const char *name, uint64_t value)
{
    fprintf(out, "%-20s %" PRIu64 "\n", name, value);
}

static void print_number(FILE *out, const char *name, double value)
{
    if (isinf(value))
        fprintf(out, "%-20s inf\n", name);
    else
        fprintf(out, "%-20s %.6g\n", name, value);
}

static void print_comparison(FILE *out, const struct comparison *c)
{
    fprintf(out, "%-20s %dx%d\n", "size", c->width[0], c->height[0]);
    print_count(out, "pixels", c->pixels);
    print_count(out, "pixels-differing", c->differing);
    print_count(out, "color-max", (uint64_t)c->max_color_error);
    print_number(out, "color-mean", c->mean_color_error);
    print_number(out, "psnr-db", c->psnr);
    if (c->has_id) {
        print_count(out, "covered-a", c->covered[0]);
        print_count(out, "covered-b", c->covered[1]);
        print_count(out, "coverage-mismatches", c->coverage_mismatches);
        print_count(out, "other-triangle", c->other_triangle);
    }
    if (c->has_depth) {
        print_count(out, "depth-pixels", c->depth_pixels);
        print_number(out, "depth-max", c->max_depth_error);
        print_number(out, "depth-mean", c->mean_depth_error);
        print_number(out, "depth-p99.9", c->p999_depth_error);
    }
}

static bool within_limits(const struct comparison *c, const struct options *options)
{
    const int color = (int)fmin(options->max_color, 255);

    return (double)compare_pixels_above(c, color) <= options->max_pixels &&
           (double)c->coverage_mismatches <= options->max_coverage &&
           c->max_depth_error <= options->max_depth;
}

static bool write_difference(const char *path, const struct picture picture[2])
{
    struct picture difference;
    struct text_error error;

    if (!compare_difference(&picture[0], &picture[1], &difference)) {
        fprintf(stderr, "qtri compare: out of memory\n");
        return false;
    }
    bool written = image_write_picture(path, &difference, &error);
    if (!written)
        fprintf(stderr, "%s\n", error.message);
    picture_free(&difference);
    return written;
}

static int compare_read_pictures(const struct options *options, const struct picture picture[2])
{
    struct comparison comparison;

    compare_pictures(&picture[0], &picture[1], &comparison);
    if (!comparison.same_size) {
        fprintf(stderr, "qtri compare: different sizes: %s is %dx%d, %s is %dx%d\n",
                options->path[0], comparison.width[0], comparison.height[0], options->path[1],
                comparison.width[1], comparison.height[1]);
        return STATUS_DIFFERENT;
    }
    /* Where the picture of the differences goes to standard output, the measures go elsewhere. */
    bool is_piped = options->difference_path && strcmp(options->difference_path, "-") == 0;
    print_comparison(is_piped ? stderr : stdout, &comparison);
    if (options->difference_path && !write_difference(options->difference_path, picture))
        return STATUS_DIFFERENT;
    return within_limits(&comparison, options) ? STATUS_SAME : STATUS_DIFFERENT;
}

int compare_main(int argc, char **argv)
{
    struct options options;
    struct picture picture[2];

    if (!parse_options(argc, argv, &options)) {
        fputs("Try: qtri compare --help\n", stderr);
        return STATUS_USAGE;
    }
    if (options.help) {
        print_usage(stdout);
        return STATUS_SAME;
    }
    if (!read_picture(options.path[0], &picture[0]))
        return STATUS_DIFFERENT;
    if (!read_picture(options.path[1], &picture[1])) {
        picture_free(&picture[0]);
        return STATUS_DIFFERENT;
    }
    int status = compare_read_pictures(&options, picture);
    picture_free(&picture[0]);
    picture_free(&picture[1]);
    return status;
}
