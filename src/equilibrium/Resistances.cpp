#include "equilibrium/Resistances.hpp"

#include "equilibrium/RowOwners.hpp"

#include <algorithm>

namespace Rhegma::equilibrium
{

namespace
{

/// Slope, times the edge of the cells, from which on a particle holds a node: its square is the part of a
/// cell's stiffness. Of a box that reaches over a row of nodes by a few percent of its width, slopes are
/// less.
constexpr double leastSlopeOfMaterial = 0.1;

} // namespace

template <int D>
Resistances<D>::Resistances(const State<D>& state, const RowGraph& graph)
    : jumps(findSlopeJumps(state, graph)), forces(state.motion.stepForces)
{
  for (const auto& force : forces)
    groups.push_back(force->begin(state, graph.rowOf));
}

template <int D>
Groups Resistances<D>::coupled(Couplings couplings) const
{
  Groups all;
  for (std::size_t k = 0; k < jumps.size() && couplings != Couplings::OfMaterial; ++k)
    all.push_back(jumps[k].row);
  for (std::size_t k = 0; k < forces.size(); ++k)
    if (couplings != Couplings::WithoutJoins || !forces[k]->joinsPieces())
      all.insert(all.end(), groups[k].begin(), groups[k].end());
  return all;
}

template <int D>
bool Resistances<D>::haveBranches() const
{
  return std::any_of(forces.begin(), forces.end(), [](const auto& force) { return force->hasBranches(); });
}

template <int D>
void connect(const State<D>& state, const Resistances<D>& resistances, Couplings couplings,
             const ClippedBoxes<D>& boxes, const RowOwners& owners, RowGraph& graph)
{
  connectRows(state, resistances.coupled(couplings), boxes, owners, graph,
              couplings == Couplings::OfMaterial ? leastSlopeOfMaterial : 0.0);
}

template <int D>
Stiffness assemble(const State<D>& state, const Resistances<D>& resistances, const Values& displacement,
                   const ClippedBoxes<D>& boxes, const RowOwners& owners, const RowGraph& graph,
                   bool symmetricOnly)
{
  Stiffness made;
  made.blocks = StiffnessBlocks("rhegma::equilibrium::stiffness", D * D * graph.column.extent(0));
  const auto blockOf = [&](int row, int other)
  { return &made.blocks(D * D * static_cast<std::size_t>(graph.find(row, other))); };
  for (const SlopeJump& jump : resistances.jumps)
    for (std::size_t a = 0; a < jump.row.size(); ++a)
      for (std::size_t b = 0; b < jump.row.size(); ++b)
      {
        double* const block = blockOf(jump.row[a], jump.row[b]);
        for (int d = 0; d < D; ++d)
          block[d * D + d] += jump.weight * jump.coefficient[a] * jump.coefficient[b];
      }
  const auto add = [&](int row, int other, const double(&values)[D * D])
  {
    double* const block = blockOf(row, other);
    for (int k = 0; k < D * D; ++k)
      block[k] += values[k];
  };
  for (const auto& force : resistances.forces)
    made.symmetric = force->addStiffness(symmetricOnly, add) && made.symmetric;
  const bool inverted = !addStiffness(state, graph, displacement, boxes, made.blocks);
  owners.sendEntries(graph, made.blocks, D * D);
  made.exists = owners.ranks().max(inverted ? 1.0 : 0.0) == 0.0;
  return made;
}

template struct Resistances<2>;
template struct Resistances<3>;
template void connect(const State<2>&, const Resistances<2>&, Couplings, const ClippedBoxes<2>&,
                      const RowOwners&, RowGraph&);
template void connect(const State<3>&, const Resistances<3>&, Couplings, const ClippedBoxes<3>&,
                      const RowOwners&, RowGraph&);
template Stiffness assemble(const State<2>&, const Resistances<2>&, const Values&, const ClippedBoxes<2>&,
                            const RowOwners&, const RowGraph&, bool);
template Stiffness assemble(const State<3>&, const Resistances<3>&, const Values&, const ClippedBoxes<3>&,
                            const RowOwners&, const RowGraph&, bool);

} // namespace Rhegma::equilibrium
