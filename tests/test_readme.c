/* SPDX-License-Identifier: MIT */
/*
 * Samples of the documentation, word for word. README's, compiled with the gear.h that the build
 * makes: what it sends to a simulated display is the gear, turned by two degrees a frame. Those of
 * core/HOWTO.md draw what their headings say.
 */
#include "support/panel.h"

#include <setjmp.h>

void show(const qtri_bus *bus);     /* of the sample */
const qtri_mesh *readme_gear(void); /* `gear` of gear.h */

enum { ILI9341 = 7, FRAMES = 20, WRITE_MEMORY = 0x2C };

/* Counts the bytes of pixels, and leaves the sample's endless loop where a frame too many begins.
 */
static struct {
    jmp_buf done;
    bool is_writing;
    size_t pixel_bytes, most; /* most: 0, no end */
} watch;

static bool watch_command(void *context, const uint8_t *bytes, size_t count)
{
    watch.is_writing = bytes[0] == WRITE_MEMORY;
    if (watch.is_writing && watch.most > 0 && watch.pixel_bytes >= watch.most) {
        longjmp(watch.done, 1);
    }
    return wire_command(context, bytes, count);
}

static bool watch_data(void *context, const uint8_t *bytes, size_t count)
{
    watch.pixel_bytes += watch.is_writing ? count : 0;
    return wire_data(context, bytes, count);
}

static void draw_gear(const qtri_surface *surface, q16 angle)
{
    const qtri_vec3 eye = {0, 0, Q16(3)}, center = {0, 0, 0}, up = {0, Q16(1), 0};
    const qtri_light light = {
        .towards = {Q16(0.4), Q16(0.6), Q16(0.7)}, .ambient = Q16(0.2), .diffuse = Q16(0.8)};
    const qtri_rgb black = {0, 0, 0};
    qtri_view view;
    qtri_transform pose;
    qtri_material material = qtri_material_default();
    qtri_view_init(&view, 320, 240);
    qtri_transform_look_at(&view.camera, eye, center, up);
    qtri_transform_perspective(&view.projection, Q16(60), q16_from_ratio(4, 3), Q16(0.1), Q16(100));
    view.light = &light;
    qtri_transform_identity(&pose);
    qtri_transform_rotate_y(&pose, angle);
    qtri_surface_clear(surface, black);
    qtri_draw_mesh(surface, &view, &pose, readme_gear(), &material);
}

TEST(the_gear_is_what_the_readme_says)
{
    assert_int_equal(readme_gear()->vertex_count, 500);
    assert_int_equal(readme_gear()->triangle_count, 996);
}

TEST(the_sample_shows_the_gear)
{
    static setup s;
    static canvas whole;
    setup_init(&s, ILI9341);
    s.wire.bus.command = watch_command;
    s.wire.bus.data = watch_data;
    assert_ok(setup_start(&s, QTRI_ROTATE_90, true));
    whole = canvas_new(&qtri_rgb565, 320, 240);
    draw_gear(&whole.surface, (FRAMES - 1) * Q16(2));
    uint32_t *expected = picture_expected(&whole.surface, &s.panel);
    size_t seen = 0;
    for (int i = 0; i < 320 * 240; i++) {
        seen += whole.surface.depth[i] != 65535 ? 1 : 0;
    }
    assert_true(seen > 5000);
    ili9341_init(&s.sim.lcd);
    watch.most = 2 * watch.pixel_bytes + (size_t)FRAMES * 320 * 240 * 2; /* twice a start */
    if (setjmp(watch.done) == 0) {
        show(&s.wire.bus);
    }
    assert_seen(&s, expected);
    free(expected);
    canvas_free(&whole);
    setup_end(&s);
}

/* ---- core/HOWTO.md ---- */

typedef void send_band(const qtri_surface *band);
void draw_changes(qtri_frame *frame, qtri_prepared *hand, const qtri_view *view,
                  const qtri_transform *pose, const qtri_mesh *mesh, const qtri_material *material,
                  send_band *send);
void draw_smooth(qtri_frame *frame, qtri_prepared *prepared, const qtri_view *view,
                 const qtri_transform *pose, const qtri_mesh *mesh, const qtri_material *material,
                 send_band *send);
enum qtri_error begin_far(qtri_frame *frame);
void draw_axes(const qtri_surface *surface, const qtri_view *view, const qtri_transform *pose);
void paint_label(const qtri_surface *surface, const qtri_image *picture, int32_t x, int32_t y,
                 const char *text);
void draw_wide_by_face(const qtri_surface *surface, const qtri_view *view,
                       const qtri_transform *pose, const qtri_mesh *mesh,
                       const qtri_material *material);
void draw_clipped(const qtri_surface *surface, const qtri_view *view,
                  qtri_clip_vertex v[QTRI_CLIP_MAX]);
extern const qtri_format rgb444;

/* What a sample is given: the gear from the front, in bands; and all that it sends. */
static struct {
    qtri_view view;
    qtri_transform pose;
    qtri_material material;
    qtri_frame frame;
    qtri_prepared prepared;
    uint32_t lists[QTRI_PREPARED_BYTES(500, 996, 240, 16) / 4 + 1];
    uint32_t memory[QTRI_FRAME_BYTES(320, 16 + 2, QTRI_RGB565_BYTES) / 4 + 1];
    qtri_vertex vertices[500];
    uint16_t seen[240][320];
    int rows;
} how;

