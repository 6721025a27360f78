# docs/reference.md is what the program prints of its parameters: the target `reference` writes it, and the test
# docs.reference fails where the committed page differs. This file is also the script of both.

if(CMAKE_SCRIPT_MODE_FILE) # cmake -DPROGRAM=... -DPAGE=... [-DCHECK=ON] -P RhegmaReference.cmake
  execute_process(COMMAND ${PROGRAM} --describe-markdown OUTPUT_VARIABLE printed RESULT_VARIABLE status)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "${PROGRAM} --describe-markdown ended with ${status}")
  endif()
  if(NOT CHECK)
    file(WRITE ${PAGE} "${printed}")
    message(STATUS "Wrote ${PAGE}")
    return()
  endif()
  set(committed "")
  if(EXISTS ${PAGE})
    file(READ ${PAGE} committed)
  endif()
  if(NOT committed STREQUAL printed)
    message(FATAL_ERROR "${PAGE} is not what the program prints of its parameters; write it anew with "
      "\"cmake --build BUILD --target reference\" and commit it.")
  endif()
  return()
endif()

if(TARGET rhegma_program)
  set(arguments -DPROGRAM=$<TARGET_FILE:rhegma_program> -DPAGE=${PROJECT_SOURCE_DIR}/docs/reference.md)
  add_custom_target(reference
    COMMAND ${CMAKE_COMMAND} ${arguments} -P ${CMAKE_CURRENT_LIST_FILE}
    DEPENDS rhegma_program VERBATIM)
  if(RHEGMA_TESTS AND NOT RHEGMA_FOLDERS_LEFT_OUT)
    add_test(NAME docs.reference COMMAND ${CMAKE_COMMAND} ${arguments} -DCHECK=ON -P ${CMAKE_CURRENT_LIST_FILE})
    rhegma_set_test(docs.reference unit 60)
  endif()
endif()
