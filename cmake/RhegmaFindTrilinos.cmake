# Finds Trilinos and gives one target, Rhegma::Trilinos, for all versions from 13.2 (plain library names and variables)
# to 16 (namespaced targets).
#
#   RHEGMA_TRILINOS   folder of the user's own Trilinos; Trilinos_ROOT and Trilinos_DIR work too
#   RHEGMA_BACKEND    what was found: openmp or serial

set(RHEGMA_TRILINOS "" CACHE PATH "Folder where Trilinos is installed; empty: the system's")
set(RHEGMA_TRILINOS_PACKAGES Kokkos Teuchos Tpetra Belos Zoltan2Core)

if(RHEGMA_TRILINOS)
  set(Trilinos_ROOT ${RHEGMA_TRILINOS})
endif()
find_package(MPI REQUIRED COMPONENTS C CXX)

# Kokkos of Trilinos 13.2 warns that it turns off compiler extensions, which are off here anyway.
set(standard ${CMAKE_CXX_STANDARD})
set(CMAKE_CXX_STANDARD 17)
find_package(Trilinos REQUIRED COMPONENTS ${RHEGMA_TRILINOS_PACKAGES})
if(standard)
  set(CMAKE_CXX_STANDARD ${standard}) # of an application that looks for Rhegma
else()
  unset(CMAKE_CXX_STANDARD)
endif()

# MueLu, the multigrid of large equilibria, is used where Trilinos has it with all that it stands on: distributions
# have packages of its headers that do not bring those of other parts.
if(NOT DEFINED RHEGMA_USE_MUELU) # set where an application looks for Rhegma
  option(RHEGMA_USE_MUELU "Use MueLu where Trilinos has it; else hypre, where it is found" ON)
endif()
set(RHEGMA_MUELU OFF)
set(config ${Trilinos_DIR}/../MueLu/MueLuConfig.cmake)
if(RHEGMA_USE_MUELU AND EXISTS ${config})
  set(RHEGMA_MUELU ON)
  file(STRINGS ${config} needed REGEX "\\.\\./[A-Za-z0-9_]+/[A-Za-z0-9_]+Config.cmake")
  foreach(line ${needed})
    string(REGEX MATCH "\\.\\./[A-Za-z0-9_]+/[A-Za-z0-9_]+Config.cmake" file "${line}")
    if(NOT EXISTS ${Trilinos_DIR}/../MueLu/${file})
      set(RHEGMA_MUELU OFF)
    endif()
  endforeach()
endif()
if(RHEGMA_MUELU)
  include(${config})
endif()

add_library(Rhegma::Trilinos INTERFACE IMPORTED)
foreach(package ${RHEGMA_TRILINOS_PACKAGES})
  if(TARGET ${package}::all_libs)
    target_link_libraries(Rhegma::Trilinos INTERFACE ${package}::all_libs)
  else()
    target_link_libraries(Rhegma::Trilinos INTERFACE ${${package}_LIBRARIES} ${${package}_TPL_LIBRARIES})
    foreach(folder ${${package}_INCLUDE_DIRS} ${${package}_TPL_INCLUDE_DIRS})
      get_filename_component(folder ${folder} ABSOLUTE)
      target_include_directories(Rhegma::Trilinos SYSTEM INTERFACE ${folder})
    endforeach()
  endif()
endforeach()
if(TARGET MueLu::all_libs)
  target_link_libraries(Rhegma::Trilinos INTERFACE $<LINK_ONLY:MueLu::all_libs>)
elseif(RHEGMA_MUELU)
  # Without --as-needed a program would load some forty libraries that nothing here calls.
  target_link_libraries(Rhegma::Trilinos INTERFACE ${MueLu_LIBRARIES})
  target_link_options(Rhegma::Trilinos INTERFACE LINKER:--as-needed)
endif()
target_link_libraries(Rhegma::Trilinos INTERFACE MPI::MPI_CXX)

if("OPENMP" IN_LIST Kokkos_DEVICES)
  set(RHEGMA_BACKEND openmp)
  find_package(OpenMP REQUIRED COMPONENTS CXX)
  target_link_libraries(Rhegma::Trilinos INTERFACE OpenMP::OpenMP_CXX)
else()
  set(RHEGMA_BACKEND serial)
endif()
message(STATUS "Trilinos ${Trilinos_VERSION} (${RHEGMA_BACKEND}): ${Trilinos_DIR}")
