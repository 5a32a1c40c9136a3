# cmake --install: bin/vkpt, the libraries with their headers, and a package, so that
# find_package(vkpt) gives vkpt::core, vkpt::scene, ... Included after src/.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

# The libraries that vkpt_library() made, what of ours they link to besides, and the packages all these come from.
get_property(vkpt_pending GLOBAL PROPERTY VKPT_LIBRARIES)
set(vkpt_libraries)
set(vkpt_packages)
while(vkpt_pending)
  list(POP_FRONT vkpt_pending vkpt_target)
  get_target_property(vkpt_aliased ${vkpt_target} ALIASED_TARGET)
  if(vkpt_aliased)
    set(vkpt_target ${vkpt_aliased})
  endif()
  if(vkpt_target IN_LIST vkpt_libraries)
    continue()
  endif()
  list(APPEND vkpt_libraries ${vkpt_target})
  string(REGEX REPLACE "^vkpt_" "" vkpt_name ${vkpt_target})
  set_target_properties(${vkpt_target} PROPERTIES EXPORT_NAME ${vkpt_name})
  get_target_property(vkpt_links ${vkpt_target} INTERFACE_LINK_LIBRARIES)
  if(NOT vkpt_links)
    continue()
  endif()
  string(REGEX REPLACE "\\$<BUILD_INTERFACE:[^>]*>" "" vkpt_links "${vkpt_links}") # not for consumers
  string(REGEX MATCHALL "[A-Za-z0-9_]+::[A-Za-z0-9_]+|vkpt_[a-z_]+" vkpt_links "${vkpt_links}")
  foreach(vkpt_link IN LISTS vkpt_links)
    if(vkpt_link MATCHES "^vkpt(_|::)")
      list(APPEND vkpt_pending ${vkpt_link})
    else()
      string(REGEX REPLACE "::.*" "" vkpt_link ${vkpt_link})
      list(APPEND vkpt_packages ${vkpt_link})
    endif()
  endforeach()
endwhile()
list(REMOVE_DUPLICATES vkpt_packages)

if(TARGET vkpt)
  install(TARGETS vkpt RUNTIME)
endif()
if(TARGET vkpt-view)
  install(TARGETS vkpt-view RUNTIME)
endif()
install(TARGETS ${vkpt_libraries} EXPORT vkpt ARCHIVE)
install(DIRECTORY src/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/vkpt
  FILES_MATCHING PATTERN "*.h" PATTERN "*.inl" PATTERN app EXCLUDE)
install(DIRECTORY shaders/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/vkpt # C++ includes them too
  FILES_MATCHING PATTERN "*.h" PATTERN "*.glsl")
install(DIRECTORY assets/ DESTINATION ${CMAKE_INSTALL_DATADIR}/vkpt/assets # for vkpt assignment
  FILES_MATCHING PATTERN "*.xml" PATTERN "*.obj" PATTERN "*.mtl" PATTERN "*.LICENSE" PATTERN tests EXCLUDE)
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})

set(vkpt_package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/vkpt)
install(EXPORT vkpt NAMESPACE vkpt:: FILE vkptTargets.cmake DESTINATION ${vkpt_package_dir})
list(TRANSFORM vkpt_packages REPLACE "(.+)" "find_dependency(\\1)" OUTPUT_VARIABLE vkpt_find_packages)
list(JOIN vkpt_find_packages "\n" vkpt_find_packages)
file(CONFIGURE OUTPUT vkptConfig.cmake @ONLY CONTENT [[
include(CMakeFindDependencyMacro)
@vkpt_find_packages@
include(${CMAKE_CURRENT_LIST_DIR}/vkptTargets.cmake)
]])
write_basic_package_version_file(vkptConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/vkptConfig.cmake ${CMAKE_CURRENT_BINARY_DIR}/vkptConfigVersion.cmake
  DESTINATION ${vkpt_package_dir})
