# What `cmake --install` leaves: the library with its headers, the program, and the files behind find_package(Rhegma).

include(CMakePackageConfigHelpers)

set(RHEGMA_INSTALLED_CMAKE ${CMAKE_INSTALL_LIBDIR}/cmake/Rhegma)

install(TARGETS rhegma EXPORT RhegmaTargets)
if(TARGET rhegma_program)
  set_target_properties(rhegma_program PROPERTIES INSTALL_RPATH_USE_LINK_PATH ON)
  install(TARGETS rhegma_program)
endif()
set(left_out)
foreach(folder ${RHEGMA_FOLDERS_LEFT_OUT})
  list(APPEND left_out PATTERN ${folder} EXCLUDE)
endforeach()
install(DIRECTORY ${PROJECT_SOURCE_DIR}/src/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/rhegma FILES_MATCHING PATTERN *.hpp)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/packages/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/rhegma
  FILES_MATCHING PATTERN *.hpp ${left_out})
file(GLOB tools CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/tools/rhegma-*)
install(PROGRAMS ${tools} DESTINATION ${CMAKE_INSTALL_BINDIR})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/tools/rhegma ${PROJECT_SOURCE_DIR}/tools/rhegma_tools DESTINATION lib/rhegma
  FILES_MATCHING PATTERN *.py PATTERN *.css PATTERN *.js PATTERN *.inc PATTERN *.INC PATTERN py.typed)

install(EXPORT RhegmaTargets NAMESPACE Rhegma:: DESTINATION ${RHEGMA_INSTALLED_CMAKE})
configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/RhegmaConfig.cmake.in ${PROJECT_BINARY_DIR}/RhegmaConfig.cmake
  INSTALL_DESTINATION ${RHEGMA_INSTALLED_CMAKE} PATH_VARS RHEGMA_INSTALLED_CMAKE)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/RhegmaConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES
  ${PROJECT_BINARY_DIR}/RhegmaConfig.cmake
  ${PROJECT_BINARY_DIR}/RhegmaConfigVersion.cmake
  ${PROJECT_SOURCE_DIR}/cmake/RhegmaFindTrilinos.cmake
  ${PROJECT_SOURCE_DIR}/cmake/RhegmaFindLibraries.cmake
  DESTINATION ${RHEGMA_INSTALLED_CMAKE})
