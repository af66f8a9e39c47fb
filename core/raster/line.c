#include "qtri/raster.h"

#include "../math/bits.h"
#include "dda.h"
#include "job.h"

enum { CHANNELS = 3, DEPTH = 3, VALUES = 4 };

/* A line along its major axis: x when it is at least as wide as high. */
typedef struct line {
    bool steep; /* the major axis is y */
    int32_t major[2], minor[2];
    const qtri_screen_vertex *end[2]; /* by increasing major coordinate */
} line;

static int32_t hold(int64_t x, int32_t limit)
{
    return x < -limit ? -limit : (x > limit ? limit : (int32_t)x);
}

static void line_init(line *l, const qtri_screen_vertex v[2])
{
    int32_t x[2];
    int32_t y[2];
    for (int i = 0; i < 2; i++) {
        x[i] = hold(v[i].x_24p8, QTRI_SCREEN_MAX_24P8);
        y[i] = hold(v[i].y_24p8, QTRI_SCREEN_MAX_24P8);
    }
    int32_t width = x[1] > x[0] ? x[1] - x[0] : x[0] - x[1];
    int32_t height = y[1] > y[0] ? y[1] - y[0] : y[0] - y[1];
    l->steep = height > width;
    const int32_t *major = l->steep ? y : x;
    const int32_t *minor = l->steep ? x : y;
    int first = major[0] <= major[1] ? 0 : 1;
    for (int i = 0; i < 2; i++) {
        int from = i == 0 ? first : 1 - first;
        l->major[i] = major[from];
        l->minor[i] = minor[from];
        l->end[i] = &v[from];
    }
}

/* Values in 2^-16 of their unit, linear along the major axis; as exact as a plane (plane.h). */
typedef struct ramp {
    uint64_t value, step;
} ramp;

static void ramp_init(ramp *r, int64_t start, int64_t end, int32_t length, int32_t along)
{
    int64_t difference = (end - start) * 65536; /* < 2^49 */
    int64_t per_sub_pixel = (difference + (difference < 0 ? -length : length) / 2) / length;
    r->value = ((uint64_t)start << 16) + (uint64_t)per_sub_pixel * (uint64_t)(int64_t)along;
    r->step = (uint64_t)per_sub_pixel << 8;
}

static uint32_t depth_of(const qtri_screen_vertex *v)
{
    const uint32_t farthest = (uint32_t)65535 << 16;
    return v->depth_16p16 < farthest ? v->depth_16p16 : farthest;
}

static void ramps_init(ramp r[VALUES], const line *l, qtri_format format, int32_t along)
{
    int32_t length = l->major[1] - l->major[0];
    qtri_channels start = qtri_channels_from_color(format, l->end[0]->color_8p16);
    qtri_channels end = qtri_channels_from_color(format, l->end[1]->color_8p16);
    for (int i = 0; i < CHANNELS; i++) {
        ramp_init(&r[i], start.c[i], end.c[i], length, along);
    }
    ramp_init(&r[DEPTH], depth_of(l->end[0]), depth_of(l->end[1]), length, along);
}

static void plot(const qtri_surface *surface, const qtri_material *material, int32_t x, int32_t y,
                 const ramp r[VALUES])
{
    ptrdiff_t stored_row = y - surface->first_row;
    if (surface->depth != NULL && material->depth_compare != QTRI_DEPTH_OFF) {
        uint16_t *stored = surface->depth + stored_row * surface->depth_pitch + x;
        uint16_t z = (uint16_t)((r[DEPTH].value + ((uint64_t)1 << 31)) >> 32);
        if (!qtri_depth_passes(material->depth_compare, z, *stored)) {
            return;
        }
        if (!material->depth_read_only) {
            *stored = z;
        }
    }
    qtri_channels color;
    for (int i = 0; i < CHANNELS; i++) {
        int64_t c = qtri_wrap64(r[i].value) >> 16;
        color.c[i] = c < 0 ? 0 : (int32_t)c;
    }
    qtri_pixel_store(surface->format, surface->pixels + stored_row * surface->pitch, x,
                     qtri_pixel_pack(surface->format, &color));
}

void qtri_raster_line(const qtri_surface *surface, const qtri_material *material,
                      const qtri_screen_vertex v[2])
{
    line l;
    line_init(&l, v);
    qtri_rect bounds = qtri_surface_bounds(surface);
    int32_t low = l.steep ? bounds.y0 : bounds.x0;
    int32_t high = l.steep ? bounds.y1 : bounds.x1;
    int32_t minor_low = l.steep ? bounds.x0 : bounds.y0;
    int32_t minor_high = l.steep ? bounds.x1 : bounds.y1;
    int32_t position = (l.major[0] + 127) >> 8; /* first centre in [start, end) */
    int32_t end = (l.major[1] + 127) >> 8;
    position = position < low ? low : position;
    end = end > high ? high : end;
    int32_t minor_least = l.minor[0] < l.minor[1] ? l.minor[0] : l.minor[1];
    int32_t minor_greatest = l.minor[0] < l.minor[1] ? l.minor[1] : l.minor[0];
    if (l.major[0] == l.major[1] || position >= end) {
        return;
    }
    if (minor_least >> 8 >= minor_high || minor_greatest >> 8 < minor_low) {
        return;
    }
    int32_t along = position * 256 + 128 - l.major[0];
    qtri_dda minor;
    ramp r[VALUES];
    qtri_dda_init(&minor, l.minor[0], l.minor[1] - l.minor[0], l.major[1] - l.major[0], along, 0);
    ramps_init(r, &l, surface->format, along);
    for (; position < end; position++) {
        if (minor.value >= minor_low && minor.value < minor_high) {
            plot(surface, material, l.steep ? minor.value : position,
                 l.steep ? position : minor.value, r);
        }
        qtri_dda_next(&minor);
        for (int i = 0; i < VALUES; i++) {
            r[i].value += r[i].step;
        }
    }
}
