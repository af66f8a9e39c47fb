/* SPDX-License-Identifier: MIT */
#include "scene_draw.h"

#include "scene_color.h"

static qtri_light_color color_of(const int32_t c[3])
{
    const qtri_light_color color = {c[0], c[1], c[2]};
    return color;
}

/* Scenes give lights in eye space: that is the world of a view whose camera is the identity. */
static void set_source(struct scene_resources *resources, uint32_t i, const struct scene_lamp *lamp)
{
    static const qtri_light_kind *const kinds[] = {[SCENE_DIRECTIONAL] = &qtri_directional_light,
                                                   [SCENE_POINT] = &qtri_point_light,
                                                   [SCENE_SPOT] = &qtri_spot_light};
    qtri_light_source *source = &resources->sources[i];
    source->kind = kinds[lamp->kind];
    source->position = scene_vec3(lamp->position);
    source->color = color_of(lamp->color);
    source->constant = lamp->fade[0];
    source->linear = lamp->fade[1];
    source->quadratic = lamp->fade[2];
    source->direction = scene_vec3(lamp->direction);
    source->inner = lamp->inner;
    source->outer = lamp->outer;
    if (lamp->exponent != 0) {
        qtri_shininess_init(&resources->falloff[i], lamp->exponent);
        source->falloff = &resources->falloff[i];
    }
}

static void set_reflection(struct scene_resources *resources, const struct scene_reflection *from)
{
    qtri_reflection *reflection = &resources->reflection;
    reflection->ambient = scene_rgb(from->ambient);
    reflection->specular = scene_rgb(from->specular);
    reflection->emission = scene_rgb(from->emission);
    reflection->own_ambient = from->own_ambient;
    reflection->two_sided = from->two_sided;
    if (from->shininess != 0) {
        qtri_shininess_init(&resources->shininess, from->shininess);
        reflection->shininess = &resources->shininess;
    }
}

/* `light` with numbers alone is a white one among the others. */
void scene_lights_create(struct scene_resources *resources, const struct scene *scene)
{
    const struct scene_light *light = &scene->light;
    const bool has_light = (light->towards[0] | light->towards[1] | light->towards[2]) != 0;
    int32_t ambient[3] = {scene->ambient[0], scene->ambient[1], scene->ambient[2]};
    uint32_t count = 0;
    set_reflection(resources, &scene->reflection);
    for (int i = 0; i < scene->lamp_count; i++) {
        set_source(resources, count++, &scene->lamps[i]);
    }
    if (has_light) {
        const struct scene_lamp white = {
            .kind = SCENE_DIRECTIONAL,
            .position = {light->towards[0], light->towards[1], light->towards[2]},
            .color = {light->diffuse, light->diffuse, light->diffuse}};
        set_source(resources, count++, &white);
        for (int i = 0; i < 3; i++) {
            ambient[i] += light->ambient;
        }
    }
    if (has_light || scene->lamps_on) {
        (void)qtri_light_init(&resources->lights, resources->sources, count, color_of(ambient));
    }
}
