# RHEGMA_FUZZERS=ON: the target `fuzzers` builds fuzz_scene and fuzz_checkpoint in BUILD/fuzz with clang, whatever compiler
# the rest has, against a copy that it installs there (unit_tests/fuzz/CMakeLists.txt).

option(RHEGMA_FUZZERS "Build fuzzers of the readers of scenes and checkpoints (libFuzzer of clang)" OFF)
if(NOT RHEGMA_FUZZERS)
  return()
endif()
find_program(RHEGMA_CLANGXX NAMES clang++ clang++-14 clang++-15 clang++-16 REQUIRED)
set(folder ${PROJECT_BINARY_DIR}/fuzz)
add_custom_target(fuzzers ALL
  COMMAND ${CMAKE_COMMAND} --install ${PROJECT_BINARY_DIR} --prefix ${folder}/prefix
  COMMAND ${CMAKE_COMMAND} -S ${PROJECT_SOURCE_DIR}/unit_tests/fuzz -B ${folder} -G ${CMAKE_GENERATOR}
    -DCMAKE_CXX_COMPILER=${RHEGMA_CLANGXX} -DCMAKE_PREFIX_PATH=${folder}/prefix
  COMMAND ${CMAKE_COMMAND} --build ${folder}
  VERBATIM)
add_dependencies(fuzzers rhegma rhegma_program)
