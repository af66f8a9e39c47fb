/* SPDX-License-Identifier: MIT */
#define _XOPEN_SOURCE 700
#include "file.h"

#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "file_identity.h"
#include "file_inputs.h"
#include "system.h"
#include "xalloc.h"

#define FIRST_READ ((size_t)1 << 16)

/* Reads to the end; returns 0 or an errno. The bytes read so far are in *content either way. */
static int read_all(int descriptor, struct file_content *content)
{
    size_t capacity = 0;
    for (;;) {
        if (content->length == capacity) {
            if (capacity >= FILE_MAX_BYTES) {
                return EFBIG;
            }
            capacity = capacity == 0 ? FIRST_READ : capacity * 2;
            char *larger = realloc(content->bytes, capacity);
            if (larger == NULL) {
                return ENOMEM;
            }
            content->bytes = larger;
        }
        int failure = system_await_input(descriptor, FILE_PIPE_SECONDS);
        if (failure != 0) {
            return failure;
        }
        ssize_t got =
            read(descriptor, content->bytes + content->length, capacity - content->length);
        if (got == 0) {
            return 0;
        }
        if (got > 0) {
            content->length += (size_t)got;
        } else if (errno != EINTR && errno != EAGAIN) {
            return errno;
        }
    }
}

bool file_read(const char *path, struct file_content *content, struct text_error *error)
{
    content->bytes = NULL;
    content->length = 0;
    /* Without waiting in open(): a pipe that nobody writes to would never let us go. */
    const bool standard = strcmp(path, "-") == 0;
    int descriptor = standard ? STDIN_FILENO : system_open_input(path);
    if (descriptor < 0) {
        return text_error_set(error, path, 0, "cannot be opened: %s", strerror(errno));
    }
    file_inputs_add(descriptor);
    const int failure = read_all(descriptor, content);
    if (!standard) {
        (void)close(descriptor); /* only read from */
    }
    if (failure != 0) {
        text_error_set(error, path, 0, "cannot be read: %s", strerror(failure));
        free(content->bytes);
        content->bytes = NULL;
        content->length = 0;
    }
    return failure == 0;
}

/* "folder/.qtri-PID-ATTEMPT.part" for a target of any name in that folder. */
static char *temporary_name(const char *path, int attempt)
{
    const char *slash = strrchr(path, '/');
    size_t folder = slash == NULL ? 0 : (size_t)(slash - path) + 1;
    size_t size = folder + 64;
    char *name = xcalloc(size, 1);
    memcpy(name, path, folder);
    (void)snprintf(name + folder, size - folder, ".qtri-%ld-%d.part", (long)getpid(), attempt);
    return name;
}

/* ---- What a signal must not leave behind: one output is open at a time ---- */

static char unfinished[PATH_MAX];
static volatile sig_atomic_t is_unfinished;

void file_remove_unfinished(void)
{
    if (is_unfinished) {
        (void)unlink(unfinished);
    }
}

void xalloc_die(void)
{
    file_remove_unfinished();
    fputs("qtri: out of memory\n", stderr);
    _exit(1);
}

static void remove_and_end(int number)
{
    file_remove_unfinished();
    (void)signal(number, SIG_DFL);
    (void)raise(number);
}

/* From before the file exists, or a signal could come in between. */
static void remember(const char *temporary)
{
    is_unfinished = 0;
    if (strlen(temporary) < sizeof unfinished) {
        memcpy(unfinished, temporary, strlen(temporary) + 1);
        system_on_end(remove_and_end);
        is_unfinished = 1;
    }
}

/* Opens output->temporary for writing; returns 0 or an errno. */
static int open_temporary(struct file_output *output)
{
    for (int attempt = 0;; attempt++) {
        output->temporary = temporary_name(output->path, attempt);
        remember(output->temporary);
        int descriptor = system_create(output->temporary);
        if (descriptor >= 0) {
            file_inputs_except(descriptor);
            output->stream = fdopen(descriptor, "wb");
            if (output->stream != NULL) {
                return 0;
            }
            (void)close(descriptor);
            (void)unlink(output->temporary);
            return ENOMEM;
        }
        int failure = errno;
        is_unfinished = 0;
        free(output->temporary);
        output->temporary = NULL;
        if (failure != EEXIST || attempt == 1000) {
            return failure;
        }
    }
}

static void release(struct file_output *output)
{
    free(output->path);
    free(output->temporary);
    memset(output, 0, sizeof *output);
}

bool file_is_stream(const char *path)
{
    struct stat status;
    return strcmp(path, "-") == 0 || strncmp(path, "/dev/", 5) == 0 ||
           strncmp(path, "/proc/", 6) == 0 ||
           (stat(path, &status) == 0 && !S_ISREG(status.st_mode) && !S_ISDIR(status.st_mode));
}

/* Written as it is: a device, a pipe, standard output. Returns 0 or an errno. */
static int open_stream(struct file_output *output)
{
    if (strcmp(output->path, "-") == 0) {
        output->stream = stdout;
        return 0;
    }
    int descriptor = open(output->path, O_WRONLY | O_TRUNC);
    if (descriptor < 0) {
        return errno;
    }
    output->stream = fdopen(descriptor, "wb");
    if (output->stream == NULL) {
        (void)close(descriptor);
        return ENOMEM;
    }
    return 0;
}

bool file_output_open(struct file_output *output, const char *path, struct text_error *error)
{
    memset(output, 0, sizeof *output);
    if (file_inputs_has(path)) {
        return text_error_set(error, path, 0, "has been read: it would be overwritten");
    }
    /* Behind a link: it is the picture that is replaced, not the link. */
    const bool is_stream = file_is_stream(path);
    char *target = is_stream ? NULL : system_real_path(path);
    output->path = target != NULL ? target : xstrdup(path);
    int failure = 0;
    if (!is_stream && file_inspect(output->path, NULL) == FILE_OTHER) {
        failure = EISDIR;
    }
    if (failure == 0) {
        failure = is_stream ? open_stream(output) : open_temporary(output);
    }
    if (failure != 0) {
        text_error_set(error, path, 0, "cannot be written: %s", strerror(failure));
        release(output);
    }
    return failure == 0;
}

void file_output_write(struct file_output *output, const void *bytes, size_t length)
{
    if (output->failure == 0 && fwrite(bytes, 1, length, output->stream) != length) {
        output->failure = errno != 0 ? errno : EIO;
    }
}

bool file_output_commit(struct file_output *output, struct text_error *error)
{
    const bool is_standard = output->stream == stdout;
    if ((ferror(output->stream) != 0) && output->failure == 0) {
        output->failure = EIO;
    }
    if ((is_standard ? fflush(stdout) : fclose(output->stream)) != 0 && output->failure == 0) {
        output->failure = errno;
    }
    if (output->temporary != NULL) {
        if (output->failure == 0) {
            output->failure = system_replace(output->temporary, output->path);
        }
        if (output->failure != 0) {
            (void)unlink(output->temporary);
        }
        is_unfinished = 0;
    }
    bool written = output->failure == 0;
    if (!written) {
        text_error_set(error, output->path, 0, "cannot be written: %s", strerror(output->failure));
    }
    release(output);
    return written;
}

void file_output_cancel(struct file_output *output)
{
    if (output->stream != NULL && output->stream != stdout) {
        (void)fclose(output->stream);
    }
    if (output->temporary != NULL) {
        (void)unlink(output->temporary);
        is_unfinished = 0;
    }
    release(output);
}
