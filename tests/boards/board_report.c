/* SPDX-License-Identifier: MIT */
/*
 * Draws every board scene in every format, as a whole frame and in bands, and writes one line for
 * each to the board's console:
 *
 *   scene format rows crc32 pixels instructions
 *
 * crc32 covers colour and depth of the whole frame, row by row, values in little-endian order, so
 * that it does not depend on bands or on the machine. pixels counts those with a depth written.
 *
 * Frames that do not fit the memory are reported as `# no memory` and left out; a band that does
 * not fit is an error. The last lines are `# stack <bytes>` and `end <lines> <pixels>`, of all
 * frames.
 */
#include "board_scenes.h"

#include "../../port/boards/board.h"
#include "board_print.h"

static const struct {
    const char *name;
    const qtri_format *format;
} formats[] = {{"rgb565", &qtri_rgb565}, {"xrgb8888", &qtri_xrgb8888}, {"gray8", &qtri_gray8}};

#define BAND_ROWS    16
#define FORMAT_COUNT (sizeof formats / sizeof formats[0])

typedef struct tally {
    uint32_t crc, pixels, instructions;
} tally;

/* CRC-32 (IEEE 802.3, reflected), four bits at a time; `bytes` of value, the low one first. */
static uint32_t crc32_add(uint32_t crc, uint32_t value, uint32_t bytes)
{
    static const uint32_t table[16] = {0x00000000, 0x1DB71064, 0x3B6E20C8, 0x26D930AC,
                                       0x76DC4190, 0x6B6B51F4, 0x4DB26158, 0x5005713C,
                                       0xEDB88320, 0xF00F9344, 0xD6D6A3E8, 0xCB61B38C,
                                       0x9B64C2B0, 0x86D3D2D4, 0xA00AE278, 0xBDBDF21C};
    for (uint32_t nibble = 0; nibble < 2 * bytes; nibble++) {
        crc = (crc >> 4) ^ table[(crc ^ value) & 15];
        value >>= 4;
    }
    return crc;
}

static void tally_rows(tally *sum, const qtri_surface *surface)
{
    const qtri_pixels *pixels = surface->format->pixels;
    for (int32_t y = 0; y < surface->rows; y++) {
        const uint8_t *row = surface->pixels + y * surface->pitch;
        const uint16_t *depth = surface->depth + y * surface->depth_pitch;
        for (int32_t x = 0; x < surface->width; x++) {
            sum->crc = crc32_add(sum->crc, pixels->load(row + x * pixels->bytes), pixels->bytes);
            sum->crc = crc32_add(sum->crc, depth[x], 2);
            sum->pixels += depth[x] != UINT16_MAX;
        }
    }
}

/* One frame in bands of `rows` rows: this loop is what an application does as well. */
static enum qtri_error draw_frame(tally *sum, const board_scene *scene, const qtri_format *format,
                                  int32_t rows, board_scene_memory *scratch, void *memory,
                                  size_t bytes)
{
    sum->crc = UINT32_MAX;
    sum->pixels = 0;
    sum->instructions = 0;
    for (int32_t first_row = 0; first_row < scene->height; first_row += rows) {
        qtri_surface band;
        enum qtri_error error = qtri_surface_init(&band, format, scene->width, scene->height,
                                                  first_row, rows, memory, bytes);
        if (error != QTRI_OK) {
            return error;
        }
        uint32_t start = board_ticks();
        qtri_surface_clear(&band, scene->background);
        scene->draw(&band, scratch);
        sum->instructions += board_instructions(start, board_ticks());
        tally_rows(sum, &band); /* an application sends the band to its display here */
    }
    sum->crc = ~sum->crc;
    return QTRI_OK;
}

static void write_line(const board_scene *scene, const char *format, int32_t rows, const tally *sum)
{
    board_write(scene->name);
    board_write(" ");
    board_write(format);
    board_write(" ");
    board_write_decimal((uint32_t)rows);
    board_write(" ");
    board_write_hex8(sum->crc);
    board_write(" ");
    board_write_decimal(sum->pixels);
    board_write(" ");
    board_write_decimal(sum->instructions);
    board_write("\n");
}

int board_program(void *memory, size_t bytes)
{
    board_scene_memory *scratch = memory;
    if (bytes < sizeof *scratch) {
        return 1;
    }
    void *frame = scratch + 1;
    size_t frame_bytes = bytes - sizeof *scratch;
    int status = 0;
    uint32_t lines = 0;
    uint32_t compared = 0;
    board_scenes_prepare(scratch);
    for (uint32_t i = 0; i < BOARD_SCENE_COUNT * FORMAT_COUNT * 2; i++) {
        const board_scene *scene = &board_scenes[i / (FORMAT_COUNT * 2)];
        uint32_t format = i / 2 % FORMAT_COUNT;
        bool whole = i % 2 == 0;
        int32_t rows = whole ? scene->height : BAND_ROWS;
        tally sum;
        enum qtri_error error =
            draw_frame(&sum, scene, formats[format].format, rows, scratch, frame, frame_bytes);
        if (error == QTRI_OK) {
            write_line(scene, formats[format].name, rows, &sum);
            lines++;
            compared += (uint32_t)(scene->width * scene->height);
        } else if (whole && error == QTRI_ERROR_MEMORY) {
            board_write("# no memory for a whole frame: ");
            board_write(scene->name);
            board_write("\n");
        } else {
            status = 1;
        }
    }
    board_write("# stack ");
    board_write_decimal((uint32_t)board_stack_used());
    board_write("\nend ");
    board_write_decimal(lines);
    board_write(" ");
    board_write_decimal(compared);
    board_write("\n");
    return status;
}
