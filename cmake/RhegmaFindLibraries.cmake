# The libraries beside Trilinos: HDF5 (C, the one of the MPI in use), checksums, JSON and expressions.

set(HDF5_PREFER_PARALLEL ON)
find_package(HDF5 REQUIRED COMPONENTS C)
find_package(ZLIB REQUIRED)
find_package(nlohmann_json REQUIRED)

find_package(muparser CONFIG QUIET)
if(NOT TARGET muparser::muparser)
  find_library(MUPARSER_LIBRARY muparser REQUIRED)
  find_path(MUPARSER_INCLUDE_DIR muParser.h REQUIRED)
  add_library(muparser::muparser UNKNOWN IMPORTED)
  set_target_properties(muparser::muparser PROPERTIES
    IMPORTED_LOCATION ${MUPARSER_LIBRARY}
    INTERFACE_INCLUDE_DIRECTORIES ${MUPARSER_INCLUDE_DIR})
endif()
