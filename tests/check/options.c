/* SPDX-License-Identifier: MIT */
/*
 * Draws pictures that use everything options can leave out, and prints a checksum for each. For the
 * gate options.sh: a library without an option must draw what the whole library draws when
 * everything that the option leaves out has its documented result. So the whole library takes names
 * of options as arguments, `TEXTURES SMOOTH`, and asks for those results instead.
 */
#include <stdio.h>
#include <string.h>

#include <qtri.h>

#define WIDTH  72
#define HEIGHT 56
#define ROWS   16
#define RINGS  10
#define SIDES  8
#define POINTS (RINGS * SIDES)

static const char *const *left_out;
static int left_out_count;

static int without(const char *option)
{
    for (int i = 0; i < left_out_count; i++) {
        if (strcmp(left_out[i], option) == 0) {
            return 1;
        }
    }
    return 0;
}

static uint32_t checksum(uint32_t sum, const void *bytes, size_t count)
{
    const uint8_t *byte = bytes;
    for (size_t i = 0; i < count; i++) {
        sum = (sum ^ byte[i]) * 16777619u;
    }
    return sum;
}

/* A torus in both kinds of arrays: the same points to 16 bits. */
static qtri_vec3 positions[POINTS];
static qtri_normal normals[POINTS];
static qtri_vec2 uvs[POINTS];
static qtri_rgb colors[POINTS];
static uint16_t triangles[2 * POINTS][3];
static qtri_position16 positions16[POINTS];
static qtri_normal8 normals8[POINTS];
static qtri_uv16 uvs16[POINTS];
static uint8_t triangles8[2 * POINTS][3];
static qtri_face8 planes[2 * POINTS];
static uint16_t texels565[64];
static uint32_t texels8888[64];

static void make_meshes(void)
{
    for (int i = 0; i < POINTS; i++) {
        q16 ring = Q16(360) / RINGS * (i / SIDES);
        q16 side = Q16(360) / SIDES * (i % SIDES);
        q16 reach = Q16(.66) + q16_mul(Q16(.33), q16_cos_deg(side));
        qtri_vec3 n = {q16_mul(q16_cos_deg(side), q16_cos_deg(ring)),
                       q16_mul(q16_cos_deg(side), q16_sin_deg(ring)), q16_sin_deg(side)};
        qtri_vec3 p = {q16_mul(reach, q16_cos_deg(ring)), q16_mul(reach, q16_sin_deg(ring)),
                       q16_mul(Q16(.33), q16_sin_deg(side))};
        positions[i] = p;
        normals[i].x = (int16_t)(n.x / 4);
        normals[i].y = (int16_t)(n.y / 4);
        normals[i].z = (int16_t)(n.z / 4);
        uvs[i].x = Q16(.25) * (i / SIDES);
        uvs[i].y = Q16(.25) * (i % SIDES);
        colors[i].r = (uint8_t)(i * 37);
        colors[i].g = (uint8_t)(255 - i);
        colors[i].b = (uint8_t)(i * 11);
        positions16[i].x = (int16_t)(p.x / 2);
        positions16[i].y = (int16_t)(p.y / 2);
        positions16[i].z = (int16_t)(p.z / 2);
        normals8[i].x = (int8_t)(n.x / 517);
        normals8[i].y = (int8_t)(n.y / 517);
        normals8[i].z = (int8_t)(n.z / 517);
        uvs16[i].x = (int16_t)(uvs[i].x / 8);
        uvs16[i].y = (int16_t)(uvs[i].y / 8);
        int up = i % SIDES == SIDES - 1 ? i - SIDES + 1 : i + 1;
        int quad[6] = {i, (i + SIDES) % POINTS,  (up + SIDES) % POINTS,
                       i, (up + SIDES) % POINTS, up};
        for (int k = 0; k < 6; k++) {
            triangles[2 * i + k / 3][k % 3] = (uint16_t)quad[k];
            triangles8[2 * i + k / 3][k % 3] = (uint8_t)quad[k];
        }
    }
    for (uint32_t i = 0; i < 64; i++) {
        texels565[i] = (uint16_t)(i * 2654435761u >> 16);
        texels8888[i] = i * 2654435761u >> 4;
    }
}

