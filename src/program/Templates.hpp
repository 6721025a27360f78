#pragma once
/// Scenes to start from.

#include "program/Options.hpp"

#include <ostream>
#include <string>
#include <vector>

namespace Rhegma::program
{

struct SceneTemplate
{
  const char* name;
  const char* text; ///< XML, with comments
};

/// The scenes of xml_inputs/templates, in the order of their names; CMake makes the function of these files.
const std::vector<SceneTemplate>& sceneTemplates();

/// The template of a name. \throws UsageError with all names if there is none
const SceneTemplate& findTemplate(const std::string& name);

/// Prints the template of the option --new, or writes it to the file of --output, which must not exist yet.
/// Collective; one rank writes. \return the exit code
int writeTemplate(const Options& options, std::ostream& out, std::ostream& err);

} // namespace Rhegma::program
