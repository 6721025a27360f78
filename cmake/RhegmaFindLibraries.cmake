# The libraries next to Trilinos: HDF5 (C, the one of the MPI in use), checksums, JSON, expressions and units; and MUMPS,
# the direct solver of equilibria, where it is there for the MPI in use.

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

if(NOT TARGET Rhegma::Udunits)
  find_library(UDUNITS2_LIBRARY udunits2)
  find_path(UDUNITS2_INCLUDE_DIR udunits2.h PATH_SUFFIXES udunits2)
  if(NOT UDUNITS2_LIBRARY OR NOT UDUNITS2_INCLUDE_DIR)
    message(FATAL_ERROR "UDUNITS-2, which converts the units of scenes, was not found. Install it (Debian: libudunits2-dev; "
      "./setup does so), or name the folder that it is installed in with -DCMAKE_PREFIX_PATH=...")
  endif()
  add_library(Rhegma::Udunits UNKNOWN IMPORTED)
  set_target_properties(Rhegma::Udunits PROPERTIES
    IMPORTED_LOCATION ${UDUNITS2_LIBRARY}
    INTERFACE_INCLUDE_DIRECTORIES ${UDUNITS2_INCLUDE_DIR})
endif()

# Pictures as images of voxels, where they are there.
find_package(PNG QUIET)
find_package(TIFF QUIET)
set(RHEGMA_PICTURES)
foreach(kind PNG TIFF)
  if(TARGET ${kind}::${kind})
    list(APPEND RHEGMA_PICTURES ${kind}::${kind})
  elseif("${RHEGMA_PICTURES_NEEDED}" MATCHES "${kind}::${kind}") # of an installed Rhegma
    message(FATAL_ERROR "Rhegma was built with ${kind}, which was not found. Install it (Debian: libpng-dev, libtiff-dev), or name the folder "
      "that it is installed in with -DCMAKE_PREFIX_PATH=...")
  else()
    message(STATUS "no ${kind}: such pictures are read by tools/rhegma-mesh alone")
  endif()
endforeach()

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

# Multigrid for a Trilinos without MueLu.
if(NOT DEFINED RHEGMA_HYPRE) # set where an application looks for Rhegma
  option(RHEGMA_HYPRE "Use hypre's multigrid where there is no MueLu" ON)
endif()
if(RHEGMA_HYPRE AND NOT RHEGMA_MUELU)
  find_library(HYPRE_LIBRARY HYPRE)
  find_path(HYPRE_INCLUDE_DIR HYPRE_parcsr_ls.h PATH_SUFFIXES hypre)
endif()
if(RHEGMA_MUELU)
elseif(NOT RHEGMA_HYPRE OR NOT HYPRE_LIBRARY OR NOT HYPRE_INCLUDE_DIR)
  message(STATUS "neither MueLu nor hypre is used: conjugate gradients of equilibria have no multigrid")
elseif(NOT TARGET Rhegma::Hypre)
  add_library(Rhegma::Hypre UNKNOWN IMPORTED)
  set_target_properties(Rhegma::Hypre PROPERTIES IMPORTED_LOCATION ${HYPRE_LIBRARY})
endif()
