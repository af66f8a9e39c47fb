/* SPDX-License-Identifier: MIT */
/*
 * Checksums that tests/pictures.tsv records: what a change of the core alters is seen, and said in
 * CHANGELOG.md. QTRI_RECORD=FILE adds lines to that file in place of comparing (`make pictures`).
 * QTRI_SEED=N takes other random numbers, of which nothing is recorded: what `make mutate HUNT=N`
 * compares between a change and none.
 */
#ifndef QTRI_TESTS_SUPPORT_RECORDED_H
#define QTRI_TESTS_SUPPORT_RECORDED_H

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "test.h"

#define RECORDED          "tests/pictures.tsv"
#define RECORDED_NAME_MAX 64
#define RECORDED_BEGIN    2166136261u

/* FNV-1a of the lowest bytes of a value, in the order that every machine has. */
static inline uint32_t recorded_add(uint32_t hash, uint32_t value, int bytes)
{
    for (int i = 0; i < bytes; i++) {
        hash = (hash ^ (value >> 8 * i & 0xFF)) * 16777619u;
    }
    return hash;
}

/* Of the random numbers of a group. */
static inline uint64_t recorded_seed(int group)
{
    const char *other = getenv("QTRI_SEED");
    return (uint64_t)group + (other != NULL ? (uint64_t)strtoull(other, NULL, 10) << 16 : 0u);
}

/* Fails where another checksum is recorded of the name, or none. */
static inline void recorded_judge(const char *name, uint32_t hash)
{
    const char *record = getenv("QTRI_RECORD");
    char line[2 * RECORDED_NAME_MAX];
    if (record != NULL) {
        FILE *out = fopen(record, "a");
        assert_non_null(out);
        fprintf(out, "%s\t%08x\n", name, (unsigned)hash);
        assert_int_equal(fclose(out), 0);
        return;
    }
    FILE *in = fopen(RECORDED, "r");
    assert_non_null(in);
    size_t length = strlen(name);
    unsigned recorded = 0;
    while (fgets(line, sizeof line, in) != NULL) {
        if (strncmp(line, name, length) == 0 && line[length] == '\t') {
            recorded = (unsigned)strtoul(line + length, NULL, 16);
        }
    }
    fclose(in);
    if (recorded != hash) {
        fail_msg("%s: %08x, recorded %08x (if it is meant to differ: make pictures)", name,
                 (unsigned)hash, recorded);
    }
}

#endif
