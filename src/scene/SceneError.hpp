#pragma once
/// Errors in scenes.

#include <string>
#include <vector>

namespace Rhegma
{

/// An error in a scene: its path, and a message with what is wrong and what to write instead.
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

/// The error as one line: path, colon, message.
inline std::string toString(const SceneError& error)
{
  return error.where.empty() ? error.message : error.where + ": " + error.message;
}

} // namespace Rhegma
