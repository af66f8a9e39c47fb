/* SPDX-License-Identifier: MIT */
/*
 * The colours of a palette: median cut over a histogram of 5 bits a channel (Heckbert 1982), then
 * k-means.
 */
#include "texture.h"

#include <stdlib.h>
#include <string.h>

#include "../io/palette.h"
#include "../io/xalloc.h"

enum { BINS = 32768, ROUNDS = 6 };

struct bin {
    uint32_t count;
    uint64_t sum[3];
};

/* Bins in a row of the list. */
struct box {
    int first, end;
};

struct reduction {
    struct bin *bins; /* those that have pixels */
    int bin_count;
    int channel; /* that is sorted by */
};

static int mean_of(const struct bin *bin, int channel)
{
    return (int)(bin->sum[channel] / bin->count);
}

static void spread_of(const struct reduction *reduction, const struct box *box, int *channel,
                      int *spread)
{
    *spread = -1;
    for (int c = 0; c < 3; c++) {
        int low = 255, high = 0;
        for (int i = box->first; i < box->end; i++) {
            int mean = mean_of(&reduction->bins[i], c);
            low = mean < low ? mean : low;
            high = mean > high ? mean : high;
        }
        if (high - low > *spread) {
            *spread = high - low;
            *channel = c;
        }
    }
}

static int compare_by(const struct bin *a, const struct bin *b, int channel)
{
    return (mean_of(a, channel) > mean_of(b, channel)) -
           (mean_of(a, channel) < mean_of(b, channel));
}

static int compare_red(const void *a, const void *b)
{
    return compare_by(a, b, 0);
}

static int compare_green(const void *a, const void *b)
{
    return compare_by(a, b, 1);
}

static int compare_blue(const void *a, const void *b)
{
    return compare_by(a, b, 2);
}

/* Where half of a box's pixels lie on either side, with a bin on both. */
static int find_median(const struct reduction *reduction, const struct box *box)
{
    uint64_t total = 0, sum = 0;
    for (int i = box->first; i < box->end; i++) {
        total += reduction->bins[i].count;
    }
    for (int i = box->first; i < box->end - 1; i++) {
        sum += reduction->bins[i].count;
        if (2 * sum >= total) {
            return i + 1;
        }
    }
    return box->end - 1;
}

/* Splits the box with the widest spread; false when there is none. */
static bool split(struct reduction *reduction, struct box *boxes, int count)
{
    static int (*const compare[3])(const void *, const void *) = {compare_red, compare_green,
                                                                  compare_blue};
    int widest = -1, channel = 0, most = -1;
    for (int i = 0; i < count; i++) {
        int spread, its_channel = 0;
        spread_of(reduction, &boxes[i], &its_channel, &spread);
        if (boxes[i].end - boxes[i].first > 1 && spread > most) {
            most = spread;
            widest = i;
            channel = its_channel;
        }
    }
    if (widest < 0) {
        return false;
    }
    struct box *box = &boxes[widest];
    qsort(&reduction->bins[box->first], (size_t)(box->end - box->first), sizeof(struct bin),
          compare[channel]);
    int middle = find_median(reduction, box);
    boxes[count].first = middle;
    boxes[count].end = box->end;
    box->end = middle;
    return true;
}

int texture_nearest_color(const uint8_t (*palette)[3], int first, int end, const int color[3])
{
    int best = first, least = 1 << 30;
    for (int i = first; i < end; i++) {
        int sum = 0;
        for (int c = 0; c < 3; c++) {
            sum += (color[c] - palette[i][c]) * (color[c] - palette[i][c]);
        }
        if (sum < least) {
            least = sum;
            best = i;
        }
    }
    return best;
}

/* Each colour becomes the mean of the bins that are nearest to it. */
static void refine(const struct reduction *reduction, uint8_t palette[256][3], int count)
{
    uint64_t sums[256][4];
    memset(sums, 0, sizeof sums);
    for (int i = 0; i < reduction->bin_count; i++) {
        const struct bin *bin = &reduction->bins[i];
        const int mean[3] = {mean_of(bin, 0), mean_of(bin, 1), mean_of(bin, 2)};
        uint64_t *sum = sums[texture_nearest_color((const uint8_t(*)[3])palette, 0, count, mean)];
        for (int c = 0; c < 3; c++) {
            sum[c] += bin->sum[c];
        }
        sum[3] += bin->count;
    }
    for (int i = 0; i < count; i++) {
        for (int c = 0; c < 3 && sums[i][3] > 0; c++) {
            palette[i][c] = (uint8_t)((sums[i][c] + sums[i][3] / 2) / sums[i][3]);
        }
    }
}

static void box_mean(const struct reduction *reduction, const struct box *box, uint8_t color[3])
{
    uint64_t sum[3] = {0, 0, 0}, count = 0;
    for (int i = box->first; i < box->end; i++) {
        count += reduction->bins[i].count;
        for (int c = 0; c < 3; c++) {
            sum[c] += reduction->bins[i].sum[c];
        }
    }
    for (int c = 0; c < 3; c++) {
        color[c] = (uint8_t)(count > 0 ? (sum[c] + count / 2) / count : 0);
    }
}

static void fill_bins(struct reduction *reduction, const uint8_t *rgb, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        const uint8_t *p = &rgb[3 * i];
        struct bin *bin = &reduction->bins[(p[0] >> 3) << 10 | (p[1] >> 3) << 5 | p[2] >> 3];
        bin->count++;
        for (int c = 0; c < 3; c++) {
            bin->sum[c] += p[c];
        }
    }
    for (int i = 0; i < BINS; i++) {
        if (reduction->bins[i].count > 0) {
            reduction->bins[reduction->bin_count++] = reduction->bins[i];
        }
    }
}

static int reduce(const uint8_t *rgb, size_t count, int most, uint8_t palette[256][3])
{
    struct reduction reduction = {xcalloc(BINS, sizeof(struct bin)), 0, 0};
    struct box boxes[256];
    fill_bins(&reduction, rgb, count);
    int colors = 1;
    boxes[0].first = 0;
    boxes[0].end = reduction.bin_count;
    while (colors < most && split(&reduction, boxes, colors)) {
        colors++;
    }
    for (int i = 0; i < colors; i++) {
        box_mean(&reduction, &boxes[i], palette[i]);
    }
    for (int i = 0; i < ROUNDS; i++) {
        refine(&reduction, palette, colors);
    }
    free(reduction.bins);
    return colors;
}

int texture_palette(const struct image *image, int most, uint8_t palette[256][3])
{
    size_t count = 0, pixels = (size_t)image->width * (size_t)image->height;
    uint8_t *rgb = xcalloc(pixels, 3);
    struct palette exact;
    for (size_t i = 0; i < pixels; i++) {
        if (image->rgba[4 * i + 3] >= 128) {
            memcpy(&rgb[3 * count++], &image->rgba[4 * i], 3);
        }
    }
    memset(palette, 0, sizeof(uint8_t[256][3]));
    int colors = 1; /* of a picture without an opaque pixel: black */
    if (count > 0 && palette_make(&exact, rgb, count, NULL) && exact.count <= most) {
        memcpy(palette, exact.color, sizeof exact.color);
        colors = exact.count;
    } else if (count > 0) {
        colors = reduce(rgb, count, most, palette);
    }
    free(rgb);
    return colors;
}
