#pragma once
/// Cells that reach an error which the scene names (Domain > Accuracy).

#include "scene/SceneError.hpp"
#include "scene/Schema.hpp"

#include <Teuchos_ParameterList.hpp>

#include <vector>

namespace Rhegma
{

/// What one of the errors asks for. Measured on a beam at rest, a running strip, a moving source of heat and
/// a penny-shaped crack (docs/accuracy-and-cost.md).
struct AccuracyRule
{
  const char* name;   ///< as scenes write it
  double share;       ///< error of G, K or a rise of temperature
  double perLigament; ///< cells across the shortest way from a front to a surface, or a crack's (half) length
  double perSource;   ///< cells in the radius of a moving source of heat
  double perResting;  ///< cells in the radius of one at rest, whose peak stays in one position
  bool running;       ///< whether cracks that run reach it
};

/// Of the largest error first.
const std::vector<AccuracyRule>& accuracyRules();

/// Fills in what Domain > Accuracy chooses and the scene leaves open: Domain > Cell Size, and smaller cells
/// at crack fronts (Adaptivity, Sub-Cycling), where both of these sections are absent and the crack allows
/// them.
///
/// A front among nodes acts as if the crack were up to a quarter of a cell shorter, and G is in proportion to
/// no more than the square of a crack's length in usual bodies; so cells at the front are small next to the
/// crack, and all others next to the ligament only.
///
/// A scene without Accuracy stays as it is. Where the cells can't be chosen an error says why; then, and
/// where the scene has other mistakes, cells are such that the checks that follow have some.
void chooseCells(Teuchos::ParameterList& scene, const SceneSchema& schema, std::vector<SceneError>& errors);

} // namespace Rhegma
