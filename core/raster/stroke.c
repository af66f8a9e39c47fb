#include "stroke.h"

#include "../frame/pixel.h"

qtri_stroke qtri_stroke_default(void)
{
    qtri_stroke stroke = {
        .width = Q16_ONE,
        .cap = QTRI_CAP_ROUND,
        .edges = &qtri_stroke_smooth,
        .alpha = 255,
        .closed = false,
        .in_space = false,
    };
    return stroke;
}

bool qtri_stroker_init(qtri_stroker *stroker, const qtri_surface *surface,
                       const qtri_material *material, const qtri_stroke *stroke)
{
    const qtri_compare compare = material->depth_compare;
    stroker->surface = surface;
    stroker->bounds = qtri_surface_bounds(surface);
    stroker->compare = surface->depth == NULL ? QTRI_DEPTH_OFF : compare;
    stroker->depth_write = stroker->compare != QTRI_DEPTH_OFF && !material->depth_read_only;
    stroker->alpha = stroke->alpha;
    stroker->edges = stroke->edges;
    return stroker->bounds.x0 < stroker->bounds.x1 && stroke->alpha != 0 && compare != QTRI_NEVER;
}

/* Whether a part may touch the row. A corner of a square cap is 3/2 radii away at most. */
static bool touches_row(const qtri_stroker *stroker, uint32_t part, qtri_stroke_place *place)
{
    const qtri_stroke_source *source = stroker->source;
    if (!source->place(source->from, part, place)) {
        return false;
    }
    const int32_t top = stroker->row * 256;
    const int32_t reach = place->radius_24p8 + (place->radius_24p8 >> 1) + 1;
    const int32_t y0 = place->end[0].y_24p8;
    const int32_t y1 = place->end[1].y_24p8;
    return qtri_least32(y0, y1) <= top + 256 + reach && qtri_greatest32(y0, y1) >= top - reach;
}

/* The shape of a part that is there; one that was made for another row is made no more. */
static const qtri_stroke_shape *shape_of(qtri_stroker *stroker, uint32_t part)
{
    const qtri_stroke_source *source = stroker->source;
    qtri_stroke_shape *shape = &stroker->shape[part % QTRI_STROKE_SHAPES];
    if (shape->part != part) {
        qtri_stroke_place place;
        (void)source->place(source->from, part, &place);
        qtri_stroke_shape_init(shape, &place);
        source->ends(source->from, part, shape->end);
        const int32_t *first = shape->end[0].color_8p16;
        const int32_t *last = shape->end[1].color_8p16;
        shape->even = first[0] == last[0] && first[1] == last[1] && first[2] == last[2];
        shape->part = part;
    }
    return shape;
}

static bool touches_window(const qtri_stroke_shape *shape, const qtri_stroker *stroker)
{
    int32_t first;
    int32_t end;
    return qtri_stroke_shape_columns(shape, stroker->row, &first, &end) &&
           first < stroker->column + QTRI_STROKE_WINDOW && end > stroker->column;
}

/*
 * The part behind those that *at has counted: of `parts`, or, behind them, any that touches the
 * row. UINT32_MAX: none.
 */
static uint32_t part_of(const qtri_stroker *stroker, const qtri_stroke_parts *parts, uint32_t *at)
{
    if (*at < parts->count) {
        return parts->part[(*at)++];
    }
    /* Behind the list *at is count + 1 and the number of the part that is next. */
    uint32_t part = *at == parts->count ? parts->rest : *at - parts->count - 1;
    for (; part < stroker->source->count; part++) {
        qtri_stroke_place place;
        if (touches_row(stroker, part, &place)) {
            *at = parts->count + 1 + part + 1;
            return part;
        }
    }
    *at = UINT32_MAX;
    return UINT32_MAX;
}

static void add_part(qtri_stroke_parts *parts, uint32_t part)
{
    if (parts->count < QTRI_STROKE_PARTS) {
        parts->part[parts->count++] = part;
    } else if (parts->rest == UINT32_MAX) {
        parts->rest = part;
    }
}

const qtri_stroke_shape *qtri_stroker_next(qtri_stroker *stroker, uint32_t *at)
{
    const uint32_t known = stroker->parts.count;
    for (;;) {
        const bool is_known = *at < known;
        const uint32_t part = part_of(stroker, &stroker->parts, at);
        if (part == UINT32_MAX) {
            return NULL;
        }
        const qtri_stroke_shape *shape = shape_of(stroker, part);
        if (is_known || touches_window(shape, stroker)) {
            return shape;
        }
    }
}

