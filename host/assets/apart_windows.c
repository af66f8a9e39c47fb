/* SPDX-License-Identifier: MIT */
/* Windows has no fork: the work is done here, and a library's crash ends the command. */
#include "apart.h"

#ifdef _WIN32

#include <string.h>

#include "../io/system.h"

FILE *apart_run(const char *path, apart_work *work, void *context, struct text_error *error)
{
    memset(error, 0, sizeof *error);
    FILE *file = system_temporary();
    if (file == NULL) {
        text_error_set(error, path, 0, "cannot be read: there is no room for a temporary file");
        return NULL;
    }
    if (work(file, context, error) && fflush(file) == 0 && !ferror(file)) {
        rewind(file);
        return file;
    }
    if (error->message[0] == '\0') {
        text_error_set(error, path, 0, "cannot be read: the temporary file cannot be written");
    }
    (void)fclose(file);
    return NULL;
}

#endif
