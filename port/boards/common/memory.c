/* SPDX-License-Identifier: MIT */
/*
 * What a compiler calls behind the program's back, for boards without a C library.
 * Words where both sides are aligned; -fno-tree-loop-distribute-patterns keeps these loops from
 * being recognised as what they are and replaced by calls to themselves.
 */
#include <stddef.h>
#include <stdint.h>

typedef uint32_t __attribute__((may_alias)) any_word;

void *memcpy(void *restrict to, const void *restrict from, size_t count);
void *memmove(void *to, const void *from, size_t count);
void *memset(void *to, int value, size_t count);

static size_t misaligned(const void *p)
{
    return (uintptr_t)p % sizeof(any_word);
}

void *memcpy(void *restrict to, const void *restrict from, size_t count)
{
    uint8_t *out = to;
    const uint8_t *in = from;
    if ((misaligned(out) | misaligned(in)) == 0) {
        for (; count >= sizeof(any_word); count -= sizeof(any_word)) {
            *(any_word *)(void *)out = *(const any_word *)(const void *)in;
            out += sizeof(any_word);
            in += sizeof(any_word);
        }
    }
    while (count-- > 0) {
        *out++ = *in++;
    }
    return to;
}

void *memmove(void *to, const void *from, size_t count)
{
    uint8_t *out = to;
    const uint8_t *in = from;
    if ((uintptr_t)out - (uintptr_t)in >= count) {
        return memcpy(to, from, count); /* a forward copy reads every byte before writing it */
    }
    while (count-- > 0) {
        out[count] = in[count];
    }
    return to;
}

void *memset(void *to, int value, size_t count)
{
    uint8_t *out = to;
    any_word word = (uint8_t)value * 0x01010101u;
    while (count > 0 && misaligned(out) != 0) {
        *out++ = (uint8_t)value;
        count--;
    }
    for (; count >= sizeof(any_word); count -= sizeof(any_word)) {
        *(any_word *)(void *)out = word;
        out += sizeof(any_word);
    }
    while (count-- > 0) {
        *out++ = (uint8_t)value;
    }
    return to;
}
