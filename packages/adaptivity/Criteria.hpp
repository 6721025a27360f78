#pragma once
/// Which cells should be refined.

#include "grid/Branches.hpp"
#include "state/State.hpp"

#include <vector>

namespace Rhegma::adaptivity
{

/// A box whose cells are refined down to a level.
template <int D>
struct Region
{
  Vector<D> lower, upper; ///< [m]
  int level;
};

template <int D>
struct Criteria
{
  int maximumLevel = 1;
  double frontCells = 0.0;        ///< 0: crack fronts are not considered
  double velocityChange = 0.0;    ///< over a cell; 0: not considered [m/s]
  double temperatureChange = 0.0; ///< over a cell; 0: not considered [K]
  double coarsening = 0.5;        ///< fraction of the threshold below which cells are coarsened
  int buffer = 1;                 ///< rings of refined cells around those in which a quantity changes much
  std::vector<Region<D>> regions;
};

/// The cells of the whole lattice that the criteria ask to refine now, and those that the balance of levels
/// needs in addition; the same on all ranks. Collective.
///
/// Fronts: a cell of any level that is nearer to a crack front than `frontCells` of its own edges is refined
/// (half a cell more where it is refined already, so that small motions of a front do not refine and coarsen
/// cells in turn). Velocity: a leaf whose edge times its mean velocity gradient is above the threshold is
/// refined, by one level at a time, and so for its mean temperature gradient; a refined cell stays so while
/// its own edge times the mean over all of it is above `coarsening` times the threshold
/// (VelocityCriterion.hpp). Cells outside of the domain stay as they are.
template <int D>
Branches<D> wantedBranches(const State<D>& state, const Criteria<D>& criteria, const Branches<D>& now);

} // namespace Rhegma::adaptivity
