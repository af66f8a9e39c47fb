/* SPDX-License-Identifier: MIT */
#include "scene_random.h"

#include <math.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>

struct writer {
    char *text;
    size_t length, capacity;
    uint64_t state;
    bool clip_space; /* both matrices are the identity: geometry brings its own w */
    double reach;    /* how far geometry spreads */
    bool textured;   /* about textures: most triangles have them, and they vary */
    bool mixed;      /* of all that makes colours: vertices have normals */
};

static void put(struct writer *w, const char *format, ...)
{
    char line[1024];
    va_list arguments;
    va_start(arguments, format);
    int count = vsnprintf(line, sizeof line, format, arguments);
    va_end(arguments);
    if (count < 0 || (size_t)count >= sizeof line) {
        abort();
    }
    while (w->length + (size_t)count + 1 > w->capacity) {
        w->capacity = 2 * w->capacity + 4096;
        w->text = realloc(w->text, w->capacity);
        if (w->text == NULL) {
            abort();
        }
    }
    for (int i = 0; i <= count; i++) {
        w->text[w->length + (size_t)i] = line[i];
    }
    w->length += (size_t)count;
}

/* splitmix64 (Steele, Lea, Flood 2014) */
static uint32_t bits(struct writer *w)
{
    uint64_t z = (w->state += UINT64_C(0x9E3779B97F4A7C15));
    z = (z ^ (z >> 30)) * UINT64_C(0xBF58476D1CE4E5B9);
    z = (z ^ (z >> 27)) * UINT64_C(0x94D049BB133111EB);
    return (uint32_t)((z ^ (z >> 31)) >> 32);
}

static int pick(struct writer *w, int count)
{
    return (int)(bits(w) % (uint32_t)count);
}

static bool chance(struct writer *w, int percent)
{
    return pick(w, 100) < percent;
}

static double uniform(struct writer *w, double low, double high)
{
    return low + (high - low) * bits(w) / 4294967296.0;
}

static double symmetric(struct writer *w, double size)
{
    return uniform(w, -size, size);
}

/* A blank and a number for each entry: between two limits, with so many digits. The last is drawn
   first. */
static void put_numbers(struct writer *w, const double entry[][3], int count)
{
    double number[8];
    for (int i = count - 1; i >= 0; i--) {
        number[i] = uniform(w, entry[i][0], entry[i][1]);
    }
    for (int i = 0; i < count; i++) {
        put(w, " %.*f", (int)entry[i][2], number[i]);
    }
}

struct point {
    double x, y, z, w;
};

static void put_vertex(struct writer *w, struct point p, bool textured)
{
    put(w, "  %.5f %.5f %.5f %.5f", p.x, p.y, p.z, p.w);
    put_numbers(w, (const double[][3]){{0, 1, 3}, {0, 1, 3}, {0, 1, 3}}, 3);
    if (textured) {
        double size = chance(w, 10) && !w->mixed ? 20.0 : 1.5;
        if (w->textured && chance(w, 20)) {
            size = 0.2; /* texels larger than pixels */
        }
        put_numbers(w, (const double[][3]){{-size, size, 4}, {-size, size, 4}}, 2);
    }
    if (w->mixed) {
        put_numbers(w, (const double[][3]){{-1, 1, 3}, {-1, 1, 3}, {.2, 1, 3}}, 3);
    }
}

static void put_triangle(struct writer *w, struct point a, struct point b, struct point c)
{
    bool textured = chance(w, w->textured ? 85 : 40);
    put(w, textured ? "trit" : "tri");
    put(w, w->mixed ? "n" : "");
    put_vertex(w, a, textured);
    put_vertex(w, b, textured);
    put_vertex(w, c, textured);
    put(w, "\n");
}

static struct point random_point(struct writer *w)
{
    struct point p = {0, 0, 0, 1};
    p.x = symmetric(w, w->reach);
    p.y = symmetric(w, w->reach);
    p.z = symmetric(w, w->reach);
    if (w->clip_space) {
        p.z = symmetric(w, 1.1);
        p.w = chance(w, 70) ? uniform(w, 0.2, 2) : symmetric(w, 2);
        if (chance(w, 5)) {
            p.w = 0;
        }
    } else if (chance(w, 5)) {
        p.w = uniform(w, 0.3, 3);
    }
    return p;
}

