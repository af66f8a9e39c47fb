/* SPDX-License-Identifier: MIT */
#include "picture.h"

#include "../frame/barrier.h"

#ifndef __OPTIMIZE_SIZE__
/* What a loop knows of its pixels: how many bytes, whether there is a key, whether v changes. */
typedef struct kind {
    int32_t bytes;
    bool is_keyed, is_turned;
} kind;

QTRI_INLINE void walk_row(kind is, const qtri_picture_walk *walk, uint8_t *to, int32_t count)
{
    const qtri_image *image = walk->image;
    const ptrdiff_t pitch = image->pitch;
    const uint8_t *pixels = (const uint8_t *)image->pixels;
    const uint32_t mask = is.is_keyed && is.bytes == 4 ? qtri_picture_key_mask(image) : UINT32_MAX;
    const uint32_t key = image->key & mask;
    const uint32_t du = walk->du;
    const uint32_t dv = walk->dv;
    uint32_t u = walk->u;
    uint32_t v = walk->v;
    if (!is.is_turned) {
        pixels += (ptrdiff_t)(v >> 16) * pitch;
    }
#define ONE(i)                                                                                     \
    {                                                                                              \
        const uint8_t *row = is.is_turned ? pixels + (ptrdiff_t)(v >> 16) * pitch : pixels;        \
        const uint32_t stored = qtri_stored_get(is.bytes, row + (ptrdiff_t)(u >> 16) * is.bytes);  \
        u += du;                                                                                   \
        QTRI_OPAQUE(u)                                                                             \
        if (is.is_turned) {                                                                        \
            v += dv;                                                                               \
            QTRI_OPAQUE(v)                                                                         \
        }                                                                                          \
        if (!is.is_keyed) {                                                                        \
            qtri_stored_put(is.bytes, to + (i)*is.bytes, stored);                                  \
        } else if ((stored & mask) != key) {                                                       \
            QTRI_BRANCH                                                                            \
            qtri_stored_put(is.bytes, to + (i)*is.bytes, stored);                                  \
        }                                                                                          \
    }
    for (; count >= 4; count -= 4) {
        ONE(0)
        ONE(1)
        ONE(2)
        ONE(3)
        to += 4 * is.bytes;
    }
    for (; count > 0; count--) {
        ONE(0)
        to += is.bytes;
    }
#undef ONE
}

QTRI_INLINE void walk_sized(int32_t bytes, const qtri_picture_walk *walk, uint8_t *to,
                            int32_t count)
{
    const kind plain = {bytes, false, false};
    const kind turned = {bytes, false, true};
    const kind keyed = {bytes, true, false};
    const kind keyed_turned = {bytes, true, true};
    if (!walk->image->has_key) {
        if (walk->dv == 0) {
            walk_row(plain, walk, to, count);
        } else {
            walk_row(turned, walk, to, count);
        }
    } else if (walk->dv == 0) {
        walk_row(keyed, walk, to, count);
    } else {
        walk_row(keyed_turned, walk, to, count);
    }
}

bool qtri_picture_walk_row(const qtri_picture_walk *walk, uint8_t *to, int32_t count)
{
    const qtri_image *image = walk->image;
    const int32_t bytes = image->format->pixels->bytes;
    if (walk->dv == 0 && walk->du == 65536 && !image->has_key) {
        const uint8_t *row =
            (const uint8_t *)image->pixels + (ptrdiff_t)(walk->v >> 16) * image->pitch;
        qtri_picture_copy(to, 0, row + (ptrdiff_t)(walk->u >> 16) * bytes, 0,
                          (size_t)bytes * (size_t)count, 1);
        return true;
    }
    switch (bytes) {
    case 1:
        walk_sized(1, walk, to, count);
        return true;
    case 2:
        walk_sized(2, walk, to, count);
        return true;
    case 3:
        walk_sized(3, walk, to, count);
        return true;
    case 4:
        walk_sized(4, walk, to, count);
        return true;
    default:
        return false;
    }
}
#else
bool qtri_picture_walk_row(const qtri_picture_walk *walk, uint8_t *to, int32_t count)
{
    (void)walk;
    (void)to;
    (void)count;
    return false;
}
#endif
