/* SPDX-License-Identifier: MIT */
#define _XOPEN_SOURCE 700
#include "apart.h"

#ifndef _WIN32

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

/* What the process may take: seconds, bytes. */
#define MOST_SECONDS 60
#define MOST_MEMORY  ((rlim_t)4 << 30)

/* The sanitizers reserve terabytes of addresses. */
#if defined(__SANITIZE_ADDRESS__)
#define LIMIT_MEMORY 0
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define LIMIT_MEMORY 0
#endif
#endif
#ifndef LIMIT_MEMORY
#define LIMIT_MEMORY 1
#endif

/* In front of the answer. */
struct verdict {
    bool ok;
    struct text_error error;
};

static void set_limit(int resource, rlim_t value)
{
    const struct rlimit limit = {value, value};
    (void)setrlimit(resource, &limit);
}

static bool put_verdict(FILE *file, const struct verdict *verdict)
{
    rewind(file);
    return fwrite(verdict, sizeof *verdict, 1, file) == 1 && fflush(file) == 0;
}

/* The other process: no way back into the caller's code, whose buffers it must not write out. */
static void serve(FILE *file, apart_work *work, void *context)
{
    struct verdict verdict;
    memset(&verdict, 0, sizeof verdict);
    set_limit(RLIMIT_CORE, 0);
    set_limit(RLIMIT_CPU, MOST_SECONDS);
    if (LIMIT_MEMORY) {
        set_limit(RLIMIT_AS, MOST_MEMORY);
    }
    int nowhere = open("/dev/null", O_WRONLY); /* the library's own last words */
    if (nowhere >= 0) {
        (void)dup2(nowhere, STDERR_FILENO);
        (void)dup2(nowhere, STDOUT_FILENO);
    }
    bool ok = put_verdict(file, &verdict);
    verdict.ok = work(file, context, &verdict.error);
    ok = ok && !ferror(file) && put_verdict(file, &verdict);
    _exit(ok ? 0 : 1);
}

static bool fail(struct text_error *error, const char *path, const char *problem)
{
    return text_error_set(error, path, 0, "cannot be read: %s", problem);
}

/* Waits for the process and reads its verdict. */
static bool await(const char *path, pid_t child, FILE *file, struct text_error *error)
{
    struct verdict verdict;
    int status = 0;
    if (waitpid(child, &status, 0) != child || !WIFEXITED(status)) {
        return fail(error, path,
                    WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU
                        ? "it takes longer than a minute"
                        : "the file is broken, and the library that reads it ended in a crash");
    }
    if (WEXITSTATUS(status) != 0) {
        return fail(error, path, "the library gave up on it");
    }
    rewind(file);
    if (fread(&verdict, sizeof verdict, 1, file) != 1) {
        return fail(error, path, "out of memory");
    }
    if (!verdict.ok) {
        *error = verdict.error;
    }
    return verdict.ok;
}

FILE *apart_run(const char *path, apart_work *work, void *context, struct text_error *error)
{
    memset(error, 0, sizeof *error);
    FILE *file = tmpfile();
    pid_t child = file == NULL ? -1 : fork();
    if (child == 0) {
        serve(file, work, context);
    }
    bool ok = child < 0 ? fail(error, path, strerror(errno)) : await(path, child, file, error);
    if (!ok && file != NULL) {
        (void)fclose(file);
    }
    return ok ? file : NULL;
}

#endif
