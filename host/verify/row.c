/* SPDX-License-Identifier: MIT */
#include "verify.h"

#include <string.h>

void verify_row_clear(verify_row *row)
{
    memset(row, 0, sizeof *row);
    row->max = -1;
}

static bool earlier(const q16 *a, const q16 *b, int arguments)
{
    for (int i = 0; i < arguments; i++) {
        if (a[i] != b[i]) {
            return a[i] < b[i];
        }
    }
    return false;
}

static bool worse(const verify_row *row, const q16 *argument, int arguments, double error)
{
    return error > row->max || (error == row->max && earlier(argument, row->worst, arguments));
}

void verify_row_add(verify_row *row, const q16 *argument, int arguments, double error, bool correct)
{
    if (worse(row, argument, arguments, error)) {
        row->max = error;
        memcpy(row->worst, argument, (size_t)arguments * sizeof *argument);
    }
    row->inputs++;
    row->correct += correct;
}

void verify_row_merge(verify_row *into, const verify_row *from)
{
    if (worse(into, from->worst, VERIFY_ARGUMENTS, from->max)) {
        into->max = from->max;
        memcpy(into->worst, from->worst, sizeof into->worst);
    }
    into->inputs += from->inputs;
    into->correct += from->correct;
}

bool verify_row_passes(const verify_row *row, const verify_label *label)
{
    return row->max <= label->limit && (!label->all_correct || row->correct == row->inputs);
}
