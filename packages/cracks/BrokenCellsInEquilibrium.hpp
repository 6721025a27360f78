#pragma once
/// Broken cells in a step of equilibrium.

#include "state/State.hpp"
#include "state/StepForce.hpp"

#include <vector>

namespace Rhegma::cracks
{

/// Reports the nodes next to cracks, where broken cells strain in a rotation
/// (docs/explanation/broken-cells.md): a free body with such a crack can move, but is held to the axes of the
/// cells as if by springs. It has no force of its own.
template <int D>
class BrokenCellsInEquilibrium : public StepForce<D>
{
public:
  using typename StepForce<D>::Values;
  using typename StepForce<D>::Groups;
  using typename StepForce<D>::AddBlock;

  /// Lists the rows of nodes next to cracks. \return no couplings
  Groups begin(const State<D>& state, const View<int*>& rowOf) override
  {
    rows_.clear();
    const View<int*> side = state.cracks.nodeSide;
    for (std::size_t n = 0; n < side.extent(0); ++n)
      if (side(n) != 0 && rowOf(n) >= 0)
        rows_.push_back(rowOf(n));
    return {};
  }
  /// Adds nothing.
  void add(const Values&, const Values&) override {}
  /// Adds nothing. \return true, as a zero matrix is symmetric
  bool addStiffness(bool, const AddBlock&) override { return true; }
  /// Those listed.
  std::vector<int> rowsThatResistRotation() const override { return rows_; }

private:
  std::vector<int> rows_;
};

} // namespace Rhegma::cracks