static void see(const qtri_surface *band)
{
    const qtri_rect b = qtri_surface_bounds(band);
    for (int32_t y = b.y0; y < b.y1; y++, how.rows++) {
        for (int32_t x = b.x0; x < b.x1; x++) {
            const qtri_rgb color = qtri_surface_pixel(band, x, y);
            how.seen[y][x] = (uint16_t)(color.r << 8 | color.g);
        }
    }
}

static void how_begin(void)
{
    const qtri_vec3 eye = {0, 0, Q16(3)}, center = {0, 0, 0}, up = {0, Q16(1), 0};
    memset(&how, 0, sizeof how);
    qtri_view_init(&how.view, 320, 240);
    qtri_view_look_at(&how.view, eye, center, up);
    qtri_view_perspective(&how.view, Q16(60), Q16(0.1), Q16(100));
    how.view.vertices = how.vertices;
    how.view.vertex_count = 500;
    qtri_transform_identity(&how.pose);
    how.material = qtri_material_default();
    assert_ok(
        qtri_frame_init(&how.frame, &qtri_rgb565, 320, 240, 16, how.memory, sizeof how.memory));
    qtri_prepared_init(&how.prepared, how.lists, sizeof how.lists);
}

static uint32_t drawn_pixels(const qtri_surface *surface)
{
    uint32_t count = 0;
    for (int32_t y = 0; y < surface->height; y++) {
        for (int32_t x = 0; x < surface->width; x++) {
            const qtri_rgb color = qtri_surface_pixel(surface, x, y);
            count += (color.r | color.g | color.b) != 0 ? 1 : 0;
        }
    }
    return count;
}

TEST(only_changes_are_sent)
{
    how_begin();
    draw_changes(&how.frame, &how.prepared, &how.view, &how.pose, readme_gear(), &how.material,
                 see);
    assert_int_equal(how.rows, 240); /* everything, at first */
    how.rows = 0;
    draw_changes(&how.frame, &how.prepared, &how.view, &how.pose, readme_gear(), &how.material,
                 see);
    assert_true(how.rows > 100 && how.rows < 240);
}

TEST(outlines_in_bands_are_those_of_the_frame)
{
    static uint32_t words[QTRI_OUTLINE_WORDS(996) + QTRI_OUTLINE_SUMS(500)];
    static uint32_t edge_words[QTRI_EDGES_WORDS(320, 240, QTRI_RGB565_BYTES)];
    const qtri_rgb sky = {0, 0, 64};
    qtri_outline outline;
    qtri_edges edges;
    how_begin();
    draw_smooth(&how.frame, &how.prepared, &how.view, &how.pose, readme_gear(), &how.material, see);
    assert_int_equal(how.rows, 240);
    canvas whole = canvas_new(&qtri_rgb565, 320, 240);
    qtri_surface_clear(&whole.surface, sky);
    assert_ok(qtri_outline_init(&outline, readme_gear(), words, LENGTH_OF(words)));
    assert_ok(
        qtri_draw_mesh_outlined(&whole.surface, &how.view, &how.pose, &how.material, &outline));
    assert_ok(qtri_edges_begin(&edges, &whole.surface, edge_words, LENGTH_OF(edge_words)));
    qtri_edges_note(&edges, &outline);
    qtri_edges_blend(&edges);
    uint32_t between = 0;
    for (int32_t y = 0; y < 240; y++) {
        for (int32_t x = 0; x < 320; x++) {
            const qtri_rgb color = qtri_surface_pixel(&whole.surface, x, y);
            assert_int_equal(how.seen[y][x], color.r << 8 | color.g);
            between += color.r != 0 && color.r != 255 ? 1 : 0;
        }
    }
    assert_true(between > 100);
    canvas_free(&whole);
}

TEST(the_other_samples_draw)
{
    qtri_clip_vertex corners[QTRI_CLIP_MAX] = {
        {100, 20, 0, 1, 0, 0}, {100, 200, 0, 1, 0, 0}, {100000, 200, 0, 1, 0, 0}};
    qtri_frame far_frame;
    how_begin();
    canvas c = canvas_new(&rgb444, 320, 240);
    canvas_clear(&c);
    draw_axes(&c.surface, &how.view, &how.pose);
    assert_true(drawn_pixels(&c.surface) > 300);
    canvas_clear(&c);
    draw_clipped(&c.surface, &how.view, corners);
    assert_true(drawn_pixels(&c.surface) > 10000);
    assert_int_equal(qtri_surface_pixel(&c.surface, 150, 190).g, 0x88);
    const qtri_image picture = qtri_image_of(&c.surface);
    canvas other = canvas_new(&qtri_rgb888, 320, 240);
    canvas_clear(&other);
    paint_label(&other.surface, &picture, 0, -20, "320 x 240");
    assert_true(drawn_pixels(&other.surface) > drawn_pixels(&c.surface));
    canvas_clear(&c);
    draw_wide_by_face(&c.surface, &how.view, &how.pose, readme_gear(), &how.material);
    assert_true(drawn_pixels(&c.surface) > 5000);
    assert_ok(begin_far(&far_frame));
    canvas_free(&c);
    canvas_free(&other);
}

int main(void)
{
    return run_all_tests(NULL, NULL);
}
