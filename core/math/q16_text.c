/* SPDX-License-Identifier: MIT */
#include "qtri/error.h"
#include "qtri/q16.h"

#include "../bits/bits.h"

/*
 * Thresholds between two neighbours are odd multiples of 2^-17, which have 17 decimals: of more
 * digits, those beyond can be cut off without changing which side of a threshold a number is on.
 */
enum { FRACTION_DIGITS = 17 };

/* F / 10^17 in units of 2^-16, halves up, is (F + 5^17) / (2 5^17), rounded down. */
#define FIVE_17 ((uint64_t)762939453125u)

static int digit_of(char c)
{
    return c >= '0' && c <= '9' ? c - '0' : -1;
}

int32_t q16_from_string(const char *text, q16 *out)
{
    QTRI_ASSERT(text != NULL && out != NULL);
    int32_t length = text[0] == '-' || text[0] == '+';
    int32_t digits = 0;
    uint32_t whole = 0;
    for (; digit_of(text[length]) >= 0; length++) {
        whole = whole * 10 + (uint32_t)digit_of(text[length]);
        whole = whole > 32769 ? 32769 : whole; /* beyond the range, whatever follows */
        digits++;
    }
    uint64_t fraction = 0;
    int32_t places = 0;
    if (text[length] == '.' && (digits > 0 || digit_of(text[length + 1]) >= 0)) {
        for (length++; digit_of(text[length]) >= 0; length++) {
            if (places < FRACTION_DIGITS) {
                fraction = fraction * 10 + (uint32_t)digit_of(text[length]);
                places++;
            }
            digits++;
        }
    }
    if (digits == 0) {
        return 0;
    }
    for (; places < FRACTION_DIGITS; places++) {
        fraction *= 10; /* < 10^17 < 2^57 */
    }
    uint32_t units = 0; /* 0..2^16 */
    fraction += FIVE_17;
    for (uint64_t step = FIVE_17 << 17; step != FIVE_17; step >>= 1) { /* < 2^57 */
        units <<= 1;
        if (fraction >= step) {
            fraction -= step;
            units++;
        }
    }
    uint32_t size = (whole << 16) + units; /* < 2^32 */
    bool negative = text[0] == '-';
    if (size > (negative ? 0x80000000u : 0x7FFFFFFFu)) {
        *out = negative ? Q16_MIN : Q16_MAX;
        return QTRI_ERROR_SIZE;
    }
    *out = (q16)(negative ? 0 - size : size);
    return length;
}

int32_t q16_to_string(q16 x, char *buffer, size_t size)
{
    QTRI_ASSERT(buffer != NULL || size == 0);
    uint32_t magnitude = qtri_magnitude32(x);
    uint32_t fraction = magnitude & 0xFFFFu;
    /*
     * With n digits, c / 10^n is read as fraction / 2^16 if it is off by half a unit at most, and
     * by less above. Five digits always do: 10^-5 < 2^-16.
     */
    uint32_t power = 1;
    uint32_t decimal = 0; /* <= 10^5 */
    int32_t places = 0;
    for (;; places++) {
        uint64_t exact = (uint64_t)fraction * power; /* in units of 10^-n 2^-16 */
        decimal = (uint32_t)((exact + 0x8000u) >> 16);
        int64_t twice_off = 2 * (int64_t)(((uint64_t)decimal << 16) - exact);
        if (places == 5 || (twice_off >= -(int64_t)power && twice_off < (int64_t)power)) {
            break;
        }
        power *= 10;
    }
    char reversed[QTRI_Q16_TEXT_SIZE];
    int32_t length = 0;
    for (int32_t i = 0; i < places; i++) {
        reversed[length++] = (char)('0' + decimal % 10);
        decimal /= 10;
    }
    if (places > 0) {
        reversed[length++] = '.';
    }
    uint32_t whole = magnitude >> 16;
    do {
        reversed[length++] = (char)('0' + whole % 10);
        whole /= 10;
    } while (whole != 0);
    if (x < 0) {
        reversed[length++] = '-';
    }
    if (size <= (size_t)length) {
        if (size > 0) {
            buffer[0] = '\0';
        }
        return QTRI_ERROR_MEMORY;
    }
    for (int32_t i = 0; i < length; i++) {
        buffer[i] = reversed[length - 1 - i];
    }
    buffer[length] = '\0';
    return length;
}
