/* SPDX-License-Identifier: MIT */
#include "verify.h"

#include <math.h>

double verify_clamp(double value)
{
    value = value > (double)Q16_MAX ? (double)Q16_MAX : value;
    return value < (double)Q16_MIN ? (double)Q16_MIN : value;
}

static void judge_exactly(const verify_judge *judge, const q16 *argument, q16 result,
                          verify_row *plain, verify_row *relative)
{
    verify_exact exact = judge->reference->exact(judge->reference->data, argument);
    double value = (double)exact.nearest + exact.delta;
    double error = fabs((double)(result - exact.nearest) - exact.delta);
    bool correct = result == exact.nearest;
    if (exact.nearest > Q16_MAX || (exact.nearest == Q16_MAX && exact.delta > 0) ||
        exact.nearest < Q16_MIN || (exact.nearest == Q16_MIN && exact.delta < 0)) {
        value = verify_clamp(value);
        error = fabs((double)result - value);
        correct = error == 0;
    }
    if (judge->relative_from > 0 && fabs(value) >= judge->relative_from) {
        error /= fabs(value) * judge->relative_unit;
        plain = relative;
    }
    verify_row_add(plain, argument, judge->arguments, error, correct);
}

void verify_judge_result(const verify_judge *judge, const q16 *argument, q16 result,
                         verify_row *plain, verify_row *relative)
{
    if (judge->exact_only || judge->reference->fast == NULL) {
        judge_exactly(judge, argument, result, plain, relative);
        return;
    }
    verify_value fast = judge->reference->fast(judge->reference->data, argument);
    if (fast.value - fast.unsure > (double)Q16_MAX || fast.value + fast.unsure < (double)Q16_MIN) {
        fast.unsure = 0; /* saturated, however large it is */
    }
    double value = verify_clamp(fast.value);
    double error = fabs((double)result - value);
    bool undecided = !(fabs(error - 0.5) > fast.unsure); /* nor is what is not a number */
    double counted = error;
    double unsure = fast.unsure;
    verify_row *row = plain;
    if (judge->relative_from > 0) {
        undecided = undecided || fabs(fabs(value) - judge->relative_from) <= fast.unsure;
        if (fabs(value) >= judge->relative_from) {
            double unit = fabs(value) * judge->relative_unit;
            /* The value divides as well; it is unsure by less than one part in a thousand. */
            undecided = undecided || fast.unsure > fabs(value) / 1024;
            counted = error / unit;
            unsure = (fast.unsure / unit) * 1.01 + counted * (fast.unsure / fabs(value)) * 1.01;
            row = relative;
        }
    }
    if (undecided || (fast.unsure > 0 && counted + unsure >= row->max)) {
        judge_exactly(judge, argument, result, plain, relative);
        return;
    }
    verify_row_add(row, argument, judge->arguments, counted, error <= 0.5);
}