/* As mesh.h asks for them, all 100 long along the largest coordinate. */
static void make_planes(void)
{
    for (int i = 0; i < 2 * POINTS; i++) {
        const qtri_position16 *a = &positions16[triangles[i][0]];
        const qtri_position16 *b = &positions16[triangles[i][1]];
        const qtri_position16 *c = &positions16[triangles[i][2]];
        const int64_t e[3] = {b->x - a->x, b->y - a->y, b->z - a->z};
        const int64_t f[3] = {c->x - a->x, c->y - a->y, c->z - a->z};
        int64_t n[3];
        int64_t largest = 1;
        for (int k = 0; k < 3; k++) {
            n[k] = e[(k + 1) % 3] * f[(k + 2) % 3] - e[(k + 2) % 3] * f[(k + 1) % 3];
            int64_t size = n[k] < 0 ? -n[k] : n[k];
            largest = size > largest ? size : largest;
        }
        for (int k = 0; k < 3; k++) {
            n[k] = (n[k] * 200 + (n[k] < 0 ? -largest : largest)) / (2 * largest);
        }
        const int64_t d = n[0] * a->x + n[1] * a->y + n[2] * a->z;
        planes[i].x = (int8_t)n[0];
        planes[i].y = (int8_t)n[1];
        planes[i].z = (int8_t)n[2];
        planes[i].d = (int8_t)((d + (d < 0 ? -16384 : 16384)) / 32768);
    }
}

/* One picture: what it asks for. */
typedef struct picture {
    const char *name;
    const qtri_format *format;
    qtri_material material;
    const qtri_light *light;
    int is_compact, is_uneven, has_colors, has_normals;
    q16 distance;
    const qtri_stroke *stroke; /* not NULL: the mesh's edges, drawn so */
} picture;

static uint64_t memory[(QTRI_BAND_BYTES(WIDTH, HEIGHT, QTRI_XRGB8888_BYTES) + 7) / 8];
static uint64_t band_memory[(QTRI_FRAME_BYTES(WIDTH, ROWS, QTRI_XRGB8888_BYTES) + 7) / 8];
static qtri_vertex vertices[POINTS];
static uint8_t prepared_memory[QTRI_PREPARED_BYTES(POINTS, 2 * POINTS, HEIGHT, ROWS)];

/* The results that config.h names, for the arguments. */
static void substitute(picture *p, qtri_texture *texture)
{
    qtri_material *m = &p->material;
    if (without("PERSPECTIVE")) {
        m->interpolation = QTRI_SCREEN_LINEAR;
    }
    if (m->texture != NULL) {
        *texture = *m->texture;
        m->texture = texture;
    }
}

static void draw_corners(const qtri_surface *surface, const qtri_view *view,
                         const qtri_transform *pose, const qtri_material *material)
{
    static const qtri_corner corners[6] = {
        {{Q16(-2), Q16(-.5), Q16(4), Q16(1)}, {255, 0, 0}, {0, 0}}, /* behind the eye */
        {{Q16(1), Q16(-.5), Q16(-1), Q16(1)}, {0, 255, 0}, {Q16(3), 0}},
        {{Q16(.5), Q16(2), Q16(-3), Q16(2)}, {0, 0, 255}, {0, Q16(3)}},
        {{Q16(-1), Q16(-1), 0, Q16(1)}, {255, 255, 0}, {0, 0}},
        {{Q16(1), Q16(-.5), Q16(.5), Q16(1)}, {0, 255, 255}, {Q16(1), 0}},
        {{0, Q16(.5), Q16(-.5), Q16(1)}, {255, 0, 255}, {0, Q16(1)}},
    };
    qtri_draw_triangles(surface, view, pose, corners, 6, material);
    qtri_draw_lines(surface, view, pose, corners, 6, material);
}

