#pragma once
/// Combinations that a scene must not have, as data: rules belong to the sections that they concern
/// (`Section::refuse`), are checked in one function, and are printed in the reference.

#include "scene/SceneError.hpp"

#include <Teuchos_ParameterList.hpp>

#include <functional>
#include <string>
#include <vector>

namespace Rhegma
{

class SceneSchema;
struct KeptParameter;

/// A condition on a scene. A section is a path of names with " > " between; "*" in it stands for every list
/// that the user names, and for the same name in all conditions of a rule.
struct Condition
{
  std::string section;
  std::string parameter; ///< of it; empty: the condition is about the section
  std::string text;      ///< as in the reference, after the path or "without"
  bool absent = false;   ///< whether it holds if the section is absent
  /// Whether it holds for an existing section.
  std::function<bool(const Teuchos::ParameterList& section)> holds;
  std::string capability{}; ///< if given: it holds where no section of the scene provides this capability
};

/// Capabilities of sections (`Section::provides`): rules need not know which section provides one.
namespace capability
{
constexpr const char* heat = "heat";     ///< temperatures of particles
constexpr const char* cracks = "cracks"; ///< explicit cracks
} // namespace capability

/// Conditions.
namespace when
{
Condition present(const std::string& section);
Condition absent(const std::string& section);
Condition given(const std::string& section, const std::string& parameter);
/// is: the parameter, a text or true or false, has one of the values. isNot: it is given and has none of
/// them.
Condition is(const std::string& section, const std::string& parameter, std::vector<std::string> values);
Condition isNot(const std::string& section, const std::string& parameter, std::vector<std::string> values);
Condition above(const std::string& section, const std::string& parameter, double bound);
Condition below(const std::string& section, const std::string& parameter, double bound);
/// The section fulfils `holds`, described by `text`.
Condition satisfies(const std::string& section, const std::string& text,
                    std::function<bool(const Teuchos::ParameterList&)> holds);
/// The scene asks for equilibrium instead of motion.
Condition equilibrium();
/// No section of the scene provides it.
Condition unprovided(const std::string& capability);
} // namespace when

/// A scene is refused where all conditions hold.
struct Rule
{
  std::vector<Condition> conditions;
  std::string reason;    ///< and what to do, as in a message after the path
  int at = 0;            ///< the condition whose path the message names
  int onlyDimension = 0; ///< 2 or 3: only scenes of this dimension; 0: all

  /// The conditions as in the reference.
  std::string asText() const;
};

/// The parameters of the schema whose conditions hold for a scene, which a restart must not change.
std::vector<KeptParameter> keptParameters(const Teuchos::ParameterList& scene, const SceneSchema& schema);

/// Adds an error for every rule of the schema that a scene breaks, and for lists whose names must be those of
/// another section's lists. The scene is valid except for such checks.
void checkRules(const Teuchos::ParameterList& scene, const SceneSchema& schema,
                std::vector<SceneError>& errors);

} // namespace Rhegma
