/// Works and energies of a step of equilibrium.

#include "equilibrium/Newton.hpp"

#include <cmath>
#include <utility>

namespace Rhegma::equilibrium
{

template <int D>
Values NewtonStep<D>::forcesOfStart(const State<D>& state, const Values& atStart) const
{
  const Values minusStored("rhegma::equilibrium::stored", D * graph_.rows);
  if (state.materials.thermo.empty())
    return minusStored;
  const Values none("rhegma::equilibrium::none", D * graph_.rows),
      minusLaw("rhegma::equilibrium::law", D * graph_.rows);
  subtractStoredForce(state, graph_, minusStored);
  subtractInternalForce(state, graph_, none, minusLaw);
  addOverRanks(state, graph_, minusStored);
  addOverRanks(state, graph_, minusLaw);
  for (int k = 0; k < D * graph_.rows; ++k)
  {
    atStart(k) += minusStored(k) - minusLaw(k);
    minusStored(k) = -minusStored(k);
  }
  return minusStored;
}

template <int D>
void NewtonStep<D>::findWork(const State<D>& state, const Values& atStart)
{
  const Values ofStress = forcesOfStart(state, atStart);
  workOfSupports_ = workOfStart_ = workOfLoadsOnStart_ = 0.0;
  for (int k = 0; k < D * graph_.rows; ++k)
  {
    const bool held = held_.is[k] != 0;
    reaction_(k) = held ? -residual_(k) : 0.0;
    if (!owners_.owns(k / D))
      continue;
    workOfSupports_ -= held ? 0.5 * (residual_(k) + atStart(k)) * displacement_(k) : 0.0;
    workOfStart_ += held ? 0.0 : 0.5 * ofStress(k) * displacement_(k);
  }
  if (state.clock.step > 0 || state.materials.thermo.empty())
    return;
  splitWork(state, ofStress);
  double works[] = {workOfStart_, workOfLoadsOnStart_, workOfSupports_};
  for (int k = 0; k < D * graph_.rows; ++k)
    works[1] += owners_.owns(k / D) ? 0.5 * load_(k) * displacement_(k) : 0.0;
  owners_.ranks().sum(works, 3);
  const double ofStart = std::fabs(works[0]), all = ofStart + std::fabs(works[1]) + std::fabs(works[2]);
  fractionOfStart_ = all > 0.0 ? ofStart / all : 0.0;
  // Only as much of it: loads follow a path of their own.
  workOfStart_ += fractionOfStart_ * workOfBentPath(state);
}

template <int D>
void NewtonStep<D>::splitWork(const State<D>& state, const Values& ofStress)
{
  const int n = D * graph_.rows;
  const Values right("rhegma::equilibrium::loads", n), ofLoads("rhegma::equilibrium::ofLoads", n);
  double acts = 0.0;
  for (int k = 0; k < n; ++k)
  {
    right(k) = owners_.owns(k / D) ? load_(k) : 0.0; // loads count once
    ofLoads(k) = held_.is[k] != 0 ? displacement_(k) : 0.0;
    acts = right(k) != 0.0 || ofLoads(k) != 0.0 ? 1.0 : acts;
  }
  if (owners_.ranks().max(acts) == 0.0)
    return;
  if (!modes_.empty())
    removeResultants(modes_, pieceOf_, position_, mass_, owners_, right);
  // Of loads and not of the stress, which may release a hundred times as much: an error of the linear
  // solution is a part of what is divided.
  const double enough = forceTolerance * norm(right, false);
  if (!assemble(state) ||
      !system_->solve(std::exchange(stiffness_, {}), symmetric_, right, enough, ofLoads).solved)
    return;
  copyFromOwners(state, graph_, owners_, ofLoads);
  removeRigidMotion(ofLoads);
  for (int k = 0; k < n; ++k)
    workOfLoadsOnStart_ += owners_.owns(k / D) && held_.is[k] == 0 ? 0.5 * ofStress(k) * ofLoads(k) : 0.0;
  workOfStart_ -= workOfLoadsOnStart_;
}

template <int D>
double NewtonStep<D>::workOfBentPath(const State<D>& state) const
{
  const int n = D * graph_.rows;
  const Values at("rhegma::equilibrium::onPath", n);
  // Simpson's rule is exact for a strain energy of the fourth order in the displacement, which that of
  // Green's strain is: (f0 + 4 f1/2 + f1) / 6 - (f0 + f1) / 2.
  double bent = 0.0;
  for (const auto& [part, weight] :
       {std::pair(0.0, -1.0 / 3.0), std::pair(0.5, 2.0 / 3.0), std::pair(1.0, -1.0 / 3.0)})
  {
    for (int k = 0; k < n; ++k)
      at(k) = part * displacement_(k);
    const Values minusForce("rhegma::equilibrium::forceOnPath", n);
    subtractInternalForce(state, graph_, at, minusForce);
    addOverRanks(state, graph_, minusForce);
    for (int k = 0; k < n; ++k)
      bent -= owners_.owns(k / D) ? weight * minusForce(k) * displacement_(k) : 0.0;
  }
  return bent;
}

template <int D>
double NewtonStep<D>::ghostEnergy() const
{
  double energy = 0.0;
  for (const SlopeJump& jump : jumps_)
    for (int d = 0; d < D; ++d)
    {
      const double difference = jumpOf<D>(jump, displacement_, d);
      energy += 0.5 * jump.weight * difference * difference;
    }
  return energy;
}

template Values NewtonStep<2>::forcesOfStart(const State<2>&, const Values&) const;
template void NewtonStep<2>::findWork(const State<2>&, const Values&);
template void NewtonStep<2>::splitWork(const State<2>&, const Values&);
template double NewtonStep<2>::workOfBentPath(const State<2>&) const;
template double NewtonStep<2>::ghostEnergy() const;
template Values NewtonStep<3>::forcesOfStart(const State<3>&, const Values&) const;
template void NewtonStep<3>::findWork(const State<3>&, const Values&);
template void NewtonStep<3>::splitWork(const State<3>&, const Values&);
template double NewtonStep<3>::workOfBentPath(const State<3>&) const;
template double NewtonStep<3>::ghostEnergy() const;

} // namespace Rhegma::equilibrium