static void draw_mesh(const qtri_surface *surface, const qtri_view *view,
                      const qtri_transform *pose, const qtri_mesh *mesh, const picture *p)
{
    if (p->stroke != NULL) {
        qtri_draw_wide_wireframe(surface, view, pose, mesh, p->stroke, &p->material);
    } else {
        qtri_draw_mesh(surface, view, pose, mesh, &p->material);
    }
}

static void draw(const picture *asked)
{
    picture p = *asked;
    qtri_texture texture;
    qtri_surface surface;
    qtri_view view;
    qtri_transform pose;
    qtri_frame frame;
    qtri_prepared prepared;
    const qtri_rgb sky = {24, 32, 48};
    const qtri_vec3 back = {0, 0, -p.distance};
    const qtri_vec3 uneven = {Q16(1), Q16(.5), Q16(.75)};
    enum qtri_error error;
    substitute(&p, &texture);
    (void)qtri_surface_init(&surface, p.format, WIDTH, HEIGHT, 0, HEIGHT, memory, sizeof memory);
    qtri_mesh mesh = {.vertex_count = POINTS, .triangle_count = 2 * POINTS};
    mesh.colors = p.has_colors ? colors : NULL;
    mesh.extent = Q16(1);
    mesh.faces.culling = &qtri_cull_by_planes;
    mesh.faces.planes = planes;
    mesh.faces.thin = 8000;
    mesh.faces.error_q16 = 60000;
    mesh.faces.radius_q14 = 17000;
    if (p.is_compact) {
        mesh.positions16 = positions16;
        mesh.normals8 = p.has_normals ? normals8 : NULL;
        mesh.uvs16 = uvs16;
        mesh.triangles8 = (const uint8_t(*)[3])triangles8;
    } else {
        mesh.positions = positions;
        mesh.normals = p.has_normals ? normals : NULL;
        mesh.uvs = uvs;
        mesh.triangles = (const uint16_t(*)[3])triangles;
    }

    qtri_view_init(&view, WIDTH, HEIGHT);
    qtri_transform_translate(&view.camera, back);
    qtri_transform_perspective(&view.projection, Q16(60), Q16(9.0 / 7), Q16(.5), Q16(20));
    view.light = p.light;
    view.vertices = vertices;
    view.vertex_count = POINTS;
    qtri_transform_identity(&pose);
    qtri_transform_rotate_y(&pose, Q16(25));
    qtri_transform_rotate_x(&pose, Q16(-40));
    if (p.is_uneven) {
        qtri_transform_scale(&pose, uneven);
    }
    qtri_surface_clear(&surface, sky);
    draw_mesh(&surface, &view, &pose, &mesh, &p);
    draw_corners(&surface, &view, &pose, &p.material);
    uint32_t sum =
        checksum(2166136261u, surface.pixels, (size_t)(WIDTH * HEIGHT) * p.format->pixels->bytes);
    sum = checksum(sum, surface.depth, (size_t)(WIDTH * HEIGHT) * 2);
    printf("%s: %08lX", p.name, (unsigned long)sum);

    /* The mesh again in bands. */
    sum = 2166136261u;
    error = qtri_frame_init(&frame, p.format, WIDTH, HEIGHT, ROWS, band_memory, sizeof band_memory);
    qtri_prepared_init(&prepared, prepared_memory, sizeof prepared_memory);
    qtri_prepare_mesh(&prepared, &frame, &view, &pose, &mesh, &p.material);
    while (error == QTRI_OK && qtri_frame_next_band(&frame, &surface)) {
        qtri_surface_clear(&surface, sky);
        qtri_draw_prepared(&surface, &prepared);
        sum =
            checksum(sum, surface.pixels, (size_t)(WIDTH * surface.rows) * p.format->pixels->bytes);
    }
    printf(" %08lX\n", (unsigned long)sum);
}

