#pragma once
/// From a scene's XML file to one validated parameter list.

#include "scene/SceneError.hpp"
#include "scene/Schema.hpp"

#include <Teuchos_ParameterList.hpp>
#include <Teuchos_RCP.hpp>

#include <string>
#include <vector>

namespace Rhegma
{

struct SceneResult
{
  /// Defaults filled in, types normalised (a Real is a double, an array a Teuchos::Array<double> or <int>).
  /// Null if the file holds no list; not to be run if there are errors.
  Teuchos::RCP<Teuchos::ParameterList> list;
  std::vector<SceneError> errors;
};

/// Reads and validates a scene; collects all errors instead of stopping at the first, and never throws for
/// one. A text whose name is "File" or ends in " File" is a path relative to the scene's folder, and is
/// resolved to one relative to the working directory.
///
/// \param overrides  "Section:Sub:Parameter=value", applied in order before the scene is validated
SceneResult readScene(const std::string& file, const std::vector<std::string>& overrides,
                      const SceneSchema& schema);

/// The same for the text of a scene.
SceneResult readSceneText(const std::string& xml, const std::vector<std::string>& overrides,
                          const SceneSchema& schema);

/// Validates a list of an application, with the same result. A list with errors is not changed.
void validateList(Teuchos::ParameterList& list, const SceneSchema& schema, std::vector<SceneError>& errors);

/// The reference of a part of a scene, for a terminal. \param path a section, or a part of it, such as
/// "Thermal > Sources" or "Domain:Cell Size"; empty: all
/// \throws std::invalid_argument if there is no such part; it names the nearest
std::string describe(const SceneSchema& schema, const std::string& path);

/// The whole reference as Markdown.
std::string describeMarkdown(const SceneSchema& schema);

} // namespace Rhegma
