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

struct point {
    double x, y, z, w;
};

static void put_vertex(struct writer *w, struct point p, bool textured)
{
    put(w, "  %.5f %.5f %.5f %.5f  %.3f %.3f %.3f", p.x, p.y, p.z, p.w, uniform(w, 0, 1),
        uniform(w, 0, 1), uniform(w, 0, 1));
    if (textured) {
        double size = chance(w, 10) && !w->mixed ? 20.0 : 1.5;
        if (w->textured && chance(w, 20)) {
            size = 0.2; /* texels larger than pixels */
        }
        put(w, "  %.4f %.4f", symmetric(w, size), symmetric(w, size));
    }
    if (w->mixed) {
        put(w, "  %.3f %.3f %.3f", symmetric(w, 1), symmetric(w, 1), uniform(w, .2, 1));
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
    struct point p = {symmetric(w, w->reach), symmetric(w, w->reach), symmetric(w, w->reach), 1};
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
            put(w, "translate %.4f %.4f %.4f\n", symmetric(w, 1), symmetric(w, 1), symmetric(w, 1));
            break;
        case 1:
            put(w, "rotate %.3f  %.3f %.3f %.3f\n", symmetric(w, 360), symmetric(w, 1),
                symmetric(w, 1), uniform(w, 0.1, 1));
            break;
        case 2:
            put(w, "scale %.4f %.4f %.4f\n", uniform(w, 0.4, 1.6) * (chance(w, 10) ? -1 : 1),
                uniform(w, 0.4, 1.6), uniform(w, 0.4, 1.6));
            break;
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
        put(w, "perspective %.3f %.4f %.4f %.3f\n", uniform(w, 25, 110), aspect,
            uniform(w, 0.05, 1), uniform(w, 4, 80));
    } else if (kind == 3) {
        put(w, "frustum %.4f %.4f %.4f %.4f %.4f %.3f\n", uniform(w, -.6, -.2), uniform(w, .2, .6),
            uniform(w, -.6, -.2), uniform(w, .2, .6), uniform(w, .3, 1), uniform(w, 5, 50));
    } else {
        put(w, "ortho %.4f %.4f %.4f %.4f %.4f %.4f\n", uniform(w, -2, -1), uniform(w, 1, 2),
            uniform(w, -2, -1), uniform(w, 1, 2), uniform(w, 0, 1), uniform(w, 4, 8));
    }
    put(w, "mode modelview\n");
    if (chance(w, 10)) {
        put(w, "load 1 0 0 0  0 1 0 0  0 0 1 0  %.4f %.4f %.4f 1\n", symmetric(w, 1),
            symmetric(w, 1), uniform(w, -4, -1.5));
    } else {
        put(w, "lookat %.4f %.4f %.4f  %.4f %.4f %.4f  %.3f 1 %.3f\n", symmetric(w, 2),
            symmetric(w, 2), uniform(w, 0.3, 4), symmetric(w, .5), symmetric(w, .5),
            symmetric(w, .5), symmetric(w, .5), symmetric(w, .5));
    }
}

static const char *either(struct writer *w, const char *first, const char *second)
{
    return chance(w, 50) ? first : second;
}

