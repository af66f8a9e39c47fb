/* SPDX-License-Identifier: MIT */
#include "system.h"

#ifdef _WIN32

#include <errno.h>
#include <fcntl.h>
#include <io.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <windows.h>

#include <direct.h>

static void to_slashes(char *path)
{
    for (; *path != '\0'; path++) {
        *path = (char)(*path == '\\' ? '/' : *path);
    }
}

void system_begin(int argc, char **argv)
{
    _fmode = _O_BINARY;
    for (int descriptor = 0; descriptor < 3; descriptor++) {
        (void)_setmode(descriptor, _O_BINARY);
    }
    for (int i = 1; i < argc; i++) {
        to_slashes(argv[i]);
    }
}

/* What Windows complained of last, as the nearest errno. */
static int last_error(void)
{
    switch (GetLastError()) {
    case ERROR_FILE_NOT_FOUND:
    case ERROR_PATH_NOT_FOUND:
    case ERROR_INVALID_NAME:
        return ENOENT;
    case ERROR_FILE_EXISTS:
    case ERROR_ALREADY_EXISTS:
        return EEXIST;
    case ERROR_DISK_FULL:
        return ENOSPC;
    default:
        return EACCES;
    }
}

int system_open_input(const char *path)
{
    return _open(path, _O_RDONLY | _O_BINARY);
}

/* Pipes that say nothing are ended by system_alarm. */
int system_await_input(int descriptor, int seconds)
{
    (void)descriptor;
    (void)seconds;
    return 0;
}

int system_create(const char *path)
{
    const HANDLE file = CreateFileA(path, GENERIC_WRITE, FILE_SHARE_READ | FILE_SHARE_DELETE, NULL,
                                    CREATE_NEW, FILE_ATTRIBUTE_NORMAL, NULL);
    if (file == INVALID_HANDLE_VALUE) {
        errno = last_error();
        return -1;
    }
    return _open_osfhandle((intptr_t)file, _O_BINARY);
}

int system_replace(const char *from, const char *to)
{
    return MoveFileExA(from, to, MOVEFILE_REPLACE_EXISTING) ? 0 : last_error();
}

/* Windows puts `\\?\` in front of a final path. */
char *system_real_path(const char *path)
{
    char real[MAX_PATH + 8] = "";
    const HANDLE file = CreateFileA(path, 0, FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE,
                                    NULL, OPEN_EXISTING, FILE_FLAG_BACKUP_SEMANTICS, NULL);
    if (file == INVALID_HANDLE_VALUE) {
        return NULL;
    }
    const DWORD length = GetFinalPathNameByHandleA(file, real, sizeof real, 0);
    (void)CloseHandle(file);
    if (length == 0 || length >= sizeof real) {
        return NULL;
    }
    to_slashes(real);
    return _strdup(strncmp(real, "//?/", 4) == 0 && strncmp(real, "//?/UNC/", 8) != 0 ? real + 4
                                                                                      : real);
}

int system_make_folder(const char *path)
{
    return _mkdir(path) == 0 ? 0 : errno;
}

bool system_program(char *path, size_t size)
{
    const DWORD length = GetModuleFileNameA(NULL, path, (DWORD)size);
    to_slashes(path);
    return length > 0 && length < size;
}

/* D: it is removed when it is closed. */
FILE *system_temporary(void)
{
    char *name = _tempnam(NULL, "qtri");
    FILE *file = name == NULL ? NULL : fopen(name, "w+bD");
    free(name);
    return file;
}

char *system_collect(void (*write)(FILE *out, const char *name), const char *name, size_t *length)
{
    FILE *file = system_temporary();
    if (file == NULL) {
        return NULL;
    }
    write(file, name);
    const long end = ftell(file);
    char *text = end < 0 || ferror(file) ? NULL : malloc((size_t)end + 1);
    rewind(file);
    if (text != NULL) {
        *length = fread(text, 1, (size_t)end, file);
        text[*length] = '\0';
    }
    (void)fclose(file);
    return text;
}

void system_on_end(void (*end)(int number))
{
    static const int numbers[] = {SIGINT, SIGTERM, SIGBREAK};
    for (size_t i = 0; i < sizeof numbers / sizeof numbers[0]; i++) {
        (void)signal(numbers[i], end);
    }
}

/* The second ends the program. */
void system_on_interrupt(void (*stop)(int number))
{
    (void)signal(SIGINT, stop);
}

static void (*ring_alarm)(int number);

static void CALLBACK ring(void *nothing, BOOLEAN fired)
{
    (void)nothing;
    (void)fired;
    ring_alarm(0);
}

void system_alarm(unsigned seconds, void (*alarm)(int number))
{
    HANDLE timer;
    ring_alarm = alarm;
    (void)CreateTimerQueueTimer(&timer, NULL, ring, NULL, 1000 * seconds, 0, WT_EXECUTEONLYONCE);
}

#endif
