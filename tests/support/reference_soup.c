/* SPDX-License-Identifier: MIT */
#include "reference_soup.h"

#include "reference.h"

struct soup soup;

void soup_begin(int width, int height)
{
    memset(&soup, 0, sizeof soup);
    soup.scene.width = width;
    soup.scene.height = height;
    soup.scene.clear_depth = 65536;
    soup.scene.depth_far = 65536;
    soup.scene.provoking = 2;
    soup.scene.ops = soup.ops;
}

void soup_add(const struct scene_vertex *a, const struct scene_vertex *b,
              const struct scene_vertex *c)
{
    assert_true(soup.scene.op_count < SOUP_TRIANGLES);
    struct scene_op *op = &soup.ops[soup.scene.op_count++];
    op->kind = SCENE_TRIANGLE;
    op->id = ++soup.scene.triangle_count;
    op->u.triangle.vertex[0] = *a;
    op->u.triangle.vertex[1] = *b;
    op->u.triangle.vertex[2] = *c;
}

struct reference_image soup_render(int bits)
{
    struct reference_image image;

    assert_true(reference_render(&soup.scene, bits, &image));
    return image;
}

struct scene_vertex window_vertex(double x, double y, double z, double w)
{
    struct scene_vertex v = {
        {q16((2 * x / soup.scene.width - 1) * w), q16((1 - 2 * y / soup.scene.height) * w),
         q16(z * w), q16(w)},
        {65536, 65536, 65536},
        {0, 0},
        {0, 0, 0},
    };
    return v;
}

struct scene_vertex random_color(struct scene_vertex v, uint32_t *seed)
{
    for (int c = 0; c < 3; c++)
        v.color[c] = (int32_t)(next_random(seed) % 65537);
    return v;
}