static struct point between(struct point a, struct point b, double t)
{
    struct point p = {a.x + (b.x - a.x) * t, a.y + (b.y - a.y) * t, a.z + (b.z - a.z) * t,
                      a.w + (b.w - a.w) * t};
    return p;
}

/* Round numbers often, so that points are shared exactly and ties occur. */
static struct point rounded(struct point p)
{
    struct point q = {floor(p.x * 64) / 64, floor(p.y * 64) / 64, floor(p.z * 64) / 64,
                      floor(p.w * 64) / 64};
    return q;
}

static void put_fan(struct writer *w)
{
    enum { SPOKES = 7 };
    struct point center = rounded(random_point(w));
    struct point rim[SPOKES];
    for (int i = 0; i < SPOKES; i++) {
        rim[i] = rounded(random_point(w));
        rim[i].w = center.w;
        rim[i].x = center.x + w->reach * 0.6 * cos(i * 6.2831853 / SPOKES);
        rim[i].y = center.y + w->reach * 0.6 * sin(i * 6.2831853 / SPOKES);
    }
    for (int i = 0; i < SPOKES; i++) {
        put_triangle(w, center, rim[i], rim[(i + 1) % SPOKES]);
    }
}

static void put_grid(struct writer *w)
{
    enum { SIDE = 3 };
    struct point corner = random_point(w);
    struct point along = random_point(w);
    struct point across = random_point(w);
    along.w = across.w = corner.w;
    struct point p[SIDE + 1][SIDE + 1];
    for (int i = 0; i <= SIDE; i++) {
        for (int j = 0; j <= SIDE; j++) {
            struct point a = between(corner, along, (double)i / SIDE);
            struct point b = between(corner, across, (double)j / SIDE);
            p[i][j] = a;
            p[i][j].x += b.x - corner.x;
            p[i][j].y += b.y - corner.y;
            p[i][j].z += (b.z - corner.z) + symmetric(w, 0.05);
        }
    }
    for (int i = 0; i < SIDE; i++) {
        for (int j = 0; j < SIDE; j++) {
            put_triangle(w, p[i][j], p[i + 1][j], p[i + 1][j + 1]);
            put_triangle(w, p[i][j], p[i + 1][j + 1], p[i][j + 1]);
        }
    }
}

static void put_sliver(struct writer *w)
{
    struct point a = random_point(w);
    struct point b = random_point(w);
    struct point c = between(a, b, uniform(w, 0.2, 0.8));
    c.x += symmetric(w, 0.02);
    c.y += symmetric(w, 0.02);
    put_triangle(w, a, b, c);
}

static void put_large(struct writer *w)
{
    double reach = w->reach;
    w->reach *= chance(w, 30) ? 200 : 8;
    struct point a = random_point(w);
    struct point b = random_point(w);
    struct point c = random_point(w);
    put_triangle(w, a, b, c);
    w->reach = reach;
}

