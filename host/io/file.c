/* SPDX-License-Identifier: MIT */
#define _POSIX_C_SOURCE 200809L
#include "file.h"

#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#define FIRST_READ ((size_t)1 << 16)

/* Reads to the end; returns 0 or an errno. The bytes read so far are in *content either way. */
static int read_stream(FILE *stream, struct file_content *content)
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
        errno = 0;
        size_t got = fread(content->bytes + content->length, 1, capacity - content->length, stream);
        content->length += got;
        if (got == 0) {
            return ferror(stream) ? (errno != 0 ? errno : EIO) : 0;
        }
    }
}

bool file_read(const char *path, struct file_content *content, struct text_error *error)
{
    content->bytes = NULL;
    content->length = 0;
    FILE *stream = fopen(path, "rb");
    if (stream == NULL) {
        text_error_set(error, path, 0, "cannot be opened: %s", strerror(errno));
        return false;
    }
    int failure = read_stream(stream, content);
    (void)fclose(stream); /* only read from */
    if (failure != 0) {
        text_error_set(error, path, 0, "cannot be read: %s", strerror(failure));
        free(content->bytes);
        content->bytes = NULL;
        content->length = 0;
    }
    return failure == 0;
}

enum file_kind file_inspect(const char *path, struct file_identity *identity)
{
    struct stat status;
    if (stat(path, &status) != 0) {
        return errno == ENOENT || errno == ENOTDIR ? FILE_MISSING : FILE_OTHER;
    }
    if (identity != NULL) {
        identity->device = (uint64_t)status.st_dev;
        identity->number = (uint64_t)status.st_ino;
    }
    return S_ISREG(status.st_mode) ? FILE_REGULAR : FILE_OTHER;
}

/* "folder/.qtri-PID-ATTEMPT.part" for a target of any name in that folder. */
static char *temporary_name(const char *path, int attempt)
{
    const char *slash = strrchr(path, '/');
    size_t folder = slash == NULL ? 0 : (size_t)(slash - path) + 1;
    size_t size = folder + 64;
    char *name = malloc(size);
    if (name != NULL) {
        memcpy(name, path, folder);
        (void)snprintf(name + folder, size - folder, ".qtri-%ld-%d.part", (long)getpid(), attempt);
    }
    return name;
}

/* Opens output->temporary for writing; returns 0 or an errno. The user's umask applies. */
static int open_temporary(struct file_output *output)
{
    for (int attempt = 0;; attempt++) {
        output->temporary = temporary_name(output->path, attempt);
        if (output->temporary == NULL) {
            return ENOMEM;
        }
        int descriptor = open(output->temporary, O_CREAT | O_EXCL | O_WRONLY, 0666);
        if (descriptor >= 0) {
            output->stream = fdopen(descriptor, "wb");
            if (output->stream != NULL) {
                return 0;
            }
            (void)close(descriptor);
            (void)unlink(output->temporary);
            return ENOMEM;
        }
        int failure = errno;
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

bool file_output_open(struct file_output *output, const char *path, struct text_error *error)
{
    memset(output, 0, sizeof *output);
    if (file_inspect(path, NULL) == FILE_OTHER) { /* rename would replace a device */
        text_error_set(error, path, 0, "cannot be written: not an ordinary file");
        return false;
    }
    output->path = strdup(path);
    int failure = output->path == NULL ? ENOMEM : open_temporary(output);
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
    if (fclose(output->stream) != 0 && output->failure == 0) {
        output->failure = errno;
    }
    if (output->failure == 0 && rename(output->temporary, output->path) != 0) {
        output->failure = errno;
    }
    bool written = output->failure == 0;
    if (!written) {
        (void)unlink(output->temporary);
        text_error_set(error, output->path, 0, "cannot be written: %s", strerror(output->failure));
    }
    release(output);
    return written;
}
