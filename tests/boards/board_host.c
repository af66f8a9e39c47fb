/* SPDX-License-Identifier: MIT */
/*
 * The host as one more board: prints the lines that the emulated boards must reproduce.
 * With a folder as argument it also writes every scene in every format as a PPM there.
 */
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>

#include "../../port/boards/board.h"
#include "board_scenes.h"

void board_init(void)
{
}

void board_write(const char *text)
{
    fputs(text, stdout);
}

uint32_t board_ticks(void)
{
    return 0;
}

uint32_t board_instructions(uint32_t from_ticks, uint32_t to_ticks)
{
    (void)from_ticks;
    (void)to_ticks;
    return 0; /* not counted here */
}

size_t board_stack_used(void)
{
    return 0;
}

void board_exit(int status)
{
    exit(status);
}

static uint64_t memory[512 * 1024 / sizeof(uint64_t)];

static const struct {
    const char *name;
    const qtri_format *format;
} formats[] = {{"rgb565", &qtri_rgb565}, {"xrgb8888", &qtri_xrgb8888}, {"gray8", &qtri_gray8}};

static bool write_ppm(const char *folder, const board_scene *scene, int number)
{
    board_scene_memory *scratch = (void *)memory;
    char path[1024];
    qtri_surface frame;
    if (qtri_surface_init(&frame, formats[number].format, scene->width, scene->height, 0,
                          scene->height, scratch + 1, sizeof memory - sizeof *scratch) != QTRI_OK) {
        return false;
    }
    qtri_surface_clear(&frame, scene->background);
    scene->draw(&frame, scratch);
    snprintf(path, sizeof path, "%s/%s-%s.ppm", folder, scene->name, formats[number].name);
    FILE *file = fopen(path, "wb");
    if (file == NULL) {
        perror(path);
        return false;
    }
    fprintf(file, "P6\n%d %d\n255\n", (int)scene->width, (int)scene->height);
    for (int32_t y = 0; y < scene->height; y++) {
        for (int32_t x = 0; x < scene->width; x++) {
            qtri_rgb pixel = qtri_surface_pixel(&frame, x, y);
            fwrite(&pixel, 1, 3, file);
        }
    }
    return fclose(file) == 0;
}

int main(int argc, char **argv)
{
    int status = board_program(memory, sizeof memory);
    for (int i = 0; argc == 2 && i < BOARD_SCENE_COUNT; i++) {
        for (int format = 0; format < 3; format++) {
            status |= !write_ppm(argv[1], &board_scenes[i], format);
        }
    }
    return status;
}
