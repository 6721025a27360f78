# How every target of this project is compiled. Targets ask for it with rhegma_compile_options(NAME).

if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Release, RelWithDebInfo or Debug" FORCE)
endif()
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)

# Paths below the source folder count as relative ones, so that a second clone finds what the first has compiled.
find_program(RHEGMA_CCACHE ccache)
if(RHEGMA_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_BASEDIR=${CMAKE_CURRENT_SOURCE_DIR} ${RHEGMA_CCACHE})
endif()

include(CheckCXXCompilerFlag)
check_cxx_compiler_flag(-march=native RHEGMA_HAS_MARCH_NATIVE)
check_cxx_compiler_flag(-fno-ipa-modref RHEGMA_HAS_IPA_MODREF)

# Results stay those of IEEE arithmetic (no -ffast-math): the two flags below only give up errno and floating-point
# traps, which nothing here reads and which keep loops with sqrt or a division from being vectorised.
# GCC's two warnings that are off come from its optimiser and are wrong where it inlines a null pointer that is never
# used (no history of a material) or the allocator of std::vector (seen with GCC 12).
# GCC's analysis of what functions read (modref) takes away stores that kernels read through a pointer in a structure: with GCC
# 12 and OpenMP the diagonal of a tangent lacked some particles (tstTangentProduct). Who compiles kernels of the headers needs
# the same.
function(rhegma_compile_options target)
  target_compile_features(${target} PUBLIC cxx_std_17)
  if(RHEGMA_HAS_IPA_MODREF AND CMAKE_CXX_COMPILER_ID STREQUAL GNU)
    target_compile_options(${target} PUBLIC $<$<CXX_COMPILER_ID:GNU>:-fno-ipa-modref>)
  endif()
  target_compile_options(${target} PRIVATE
    -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Woverloaded-virtual
    -fno-math-errno -fno-trapping-math
    $<$<CONFIG:Release>:-O3>
    $<$<CXX_COMPILER_ID:GNU>:-Wno-array-bounds -Wno-free-nonheap-object>
    $<$<BOOL:${RHEGMA_WARNINGS_AS_ERRORS}>:-Werror>)
  if(RHEGMA_NATIVE AND RHEGMA_HAS_MARCH_NATIVE)
    target_compile_options(${target} PRIVATE -march=native)
  endif()
endfunction()

# Compiles the sources of a target in groups of at most so many files of one folder, as equal as they can be. A group is named
# by its folder below the source folder, so that a second clone finds it in ccache. Files of folders in the list
# RHEGMA_LIGHT_FOLDERS (names such as src_output) are optimised less. Two warnings are off there: a local name may be that of
# another file's constant, and lambdas of a group's files may use types of their anonymous namespaces.
function(rhegma_unity_groups target most)
  foreach(source ${ARGN})
    get_filename_component(folder ${source} DIRECTORY)
    file(RELATIVE_PATH folder ${PROJECT_SOURCE_DIR} ${folder})
    string(MAKE_C_IDENTIFIER "${folder}" folder)
    list(APPEND folders ${folder})
    list(APPEND sources_${folder} ${source})
  endforeach()
  list(REMOVE_DUPLICATES folders)
  foreach(folder ${folders})
    list(LENGTH sources_${folder} count)
    math(EXPR groups "(${count} + ${most} - 1) / ${most}")
    set(at 0)
    foreach(source ${sources_${folder}})
      math(EXPR group "${at} * ${groups} / ${count}")
      math(EXPR at "${at} + 1")
      set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${folder}_${group})
      if(folder IN_LIST RHEGMA_LIGHT_FOLDERS)
        set_source_files_properties(${CMAKE_CURRENT_BINARY_DIR}/CMakeFiles/${target}.dir/Unity/unity_${folder}_${group}_cxx.cxx
          PROPERTIES COMPILE_OPTIONS -O1)
      endif()
    endforeach()
  endforeach()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  target_compile_options(${target} PRIVATE -Wno-shadow $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
endfunction()
