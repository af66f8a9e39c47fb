/* SPDX-License-Identifier: MIT */
/*
 * The README's sample, word for word, compiled with the gear.h that the build makes: what it sends
 * to a simulated display is the gear, turned by two degrees a frame.
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

static void the_gear_is_what_the_readme_says(void **state)
{
    (void)state;
    assert_int_equal(readme_gear()->vertex_count, 500);
    assert_int_equal(readme_gear()->triangle_count, 996);
}

static void the_sample_shows_the_gear(void **state)
{
    (void)state;
    static setup s;
    static canvas whole;
    setup_init(&s, ILI9341);
    s.wire.bus.command = watch_command;
    s.wire.bus.data = watch_data;
    assert_int_equal(setup_start(&s, QTRI_ROTATE_90, true), QTRI_OK);
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

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_gear_is_what_the_readme_says),
        cmocka_unit_test(the_sample_shows_the_gear),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
