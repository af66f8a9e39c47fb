/* SPDX-License-Identifier: MIT */
/* The library stb, of its headers: what it does in the command, here. */
#define STB_IMAGE_IMPLEMENTATION
#define STBI_NO_STDIO
#define STBI_ONLY_JPEG
#define STBI_ONLY_PNG
#include <stb_image.h>
