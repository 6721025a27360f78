# RHEGMA_SOURCES: all of src/ and packages/ but the files of the program alone (RHEGMA_PROGRAM_SOURCES) and the packages that are
# switched off.
# RHEGMA_ROOT is the folder of this repository.

get_filename_component(RHEGMA_ROOT ${CMAKE_CURRENT_LIST_DIR}/.. ABSOLUTE)
include(${RHEGMA_ROOT}/packages/Packages.cmake)
file(GLOB_RECURSE RHEGMA_SOURCES CONFIGURE_DEPENDS ${RHEGMA_ROOT}/src/*.cpp ${RHEGMA_ROOT}/packages/*.cpp)
set(RHEGMA_PROGRAM_SOURCES ${RHEGMA_ROOT}/src/main.cpp ${RHEGMA_ROOT}/src/LargeAllocations.cpp)
list(REMOVE_ITEM RHEGMA_SOURCES ${RHEGMA_PROGRAM_SOURCES})
foreach(folder ${RHEGMA_FOLDERS_LEFT_OUT})
  list(FILTER RHEGMA_SOURCES EXCLUDE REGEX "^${RHEGMA_ROOT}/packages/${folder}/")
endforeach()
include(${CMAKE_CURRENT_LIST_DIR}/RhegmaTemplates.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/RhegmaMaterials.cmake)
list(APPEND RHEGMA_SOURCES ${RHEGMA_REGISTRY} ${RHEGMA_TEMPLATES} ${RHEGMA_MATERIALS})
