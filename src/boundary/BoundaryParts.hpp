#pragma once
/// What the boundaries of a scene do together, and parameters that several types have.

#include "boundary/ReadLoad.hpp"
#include "boundary/Supports.hpp"
#include "plan/BoundaryType.hpp"
#include "plan/Effect.hpp"

namespace Rhegma
{

/// A boundary type adds to one of these: a support or a load, which then has its reports, energy and
/// checkpoints, or calls of its own.
template <int D>
struct BoundaryParts
{
  Effect<D>& effect; ///< all boundaries as a part of the plan: `effect.call(...)`
  const Teuchos::ParameterList& scene;
  /// Each makes a support or a load when all particles exist; throws std::invalid_argument where it can't.
  std::vector<std::function<TimedConstraint<D>(State<D>&)>> supports{};
  std::vector<std::function<Load<D>(const State<D>&)>> loads{};
};

/// The factor over time that most types have.
void describeHistory(Section& section);

/// The body on which a load acts.
void describeLoadedBody(Section& section);

/// All boundary types, in the order of the reference: one line each. The file of a type defines the function
/// of that name.
#define RHEGMA_BOUNDARY_TYPES(one)                                                                           \
  one(velocity) one(symmetry) one(pointLoad) one(lineLoad) one(traction) one(gravity) one(temperature)       \
      one(heatFlux) one(convection)

namespace BoundaryTypes
{
#define RHEGMA_DECLARE(name) BoundaryType name();
RHEGMA_BOUNDARY_TYPES(RHEGMA_DECLARE)
#undef RHEGMA_DECLARE
} // namespace BoundaryTypes

} // namespace Rhegma
