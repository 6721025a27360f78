#pragma once
/// The supports and loads of a scene, and parameters of several types.

#include "boundary/BodySurface.hpp"
#include "boundary/ReadLoad.hpp"
#include "boundary/Supports.hpp"
#include "plan/BoundaryType.hpp"
#include "plan/Effect.hpp"

namespace Rhegma
{

/// A boundary type adds a support or a load, for which reports, energy and checkpoints are provided, or its
/// own calls.
template <int D>
struct BoundaryParts
{
  Effect<D>& effect; ///< all boundaries as a part of the plan: `effect.call(...)`
  const Teuchos::ParameterList& scene;
  /// Each makes a support or a load when all particles exist; throws std::invalid_argument where it can't.
  std::vector<std::function<TimedConstraint<D>(State<D>&)>> supports{};
  std::vector<std::function<Load<D>(const State<D>&)>> loads{};
};

/// Adds the parameter History, a factor over time.
ParameterBuilder describeHistory(Section& section);

/// Adds the parameter Body, on which a load acts.
void describeLoadedBody(Section& section);

/// A parameter as a point; zero along z in 2D [m].
Vector<3> readPoint(const Teuchos::ParameterList& list, const std::string& name);

/// All boundary types, in the order of the reference: one line each. The file of a type defines the function
/// of that name with `Boundary` after it.
#define RHEGMA_BOUNDARY_TYPES(one)                                                                           \
  one(velocity) one(symmetry) one(pointLoad) one(lineLoad) one(traction) one(gravity) one(temperature)       \
      one(heatFlux) one(convection)

#define RHEGMA_DECLARE(name) BoundaryType name##Boundary();
RHEGMA_BOUNDARY_TYPES(RHEGMA_DECLARE)
#undef RHEGMA_DECLARE

} // namespace Rhegma
