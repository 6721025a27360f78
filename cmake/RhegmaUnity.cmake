# Where CMAKE_UNITY_BUILD is on (preset `sanitize`), up to eight files of a folder of the library are compiled
# as one, which is sooner done. These stay apart: they have names of their own that a neighbour has too.

set(RHEGMA_APART
  packages/cracks/Layout packages/cracks/Nearest packages/cracks/SurfaceMesh
  packages/energy_release/FrontDisk packages/energy_release/FrontDriving packages/energy_release/FrontIntegral
  packages/energy_release/FrontOpening packages/energy_release/FrontsInSpace
  packages/mass_matrix/KeepGuesses packages/propagation/PropagationInSpace packages/thermal/LongSteps
  src/scene/HeatWords src/scene/Overrides src/scene/TimeFunction)
list(TRANSFORM RHEGMA_APART PREPEND ${PROJECT_SOURCE_DIR}/)
list(TRANSFORM RHEGMA_APART APPEND .cpp)

# rhegma_compile_together(TARGET SOURCE...): sources by their full names, those of a folder one after another.
function(rhegma_compile_together target)
  if(NOT CMAKE_UNITY_BUILD)
    return()
  endif()
  list(REMOVE_ITEM ARGN ${RHEGMA_APART})
  set_target_properties(${target} PROPERTIES UNITY_BUILD_MODE GROUP)
  foreach(source ${ARGN})
    get_filename_component(folder ${source} DIRECTORY)
    file(RELATIVE_PATH folder ${PROJECT_SOURCE_DIR} ${folder})
    string(MAKE_C_IDENTIFIER ${folder} group)
    math(EXPR count_${group} "${count_${group}} + 1")
    math(EXPR part "(${count_${group}} - 1) / 8")
    set_property(SOURCE ${source} PROPERTY UNITY_GROUP ${group}_${part})
  endforeach()
endfunction()