static bool passes(qtri_compare compare, uint32_t depth, uint32_t stored)
{
    switch (compare) {
    case QTRI_LESS:
        return depth < stored;
    case QTRI_EQUAL:
        return depth == stored;
    case QTRI_LESS_EQUAL:
        return depth <= stored;
    case QTRI_GREATER:
        return depth > stored;
    case QTRI_NOT_EQUAL:
        return depth != stored;
    case QTRI_GREATER_EQUAL:
        return depth >= stored;
    default:
        return true;
    }
}

/* What a pixel takes of its part. */
typedef struct sample {
    uint32_t depth;        /* 0..65535 */
    int32_t color_8p16[3]; /* 0..255.0 */
} sample;

/* Where along the parts pixels of a window are. */
typedef struct position {
    uint64_t square; /* of the distance in 24.8 */
    uint32_t share_q16;
    uint32_t part; /* UINT32_MAX: none yet */
} position;

/* From a pixel's centre to the part; |along|, |across| < 2^25, far away taken as 2^22. */
static uint64_t square_of(int32_t beyond, int32_t across)
{
    const int32_t most = (int32_t)1 << 22;
    const int32_t x = qtri_hold32(beyond, -most, most);
    const int32_t y = qtri_hold32(across, -most, most);
    return (uint64_t)qtri_mul_s32(x, x) + (uint64_t)qtri_mul_s32(y, y);
}

/* Of the pixels first .. end-1 of the window: taken where the shape is nearer than others. */
static void take_positions(position *at, const qtri_stroker *stroker,
                           const qtri_stroke_shape *shape, int32_t first, int32_t end)
{
    const int32_t x = (stroker->column + first) * 256 + 128 - shape->origin.x_24p8;
    const int32_t y = stroker->row * 256 + 128 - shape->origin.y_24p8;
    const int32_t down = 30 - shape->up;
    const int64_t length_q30 = (int64_t)((uint64_t)shape->length << down);
    const bool is_alone = stroker->parts.count == 1;
    /* |x|, |y| < 2^24: below 2^55. */
    int64_t along_q30 = qtri_mul_s32(x, shape->along_x_q30) + qtri_mul_s32(y, shape->along_y_q30);
    int64_t across_q30 = qtri_mul_s32(y, shape->along_x_q30) - qtri_mul_s32(x, shape->along_y_q30);
    const int64_t step = (int64_t)shape->along_x_q30 * 256;
    const int64_t step_across = (int64_t)shape->along_y_q30 * -256;
    for (int32_t i = first; i < end; i++) {
        const int64_t held_q30 =
            along_q30 < 0 ? 0 : (along_q30 > length_q30 ? length_q30 : along_q30);
        const uint64_t square = is_alone ? 0
                                         : square_of((int32_t)((along_q30 - held_q30) >> 30),
                                                     (int32_t)(across_q30 >> 30));
        if (at[i].part == UINT32_MAX || square < at[i].square) {
            const uint64_t product = qtri_mul_u32((uint32_t)(held_q30 >> down), shape->inverse);
            const uint32_t share = (uint32_t)(product >> shape->inverse_shift);
            at[i].square = square;
            at[i].share_q16 = share < 65536 ? share : 65536;
            at[i].part = shape->part;
        }
        along_q30 += step;
        across_q30 += step_across;
    }
}

/* from + (to - from) share / 2^16; |to - from| < 2^24. */
static int32_t mixed(int32_t from, int32_t to, uint32_t share_q16)
{
    return from + (int32_t)((qtri_mul_s32(to - from, (int32_t)share_q16) + 0x8000) >> 16);
}

static void take_sample(sample *out, const qtri_stroke_shape *shape, uint32_t share_q16)
{
    const qtri_stroke_end *from = &shape->end[0];
    const qtri_stroke_end *to = &shape->end[1];
    const int32_t depth_16p8 =
        mixed((int32_t)(from->depth_16p8 >> 8), (int32_t)(to->depth_16p8 >> 8), share_q16);
    out->depth = (uint32_t)(depth_16p8 + 128) >> 8;
    for (int i = 0; i < 3; i++) {
        out->color_8p16[i] = shape->even ? from->color_8p16[i]
                                         : mixed(from->color_8p16[i], to->color_8p16[i], share_q16);
    }
}

