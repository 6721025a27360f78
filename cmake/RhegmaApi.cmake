# The reference of the interface, where doxygen is: the target `api` writes BUILD/api, and the test docs.api fails
# where a public name has no words.

find_program(RHEGMA_DOXYGEN doxygen)
if(NOT RHEGMA_DOXYGEN)
  return()
endif()
file(WRITE ${PROJECT_BINARY_DIR}/Doxyfile
  "@INCLUDE = ${PROJECT_SOURCE_DIR}/docs/Doxyfile\nOUTPUT_DIRECTORY = ${PROJECT_BINARY_DIR}\n")
add_custom_target(api COMMAND ${RHEGMA_DOXYGEN} ${PROJECT_BINARY_DIR}/Doxyfile WORKING_DIRECTORY ${PROJECT_SOURCE_DIR})
if(RHEGMA_TESTS)
  add_test(NAME docs.api COMMAND ${RHEGMA_DOXYGEN} ${PROJECT_BINARY_DIR}/Doxyfile WORKING_DIRECTORY ${PROJECT_SOURCE_DIR})
  rhegma_set_test(docs.api unit 120)
endif()
