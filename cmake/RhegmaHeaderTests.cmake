# Every header of src/ and packages/ compiles alone: one generated file for each, which includes nothing else.
# Unoptimised, since only the front end of the compiler matters here.

file(GLOB_RECURSE headers CONFIGURE_DEPENDS RELATIVE ${PROJECT_SOURCE_DIR}
  ${PROJECT_SOURCE_DIR}/src/*.hpp ${PROJECT_SOURCE_DIR}/packages/*.hpp)
foreach(folder ${RHEGMA_FOLDERS_LEFT_OUT})
  list(FILTER headers EXCLUDE REGEX "^packages/${folder}/")
endforeach()

set(sources)
foreach(header ${headers})
  string(REGEX REPLACE "^(src|packages)/" "" include ${header})
  set(source ${PROJECT_BINARY_DIR}/header_tests/${header}.cpp)
  file(CONFIGURE OUTPUT ${source} CONTENT "#include \"${include}\"\n")
  list(APPEND sources ${source})
endforeach()

if(sources)
  add_library(header_tests OBJECT ${sources})
  rhegma_compile_options(header_tests)
  target_compile_options(header_tests PRIVATE -O0)
  target_link_libraries(header_tests PRIVATE Rhegma::rhegma)
endif()