/* A colour, or what a share of it, 0..2^16, makes of a stored pixel, before it is encoded. */
static uint32_t word_of(const qtri_format *format, const sample *from, const uint8_t *pixel,
                        int32_t share_q16)
{
    int32_t color[3] = {from->color_8p16[0], from->color_8p16[1], from->color_8p16[2]};
    if (share_q16 < 65536) {
        const uint32_t stored = format->decode(format->pixels->load(pixel));
        for (int i = 0; i < 3; i++) {
            const int32_t below = (int32_t)(stored >> (16 - 8 * i) & 0xFFu) << 16;
            /* |.| <= 255 2^7 2^16 < 2^31 */
            color[i] = below + ((((color[i] - below) >> 9) * share_q16) >> 7);
        }
    }
    const qtri_channels channels = qtri_channels_from_color(format->colors, color);
    return format->colors->pack(channels.c);
}

/* Less than a half of 1/256 is nothing. */
#define LEAST (QTRI_STROKE_FULL / 512)

/* cover alpha / 255 in Q16: 32897 / 2^23 is 1 / 255 within 2^-30. */
static int32_t share_of(const qtri_stroker *stroker, int32_t cover)
{
    if (stroker->alpha == 255) {
        return cover >> 1;
    }
    return (int32_t)((uint32_t)(cover >> 2) * ((stroker->alpha * 32897u) >> 8) >> 14);
}

/* The part of the window inside the bounds, from its first pixel on. */
typedef struct clip {
    int32_t first, end;
} clip;

/* Depths, colours and stores of the pixels that are covered. */
QTRI_NOINLINE static void draw_covered(qtri_stroker *stroker, const clip *in)
{
    const qtri_surface *surface = stroker->surface;
    const qtri_format *format = surface->format;
    const ptrdiff_t row = stroker->row - surface->first_row;
    uint8_t *pixel = surface->pixels + row * surface->pitch +
                     (ptrdiff_t)format->pixels->bytes * (stroker->column + in->first);
    uint8_t *first_pixel = pixel;
    uint16_t *depth = stroker->compare != QTRI_DEPTH_OFF
                          ? surface->depth + row * surface->depth_pitch + stroker->column
                          : NULL;
    position at[QTRI_STROKE_WINDOW];
    uint32_t word[QTRI_STROKE_WINDOW + 4] = {0};
    uint32_t mask = 0;
    for (int32_t i = in->first; i < in->end; i++) {
        at[i].part = UINT32_MAX;
    }
    uint32_t listed = 0;
    for (const qtri_stroke_shape *s; (s = qtri_stroker_next(stroker, &listed)) != NULL;) {
        int32_t first;
        int32_t end;
        (void)qtri_stroke_shape_columns(s, stroker->row, &first, &end);
        take_positions(at, stroker, s, qtri_greatest32(first - stroker->column, in->first),
                       qtri_least32(end - stroker->column, in->end));
    }
    for (int32_t i = in->first; i < in->end; i++, pixel += format->pixels->bytes) {
        const int32_t cover = stroker->cover[i];
        mask <<= 1;
        if (cover < LEAST || at[i].part == UINT32_MAX) {
            continue;
        }
        sample s;
        take_sample(&s, shape_of(stroker, at[i].part), at[i].share_q16);
        if (depth != NULL) {
            if (!passes(stroker->compare, s.depth, depth[i])) {
                continue;
            }
            if (stroker->depth_write && cover >= QTRI_STROKE_FULL / 2) {
                depth[i] = (uint16_t)s.depth;
            }
        }
        word[i - in->first] = word_of(format, &s, pixel, share_of(stroker, cover));
        mask |= 1;
    }
    const int32_t count = in->end - in->first;
    if (mask != 0) {
        if (format->encode != NULL) {
            format->encode(word, count);
        }
        format->pixels->store(first_pixel, word, mask, count);
    }
}

