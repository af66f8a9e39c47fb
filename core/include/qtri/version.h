/* SPDX-License-Identifier: MIT */
/*
 * The version of the library, by semantic versioning: MAJOR changes with what applications must
 * change for, MINOR with what is new, PATCH with what is mended; while MAJOR is 0, MINOR stands for
 * both of the former. `make check-version` holds every manifest to this one.
 */
#ifndef QTRI_VERSION_H
#define QTRI_VERSION_H

/* The parts of the version. */
#define QTRI_VERSION_MAJOR 0
#define QTRI_VERSION_MINOR 1
#define QTRI_VERSION_PATCH 0

/* "0.1.0" */
#define QTRI_VERSION_TEXT_OF(number) #number
#define QTRI_VERSION_JOINED(major, minor, patch)                                                   \
    QTRI_VERSION_TEXT_OF(major) "." QTRI_VERSION_TEXT_OF(minor) "." QTRI_VERSION_TEXT_OF(patch)
#define QTRI_VERSION_TEXT                                                                          \
    QTRI_VERSION_JOINED(QTRI_VERSION_MAJOR, QTRI_VERSION_MINOR, QTRI_VERSION_PATCH)

/* To compare with: #if QTRI_VERSION >= QTRI_VERSION_NUMBER(0, 2, 0). Parts are below 1000. */
#define QTRI_VERSION_NUMBER(major, minor, patch) ((major)*1000000L + (minor)*1000L + (patch))
#define QTRI_VERSION                             QTRI_VERSION_NUMBER(QTRI_VERSION_MAJOR, QTRI_VERSION_MINOR, QTRI_VERSION_PATCH)

#endif
