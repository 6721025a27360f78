#pragma once
/// What effects ask of the cells that Domain > Accuracy chooses (scene/Accuracy.hpp).

#include "scene/SceneError.hpp"

#include <Teuchos_ParameterList.hpp>

#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace Rhegma
{

/// What a scene asks of its cells. Lengths are infinite where nothing has one.
struct CellNeeds
{
  static constexpr double none = std::numeric_limits<double>::infinity();

  double across = none;   ///< from a crack front to a surface, or a crack's (half) length if shorter [m]
  double atFronts = none; ///< the shortest crack's (half) length, next to which cells at fronts are small [m]
  double source = none;   ///< radius of the smallest round source of heat that moves [m]
  double atRest = none;   ///< radius of the smallest one at rest [m]
  bool running = false;   ///< whether fronts run
  bool equal = false;     ///< whether what the scene has does without smaller cells at fronts
  std::string shortestAcross, smallestSource; ///< which sections the lengths are from

  bool fronts() const { return across < none; }
};

/// How an effect takes part. All may be empty.
struct CellHook
{
  /// For what of the effect cells can be chosen, in words.
  std::string knows{};
  /// Adds what the effect's section asks for to the needs; where it is wrong itself, an error. The scene is
  /// valid but for cross checks, and has the section.
  std::function<void(const Teuchos::ParameterList& scene, CellNeeds&, std::vector<SceneError>&)> tell{};
  /// Gives a scene smaller cells at fronts, by so many levels. It has no section of the effect yet.
  std::function<void(Teuchos::ParameterList& scene, int levels)> refine{};
};

} // namespace Rhegma
