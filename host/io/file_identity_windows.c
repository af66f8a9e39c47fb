/* SPDX-License-Identifier: MIT */
#include "file_identity.h"

#ifdef _WIN32

#include <errno.h>
#include <io.h>
#include <stddef.h>
#include <windows.h>

static enum file_kind inspect(HANDLE file, struct file_identity *identity)
{
    BY_HANDLE_FILE_INFORMATION about;
    if (GetFileType(file) != FILE_TYPE_DISK || !GetFileInformationByHandle(file, &about)) {
        return FILE_OTHER;
    }
    if (identity != NULL) {
        identity->device = about.dwVolumeSerialNumber;
        identity->number = (uint64_t)about.nFileIndexHigh << 32 | about.nFileIndexLow;
    }
    return (about.dwFileAttributes & FILE_ATTRIBUTE_DIRECTORY) != 0 ? FILE_OTHER : FILE_REGULAR;
}

enum file_kind file_inspect(const char *path, struct file_identity *identity)
{
    const HANDLE file = CreateFileA(path, 0, FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE,
                                    NULL, OPEN_EXISTING, FILE_FLAG_BACKUP_SEMANTICS, NULL);
    if (file == INVALID_HANDLE_VALUE) {
        const DWORD error = GetLastError();
        return error == ERROR_FILE_NOT_FOUND || error == ERROR_PATH_NOT_FOUND ? FILE_MISSING
                                                                              : FILE_OTHER;
    }
    const enum file_kind kind = inspect(file, identity);
    (void)CloseHandle(file);
    return kind;
}

enum file_kind file_inspect_open(int descriptor, struct file_identity *identity)
{
    return inspect((HANDLE)_get_osfhandle(descriptor), identity);
}

#endif
