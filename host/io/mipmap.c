/* SPDX-License-Identifier: MIT */
#include "mipmap.h"

#include <math.h>
#include <stddef.h>

double mipmap_to_linear(double value)
{
    return value <= 0.04045 ? value / 12.92 : pow((value + 0.055) / 1.055, 2.4);
}

double mipmap_from_linear(double value)
{
    return value <= 0.0031308 ? 12.92 * value : 1.055 * pow(value, 1.0 / 2.4) - 0.055;
}

uint8_t mipmap_log2(int side)
{
    uint8_t log2 = 0;
    while (side >> log2 > 1) {
        log2++;
    }
    return log2;
}

int mipmap_side(int side, int level)
{
    return side >> level > 0 ? side >> level : 1;
}

int mipmap_count(int width)
{
    int count = 0;
    while (width >> (count + 1) >= 2) {
        count++;
    }
    return count;
}

/* The mean of `columns` by `rows` pixels. */
static void mean(const uint8_t *rgba, size_t stride, int columns, int rows,
                 const double linear[256], uint8_t out[4])
{
    double light[3] = {0.0, 0.0, 0.0}, opacity = 0.0;
    for (int y = 0; y < rows; y++) {
        for (int x = 0; x < columns; x++) {
            const uint8_t *pixel = &rgba[4 * ((size_t)y * stride + (size_t)x)];
            opacity += pixel[3];
            for (int c = 0; c < 3; c++) {
                light[c] += pixel[3] * linear[pixel[c]];
            }
        }
    }
    for (int c = 0; c < 3; c++) {
        double value = opacity > 0.0 ? mipmap_from_linear(light[c] / opacity) : 0.0;
        out[c] = (uint8_t)lround(255.0 * fmin(fmax(value, 0.0), 1.0));
    }
    out[3] = (uint8_t)lround(opacity / ((double)columns * rows));
}

void mipmap_level(const uint8_t *rgba, int width, int height, int level, uint8_t *out)
{
    double linear[256];
    const int to_width = mipmap_side(width, level), to_height = mipmap_side(height, level);
    const int columns = width / to_width, rows = height / to_height;
    for (int i = 0; i < 256; i++) {
        linear[i] = mipmap_to_linear(i / 255.0);
    }
    for (int y = 0; y < to_height; y++) {
        for (int x = 0; x < to_width; x++) {
            const size_t from = (size_t)(y * rows) * (size_t)width + (size_t)(x * columns);
            mean(&rgba[4 * from], (size_t)width, columns, rows, linear,
                 &out[4 * ((size_t)y * (size_t)to_width + (size_t)x)]);
        }
    }
}
