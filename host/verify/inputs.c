/* SPDX-License-Identifier: MIT */
/*
 * What the functions are asked. Random numbers are the same in every run and on every thread.
 */
#include "verify.h"

#include <pthread.h>
#include <string.h>

/* splitmix64 (Steele, Lea and Flood 2014). */
uint64_t verify_random(uint64_t *state)
{
    uint64_t z = (*state += 0x9E3779B97F4A7C15u);
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return z ^ (z >> 31);
}

q16 verify_random_q16(uint64_t *state)
{
    uint64_t bits = verify_random(state);
    uint32_t low = (uint32_t)bits;
    q16 value;
    memcpy(&value, &low, sizeof value);
    /* 0: any; 1: any magnitude; and one in eight is odd times a power of two, which makes ties. */
    int shift = (int)(bits >> 33 & 31);
    if ((bits >> 32 & 1) == 0) {
        return value;
    }
    return (bits >> 38 & 3) == 0 ? (value >> shift) * (1 << (shift / 2)) : value >> shift;
}

static q16 stress[VERIFY_STRESS];
static int stress_count;
static pthread_once_t stress_once = PTHREAD_ONCE_INIT;

/* Unless it is there already. */
static void stress_add(int64_t value)
{
    bool room = stress_count < VERIFY_STRESS && value >= INT32_MIN && value <= INT32_MAX;
    for (int i = 0; i < stress_count && room; i++) {
        room = stress[i] != value;
    }
    if (room) {
        stress[stress_count++] = (q16)value;
    }
}

static void stress_near(int64_t centre, int64_t distance)
{
    for (int64_t value = centre - distance; value <= centre + distance; value++) {
        stress_add(value);
    }
}

static void stress_fill(void)
{
    stress_near(0, 200);
    stress_near(INT32_MAX, 8);
    stress_near(INT32_MIN, 8);
    for (int bit = 8; bit < 32; bit++) {
        for (int sign = -1; sign <= 1; sign += 2) {
            int64_t power = sign * ((int64_t)1 << bit);
            stress_near(power, 6);
            stress_near(power + power / 2, 2);
            stress_near(power + power / 4, 1);
        }
    }
    for (int n = -180; n <= 180; n++) {
        stress_near((int64_t)n * 65536, 1);
        stress_add((int64_t)n * 65536 + 32768);
    }
    for (int n = -15; n <= 15; n++) {
        stress_near((int64_t)n * 90 * 65536, 2);
    }
    uint64_t seed = 3;
    while (stress_count < VERIFY_STRESS) {
        stress_add(verify_random_q16(&seed));
    }
}

const q16 *verify_stress(void)
{
    (void)pthread_once(&stress_once, stress_fill);
    return stress;
}

/* Half evenly spread with a random offset, a quarter around zero, a quarter around powers of two.
 */
q16 verify_stratum(int index)
{
    int64_t block;
    const int64_t blocks = (int64_t)1 << 22; /* -2^21..2^21-1 */
    if (index < VERIFY_STRATA / 2) {
        uint64_t seed = (uint64_t)index;
        int64_t width = blocks / (VERIFY_STRATA / 2);
        block = index * width + (int64_t)(verify_random(&seed) % (uint64_t)width) - blocks / 2;
    } else if (index < VERIFY_STRATA * 3 / 4) {
        block = index - VERIFY_STRATA * 5 / 8;
    } else {
        int k = index - VERIFY_STRATA * 3 / 4; /* 16 powers, either sign, 8 blocks about each */
        int64_t power = (int64_t)1 << (6 + k / 16);
        block = (k / 8 % 2 != 0 ? power : -power) + k % 8 - 4;
        block = block < -blocks / 2 ? -blocks / 2 : block;
        block = block >= blocks / 2 ? blocks / 2 - 1 : block;
    }
    return (q16)(block * VERIFY_BLOCK);
}
