# Rhegma as a package of Trilinos (docs/how-to/build-within-trilinos.md): the library and the program, without tests.

tribits_package(Rhegma)

set(RHEGMA_VERSION 0.2.0)
list(PREPEND CMAKE_MODULE_PATH ${CMAKE_CURRENT_LIST_DIR})
include(RhegmaDefaults)
include(RhegmaFindLibraries)
include(RhegmaSources)
set(RHEGMA_SOLVERS)
if(TARGET Rhegma::Mumps)
  set_source_files_properties(${RHEGMA_ROOT}/src/solver/DirectSolver.cpp PROPERTIES COMPILE_DEFINITIONS RHEGMA_HAVE_MUMPS
    COMPILE_OPTIONS -idirafter${MUMPS_INCLUDE_DIR})
  set(RHEGMA_SOLVERS Rhegma::Mumps)
endif()
if(TARGET Rhegma::Hypre)
  set_source_files_properties(${RHEGMA_ROOT}/src/solver/Multigrid.cpp ${RHEGMA_ROOT}/src/solver/HypreMultigrid.cpp PROPERTIES
    COMPILE_DEFINITIONS RHEGMA_HAVE_HYPRE COMPILE_OPTIONS -idirafter${HYPRE_INCLUDE_DIR})
  list(APPEND RHEGMA_SOLVERS Rhegma::Hypre)
endif()
if(TARGET PNG::PNG)
  set_source_files_properties(${RHEGMA_ROOT}/src/geometry/PngFile.cpp PROPERTIES COMPILE_DEFINITIONS RHEGMA_HAVE_PNG)
endif()
if(TARGET TIFF::TIFF)
  set_source_files_properties(${RHEGMA_ROOT}/src/geometry/TiffFile.cpp PROPERTIES COMPILE_DEFINITIONS RHEGMA_HAVE_TIFF)
endif()

tribits_include_directories(${RHEGMA_ROOT}/src ${RHEGMA_ROOT}/packages)
tribits_add_library(rhegma SOURCES ${RHEGMA_SOURCES} NOINSTALLHEADERS
  IMPORTEDLIBS hdf5::hdf5 ZLIB::ZLIB nlohmann_json::nlohmann_json muparser::muparser Rhegma::Udunits
  ${RHEGMA_PICTURES} ${RHEGMA_SOLVERS})
tribits_add_executable(rhegma_program NOEXEPREFIX NOEXESUFFIX SOURCES ${RHEGMA_PROGRAM_SOURCES} INSTALLABLE)
if(TARGET rhegma_program) # Trilinos leaves it out where it is told to make no executables
  set_target_properties(rhegma_program PROPERTIES OUTPUT_NAME rhegma)
  rhegma_compile_options(rhegma_program)
  target_compile_definitions(rhegma_program PRIVATE RHEGMA_VERSION="${RHEGMA_VERSION}")
endif()
rhegma_compile_options(rhegma)
target_compile_definitions(rhegma PRIVATE RHEGMA_VERSION="${RHEGMA_VERSION}")

tribits_package_postprocess()
