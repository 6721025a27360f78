#include "cracks/AdvectedFronts.hpp"

#include "base/Numbers.hpp"
#include "base/SmallLoops.hpp"
#include "cracks/CrackGeometry.hpp"
#include "cracks/SpringConstants.hpp"
#include "transfer/LocalSpacing.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

namespace Rhegma::cracks
{

namespace
{

template <int D>
void disableSprings(const State<D>& state, int crack)
{
  const View<int*> near = state.cracks.nearFront, crackOf = state.cracks.crackOf;
  parallelForSmall(
      "rhegma::cracks::disableSprings", static_cast<int>(near.extent(0)), KOKKOS_LAMBDA(const int s) {
        if (crackOf(s) == crack && nearFront::mayHaveSprings(near(s)))
          near(s) = nearFront::springsDisabled;
      });
}

} // namespace

template <int D>
void AdvectedFronts<D>::start(const State<D>& state)
{
  start_.clear();
  for (const CrackFront<D>& front : state.cracks.fronts)
    start_.push_back(front.position);
  disabled_.assign(state.cracks.cracks.size(), false);
}

template <int D>
double AdvectedFronts<D>::advectedCells(const State<D>& state, std::size_t front) const
{
  const CrackFront<D>& now = state.cracks.fronts[front];
  if (now.grown || now.ended || front >= start_.size())
    return 0.0;
  const double distance = norm(now.position - start_[front]);
  return distance > springs::advectionLimit * state.mesh.smallestSpacing()
             ? distance / spacingAt(state, now.position)
             : 0.0;
}

template <int D>
void AdvectedFronts<D>::findMarks(const State<D>& state)
{
  const auto near = onHost(state.cracks.nearFront);
  const auto crackOf = onHost(state.cracks.crackOf);
  for (std::size_t s = 0; s < near.extent(0); ++s)
    if (near(s) == nearFront::springsDisabled)
      disabled_[crackOf(s)] = true;
}

template <int D>
void AdvectedFronts<D>::update(State<D>& state)
{
  if (marked_ == nullptr)
    findMarks(state); // those of a checkpoint
  bool changed = marked_ != state.cracks.nearFront.data();
  for (std::size_t f = 0; f < state.cracks.fronts.size(); ++f)
  {
    const int crack = state.cracks.fronts[f].crack;
    if (disabled_[crack] || advectedCells(state, f) <= springs::advectionLimit)
      continue;
    disabled_[crack] = true;
    changed = true;
  }
  if (!changed)
    return;
  for (std::size_t c = 0; c < disabled_.size(); ++c)
    if (disabled_[c])
      disableSprings(state, static_cast<int>(c));
  marked_ = state.cracks.nearFront.data();
}

template <int D>
void AdvectedFronts<D>::report(const State<D>& state, nlohmann::json& summary) const
{
  for (std::size_t f = 0; f < state.cracks.fronts.size(); ++f)
  {
    const CrackFront<D>& front = state.cracks.fronts[f];
    const double cells = advectedCells(state, f);
    if (cells > springs::advectionLimit)
      summary["warnings"].push_back(
          "Cracks > " + state.cracks.cracks[front.crack].name + ", front " + std::to_string(front.number) +
          ": the body moved it by " + formatReal(std::round(10.0 * cells) / 10.0) +
          " of a cell's edge; its front springs were disabled after half a cell, so G is that of a crack up "
          "to half a "
          "cell longer or shorter. " +
          (state.method.equilibrium()
               ? "Use cells that are small compared with the crack (Domain > Cell Size), or loads that move "
                 "it less"
               : "Average G over the time in which the front moves through a few cells, or use smaller cells "
                 "(Domain > Cell Size)"));
  }
}

template class AdvectedFronts<2>;
template class AdvectedFronts<3>;

} // namespace Rhegma::cracks
