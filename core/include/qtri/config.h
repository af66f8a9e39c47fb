/* SPDX-License-Identifier: MIT */
/*
 * What the library is built with. Each option is 1, the default, or 0: left out, to save code.
 *
 * Options are for the command line of the compiler, -DQTRI_WITH_FACE_LIGHT=0, the same for all
 * files of the library and of the application: where they differ, linking fails. An option never
 * changes what is left in: it draws the same pixels to the bit. What is left out has the one result
 * that stands beside the option. What is chosen by a description, as formats and filters are, needs
 * none: it is linked where it is named.
 */
#ifndef QTRI_CONFIG_H
#define QTRI_CONFIG_H

#include <limits.h>
#include <stdint.h>

/*
 * Drawing needs an int and a size_t of 32 bits: on an AVR or an MSP430 memory for a frame would
 * wrap at 64 KB, and sums of plain numbers at 32767. The mathematics and the transforms (q16.h,
 * vec.h, mat.h, quat.h, transform.h) do not, and give the same bits there.
 */
#if INT_MAX < 0x7FFFFFFF || SIZE_MAX < 0xFFFFFFFF
#error "qtri draws where int and size_t have 32 bits or more; here only its mathematics can be used"
#endif

/* Light by faces: of meshes without normals, and of flat ones. Without: they are not lit. */
#ifndef QTRI_WITH_FACE_LIGHT
#define QTRI_WITH_FACE_LIGHT 1
#endif

/*
 * Light on meshes that camera and pose scale unevenly or shear, and light with a negative part or
 * a diffuse one above 4. Without: they are not lit.
 */
#ifndef QTRI_WITH_UNEVEN_LIGHT
#define QTRI_WITH_UNEVEN_LIGHT 1
#endif

/* Without: a mesh with positions16, normals8, uvs16 or triangles8 draws nothing. */
#ifndef QTRI_WITH_COMPACT_MESHES
#define QTRI_WITH_COMPACT_MESHES 1
#endif

/* Without: a mesh without positions16, or with normals or uvs in place of normals8 or uvs16,
   draws nothing. */
#ifndef QTRI_WITH_WIDE_MESHES
#define QTRI_WITH_WIDE_MESHES 1
#endif

/*
 * Pipelines for RGB565 that blends, fog, bilinear filters and formats of depth bring, and that draw
 * in place of the generic one (pipeline.h): some 1.5 KB each at -Os. Without: the generic one
 * draws, the same pixels at many times the cost. For applications whose lists name all that they
 * draw with.
 */
#ifndef QTRI_WITH_BROUGHT_PIPELINES
#define QTRI_WITH_BROUGHT_PIPELINES 1
#endif

/*
 * A library and an application that are built with other options than each other do not link: what
 * begins every picture has their options in its name, unless all are 1.
 */
#if !(QTRI_WITH_FACE_LIGHT && QTRI_WITH_UNEVEN_LIGHT && QTRI_WITH_COMPACT_MESHES &&                \
      QTRI_WITH_WIDE_MESHES)
#define QTRI_OPTIONS_JOINED(name, a, b, c, d) name##_built_##a##b##c##d
#define QTRI_OPTIONS_JOIN(name, a, b, c, d)   QTRI_OPTIONS_JOINED(name, a, b, c, d)
#define QTRI_OPTIONS_NAMED(name)                                                                   \
    QTRI_OPTIONS_JOIN(name, QTRI_WITH_FACE_LIGHT, QTRI_WITH_UNEVEN_LIGHT,                          \
                      QTRI_WITH_COMPACT_MESHES, QTRI_WITH_WIDE_MESHES)
#define qtri_surface_init QTRI_OPTIONS_NAMED(qtri_surface_init)
#define qtri_frame_init   QTRI_OPTIONS_NAMED(qtri_frame_init)
#endif

#endif
