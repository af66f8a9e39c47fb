/* SPDX-License-Identifier: MIT */
/*
 * What the fuzzer has found to reach in core, drawn again: checksums of groups of the inputs in
 * tests/corpus/fuzz_draw.b64, as tests/pictures.tsv records them (`make pictures`, also after
 * `make corpus`).
 */
#include "support/core.h"
#include "support/draw_bytes.h"
#include "support/recorded.h"

enum { GROUP = 50, LINE_BYTES = 20000, LONGER = 1200, LIKE_IT = 20 };

static uint64_t seed;

static int32_t digit_of_base64(char c)
{
    static const char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    const char *at = c != '\0' ? strchr(digits, c) : NULL;
    return at != NULL ? (int32_t)(at - digits) : -1;
}

/* The bytes of a line, up to its padding; returns how many. */
static size_t decode(const char *line, uint8_t *out)
{
    uint32_t bits = 0;
    int count = 0;
    size_t bytes = 0;
    for (int32_t digit; (digit = digit_of_base64(*line)) >= 0; line++) {
        bits = bits << 6 | (uint32_t)digit;
        count += 6;
        if (count >= 8) {
            count -= 8;
            out[bytes++] = (uint8_t)(bits >> count);
        }
    }
    return bytes;
}

/* What these bytes draw, and others like them: longer, with some bytes changed. */
static uint32_t draw_input(uint32_t hash, const uint8_t *input, size_t bytes)
{
    uint8_t *exactly = malloc(bytes > 0 ? bytes : 1); /* AddressSanitizer watches its end */
    assert_non_null(exactly);
    memcpy(exactly, input, bytes);
    hash = recorded_add(hash, draw_bytes(exactly, bytes, qtri_pipelines_default), 4);
    free(exactly);
    for (int like = 0; like < LIKE_IT; like++) {
        uint8_t other[LONGER];
        for (size_t i = 0; i < LONGER; i++) {
            const bool kept = i < bytes && random_in(&seed, 0, 31) != 0;
            other[i] = kept ? input[i] : (uint8_t)random_in(&seed, 0, 255);
        }
        hash = recorded_add(hash, draw_bytes(other, LONGER, qtri_pipelines_default), 4);
    }
    return hash;
}

TEST(inputs_of_the_corpus_draw_what_they_drew)
{
    static char line[LINE_BYTES];
    static uint8_t input[LINE_BYTES];
    char name[RECORDED_NAME_MAX];
    uint32_t hash = RECORDED_BEGIN;
    int count = 0;
    seed = recorded_seed(0);
    FILE *in = fopen("tests/corpus/fuzz_draw.b64", "r");
    assert_non_null(in);
    while (fgets(line, sizeof line, in) != NULL) {
        assert_non_null(strchr(line, '\n'));
        const size_t bytes = decode(line, input);
        hash = draw_input(hash, input, bytes);
        count++;
        if (count % GROUP == 0) {
            snprintf(name, sizeof name, "corpus %d", count);
            recorded_judge(name, hash);
            hash = RECORDED_BEGIN;
        }
    }
    assert_int_equal(fclose(in), 0);
    recorded_judge("corpus rest", hash);
}

int main(void)
{
    return run_all_tests(NULL, NULL);
}
