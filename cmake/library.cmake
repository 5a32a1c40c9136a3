# vkpt_library(NAME SOURCES... DEVICE_SOURCES... DEPENDS... PRIVATE_DEPENDS...): the library vkpt_NAME of src/NAME;
# installed and exported as vkpt::NAME. DEVICE_SOURCES need a device and are left out with VKPT_HOST_ONLY.
# Includes are written from src/ or shaders/ on: "core/error.h", "shared/structs.h".
# Packages it depends on are named by their targets, PACKAGE::TARGET (cmake/install.cmake finds them for consumers).
function(vkpt_library name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "SOURCES;DEVICE_SOURCES;DEPENDS;PRIVATE_DEPENDS")
  if(NOT VKPT_HOST_ONLY)
    list(APPEND arg_SOURCES ${arg_DEVICE_SOURCES})
  endif()
  add_library(vkpt_${name} STATIC ${arg_SOURCES})
  add_library(vkpt::${name} ALIAS vkpt_${name})
  set_property(GLOBAL APPEND PROPERTY VKPT_LIBRARIES vkpt_${name})
  target_compile_features(vkpt_${name} PUBLIC cxx_std_20)
  target_include_directories(vkpt_${name} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/src>
                                                 $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/shaders>
                                                 $<INSTALL_INTERFACE:include/vkpt>)
  target_link_libraries(vkpt_${name} PUBLIC ${arg_DEPENDS} PRIVATE ${arg_PRIVATE_DEPENDS} $<BUILD_INTERFACE:vkpt_settings>)
endfunction()
