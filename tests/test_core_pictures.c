/* SPDX-License-Identifier: MIT */
/*
 * Random draws with options that scene files do not name (support/random_states.h): checksums, as
 * tests/pictures.tsv records them (`make pictures`). Other tests say what is right; these see that
 * nothing else changed.
 */
#include "support/faces.h"
#include "support/random_states.h"
#include "support/recorded.h"

enum { GROUPS = 8 };

typedef char a_slot_for_each_vertex[(int)FACES_VERTICES <= (int)STATES_VERTICES ? 1 : -1];

static uint8_t memory[STATES_BYTES], resolved[STATES_BYTES];
static random_states states;

static random_states *states_of(int group)
{
    states.seed = recorded_seed(group);
    states.memory = memory;
    states.resolved = resolved;
    return &states;
}

static void record(const char *name, int32_t pictures, random_draw *draw, random_picture *picture)
{
    for (int group = 0; group < GROUPS; group++) {
        char line[RECORDED_NAME_MAX];
        uint32_t hash = RECORDED_BEGIN;
        random_states *w = states_of(group);
        for (int32_t n = 0; n < pictures; n++) {
            hash = picture(w, hash, draw);
        }
        assert_false(w->failed);
        snprintf(line, sizeof line, "core %s %d", name, group);
        recorded_judge(line, hash);
    }
}

/* One that has planes of its faces. */
static void random_faces(random_states *w)
{
    static faces_mesh made;
    faces_mesh_make(&made, &w->seed, random_one_in(w, 2) ? 0 : .05);
    w->mesh = random_one_in(w, 2) ? made.wide : made.compact;
    faces_view(&w->view, &w->seed, STATES_WIDTH, STATES_HEIGHT);
    faces_pose(&w->pose, &w->seed, &w->mesh);
    w->view.light = random_one_in(w, 3) ? NULL : &w->light;
    if (random_one_in(w, 3)) {
        w->view.light = &w->lights;
    }
    w->view.vertices = w->vertices;
    w->view.vertex_count = STATES_VERTICES;
    w->material.cull = random_one_in(w, 3) ? w->material.cull : QTRI_CULL_BACK;
}

static void draw_mesh(random_states *w, const qtri_surface *surface)
{
    if (random_one_in(w, 4)) {
        random_faces(w);
    } else {
        random_mesh(w);
    }
    random_draw_mesh(w, surface);
}

static void usual(void **state)
{
    (void)state;
    record("usual", 90, random_draw_usual, random_on_surface);
    record("usual on screen", 120, random_draw_usual_screen, random_on_surface);
}

static void solids(void **state)
{
    (void)state;
    record("solids", 60, random_draw_solid, random_on_surface);
    record("solids of samples", 60, random_draw_solid, random_on_samples);
}

static void meshes(void **state)
{
    (void)state;
    record("meshes", 120, draw_mesh, random_on_surface);
    record("meshes of samples", 50, draw_mesh, random_on_samples);
}

static void corners(void **state)
{
    (void)state;
    record("corners", 120, random_draw_corners, random_on_surface);
    record("corners of samples", 50, random_draw_corners, random_on_samples);
}

static void on_screen(void **state)
{
    (void)state;
    record("screen", 120, random_draw_screen, random_on_surface);
    record("screen of samples", 50, random_draw_screen, random_on_samples);
}

static void passes(void **state)
{
    (void)state;
    record("outlines", 60, random_draw_outlined, random_on_surface);
    record("bands", 60, NULL, random_in_bands);
}

/* A band has the rows of the whole picture. */
static void bands_have_the_pixels_of_the_whole(void **state)
{
    (void)state;
    for (const random_kind *kind = random_kinds; kind->name != NULL; kind++) {
        for (int n = 0; kind->in_bands && n < random_cases(400); n++) {
            random_states *w = states_of(n);
            const uint32_t whole = kind->picture(w, RANDOM_HASH_BEGIN, kind->draw);
            w = states_of(n);
            w->band_rows = 1 + n % 19;
            if (kind->picture(w, RANDOM_HASH_BEGIN, kind->draw) != whole) {
                fail_msg("%s, seed %d: bands of %d rows differ", kind->name, n, 1 + n % 19);
            }
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(meshes),    cmocka_unit_test(corners),
        cmocka_unit_test(on_screen), cmocka_unit_test(passes),
        cmocka_unit_test(solids),    cmocka_unit_test(bands_have_the_pixels_of_the_whole),
        cmocka_unit_test(usual),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