static void put_matrix(struct writer *w, const char *statement)
{
    double m[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    for (int i = 0; i < 12; i++) {
        m[i % 4 + 4 * (i / 4)] += i % 4 == 3 ? 0 : symmetric(w, 0.3);
    }
    put(w, "%s", statement);
    for (int i = 0; i < 16; i++) {
        put(w, " %.4f", m[i]);
    }
    put(w, "\n");
}

static void put_pose(struct writer *w)
{
    for (int steps = pick(w, 3); steps > 0; steps--) {
        switch (pick(w, 4)) {
        case 0:
            put(w, "translate");
            put_numbers(w, (const double[][3]){{-1, 1, 4}, {-1, 1, 4}, {-1, 1, 4}}, 3);
            put(w, "\n");
            break;
        case 1:
            put(w, "rotate");
            put_numbers(w, (const double[][3]){{-360, 360, 3}, {-1, 1, 3}, {-1, 1, 3}, {0.1, 1, 3}},
                        4);
            put(w, "\n");
            break;
        case 2: {
            const double z = uniform(w, 0.4, 1.6);
            const double y = uniform(w, 0.4, 1.6);
            const double x = uniform(w, 0.4, 1.6) * (chance(w, 10) ? -1 : 1);
            put(w, "scale %.4f %.4f %.4f\n", x, y, z);
            break;
        }
        default:
            put_matrix(w, "mult");
            break;
        }
    }
}

static void put_view(struct writer *w, int kind)
{
    w->clip_space = kind == 0;
    w->reach = kind == 0 ? 1.3 : 1.6;
    if (kind == 0) {
        return;
    }
    put(w, "mode projection\n");
    if (chance(w, 20)) {
        put(w, "identity\n");
    }
    double aspect = uniform(w, 0.7, 1.5);
    if (kind == 1 || kind == 2) {
        const double far_z = uniform(w, 4, 80);
        const double near_z = uniform(w, 0.05, 1);
        const double degrees = uniform(w, 25, 110);
        put(w, "perspective %.3f %.4f %.4f %.3f\n", degrees, aspect, near_z, far_z);
    } else if (kind == 3) {
        put(w, "frustum");
        put_numbers(
            w,
            (const double[][3]){
                {-.6, -.2, 4}, {.2, .6, 4}, {-.6, -.2, 4}, {.2, .6, 4}, {.3, 1, 4}, {5, 50, 3}},
            6);
        put(w, "\n");
    } else {
        put(w, "ortho");
        put_numbers(w,
                    (const double[][3]){
                        {-2, -1, 4}, {1, 2, 4}, {-2, -1, 4}, {1, 2, 4}, {0, 1, 4}, {4, 8, 4}},
                    6);
        put(w, "\n");
    }
    put(w, "mode modelview\n");
    if (chance(w, 10)) {
        put(w, "load 1 0 0 0  0 1 0 0  0 0 1 0");
        put_numbers(w, (const double[][3]){{-1, 1, 4}, {-1, 1, 4}, {-4, -1.5, 4}}, 3);
        put(w, " 1\n");
    } else {
        const double up_z = symmetric(w, .5);
        const double up_x = symmetric(w, .5);
        const double z = symmetric(w, .5);
        const double y = symmetric(w, .5);
        const double x = symmetric(w, .5);
        const double eye_z = uniform(w, 0.3, 4);
        const double eye_y = symmetric(w, 2);
        const double eye_x = symmetric(w, 2);
        put(w, "lookat %.4f %.4f %.4f  %.4f %.4f %.4f  %.3f 1 %.3f\n", eye_x, eye_y, eye_z, x, y, z,
            up_x, up_z);
    }
}

static const char *either(struct writer *w, const char *first, const char *second)
{
    return chance(w, 50) ? first : second;
}

static void put_texture(struct writer *w)
{
    static const int side[] = {1, 2, 8, 16, 64, 256};
    static const char *const format[] = {"xrgb8888", "rgb565", "palette", "gray8", "palette565"};
    int width = side[pick(w, 6)];
    int height = side[pick(w, 6)];
    int smaller = width < height ? width : height;
    int cells = 1 + pick(w, smaller < 8 ? smaller : 8);
    int color[6];
    put(w, "texture %d %d %d", width, height, cells);
    for (int i = 0; i < 6; i++) {
        color[i] = pick(w, 256);
        put(w, " %d", color[i]);
    }
    put(w, "\ntexmode %s\n", chance(w, 30) ? "replace" : "modulate");
    if (!w->textured) {
        return;
    }
    put(w, "texwrap %s\n", either(w, "repeat", "clamp"));
    if (chance(w, 30)) {
        const char *v = either(w, "repeat", "clamp");
        const char *u = either(w, "repeat", "clamp");
        put(w, "texwrap %s %s\n", u, v);
    }
    put(w, "texfilter %s\n", chance(w, 35) ? "nearest" : "bilinear");
    put(w, "texformat %s\n", format[pick(w, 4)]);
    if (chance(w, 25)) {
        const int *key = &color[3 * pick(w, 2)];
        put(w, "texkey %d %d %d\n", key[0], key[1], key[2]);
    }
}

static void put_state(struct writer *w)
{
    static const char *const depth[] = {"less", "less", "less", "lequal", "less", "always", "off"};
    static const char *const cull[] = {"none", "none", "back", "front"};
    const int height = 48 + pick(w, 200);
    const int width = 64 + pick(w, 5) * 64;
    put(w, "viewport %d %d\n", width, height);
    put(w, "clear");
    put_numbers(w, (const double[][3]){{0, 1, 3}, {0, 1, 3}, {0, 1, 3}}, 3);
    put(w, "\n");
    if (chance(w, 12)) {
        const double cleared = uniform(w, 0, .3);
        const char *compare = chance(w, 50) ? "greater" : "gequal";
        put(w, "depth %s\ncleardepth %.3f\n", compare, cleared);
    } else {
        put(w, "depth %s\n", depth[pick(w, 7)]);
        if (chance(w, 10)) {
            put(w, "cleardepth %.3f\n", uniform(w, .5, 1));
        }
    }
    put(w, "cull %s\n", cull[pick(w, 4)]);
    if (chance(w, 20)) {
        put(w, "shade flat %s\n", chance(w, 50) ? "first" : "last");
    }
    /* Linear between the corners that clipping leaves, and the reference's guard band is wider: a
       cut there, which the plain scenes hold few of, says nothing about textures. */
    if (chance(w, 15) && !w->textured) {
        put(w, "interpolate linear\n");
    }
    if (chance(w, 10)) {
        put(w, "depthrange");
        put_numbers(w, (const double[][3]){{0, 1, 3}, {0, 1, 3}}, 2);
        put(w, "\n");
    }
    if (chance(w, 5)) {
        put(w, "depthmask off\n");
    }
    if (chance(w, w->textured ? 95 : 60)) {
        put_texture(w);
    }
}

static void put_geometry(struct writer *w)
{
    switch (pick(w, 6)) {
    case 0:
        put_fan(w);
        break;
    case 1:
        put_grid(w);
        break;
    case 2:
        put_sliver(w);
        break;
    case 3:
        put_large(w);
        break;
    default:
        for (int i = 0; i < 4; i++) {
            struct point a = random_point(w);
            struct point b = random_point(w);
            struct point c = random_point(w);
            put_triangle(w, a, b, c);
        }
        break;
    }
}

/* ---- Scenes that mix ---- */

static void put_color(struct writer *w, double most)
{
    put_numbers(w, (const double[][3]){{0, most, 3}, {0, most, 3}, {0, most, 3}}, 3);
}

static void put_place(struct writer *w, double reach)
{
    put_numbers(w, (const double[][3]){{-reach, reach, 3}, {-reach, reach, 3}, {-reach, reach, 3}},
                3);
}

static void put_lights(struct writer *w)
{
    put(w, "ambient");
    put_color(w, .4);
    for (int count = 1 + pick(w, 4); count > 0; count--) {
        switch (pick(w, 3)) {
        case 0:
            put(w, "\nlight directional");
            put_numbers(w, (const double[][3]){{-1, 1, 3}, {-1, 1, 3}, {.1, 1, 3}}, 3);
            put_color(w, .8);
            break;
        case 1:
            put(w, "\nlight point");
            put_place(w, 3);
            put_color(w, 1.5);
            put_numbers(w, (const double[][3]){{.2, 1, 3}, {0, .4, 3}, {0, .2, 3}}, 3);
            break;
        default:
            put(w, "\nlight spot");
            put_place(w, 3);
            put_numbers(w, (const double[][3]){{-1, 1, 3}, {-1, 1, 3}}, 2);
            put(w, " -1 ");
            put_numbers(w, (const double[][3]){{5, 40, 2}, {45, 120, 2}}, 2);
            put_color(w, 2);
            break;
        }
    }
    put(w, "\n");
    if (chance(w, 60)) {
        put(w, "material specular");
        put_color(w, .8);
        put(w, " %.2f\n", uniform(w, 2, 60));
    }
    if (chance(w, 30)) {
        put(w, "material emission");
        put_color(w, .3);
        put(w, "\n");
    }
    put(w, "twosided %s\n", either(w, "on", "off"));
}

static void put_mixed_state(struct writer *w)
{
    static const char *const blend[] = {"off", "alpha", "alpha", "add", "multiply", "screendoor"};
    static const char *const depth[] = {"less", "less", "lequal", "always", "off"};
    const double near_z = uniform(w, .3, 1);
    const double far_z = uniform(w, 8, 60);
    const int height = 64 + pick(w, 100);
    const int width = 96 + pick(w, 5) * 32;
    put(w, "viewport %d %d\nclear", width, height);
    put_color(w, 1);
    const char *culled = chance(w, 25) ? "back" : "none";
    const char *compare = depth[pick(w, 5)];
    put(w, "\ndepth %s\ncull %s\n", compare, culled);
    if (chance(w, 20)) {
        put(w, "shade flat %s\n", either(w, "first", "last"));
    }
    if (chance(w, 12)) {
        put(w, "polygon line\n");
    }
    if (chance(w, 10)) {
        const char *green = either(w, "on", "off");
        const char *red = either(w, "on", "off");
        put(w, "colormask %s %s on\n", red, green);
    }
    const double alpha = chance(w, 20) ? 1.0 : uniform(w, .1, 1);
    const char *name = blend[pick(w, 6)];
    put(w, "blend %s %.3f\n", name, alpha);
    if (chance(w, 30)) {
        put(w, "fog linear %.4f %.4f", near_z, far_z);
        put_color(w, 1);
        put_numbers(w, (const double[][3]){{0, 3, 3}, {4, 12, 3}}, 2);
        put(w, "\n");
    } else if (chance(w, 60)) {
        put(w, "fogdensity %s %.4f %.4f", either(w, "exp", "exp2"), near_z, far_z);
        put_color(w, 1);
        put(w, " %.3f\n", uniform(w, .02, .4));
    }
    if (chance(w, 75)) {
        put_lights(w);
    }
    if (chance(w, 60)) {
        put(w, "texture 16 16 %d", 1 + pick(w, 4));
        for (int i = 0; i < 6; i++) {
            put(w, " %d", pick(w, 256));
        }
        put(w, "\ntexfilter bilinear\ntexmode %s\n", chance(w, 30) ? "replace" : "modulate");
    }
    const double aspect = uniform(w, .8, 1.6);
    const double degrees = uniform(w, 30, 90);
    put(w, "mode projection\nperspective %.3f %.4f %.4f %.4f\n", degrees, aspect, near_z, far_z);
    put(w, "mode modelview\nlookat");
    put_numbers(w, (const double[][3]){{-1.5, 1.5, 4}, {-1.5, 1.5, 4}, {2.5, 5, 4}}, 3);
    put(w, " 0 0 0  0 1 0\n");
}

static void put_strokes(struct writer *w)
{
    const char *smooth = chance(w, 75) ? "on" : "off";
    const double width = uniform(w, .5, 9);
    put(w, "linewidth %.3f\nlinesmooth %s\n", width, smooth);
    put(w, "linecap %s\n", chance(w, 60) ? "round" : either(w, "butt", "square"));
    put(w, "linealpha %.3f\n", chance(w, 50) ? 1.0 : uniform(w, .1, 1));
    if (chance(w, 40)) {
        put(w, "pointsize %.3f\npoint", uniform(w, 2, 20));
        put_place(w, 1.5);
        put(w, " 1");
        put_color(w, 1);
        put(w, "\n");
        return;
    }
    put(w, "polyline %s\n", either(w, "open", "closed"));
    for (int count = 2 + pick(w, 4); count > 0; count--) {
        put(w, "vertex");
        put_place(w, 1.5);
        put(w, " 1");
        put_color(w, 1);
        put(w, "\n");
    }
}

static void put_paint(struct writer *w)
{
    const double x = uniform(w, 0, 180);
    const double y = uniform(w, 0, 120);
    put(w, "ink");
    put_color(w, 1);
    const char *edges = either(w, "hard", "smooth");
    const double alpha = chance(w, 40) ? 1.0 : uniform(w, .1, 1);
    put(w, " %.3f\nedges %s\n", alpha, edges);
    switch (pick(w, 4)) {
    case 0:
        put(w, "rect %.3f %.3f", x, y);
        put_numbers(w, (const double[][3]){{x + 1, x + 60, 3}, {y + 1, y + 60, 3}}, 2);
        break;
    case 1: {
        const double radius = uniform(w, 1, 5);
        put(w, "roundrect %.3f %.3f", x, y);
        put_numbers(w, (const double[][3]){{x + 14, x + 60, 3}, {y + 14, y + 60, 3}}, 2);
        put(w, " 6 %.3f", radius);
        break;
    }
    case 2:
        put(w, "circle %.3f %.3f %.3f", x, y, uniform(w, 1, 40));
        break;
    default:
        put(w, "stroke %.3f %.3f", x, y);
        put_numbers(w, (const double[][3]){{x - 60, x + 60, 3}, {y - 60, y + 60, 3}, {1, 9, 3}}, 3);
        break;
    }
    put(w, "\n");
}

/* Alpha in steps of 1/255, as vertices have it. */
static void put_vertex_state(struct writer *w)
{
    put(w, "depthslope %.4f\n", chance(w, 20) ? symmetric(w, 2) : 0);
    if (chance(w, 60)) {
        put(w, "vertexalpha off\n");
        return;
    }
    put(w, "vertexalpha");
    for (int i = 0; i < 3; i++) {
        put(w, " %.5f", pick(w, 256) / 255.0);
    }
    put(w, "\n");
}

char *scene_random_mixed(uint32_t seed, size_t *length)
{
    struct writer w = {.text = NULL,
                       .state = (seed + UINT64_C(1)) * UINT64_C(0xA0761D6478BD642F),
                       .reach = 1.6,
                       .mixed = true};
    put_mixed_state(&w);
    for (int groups = 4 + pick(&w, 6); groups > 0; groups--) {
        put(&w, "push\ndepthbias %.5f\n", chance(&w, 20) ? symmetric(&w, .003) : 0);
        put_vertex_state(&w);
        put(&w, "rotate");
        put_numbers(&w, (const double[][3]){{-180, 180, 3}, {-1, 1, 3}, {-1, 1, 3}, {.1, 1, 3}}, 4);
        put(&w, "\n");
        switch (pick(&w, 5)) {
        case 0:
            put_fan(&w);
            break;
        case 1:
            put_grid(&w);
            break;
        case 2:
            put_strokes(&w);
            break;
        case 3:
            put_paint(&w);
            break;
        default: {
            const struct point c = random_point(&w);
            const struct point b = random_point(&w);
            put_triangle(&w, random_point(&w), b, c);
            break;
        }
        }
        put(&w, "pop\n");
    }
    *length = w.length;
    return w.text;
}

static char *write_scene(uint32_t seed, bool textured, size_t *length)
{
    /* Far from multiples of the generator's own step, or neighbours would share their stream. */
    struct writer w = {.text = NULL,
                       .state = (seed + UINT64_C(1)) * UINT64_C(0xD1B54A32D192ED03),
                       .textured = textured};
    put_state(&w);
    put_view(&w, pick(&w, 5));
    for (int groups = 3 + pick(&w, 5); groups > 0; groups--) {
        bool pose = !w.clip_space && chance(&w, 60);
        if (pose) {
            put(&w, "push\n");
            put_pose(&w);
        }
        put_geometry(&w);
        if (pose) {
            put(&w, "pop\n");
        }
    }
    *length = w.length;
    return w.text;
}

char *scene_random(uint32_t seed, size_t *length)
{
    return write_scene(seed, false, length);
}

char *scene_random_textured(uint32_t seed, size_t *length)
{
    return write_scene(seed, true, length);
}
