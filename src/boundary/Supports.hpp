#pragma once
/// Prescribed motion and symmetry from the scene.

#include "plan/Effect.hpp"
#include "scene/PositionFunction.hpp"
#include "scene/TimeFunction.hpp"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace Rhegma
{

/// A constraint, the time function of its value, and the force that holds it.
template <int D>
struct TimedConstraint
{
  NodeConstraint<D> constraint;
  Vector<D> value;
  TimeFunction history;
  std::string name;
  Vector<D> impulse{};      ///< on the body since the last sample [N s]
  Vector<D> displacement{}; ///< by `value` since the start, in steps of equilibrium [m]
  double absorbed = 0.0; ///< energy of waves of a few cells, absorbed since the last sample, on this rank [J]
  double absorbedTotal = 0.0; ///< the same up to the last sample, on all ranks [J]
  /// Mean between the last two samples, in equilibrium that of the last solution [N]; before the first not a
  /// number.
  Vector<D> force = notANumber<D>();
  std::optional<PositionFunction> field{}; ///< velocity as a function of position, if it varies
  int generation = 0;                      ///< of the cells whose nodes have it

  NodeConstraint<D> at(double time) const
  {
    NodeConstraint<D> now = constraint;
    now.factor = history(time);
    now.value = now.factor * value;
    return now;
  }
};

/// Evaluates the function of position at the nodes that the constraint holds, those of refined cells
/// included. Throws std::invalid_argument where it is not finite.
template <int D>
void setFieldAtNodes(TimedConstraint<D>& timed, const State<D>& state);

/// The calls that prescribe the motion. \param isEquilibrium whether the scene asks for that
template <int D>
void addConstraints(Effect<D>& effect, const std::shared_ptr<std::vector<TimedConstraint<D>>>& constraints,
                    bool isEquilibrium);

/// The calls that report the force of each support on the bodies, as a mean over the time since the last
/// sample, so that no part of it is missed; in equilibrium as that of the last solution.
template <int D>
void addReactions(Effect<D>& effect, const std::shared_ptr<std::vector<TimedConstraint<D>>>& constraints);

} // namespace Rhegma
