/*
 * What the library is built with. Each option is 1, the default, or 0: left out, to save code.
 *
 * Options are for the command line of the compiler, -DQTRI_WITH_GRAY8=0, the same for all files of
 * the library and of the application. An option never changes what is left in: it draws the same
 * pixels to the bit. What is left out is an error where a function returns one, and otherwise has
 * the one result that stands beside the option.
 */
#ifndef QTRI_CONFIG_H
#define QTRI_CONFIG_H

/*
 * Formats of surfaces, at least one. qtri_surface_init and qtri_frame_init return QTRI_ERROR_OPTION
 * for others; nothing is drawn on a surface that is made otherwise.
 */
#ifndef QTRI_WITH_RGB565
#define QTRI_WITH_RGB565 1
#endif
#ifndef QTRI_WITH_XRGB8888
#define QTRI_WITH_XRGB8888 1
#endif
#ifndef QTRI_WITH_GRAY8
#define QTRI_WITH_GRAY8 1
#endif

/* Colours that vary over a triangle. Without: QTRI_SMOOTH is QTRI_FLAT_LAST. */
#ifndef QTRI_WITH_SMOOTH
#define QTRI_WITH_SMOOTH 1
#endif

/* Without: QTRI_PERSPECTIVE is QTRI_SCREEN_LINEAR, for colours and textures. */
#ifndef QTRI_WITH_PERSPECTIVE
#define QTRI_WITH_PERSPECTIVE 1
#endif

/* Without: a material's texture is NULL. */
#ifndef QTRI_WITH_TEXTURES
#define QTRI_WITH_TEXTURES 1
#endif

/* Texels other than QTRI_TEXEL_RGB565. Without: a texture of them is none. */
#ifndef QTRI_WITH_TEXEL_FORMATS
#define QTRI_WITH_TEXEL_FORMATS 1
#endif

/* Without: QTRI_BILINEAR is QTRI_NEAREST. */
#ifndef QTRI_WITH_BILINEAR
#define QTRI_WITH_BILINEAR 1
#endif

/* Lines and QTRI_WIREFRAME. Without: they draw nothing. */
#ifndef QTRI_WITH_LINES
#define QTRI_WITH_LINES 1
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
 * Code that only saves time: loops for single formats and depth tests, short ways for small
 * triangles, lines and vertices. Without, everything takes the general way to the same pixels.
 */
#ifndef QTRI_WITH_FAST_PATHS
#define QTRI_WITH_FAST_PATHS 1
#endif

typedef char
    qtri_some_format_required[QTRI_WITH_RGB565 || QTRI_WITH_XRGB8888 || QTRI_WITH_GRAY8 ? 1 : -1];

#endif
