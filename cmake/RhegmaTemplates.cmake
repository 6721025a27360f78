# RHEGMA_TEMPLATES: a source file with the scenes of xml_inputs/templates, which `rhegma --new NAME` prints. It is made anew
# when one of them changes.

set(RHEGMA_TEMPLATES ${CMAKE_CURRENT_BINARY_DIR}/Templates.cpp)
file(GLOB templates CONFIGURE_DEPENDS ${RHEGMA_ROOT}/xml_inputs/templates/*.xml)
set(entries "")
foreach(template ${templates})
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${template})
  get_filename_component(name ${template} NAME_WE)
  file(READ ${template} text)
  string(APPEND entries "      {\"${name}\", R\"scene(${text})scene\"},\n")
endforeach()
file(CONFIGURE OUTPUT ${RHEGMA_TEMPLATES} @ONLY CONTENT [[
// Made by CMake from the files in xml_inputs/templates.
#include "program/Templates.hpp"

namespace Rhegma::program
{

const std::vector<SceneTemplate>& sceneTemplates()
{
  static const std::vector<SceneTemplate> all = {
@entries@  };
  return all;
}

} // namespace Rhegma::program
]])
