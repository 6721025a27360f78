#include "state/Subdomain.hpp"
#include "thermal/Conduction.hpp"
#include "transfer/Stencils.hpp"

#include <algorithm>

namespace Rhegma::thermal
{

namespace
{

/// A position on a front and the fraction of the front's heat that it gets.
template <int D>
struct HeatedPosition
{
  Vector<D> at;
  double fraction;
};

/// The nodes of a front, weighted by their rate of new area: tributary length times speed; where none of them
/// runs, as just after arrest, by length alone. Of a front that has ended, its last position.
template <int D>
std::vector<HeatedPosition<D>> heatedPositions(const CrackFront<D>& front)
{
  if (front.nodes.size() < 2)
    return {{front.position, 1.0}};
  double length = 0.0, swept = 0.0;
  for (const FrontNode<D>& frontNode : front.nodes)
  {
    length += frontNode.tributaryLength;
    swept += frontNode.tributaryLength * frontNode.speed;
  }
  std::vector<HeatedPosition<D>> positions;
  for (const FrontNode<D>& frontNode : front.nodes)
  {
    const double fraction = swept > 0.0 ? frontNode.tributaryLength * frontNode.speed / swept
                                        : frontNode.tributaryLength / length;
    if (fraction > 0.0)
      positions.push_back({frontNode.position, fraction});
  }
  return positions;
}

} // namespace

/// Adds the heat of the fracture energy since the last call [J], distributed among the fronts by the required
/// energy of their new faces that has not become heat yet.
template <int D>
double Conduction<D>::heatOfFronts(State<D>& state, double dt)
{
  const std::vector<CrackFront<D>>& all = state.cracks.fronts;
  // Records since the last sample belong to each rank.
  const double before = state.ranks.many() ? state.sample.energy.fracture : 0.0;
  const double spent = before + state.ranks.sum(state.energy.fracture - before);
  const double since = spent - fractureSeen;
  frontHeat.resize(all.size(), 0.0);
  double required = 0.0;
  for (std::size_t f = 0; f < all.size(); ++f)
    required += std::max(0.0, all[f].budget.required - frontHeat[f]);
  // Faces that close return energy, which the next ones that open require again.
  if (!(since > 0.0) || !(required > 0.0))
    return 0.0;
  const double radius = std::max(frontRadius, smallestRadius(state));
  double added = 0.0;
  for (std::size_t f = 0; f < all.size(); ++f)
  {
    const double ofFront = since * std::max(0.0, all[f].budget.required - frontHeat[f]) / required;
    if (!(ofFront > 0.0))
      continue;
    for (const HeatedPosition<D>& heated : heatedPositions(all[f]))
    {
      const double energy = heated.fraction * ofFront;
      const double given = dt * addBall<D>(state, heated.at, radius, frontFraction * energy / dt, supply);
      added += given;
      if (given > 0.0)
      {
        finestHeated = std::min(finestHeated, state.mesh.smallestSpacing());
        frontHeat[f] += energy;
        fractureSeen += energy;
      }
    }
  }
  return added;
}

/// Sets for fronts and their front nodes the temperature of the nodes around them.
template <int D>
void Conduction<D>::reportFronts(State<D>& state)
{
  std::vector<Vector<D>> at;
  std::vector<double*> temperature;
  frontTemperature.resize(state.cracks.fronts.size(), 0.0);
  for (const CrackFront<D>& front : state.cracks.fronts)
  {
    at.push_back(front.position);
    temperature.push_back(&frontTemperature[at.size() - 1]);
  }
  for (CrackFront<D>& front : state.cracks.fronts)
    for (FrontNode<D>& frontNode : front.nodes)
    {
      at.push_back(frontNode.position);
      temperature.push_back(&frontNode.temperature);
    }
  const int count = static_cast<int>(at.size());
  if (count == 0)
    return;
  if (static_cast<int>(fronts.side.extent(0)) < count)
  {
    fronts.position = View<double* [D]>("rhegma::thermal::fronts", count);
    fronts.half = View<double* [D]>("rhegma::thermal::frontHalf", count);
    fronts.side = View<int*>("rhegma::thermal::frontSide", count);
  }
  fronts.count = count;
  fronts.onAllRanks = true;
  const auto positions = Kokkos::create_mirror_view(fronts.position);
  for (int f = 0; f < count; ++f)
    for (int d = 0; d < D; ++d)
      positions(f, d) = at[f][d];
  Kokkos::deep_copy(fronts.position, positions);
  pointStencils(state, fronts, frontStencils, true);
  const auto number = onHost(frontStencils.count);
  const auto node = onHost(frontStencils.node);
  const auto weight = onHost(frontStencils.weight);
  const auto value = onHost(nodes.value);
  const auto held = onHost(nodes.held);
  std::vector<double> found(2 * count, 0.0); // temperature of each, and whether it has nodes
  for (int f = 0; f < count; ++f)
  {
    for (int k = 0; k < number(f); ++k)
      found[2 * f] +=
          weight(f, k) * (value(node(f, k), 0) + (held(node(f, k)) == 0 ? value(node(f, k), 1) : 0.0));
    found[2 * f + 1] = number(f) > 0 ? 1.0 : 0.0;
  }
  sumParts(state, found.data(), 2 * count);
  for (int f = 0; f < count; ++f)
    if (found[2 * f + 1] > 0.0)
      *temperature[f] = found[2 * f];
}

template double Conduction<2>::heatOfFronts(State<2>&, double);
template double Conduction<3>::heatOfFronts(State<3>&, double);
template void Conduction<2>::reportFronts(State<2>&);
template void Conduction<3>::reportFronts(State<3>&);

} // namespace Rhegma::thermal
