/* SPDX-License-Identifier: MIT */
#define _XOPEN_SOURCE 700
#include "file_inputs.h"

#include <errno.h>
#include <stdlib.h>
#include <sys/stat.h>

#include "file.h"

static struct file_identity *inputs;
static size_t input_count, input_room;
static bool is_guarded;

void file_inputs_guard(void)
{
    is_guarded = true;
}

static bool is_known(const struct file_identity *identity)
{
    for (size_t i = 0; i < input_count; i++) {
        if (inputs[i].device == identity->device && inputs[i].number == identity->number) {
            return true;
        }
    }
    return false;
}

int file_inputs_add(int descriptor)
{
    struct stat status;
    if (!is_guarded || fstat(descriptor, &status) != 0 || !S_ISREG(status.st_mode)) {
        return 0;
    }
    const struct file_identity identity = {(uint64_t)status.st_dev, (uint64_t)status.st_ino};
    if (is_known(&identity)) {
        return 0;
    }
    if (input_count == input_room) {
        const size_t room = input_room == 0 ? 16 : 2 * input_room;
        struct file_identity *larger = realloc(inputs, room * sizeof *larger);
        if (larger == NULL) {
            return ENOMEM;
        }
        inputs = larger;
        input_room = room;
    }
    inputs[input_count++] = identity;
    return 0;
}

bool file_inputs_has(const char *path)
{
    struct file_identity identity;
    return input_count > 0 && file_inspect(path, &identity) == FILE_REGULAR && is_known(&identity);
}