/* Those whose centres lie inside. */
static void cover_hard(qtri_stroker *stroker)
{
    const int32_t y = stroker->row * 256 + 128;
    uint32_t listed = 0;
    for (const qtri_stroke_shape *s; (s = qtri_stroker_next(stroker, &listed)) != NULL;) {
        qtri_stroke_slice slice;
        /* Down to the next level, so that a side which ends here does not count. */
        if (!qtri_stroke_shape_slice(s, y, y + 1, &slice)) {
            continue;
        }
        const int32_t first = ((slice.left[0] + 127) >> 8) - stroker->column;
        const int32_t end = ((slice.right[0] + 127) >> 8) - stroker->column;
        for (int32_t i = qtri_greatest32(first, 0); i < qtri_least32(end, QTRI_STROKE_WINDOW);
             i++) {
            stroker->cover[i] = QTRI_STROKE_FULL;
        }
    }
}

static void draw_window(qtri_stroker *stroker)
{
    const clip in = {qtri_greatest32(stroker->bounds.x0 - stroker->column, 0),
                     qtri_least32(stroker->bounds.x1 - stroker->column, QTRI_STROKE_WINDOW)};
    for (int i = 0; i <= QTRI_STROKE_WINDOW; i++) {
        stroker->cover[i] = 0;
    }
    if (stroker->edges != NULL) {
        stroker->edges->cover(stroker);
    } else {
        cover_hard(stroker);
    }
    draw_covered(stroker, &in);
}

/* Lists the parts that touch the window; returns the first column of those that begin behind it. */
static int32_t list_window(qtri_stroker *stroker)
{
    const int32_t column = stroker->column;
    int32_t next = INT32_MAX;
    uint32_t at = 0;
    stroker->parts.count = 0;
    stroker->parts.rest = UINT32_MAX;
    for (uint32_t part; (part = part_of(stroker, &stroker->in_row, &at)) != UINT32_MAX;) {
        int32_t first;
        int32_t end;
        const qtri_stroke_shape *shape = shape_of(stroker, part);
        if (!qtri_stroke_shape_columns(shape, stroker->row, &first, &end) || end <= column) {
            continue;
        }
        if (first < column + QTRI_STROKE_WINDOW) {
            add_part(&stroker->parts, part);
        } else {
            next = qtri_least32(next, first);
        }
    }
    return next;
}

static void draw_row(qtri_stroker *stroker)
{
    qtri_stroke_parts *parts = &stroker->in_row;
    parts->count = 0;
    parts->rest = UINT32_MAX;
    for (uint32_t part = 0; part < stroker->source->count; part++) {
        qtri_stroke_place place;
        if (touches_row(stroker, part, &place)) {
            add_part(parts, part);
            if (parts->rest != UINT32_MAX) {
                break;
            }
        }
    }
    if (parts->count == 0) {
        return;
    }
    const int32_t to_window = ~(QTRI_STROKE_WINDOW - 1);
    int32_t column = stroker->bounds.x0 & to_window;
    while (column < stroker->bounds.x1) {
        stroker->column = column;
        const int32_t next = list_window(stroker);
        column += QTRI_STROKE_WINDOW;
        if (stroker->parts.count > 0) {
            draw_window(stroker);
        } else {
            column = next & to_window;
        }
    }
}

/* The rows that parts may touch. */
static void find_rows(const qtri_stroker *stroker, int32_t *first, int32_t *end)
{
    const qtri_stroke_source *source = stroker->source;
    int32_t top = QTRI_SCREEN_MAX_24P8 * 2;
    int32_t bottom = -top;
    for (uint32_t part = 0; part < source->count; part++) {
        qtri_stroke_place place;
        if (source->place(source->from, part, &place)) {
            const int32_t reach = place.radius_24p8 + (place.radius_24p8 >> 1) + 1;
            const int32_t y0 = place.end[0].y_24p8;
            const int32_t y1 = place.end[1].y_24p8;
            top = qtri_least32(top, qtri_least32(y0, y1) - reach);
            bottom = qtri_greatest32(bottom, qtri_greatest32(y0, y1) + reach);
        }
    }
    *first = qtri_greatest32(top >> 8, stroker->bounds.y0);
    *end = qtri_least32((bottom >> 8) + 1, stroker->bounds.y1);
}

void qtri_stroker_draw(qtri_stroker *stroker, const qtri_stroke_source *source)
{
    int32_t end;
    stroker->source = source;
    for (int i = 0; i < QTRI_STROKE_SHAPES; i++) {
        stroker->shape[i].part = UINT32_MAX;
    }
    find_rows(stroker, &stroker->row, &end);
    for (; stroker->row < end; stroker->row++) {
        draw_row(stroker);
    }
}
