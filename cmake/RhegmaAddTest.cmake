# Tests of two kinds: folders of unit tests, and scenes that the program runs.

find_package(GTest REQUIRED)
find_package(Threads REQUIRED)

set(RHEGMA_TEST_THREADS 2 CACHE STRING "Threads of a test where the back end has threads")
# Ranks and threads that wait leave their core to others: tests run side by side, with more ranks and threads than cores.
# Without it, tests on several ranks take five times as long.
set(RHEGMA_TEST_ENVIRONMENT OMP_PROC_BIND=false OMP_WAIT_POLICY=passive OMPI_MCA_mpi_yield_when_idle=1
  OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1)
if(RHEGMA_BACKEND STREQUAL openmp)
  list(APPEND RHEGMA_TEST_ENVIRONMENT OMP_NUM_THREADS=${RHEGMA_TEST_THREADS})
endif()

# rhegma_set_test(NAME label LABEL timeout SECONDS): what all tests have in common. Each has a folder of its own for
# Open MPI, of which a program that ends removes what another that starts needs.
function(rhegma_set_test name label timeout)
  string(REPLACE "/" "_" folder ${name})
  set_tests_properties(${name} PROPERTIES LABELS ${label} TIMEOUT ${timeout}
    ENVIRONMENT "${RHEGMA_TEST_ENVIRONMENT};OMPI_MCA_orte_tmpdir_base=${PROJECT_BINARY_DIR}/mpi/${folder}")
endfunction()

# One program of all tst*.cpp of one folder of unit_tests: src/state becomes test_src_state. Further arguments go to
# the program.
function(rhegma_add_unit_tests folder)
  string(REPLACE "/" "_" name "test_${folder}")
  file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${folder}/*.cpp)
  add_executable(${name} ${sources} $<TARGET_OBJECTS:rhegma_test_main>)
  rhegma_compile_options(${name})
  target_compile_options(${name} PRIVATE -O1) # what is timed or heavy is in the library; -O3 takes half as long again
  target_include_directories(${name} PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})
  target_link_libraries(${name} PRIVATE Rhegma::rhegma GTest::gtest Threads::Threads)
  if(RHEGMA_UNITY_BUILD)
    set(grouped ${sources})
    foreach(alone ${RHEGMA_TESTS_ALONE})
      list(REMOVE_ITEM grouped ${CMAKE_CURRENT_SOURCE_DIR}/${alone}.cpp)
    endforeach()
    if(grouped)
      rhegma_unity_groups(${name} 5 ${grouped})
    endif()
  endif()
  target_compile_definitions(${name} PRIVATE RHEGMA_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
  if(TARGET rhegma_program)
    target_compile_definitions(${name} PRIVATE RHEGMA_PROGRAM="$<TARGET_FILE:rhegma_program>")
    add_dependencies(${name} rhegma_program)
  endif()
  add_test(NAME unit.${folder} COMMAND ${name} ${ARGN})
  rhegma_set_test(unit.${folder} unit 900)
endfunction()

# An interpreter that can read and draw a run, for the tools and their tests; empty if there is none.
set(RHEGMA_PYTHON $ENV{RHEGMA_PYTHON} CACHE FILEPATH "python3 with numpy, h5py and matplotlib")
if(NOT RHEGMA_PYTHON)
  foreach(python python3 /usr/bin/python3)
    execute_process(COMMAND ${python} -c "import h5py, matplotlib, numpy" RESULT_VARIABLE status OUTPUT_QUIET ERROR_QUIET)
    if(status EQUAL 0)
      set_property(CACHE RHEGMA_PYTHON PROPERTY VALUE ${python})
      break()
    endif()
  endforeach()
endif()

# One test in Python: a file tst*.py or test_*.py, run by itself; the exit status tells. With WHILE_TIME_IS_LEFT as a fourth
# argument it does not start after the time that `setup test --minutes` sets; it has the label limited, too. A fifth argument is
# added to its name, so that a test that draws its cases can be run several times.
function(rhegma_add_python_test file label timeout)
  get_filename_component(name ${file} NAME_WE)
  get_filename_component(folder ${file} DIRECTORY)
  set(name ${label}.${folder}.${name}${ARGV4})
  if(NOT RHEGMA_PYTHON)
    message(STATUS "no python3 with numpy, h5py and matplotlib: without the test of ${file}")
    return()
  endif()
  set(command ${CMAKE_CURRENT_SOURCE_DIR}/${file})
  if(ARGV3 STREQUAL WHILE_TIME_IS_LEFT)
    list(PREPEND command ${PROJECT_SOURCE_DIR}/unit_tests/while_time_is_left.py)
  endif()
  add_test(NAME ${name} COMMAND ${RHEGMA_PYTHON} ${command})
  rhegma_set_test(${name} ${label} ${timeout})
  if(ARGV3 STREQUAL WHILE_TIME_IS_LEFT)
    set_tests_properties(${name} PROPERTIES SKIP_RETURN_CODE 77)
    set_property(TEST ${name} APPEND PROPERTY LABELS limited)
  endif()
  set_property(TEST ${name} APPEND PROPERTY ENVIRONMENT PYTHONDONTWRITEBYTECODE=1 MPLBACKEND=Agg
    RHEGMA_SOURCE_DIR=${PROJECT_SOURCE_DIR})
  if(TARGET rhegma_program)
    set_property(TEST ${name} APPEND PROPERTY ENVIRONMENT RHEGMA_PROGRAM=$<TARGET_FILE:rhegma_program>)
  endif()
endfunction()

# One test that runs a scene; the program's exit status 4 (a reference was missed) fails it like any other.
function(rhegma_add_scene_test scene label)
  get_filename_component(name ${scene} NAME_WE)
  foreach(section ${RHEGMA_SECTIONS_LEFT_OUT})
    file(STRINGS ${scene} asks REGEX "^  <ParameterList name=\"${section}\"")
    if(asks)
      return()
    endif()
  endforeach()
  add_test(NAME ${label}.${name}
    COMMAND rhegma_program ${scene} --output ${PROJECT_BINARY_DIR}/scenes/${name})
  rhegma_set_test(${label}.${name} ${label} 1200)
endfunction()
