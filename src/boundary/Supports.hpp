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
  Vector<D> displacement{}; ///< by `value` since the start, along the axes that are held [m]
  double absorbed = 0.0; ///< energy of waves of a few cells, absorbed since the last sample, on this rank [J]
  double absorbedTotal = 0.0; ///< the same up to the last sample, on all ranks [J]
  /// Mean between the last two samples, in equilibrium that of the last solution [N]; before the first not a
  /// number.
  Vector<D> force = notANumber<D>();
  std::optional<PositionFunction> field{}; ///< velocity as a function of position, if it varies
  int generation = 0;                      ///< of the cells whose nodes have it
  /// Whether the box moves by `displacement`, so that it stays on the material that it held at the start.
  bool boxMoves = false;
  /// Length by which the trailing edges of such a box lag behind, so that nodes on them are not lost with the
  /// first motion [m]
  double lag = 0.0;
  /// Whether the body leaves its box, though the scene does not say that the box is to stay (leavesBox).
  bool leftBehind = false;
  bool reported = true;   ///< whether its force is a result, and a warning says where it is idle
  bool gridMoves = false; ///< whether all cells move with it, so that it holds the same nodes throughout

  /// Whether its value differs from zero along an axis that it holds.
  bool hasMotion() const
  {
    bool found = false;
    for (int d = 0; d < D; ++d)
      found = found || (constraint.holds[d] && value[d] != 0.0);
    return found;
  }

  /// The constraint with its value at a time [s], and with its box as it is now.
  NodeConstraint<D> at(double time) const { return withFactor(history(time)); }

  /// The same with a given factor of the value.
  NodeConstraint<D> withFactor(double factor) const
  {
    NodeConstraint<D> now = constraint;
    now.factor = factor;
    now.value = factor * value;
    for (int d = 0; d < D && boxMoves; ++d)
    {
      const double by = displacement[d];
      now.lower[d] += by > 0.0 ? trailing(by) : by;
      now.upper[d] += by < 0.0 ? trailing(by) : by;
    }
    return now;
  }

  /// Displacement of a trailing edge. \param by that of the box [m]
  double trailing(double by) const
  {
    return by > 0.0 ? (by > lag ? by - lag : 0.0) : (by < -lag ? by + lag : 0.0);
  }

  /// Records the motion over a step. \param by velocity times length of the step [m] \return its part along
  /// the axes that are held
  Vector<D> displace(Vector<D> by)
  {
    for (int d = 0; d < D; ++d)
      by[d] = constraint.holds[d] ? by[d] : 0.0;
    displacement = displacement + by;
    return by;
  }
};

/// Whether the box of a support with one velocity at all of its nodes moves: where the scene requests it, and
/// where it leaves the choice and the support moves and holds particles at the start. Collective.
/// \param choice value of the parameter Box Motion
/// \throws std::invalid_argument where the scene requests a moving box that contains no particle
template <int D>
bool boxMoves(const TimedConstraint<D>& timed, const std::string& choice, const State<D>& state);

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
