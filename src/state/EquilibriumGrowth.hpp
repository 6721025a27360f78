#pragma once
/// Growth of cracks in equilibrium: what the loop and the effect that advances fronts exchange.

#include <vector>

namespace Rhegma
{

/// A state of equilibrium on the path of growing cracks.
struct PathState
{
  double time = 0.0;         ///< [s]
  double factor = 0.0;       ///< of the loads, where they have one
  double displacement = 0.0; ///< of these loads: their work over the factor, summed from the start [J]
  double area = 0.0;         ///< by which cracks have grown since the start [m2]
  double rise = 0.0;         ///< of G over the last increment, over G before it, where loads are given
  double from = 0.0;         ///< begin of the load step [s], where loads are given
  /// When G reached the toughness in that load step [s]: G is taken as the square of a load that is linear in
  /// time.
  double reached = 0.0;
};

/// Growth under the loads of a load step, where unstable growth ends the equilibrium (Method::handsOver).
struct UnstableGrowth
{
  bool found = false; ///< growth is unstable: the state is of no use
  double drive = 0.0; ///< largest G/Gc under these loads, before cracks grew
  double rise = 0.0;  ///< of it while they grew, over itself
};

/// Growth of cracks in equilibrium.
struct EquilibriumGrowth
{
  double drive = 0.0;       ///< largest G/Gc of the fronts that can advance; 0: there are none
  double rate = 0.0;        ///< of the root of `drive` in the last load step, before cracks grew [1/s]
  double release = 0.0;     ///< G of the front node whose G/Gc is the largest [J/m2]; found with `drive`
  bool advance = false;     ///< set by the loop: fronts advance before the next step
  bool held = false;        ///< set by the loop: no front advances in the next step, whatever its G
  UnstableGrowth unstable;  ///< of the last step
  double motionFrom = -1.0; ///< time from which the run is one of motion [s]; negative: it is not
  double area = 0.0;        ///< by which cracks have grown since the start [m2]
  double startTime = 0.0;   ///< before which none grows under given loads; set at the start [s]
  /// Where the loads have a factor, one state a load step, the first before cracks have grown; else one an
  /// increment.
  std::vector<PathState> path;
};

} // namespace Rhegma
