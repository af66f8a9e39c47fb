# SPDX-License-Identifier: MIT
# What every CMake build of the library shares: its files, version and options.
#   QTRI_SOURCES QTRI_HOT_SOURCES QTRI_INCLUDES QTRI_VERSION QTRI_OPTIONS (names of config.h's options)

get_filename_component(QTRI_ROOT "${CMAKE_CURRENT_LIST_DIR}/../.." ABSOLUTE)
file(GLOB QTRI_SOURCES "${QTRI_ROOT}/core/*/*.c" "${QTRI_ROOT}/port/panels/*.c")

# What makes pixels: at -O2 where the rest is at -Os, nearly the speed of -O2 in three quarters of its bytes.
set(QTRI_HOT core/draw/pipelines_*.c core/raster/pipelines_*.c core/filter/*.c core/frame/*.c core/paint/*.c)
list(TRANSFORM QTRI_HOT PREPEND "${QTRI_ROOT}/" OUTPUT_VARIABLE hot)
file(GLOB QTRI_HOT_SOURCES ${hot})

set(QTRI_INCLUDES "${QTRI_ROOT}/core/include" "${QTRI_ROOT}/port/include")

file(STRINGS "${QTRI_ROOT}/core/include/qtri/version.h" QTRI_VERSION
     REGEX "^#define QTRI_VERSION_(MAJOR|MINOR|PATCH) [0-9]+$")
list(TRANSFORM QTRI_VERSION REPLACE ".* " "")
string(REPLACE ";" "." QTRI_VERSION "${QTRI_VERSION}")

file(STRINGS "${QTRI_ROOT}/core/include/qtri/config.h" QTRI_OPTIONS REGEX "^#define QTRI_WITH_[A-Z0-9_]+ 1$")
list(TRANSFORM QTRI_OPTIONS REPLACE "^#define ([A-Z0-9_]+) 1$" "\\1")

# QTRI_WITH_X=0 for each option that the Kconfig symbol CONFIG_QTRI_WITH_X has switched off.
function(qtri_kconfig_definitions result)
  set(definitions)
  foreach(option IN LISTS QTRI_OPTIONS)
    if(NOT CONFIG_${option})
      list(APPEND definitions "${option}=0")
    endif()
  endforeach()
  set(${result} "${definitions}" PARENT_SCOPE)
endfunction()

# The same for each CMake option that is off.
function(qtri_option_definitions result)
  set(definitions)
  foreach(option IN LISTS QTRI_OPTIONS)
    if(NOT ${option})
      list(APPEND definitions "${option}=0")
    endif()
  endforeach()
  set(${result} "${definitions}" PARENT_SCOPE)
endfunction()
