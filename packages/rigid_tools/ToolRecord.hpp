#pragma once
/// What a tool has exchanged with bodies since the start, for the energy balance, the history and the
/// summary.

#include "rigid_tools/ToolImpulses.hpp"

#include <nlohmann/json.hpp>

#include <string>

namespace Rhegma
{
class Archive;
}

namespace Rhegma::rigid_tools
{

/// Record of a tool.
template <int D>
class ToolRecord
{
public:
  /// Adds what the tool has exchanged in this step.
  void add(const State<D>& state, const ToolSums<D>& sums);
  /// Adds position, velocity, force since the last sample and work to the history.
  void sample(State<D>& state, const Tool<D>& tool);
  /// The entry of the summary.
  nlohmann::json report(const Tool<D>& tool) const;
  /// A warning of steps with too little friction; empty if there are none.
  std::string warning(const Tool<D>& tool) const;
  void serialize(Archive& archive); ///< saves or loads it

  double friction() const { return friction_; }  ///< energy lost along the faces [J]
  void addHeat(double heat) { heated_ += heat; } ///< adds heat by friction in the bodies [J]

private:
  double firstTouch_ = -1.0;  ///< when it first pressed on a body [s]; below 0: not yet
  double dissipated_ = 0.0;   ///< kinetic energy that contact took [J]
  double friction_ = 0.0;     ///< the part of it along the faces [J]
  double heated_ = 0.0;       ///< the part of that which became heat of bodies [J]
  double work_ = 0.0;         ///< on bodies [J]
  double overlap_ = 0.0;      ///< largest so far [m]
  double largestForce_ = 0.0; ///< largest mean force of an interval of the history [N]
  int closed_ = 0;            ///< fields of nodes that press on it now
  int cutSteps_ = 0;          ///< steps in which fields slid with less friction than the law has
  int mostCut_ = 0;           ///< largest number of these fields in a step
  Vector<D> impulse_{};       ///< on bodies so far [N s]
  Vector<D> atSample_{};      ///< the same at the last sample [N s]
  double sampled_ = 0.0;      ///< time of that sample [s]
  Vector<D> force_{};         ///< on bodies, mean between the last two samples [N]
};

} // namespace Rhegma::rigid_tools
