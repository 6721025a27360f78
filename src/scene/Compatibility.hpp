#pragma once
/// What does not go together in a scene, as data: rules stand in the sections that they are about
/// (`Section::refuse`), are checked in one position, and are printed in the reference.

#include "scene/SceneError.hpp"

#include <Teuchos_ParameterList.hpp>

#include <functional>
#include <string>
#include <vector>

namespace Rhegma
{

class SceneSchema;

/// Something that a scene may have. A section is a path of names with " > " between; "*" in it stands for
/// every list that the user names, and for the same name in all conditions of a rule.
struct Condition
{
  std::string section;
  std::string parameter; ///< of it; empty: the condition is about the section
  std::string words;     ///< as in the reference, after the path
  bool absent = false;   ///< whether it holds where there is no such section
  /// Whether it holds for a section that is there.
  std::function<bool(const Teuchos::ParameterList& section)> holds;
  std::string capability{}; ///< given: it holds where no section of the scene provides this instead
};

/// What sections may provide (`Section::provides`), so that others need not know which one does.
namespace capability
{
constexpr const char* heat = "heat"; ///< temperatures of particles
}

/// Conditions.
namespace when
{
Condition present(const std::string& section);
Condition absent(const std::string& section);
Condition given(const std::string& section, const std::string& parameter);
/// The parameter, a text or true or false, has one of the values, or, if it is given, another than these.
Condition is(const std::string& section, const std::string& parameter, std::vector<std::string> values);
Condition isNot(const std::string& section, const std::string& parameter, std::vector<std::string> values);
Condition above(const std::string& section, const std::string& parameter, double bound);
Condition below(const std::string& section, const std::string& parameter, double bound);
/// The section is as the words say.
Condition satisfies(const std::string& section, const std::string& words,
                    std::function<bool(const Teuchos::ParameterList&)> holds);
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

/// Adds an error for every rule of the schema that a scene breaks, and for lists that should have names of
/// another section's. The scene is valid but for such checks.
void checkRules(const Teuchos::ParameterList& scene, const SceneSchema& schema,
                std::vector<SceneError>& errors);

} // namespace Rhegma
