# SPDX-License-Identifier: MIT
# Stands in for the Pico SDK's: what a project asks of it, for programs of this computer. GLUE_LIBRARIES: the simulated
# display's.
set(PICO_SDK_VERSION_STRING 2.0.0)
macro(pico_sdk_init)
  add_library(pico_stdlib INTERFACE)
  target_sources(pico_stdlib INTERFACE $ENV{PICO_SDK_PATH}/sdk.c $ENV{PICO_SDK_PATH}/../glue/display.c)
  target_include_directories(pico_stdlib INTERFACE $ENV{PICO_SDK_PATH} $ENV{PICO_SDK_PATH}/../../../host)
  target_link_libraries(pico_stdlib INTERFACE ${GLUE_LIBRARIES})
  add_library(hardware_spi INTERFACE)
  add_library(hardware_dma INTERFACE)
endmacro()
function(pico_add_extra_outputs)
endfunction()
