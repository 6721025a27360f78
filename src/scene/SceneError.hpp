#pragma once
/// A user's mistake in a scene.

#include <string>
#include <vector>

namespace Rhegma
{

/// One mistake: where it is and one sentence that says what is wrong and what to write instead.
struct SceneError
{
  std::string
      where; ///< path of names, such as "Materials > Steel > Poisson Ratio"; empty for the scene as a whole
  std::string message;
};

/// "Materials > Steel" and "Poisson Ratio" give "Materials > Steel > Poisson Ratio".
inline std::string scenePath(const std::string& parent, const std::string& name)
{
  return parent.empty() ? name : parent + " > " + name;
}

/// The mistake as a line for a person: where it is, a colon, the sentence.
inline std::string toString(const SceneError& error)
{
  return error.where.empty() ? error.message : error.where + ": " + error.message;
}

} // namespace Rhegma
