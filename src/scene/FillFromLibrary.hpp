#pragma once
/// Constants of the library of materials in a scene.
///
/// A list whose section has a `libraryKey`, such as `Material From Library`, may leave out what the material
/// has. What the scene writes wins. Values from the library are marked as default ones
/// (ParameterEntry::isDefault).

#include "scene/SceneError.hpp"
#include "scene/Schema.hpp"

#include <Teuchos_ParameterList.hpp>

#include <string>
#include <vector>

namespace Rhegma
{

/// Adds the laws of library materials where a scene has none, so that --set knows the parameters of the law.
void addLibraryLaws(Teuchos::ParameterList& scene, const SceneSchema& schema);

/// Adds the constants of library materials, in SI units, where the scene has none of its own; errors of an
/// unknown material, of a law that it does not have, and of one without a toughness. Constants of heat are
/// added where a section of the scene provides heat. Of a yield stress and its hardening, which are one
/// curve, the hardening is added only if the scene has none of both.
void fillFromLibrary(Teuchos::ParameterList& scene, const SceneSchema& schema,
                     std::vector<SceneError>& errors);

/// What a list of a scene has from the library.
struct LibraryUse
{
  std::string where;    ///< path of the list, such as "Materials > Plate"
  std::string material; ///< of the library
  struct Value
  {
    std::string name;
    Teuchos::ParameterEntry entry; ///< a number in SI units, or a text
    std::string unit;              ///< empty for a pure number or a text without one
  };
  std::vector<Value> taken;         ///< from the library
  std::vector<std::string> written; ///< parameters that the scene has itself, though the library has them
};

/// All of a validated scene.
std::vector<LibraryUse> libraryUses(const Teuchos::ParameterList& scene, const SceneSchema& schema);

/// The same as text, a line each, for a terminal.
std::string libraryUsesAsText(const Teuchos::ParameterList& scene, const SceneSchema& schema);

} // namespace Rhegma