int main(int argc, char **argv)
{
    static const struct {
        const char *name;
        const qtri_format *format;
    } formats[3] = {{"rgb565", &qtri_rgb565}, {"xrgb8888", &qtri_xrgb8888}, {"gray8", &qtri_gray8}};
    static const qtri_light sun = {
        .towards = {Q16(.4), Q16(.6), Q16(.7)}, .ambient = Q16(.2), .diffuse = Q16(.8)};
    const qtri_texture nearest = {
        .texels = texels565, .format = &qtri_texel_rgb565, .width_log2 = 3, .height_log2 = 3};
    qtri_texture bilinear = nearest;
    qtri_texture wide = nearest;
    bilinear.filter = &qtri_bilinear;
    wide.texels = texels8888;
    wide.format = &qtri_texel_xrgb8888;
    qtri_stroke thin = qtri_stroke_default();
    thin.cap = QTRI_CAP_BUTT;
    qtri_stroke thick = thin;
    thick.width = Q16(3.5);
    thick.alpha = 128;
    left_out = (const char *const *)&argv[1];
    left_out_count = argc - 1;
    make_meshes();
    make_planes();
    for (int i = 0; i < 3 * 2 * 17; i++) {
        char name[80];
        int kind = i / 6;
        picture p = {.name = name,
                     .format = formats[i % 3].format,
                     .material = qtri_material_default(),
                     .light = &sun,
                     .is_compact = i / 3 % 2,
                     .has_normals = 1,
                     .distance = Q16(2)};
        qtri_material *m = &p.material;
        m->color.g = 160;
        const char *what = "smooth";
        switch (kind) {
        case 0:
            break;
        case 1:
            what = "flat";
            m->shading = QTRI_FLAT_FIRST;
            p.has_colors = 1;
            break;
        case 2:
            what = "by faces";
            p.has_normals = 0;
            break;
        case 3:
            what = "near, in colours";
            p.distance = Q16(1);
            p.has_colors = 1;
            break;
        case 4:
            what = "copied texels";
            m->texture = &nearest;
            p.light = NULL;
            m->color.g = 255;
            break;
        case 5:
            what = "bilinear";
            m->texture = &bilinear;
            m->shading = QTRI_FLAT_LAST;
            p.distance = Q16(1);
            break;
        case 6:
            what = "wide texels";
            m->texture = &wide;
            m->texture_mode = QTRI_REPLACE;
            break;
        case 7:
            what = "affine";
            m->texture = &nearest;
            m->interpolation = QTRI_SCREEN_LINEAR;
            p.distance = Q16(1.25);
            break;
        case 8:
            what = "wireframe";
            m->fill = &qtri_wireframe;
            break;
        case 9:
            what = "always";
            m->depth_compare = QTRI_ALWAYS;
            break;
        case 10:
            what = "uneven";
            p.is_uneven = 1;
            break;
        case 11:
            what = "smooth wireframe";
            m->fill = &qtri_smooth_wireframe;
            break;
        case 12:
            what = "smooth wireframe without depth";
            m->fill = &qtri_smooth_wireframe;
            m->depth_compare = QTRI_DEPTH_OFF;
            break;
        case 13:
            what = "smooth wireframe in colours";
            m->fill = &qtri_smooth_wireframe;
            m->depth_compare = QTRI_LESS_EQUAL;
            p.has_colors = 1;
            break;
        case 14:
            what = "thin wireframe";
            p.stroke = &thin;
            break;
        case 15:
            what = "thick wireframe";
            p.stroke = &thick;
            m->depth_compare = QTRI_DEPTH_OFF;
            break;
        default:
            what = "without depth";
            m->depth_compare = QTRI_DEPTH_OFF;
            m->cull = QTRI_CULL_NONE;
            break;
        }
        (void)snprintf(name, sizeof name, "%s %s %s", what, p.is_compact ? "compact" : "wide",
                       formats[i % 3].name);
        draw(&p);
    }
    return 0;
}
