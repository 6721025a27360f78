#pragma once
/// Needs of effects for the cells that Domain > Accuracy chooses (scene/Accuracy.hpp).

#include "scene/SceneError.hpp"

#include <Teuchos_ParameterList.hpp>

#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace Rhegma
{

/// A box round a narrow part of a body: between a crack and a surface next to it, or another crack.
struct NarrowGap
{
  std::vector<double> lower, upper; ///< corners [m]
  double width;                     ///< of the part [m]
};

/// A box in which cells are small.
struct RefinedBox
{
  std::vector<double> lower, upper; ///< corners [m]
  double cell;                      ///< largest edge of cells [m]
};

/// Needs of a scene for its cells. Lengths are infinite where nothing requires one.
struct CellNeeds
{
  static constexpr double none = std::numeric_limits<double>::infinity();

  double across = none;   ///< from a crack front to a surface, or a crack's (half) length if shorter [m]
  double atFronts = none; ///< the shortest crack's (half) length, next to which cells at fronts are small [m]
  double ahead = none;    ///< in 2D from a front to the surface ahead of it, or `atFronts` if shorter [m]
  /// In 2D the least thickness that cells far from fronts resolve: half the extent of the body through a
  /// front [m].
  double thickness = none;
  double clear = none;   ///< in 2D from a front to the nearest surface or other crack, in any direction [m]
  double source = none;  ///< radius of the smallest round source of heat that moves [m]
  double atRest = none;  ///< radius of the smallest one at rest [m]
  double contour = none; ///< the inner radius that the scene gives to contours round fronts [m]
  bool running = false;  ///< whether fronts run
  bool rests = false;    ///< whether waves are damped, so that none needs small cells
  bool heat = false;     ///< whether layers of heat need small cells far from fronts, too
  bool facesLoaded = false;        ///< whether faces of cracks may have pressure, contact, gas or heat
  bool equal = false;              ///< whether all effects of the scene need cells of equal size
  std::vector<NarrowGap> narrow{}; ///< next to cracks, in 2D
  std::string shortestAcross, smallestSource; ///< sections that give these lengths

  bool fronts() const { return across < none; }
};

/// Smaller cells at fronts.
struct FrontRefinement
{
  int levels;                      ///< below Domain > Cell Size
  double around;                   ///< cells of each size next to a front
  bool moves;                      ///< whether the scene has time steps
  std::vector<RefinedBox> boxes{}; ///< where cells are smaller, too
};

/// Functions of an effect. All may be empty.
struct CellHook
{
  /// What cells can be chosen for, as text for messages.
  std::string subject{};
  /// Adds the needs of the effect's section, or an error where the section is wrong. The scene is valid
  /// except for cross checks, and has the section.
  std::function<void(const Teuchos::ParameterList& scene, CellNeeds&, std::vector<SceneError>&)> addNeeds{};
  /// Adds smaller cells at fronts to a scene that has no section of the effect.
  std::function<void(Teuchos::ParameterList& scene, const FrontRefinement&)> refine{};
  /// Levels of cells below Domain > Cell Size that the effect's section makes within this number of their
  /// edge lengths from fronts; at 0 anywhere.
  std::function<int(const Teuchos::ParameterList& section, double around)> levels{};
};

} // namespace Rhegma
