# The applications of docs/embedding and docs/guides as a stranger builds them: against a copy installed in an empty folder of the build
# tree, which find_package(Rhegma) is told of. One back end is enough, for what they try is the same in all.

if(NOT RHEGMA_TESTS OR NOT TARGET rhegma_program OR RHEGMA_FOLDERS_LEFT_OUT OR NOT RHEGMA_BACKEND STREQUAL serial)
  return()
endif()

set(folder ${PROJECT_BINARY_DIR}/embedding)

# rhegma_add_embedding_test(NAME [SETUP fixture] [NEEDS fixture] COMMAND ...)
function(rhegma_add_embedding_test name)
  cmake_parse_arguments(ARG "" "SETUP;NEEDS" COMMAND ${ARGN})
  add_test(NAME embedding.${name} COMMAND ${ARG_COMMAND})
  rhegma_set_test(embedding.${name} embedding 600)
  set_tests_properties(embedding.${name} PROPERTIES
    FIXTURES_SETUP "${ARG_SETUP}" FIXTURES_REQUIRED "${ARG_NEEDS}")
endfunction()

rhegma_add_embedding_test(empty SETUP embedding_empty COMMAND ${CMAKE_COMMAND} -E rm -rf ${folder})
rhegma_add_embedding_test(install SETUP embedding_installed NEEDS embedding_empty
  COMMAND ${CMAKE_COMMAND} --install ${PROJECT_BINARY_DIR} --prefix ${folder}/prefix)
set(launcher) # one word: a list would end the options
if(RHEGMA_CCACHE)
  set(launcher -DCMAKE_CXX_COMPILER_LAUNCHER=${RHEGMA_CCACHE})
endif()
foreach(source docs/embedding/film docs/guides/examples/effect)
  get_filename_component(application ${source} NAME)
  rhegma_add_embedding_test(${application}.build SETUP embedding_${application} NEEDS embedding_installed
    COMMAND ${CMAKE_CTEST_COMMAND} --build-and-test ${PROJECT_SOURCE_DIR}/${source}
      ${folder}/${application} --build-generator ${CMAKE_GENERATOR} --build-options
      -DCMAKE_PREFIX_PATH=${folder}/prefix -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_COMPILER=${CMAKE_CXX_COMPILER}
      ${launcher} -DCMAKE_CXX_FLAGS=-Werror)
endforeach()

set(film ${folder}/film/film ${PROJECT_SOURCE_DIR}/docs/embedding/film/film.xml)
rhegma_add_embedding_test(film NEEDS embedding_film COMMAND ${film})
rhegma_add_embedding_test(film.ranks NEEDS embedding_film
  COMMAND ${MPIEXEC_EXECUTABLE} ${MPIEXEC_NUMPROC_FLAG} 2 ${film})
set_tests_properties(embedding.film.ranks PROPERTIES PROCESSORS 2)
set_property(TEST embedding.film.ranks APPEND PROPERTY ENVIRONMENT OMPI_MCA_rmaps_base_oversubscribe=1)
rhegma_add_embedding_test(effect NEEDS embedding_effect
  COMMAND ${folder}/effect/bristles ${PROJECT_SOURCE_DIR}/docs/guides/examples/effect/block.xml)
