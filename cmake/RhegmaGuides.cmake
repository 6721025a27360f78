# The examples of docs/guides: each folder is a program, tested. A folder with a main file of its own is an application
# (tests/embedding builds it against an installed copy); the others are unit tests.

if(NOT RHEGMA_TESTS OR RHEGMA_FOLDERS_LEFT_OUT)
  return()
endif()

set(examples ${PROJECT_SOURCE_DIR}/docs/guides/examples)
foreach(guide boundary effect material test)
  file(GLOB sources CONFIGURE_DEPENDS ${examples}/${guide}/*.cpp)
  file(GLOB scene ${examples}/${guide}/*.xml)
  if(NOT EXISTS ${examples}/${guide}/main.cpp)
    list(APPEND sources ${PROJECT_SOURCE_DIR}/unit_tests/main.cpp)
    set(scene)
  endif()
  add_executable(guide_${guide} ${sources})
  rhegma_compile_options(guide_${guide})
  target_include_directories(guide_${guide} PRIVATE ${PROJECT_SOURCE_DIR}/unit_tests)
  target_link_libraries(guide_${guide} PRIVATE Rhegma::rhegma GTest::gtest Threads::Threads)
  add_test(NAME docs.guide.${guide} COMMAND guide_${guide} ${scene})
  rhegma_set_test(docs.guide.${guide} unit 300)
endforeach()
