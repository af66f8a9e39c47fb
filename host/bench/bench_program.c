/* SPDX-License-Identifier: MIT */
/*
 * The program of a board: one line for each scene,
 *
 *   scene crc32 pixels triangles instructions
 *
 * and `end`. crc32 covers colour and depth, row by row, values in little-endian order.
 */
#include "bench_program.h"

#include "../../port/boards/board.h"
#include "bench_core.h"
#include "bench_print.h"

bench_frame bench_memory;

/* CRC-32 (IEEE 802.3, reflected), four bits at a time, of 16 bits, the low byte first. */
static uint32_t crc32_add(uint32_t crc, uint32_t value)
{
    static const uint32_t table[16] = {0x00000000, 0x1DB71064, 0x3B6E20C8, 0x26D930AC,
                                       0x76DC4190, 0x6B6B51F4, 0x4DB26158, 0x5005713C,
                                       0xEDB88320, 0xF00F9344, 0xD6D6A3E8, 0xCB61B38C,
                                       0x9B64C2B0, 0x86D3D2D4, 0xA00AE278, 0xBDBDF21C};
    for (uint32_t nibble = 0; nibble < 4; nibble++) {
        crc = (crc >> 4) ^ table[(crc ^ value) & 15];
        value >>= 4;
    }
    return crc;
}

static uint32_t checksum(const qtri_surface *surface)
{
    uint32_t crc = UINT32_MAX;
    for (int32_t y = 0; y < surface->rows; y++) {
        const qtri_pixels *pixels = surface->format->pixels;
        const uint8_t *color = surface->pixels + y * surface->pitch;
        const uint16_t *depth = surface->depth + y * surface->depth_pitch;
        for (int32_t x = 0; x < surface->width; x++) {
            crc = crc32_add(crc, pixels->load(color + x * pixels->bytes));
            crc = crc32_add(crc, depth[x]);
        }
    }
    return ~crc;
}

uint32_t bench_pixels(const bench_frame *frame)
{
    uint32_t count = 0;
    for (int32_t y = 0; y < frame->surface.rows; y++) {
        for (int32_t x = 0; x < frame->surface.width; x++) {
            count += frame->scene->work == BENCH_CLEAR || bench_is_drawn(frame, x, y);
        }
    }
    return count;
}

/* BENCH_ONLY: the name of the one scene to draw. */
#ifdef BENCH_ONLY
static bool is_wanted(const char *name)
{
    const char *only = BENCH_ONLY;
    while (*name != '\0' && *name == *only) {
        name++;
        only++;
    }
    return *name == *only;
}
#else
static bool is_wanted(const char *name)
{
    (void)name;
    return true;
}
#endif

int board_program(void *memory, size_t bytes)
{
    (void)memory;
    (void)bytes;
    bench_set_up_core();
    for (const bench_scene *scene = bench_scenes; scene->name != NULL; scene++) {
        bench_frame *frame = &bench_memory;
        if (!is_wanted(scene->name) || !bench_prepare(frame, scene)) {
            continue;
        }
        uint32_t start = board_ticks();
        bench_draw(frame);
        uint32_t instructions = board_instructions(start, board_ticks());
        bench_finish(frame);
        board_write(scene->name);
        board_write(" ");
        bench_write_number(checksum(&frame->surface), 16, 8);
        bench_write_decimal(bench_pixels(frame));
        bench_write_decimal(bench_triangles(scene));
        bench_write_decimal(instructions);
        board_write("\n");
    }
    board_write("end\n");
    return 0;
}