static void put_texture(struct writer *w)
{
    static const int side[] = {1, 2, 8, 16, 64, 256};
    static const char *const format[] = {"xrgb8888", "rgb565", "palette", "gray8"};
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
        put(w, "texwrap %s %s\n", either(w, "repeat", "clamp"), either(w, "repeat", "clamp"));
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
    put(w, "viewport %d %d\n", 64 + pick(w, 5) * 64, 48 + pick(w, 200));
    put(w, "clear %.3f %.3f %.3f\n", uniform(w, 0, 1), uniform(w, 0, 1), uniform(w, 0, 1));
    if (chance(w, 12)) {
        put(w, "depth %s\ncleardepth %.3f\n", chance(w, 50) ? "greater" : "gequal",
            uniform(w, 0, .3));
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
        put(w, "depthrange %.3f %.3f\n", uniform(w, 0, 1), uniform(w, 0, 1));
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
    put(w, " %.3f %.3f %.3f", uniform(w, 0, most), uniform(w, 0, most), uniform(w, 0, most));
}

static void put_place(struct writer *w, double reach)
{
    put(w, " %.3f %.3f %.3f", symmetric(w, reach), symmetric(w, reach), symmetric(w, reach));
}

static void put_lights(struct writer *w)
{
    put(w, "ambient");
    put_color(w, .4);
    for (int count = 1 + pick(w, 4); count > 0; count--) {
        switch (pick(w, 3)) {
        case 0:
            put(w, "\nlight directional %.3f %.3f %.3f ", symmetric(w, 1), symmetric(w, 1),
                uniform(w, .1, 1));
            put_color(w, .8);
            break;
        case 1:
            put(w, "\nlight point");
            put_place(w, 3);
            put_color(w, 1.5);
            put(w, "  %.3f %.3f %.3f", uniform(w, .2, 1), uniform(w, 0, .4), uniform(w, 0, .2));
            break;
        default:
            put(w, "\nlight spot");
            put_place(w, 3);
            put(w, " %.3f %.3f -1 ", symmetric(w, 1), symmetric(w, 1));
            put(w, " %.2f %.2f ", uniform(w, 5, 40), uniform(w, 45, 120));
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
    put(w, "viewport %d %d\nclear", 96 + pick(w, 5) * 32, 64 + pick(w, 100));
    put_color(w, 1);
    put(w, "\ndepth %s\ncull %s\n", depth[pick(w, 5)], chance(w, 25) ? "back" : "none");
    if (chance(w, 20)) {
        put(w, "shade flat %s\n", either(w, "first", "last"));
    }
    if (chance(w, 12)) {
        put(w, "polygon line\n");
    }
    if (chance(w, 10)) {
        put(w, "colormask %s %s on\n", either(w, "on", "off"), either(w, "on", "off"));
    }
    put(w, "blend %s %.3f\n", blend[pick(w, 6)], chance(w, 20) ? 1.0 : uniform(w, .1, 1));
    if (chance(w, 30)) {
        put(w, "fog linear %.4f %.4f", near_z, far_z);
        put_color(w, 1);
        put(w, " %.3f %.3f\n", uniform(w, 0, 3), uniform(w, 4, 12));
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
    put(w, "mode projection\nperspective %.3f %.4f %.4f %.4f\n", uniform(w, 30, 90),
        uniform(w, .8, 1.6), near_z, far_z);
    put(w, "mode modelview\nlookat %.4f %.4f %.4f  0 0 0  0 1 0\n", symmetric(w, 1.5),
        symmetric(w, 1.5), uniform(w, 2.5, 5));
}

static void put_strokes(struct writer *w)
{
    put(w, "linewidth %.3f\nlinesmooth %s\n", uniform(w, .5, 9), chance(w, 75) ? "on" : "off");
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
    put(w, " %.3f\nedges %s\n", chance(w, 40) ? 1.0 : uniform(w, .1, 1),
        either(w, "hard", "smooth"));
    switch (pick(w, 4)) {
    case 0:
        put(w, "rect %.3f %.3f %.3f %.3f\n", x, y, x + uniform(w, 1, 60), y + uniform(w, 1, 60));
        break;
    case 1:
        put(w, "roundrect %.3f %.3f %.3f %.3f 6 %.3f\n", x, y, x + uniform(w, 14, 60),
            y + uniform(w, 14, 60), uniform(w, 1, 5));
        break;
    case 2:
        put(w, "circle %.3f %.3f %.3f\n", x, y, uniform(w, 1, 40));
        break;
    default:
        put(w, "stroke %.3f %.3f %.3f %.3f %.3f\n", x, y, x + symmetric(w, 60),
            y + symmetric(w, 60), uniform(w, 1, 9));
        break;
    }
}

/* Alpha in steps of 1/255, as vertices have it. */
static void put_vertex_state(struct writer *w)
{
    put(w, "depthslope %.4f\n", chance(w, 20) ? symmetric(w, 2) : 0);
    if (chance(w, 60)) {
        put(w, "vertexalpha off\n");
        return;
    }
    put(w, "vertexalpha %.5f %.5f %.5f\n", pick(w, 256) / 255.0, pick(w, 256) / 255.0,
        pick(w, 256) / 255.0);
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
        put(&w, "rotate %.3f  %.3f %.3f %.3f\n", symmetric(&w, 180), symmetric(&w, 1),
            symmetric(&w, 1), uniform(&w, .1, 1));
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
        default:
            put_triangle(&w, random_point(&w), random_point(&w), random_point(&w));
            break;
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
