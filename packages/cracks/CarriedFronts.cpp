#include "cracks/CarriedFronts.hpp"

#include "base/FewItems.hpp"
#include "base/Numbers.hpp"
#include "cracks/CrackGeometry.hpp"
#include "transfer/LocalSpacing.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

namespace Rhegma::cracks
{

namespace
{

/// Cells over which a front may be carried with its ties.
constexpr double farForTies = 0.5;

template <int D>
void loosen(const State<D>& state, int crack)
{
  const View<int*> near = state.cracks.nearFront, crackOf = state.cracks.crackOf;
  forFew(
      "rhegma::cracks::loosen", static_cast<int>(near.extent(0)), KOKKOS_LAMBDA(const int s) {
        if (crackOf(s) == crack && near(s) == nearFront::tied)
          near(s) = nearFront::loose;
      });
}

} // namespace

template <int D>
void CarriedFronts<D>::start(const State<D>& state)
{
  start_.clear();
  for (const CrackFront<D>& front : state.cracks.fronts)
    start_.push_back(front.position);
  loose_.assign(state.cracks.cracks.size(), false);
}

template <int D>
double CarriedFronts<D>::carried(const State<D>& state, std::size_t front) const
{
  const CrackFront<D>& now = state.cracks.fronts[front];
  if (now.grown || now.ended || front >= start_.size())
    return 0.0;
  const double way = norm(now.position - start_[front]);
  return way > farForTies * state.mesh.smallestSpacing() ? way / spacingAt(state, now.position) : 0.0;
}

template <int D>
void CarriedFronts<D>::findMarks(const State<D>& state)
{
  const auto near = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, state.cracks.nearFront);
  const auto crackOf = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, state.cracks.crackOf);
  for (std::size_t s = 0; s < near.extent(0); ++s)
    if (near(s) == nearFront::loose)
      loose_[crackOf(s)] = true;
}

template <int D>
void CarriedFronts<D>::update(State<D>& state)
{
  if (marked_ == nullptr)
    findMarks(state); // those of a checkpoint
  bool changed = marked_ != state.cracks.nearFront.data();
  for (std::size_t f = 0; f < state.cracks.fronts.size(); ++f)
  {
    const int crack = state.cracks.fronts[f].crack;
    if (loose_[crack] || carried(state, f) <= farForTies)
      continue;
    loose_[crack] = true;
    changed = true;
  }
  if (!changed)
    return;
  for (std::size_t c = 0; c < loose_.size(); ++c)
    if (loose_[c])
      loosen(state, static_cast<int>(c));
  marked_ = state.cracks.nearFront.data();
}

template <int D>
void CarriedFronts<D>::report(const State<D>& state, nlohmann::json& summary) const
{
  for (std::size_t f = 0; f < state.cracks.fronts.size(); ++f)
  {
    const CrackFront<D>& front = state.cracks.fronts[f];
    const double cells = carried(state, f);
    if (cells > farForTies)
      summary["warnings"].push_back(
          "Cracks > " + state.cracks.cracks[front.crack].name + ": its body carried the front " +
          std::to_string(front.number) + " through " + formatReal(std::round(10.0 * cells) / 10.0) +
          " cells; after half a cell it went on without ties, so that its G is that of a crack up to half a "
          "cell longer or shorter; a mean over the time of a few cells' way is better, or smaller cells");
  }
}

template class CarriedFronts<2>;
template class CarriedFronts<3>;

} // namespace Rhegma::cracks
