# Settings of our own targets; third-party headers are SYSTEM and exempt from the warnings.
if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "" FORCE)
endif()
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_UNITY_BUILD ON CACHE BOOL "Compile the sources of a target together: less than half the time from scratch")
set(CMAKE_UNITY_BUILD_BATCH_SIZE 40)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}) # the command is build/vkpt
find_package(Threads REQUIRED)

set(VKPT_SANITIZE "" CACHE STRING "Sanitizers of our own code, e.g. address,undefined")
option(VKPT_HOST_ONLY "Leave out what needs a device: no Vulkan driver under the sanitizers" OFF)
if(NOT VKPT_HOST_ONLY)
  set(VKPT_DEVICE_HEADERS <vulkan/vulkan_raii.hpp>) # to precompile
endif()

add_library(vkpt_settings INTERFACE)
target_compile_options(vkpt_settings INTERFACE -Wall -Wextra -Wconversion -Wshadow -Werror -ffp-contract=off)
if(VKPT_SANITIZE)
  target_compile_options(vkpt_settings INTERFACE -fsanitize=${VKPT_SANITIZE} -fno-sanitize-recover=all
                                                 -fno-omit-frame-pointer)
  target_link_options(vkpt_settings INTERFACE -fsanitize=${VKPT_SANITIZE})
endif()
include(cmake/library.cmake)
