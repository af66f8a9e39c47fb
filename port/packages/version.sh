#!/bin/sh
# SPDX-License-Identifier: MIT
# Prints the version that core/include/qtri/version.h states: 1.2.3
awk '/^#define QTRI_VERSION_(MAJOR|MINOR|PATCH) [0-9]+$/ { version = version (version == "" ? "" : ".") $3 }
     END { print version; exit version !~ /^[0-9]+\.[0-9]+\.[0-9]+$/ }' core/include/qtri/version.h
