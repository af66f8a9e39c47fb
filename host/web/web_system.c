/* SPDX-License-Identifier: MIT */
/* Of ../io/system.h and ../assets/apart.h what the page needs: there are no links to follow, no
   signals and no processes. */
#define _XOPEN_SOURCE 700
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../assets/apart.h"
#include "../io/system.h"
#include "../io/xalloc.h"

/* The page starts the module anew, and says that the model is more than it can take. */
void xalloc_die(void)
{
    fputs("out of memory\n", stderr);
    abort();
}

char *system_real_path(const char *path)
{
    return strdup(path);
}

/* The work is done here; the page starts the module anew after a crash. */
FILE *apart_run(const char *path, apart_work *work, void *context, struct text_error *error)
{
    static char *answer; /* of the last work, until the next */
    static size_t length;
    free(answer);
    answer = NULL;
    memset(error, 0, sizeof *error);
    FILE *file = open_memstream(&answer, &length);
    const bool ok = file != NULL && work(file, context, error);
    const bool is_whole = file != NULL && fclose(file) == 0;
    FILE *reading = ok && is_whole ? fmemopen(answer, length, "rb") : NULL;
    if (reading == NULL && error->message[0] == '\0') {
        text_error_set(error, path, 0, "out of memory");
    }
    return reading;
}
