# RHEGMA_MATERIALS: a source file with the files of xml_inputs/materials, the library of materials. It is made anew when one
# of them changes.

set(RHEGMA_MATERIALS ${CMAKE_CURRENT_BINARY_DIR}/MaterialFiles.cpp)
file(GLOB materials CONFIGURE_DEPENDS ${RHEGMA_ROOT}/xml_inputs/materials/*.xml)
set(entries "")
foreach(file ${materials})
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
  get_filename_component(name ${file} NAME)
  file(READ ${file} text)
  string(APPEND entries "      {\"${name}\", R\"file(${text})file\"},\n")
endforeach()
file(CONFIGURE OUTPUT ${RHEGMA_MATERIALS} @ONLY CONTENT [[
// Made by CMake from the files in xml_inputs/materials.
#include "scene/MaterialLibrary.hpp"

namespace Rhegma
{

const std::vector<MaterialFile>& materialFiles()
{
  static const std::vector<MaterialFile> all = {
@entries@  };
  return all;
}

} // namespace Rhegma
]])
