# The libraries next to Trilinos: HDF5 (C, the one of the MPI in use), checksums, JSON and expressions; and MUMPS, the
# direct solver of equilibria, where it is there for the MPI in use.

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

option(RHEGMA_MUMPS "Solve equilibria directly with MUMPS where it is found" ON)
if(RHEGMA_MUMPS)
  find_library(MUMPS_LIBRARY dmumps)
  find_path(MUMPS_INCLUDE_DIR dmumps_c.h)
endif()
if(NOT MUMPS_LIBRARY OR NOT MUMPS_INCLUDE_DIR)
  message(STATUS "no MUMPS: equilibria are solved by conjugate gradients alone")
elseif(NOT TARGET Rhegma::Mumps)
  add_library(Rhegma::Mumps UNKNOWN IMPORTED)
  set_target_properties(Rhegma::Mumps PROPERTIES IMPORTED_LOCATION ${MUMPS_LIBRARY})
endif()
