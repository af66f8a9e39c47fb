/* SPDX-License-Identifier: MIT */
/*
 * What mesh.c draws where it has no model: a ring of bricks, computed. Its names are those of what
 * `qtri model` makes of a file, where all of it is constant.
 */
#include <qtri.h>

enum {
    AROUND = 24, /* steps about the ring's axis, */
    ACROSS = 12, /* and about its tube */
    VERTICES = (AROUND + 1) * (ACROSS + 1),
    TRIANGLES = 2 * AROUND * ACROSS,
    SIDE_LOG2 = 5
};
#define MODEL_PARTS               1
#define MODEL_BYTES(height, rows) QTRI_PREPARED_BYTES(VERTICES, TRIANGLES, height, rows)
#define MODEL_CENTER                                                                               \
    {                                                                                              \
        0, 0, 0                                                                                    \
    }
#define MODEL_RADIUS Q16(1.5)

static qtri_mesh ring;
static qtri_part model[MODEL_PARTS];
static qtri_texture skin;

static qtri_vec3 positions[VERTICES];
static qtri_normal normals[VERTICES];
static qtri_vec2 uvs[VERTICES];
static uint16_t triangles[TRIANGLES][3];
static uint16_t texels[1 << (2 * SIDE_LOG2)];

/* Vertices of the seams are there twice: their texture coordinates differ. */
static void make_ring(void)
{
    for (int32_t i = 0; i < VERTICES; i++) {
        int32_t u = i / (ACROSS + 1), v = i % (ACROSS + 1);
        q16 around = q16_from_ratio(360 * u, AROUND);
        q16 across = q16_from_ratio(360 * v, ACROSS);
        q16 out = q16_cos_deg(across);
        q16 radius = Q16(1) + q16_mul(Q16(.45), out);
        qtri_vec3 p = {q16_mul(radius, q16_cos_deg(around)), q16_mul(radius, q16_sin_deg(around)),
                       q16_mul(Q16(.45), q16_sin_deg(across))};
        /* Q2.14 of the normal, whose parts are at most 1. */
        qtri_normal n = {(int16_t)(q16_mul(out, q16_cos_deg(around)) / 4),
                         (int16_t)(q16_mul(out, q16_sin_deg(around)) / 4),
                         (int16_t)(q16_sin_deg(across) / 4)};
        qtri_vec2 uv = {q16_from_ratio(6 * u, AROUND), q16_from_ratio(2 * v, ACROSS)};
        positions[i] = p;
        normals[i] = n;
        uvs[i] = uv;
    }
    for (int32_t i = 0; i < TRIANGLES; i++) {
        int32_t quad = i / 2;
        int32_t a = quad / ACROSS * (ACROSS + 1) + quad % ACROSS; /* this step, and the next: */
        int32_t b = a + ACROSS + 1;
        triangles[i][0] = (uint16_t)a;
        triangles[i][1] = (uint16_t)(i % 2 == 0 ? b : b + 1);
        triangles[i][2] = (uint16_t)(i % 2 == 0 ? b + 1 : a + 1);
    }
}

/* Bricks: RGB565, a darker joint at the top and on the left, every other row shifted. */
static void make_texture(void)
{
    const int32_t side = 1 << SIDE_LOG2;
    for (int32_t i = 0; i < side * side; i++) {
        int32_t x = i % side, y = i / side;
        int32_t shifted = (x + (y / 8 % 2) * 8) % 16;
        bool joint = y % 8 == 0 || shifted == 0;
        int32_t red = joint ? 18 : 24 + (x * 7 + y * 3) % 6;
        int32_t green = joint ? 34 : 22 + (x * 5 + y * 11) % 8;
        int32_t blue = joint ? 16 : 8;
        texels[i] = (uint16_t)(red << 11 | green << 5 | blue);
    }
}

static void make_model(void)
{
    make_ring();
    make_texture();
    ring.positions = positions;
    ring.normals = normals;
    ring.uvs = uvs;
    ring.triangles = (const uint16_t(*)[3])triangles;
    ring.vertex_count = VERTICES;
    ring.triangle_count = TRIANGLES;
    model[0].mesh = &ring;
    model[0].material = qtri_material_default();
    model[0].material.texture = &skin;
    skin.texels = texels;
    skin.format = &qtri_texel_rgb565;
    skin.width_log2 = SIDE_LOG2;
    skin.height_log2 = SIDE_LOG2;
}

static void set_pose(qtri_transform *pose, q16 angle)
{
    qtri_transform_identity(pose);
    qtri_transform_rotate_x(pose, Q16(-55));
    qtri_transform_rotate_y(pose, angle / 3);
    qtri_transform_rotate_z(pose, angle);
}
