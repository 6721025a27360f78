#pragma once
/// Cell sizes for a requested error (Domain > Accuracy).

#include "scene/SceneError.hpp"
#include "scene/Schema.hpp"

#include <Teuchos_ParameterList.hpp>

#include <vector>

namespace Rhegma
{

/// Requirements of one error. Measured on a beam at rest, a running strip, a moving source of heat and a
/// penny-shaped crack (docs/how-to/accuracy.md).
struct AccuracyRule
{
  const char* name;   ///< as scenes write it
  double error;       ///< relative, of G, K or a rise of temperature
  double perLigament; ///< cells across the shortest distance from a front to a surface, or a crack's (half)
                      ///< length
  double
      perThickness;   ///< in 2D at rest, instead, cells across CellNeeds::thickness and NarrowGap::width: n
                      ///< cells across an arm bend with 54 / n^2 percent too little energy, half of the error
  double perFront;    ///< in 2D cells at a front in CellNeeds::ahead
  double aroundFront; ///< in 2D cells of each size next to a front
  double perClear;    ///< in 2D cells at a front in CellNeeds::clear, which the contour of J needs
  double perSource;   ///< cells in the radius of a moving source of heat
  double perResting;  ///< cells in the radius of a source at rest
  bool running;       ///< whether running cracks reach this error
};

/// In order of decreasing error.
const std::vector<AccuracyRule>& accuracyRules();

/// Sets what Domain > Accuracy chooses and the scene does not give: Domain > Cell Size, and smaller cells at
/// crack fronts (Adaptivity, Sub-Cycling), where both of these sections are absent and the crack allows them.
///
/// In 2D, cells at fronts are a fraction of the crack's length, and in scenes at rest all others
/// grow with the distance to the front up to a fraction of the body's thickness. In 3D a front among nodes
/// acts as if the crack were up to a quarter of a cell shorter, and G is in proportion to no more than the
/// square of a crack's length in usual bodies; so cells at the front are small compared with the crack, and
/// all others only compared with the ligament.
///
/// A scene without Accuracy does not change. If the cells can't be chosen, an error gives the reason. In that
/// case, and if the scene has other errors, some cell size is set for the checks that follow.
void chooseCells(Teuchos::ParameterList& scene, const SceneSchema& schema, std::vector<SceneError>& errors);

} // namespace Rhegma
