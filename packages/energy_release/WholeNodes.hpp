#pragma once
/// Numbers that nodes have on all ranks.

#include "state/State.hpp"

#include <array>
#include <vector>

namespace Rhegma::energy_release
{

/// Numbers nodes of a rank as in the whole lattice, and those of refined cells, in the order of their
/// positions, by the next ones. Where there is one rank these are its own numbers.
class WholeNodes
{
public:
  explicit WholeNodes(const State<2>& state);

  /// \param node of this rank, no enriched field
  int operator()(int node) const;

  /// Where a node with a number in the whole lattice is.
  Vector<2> positionOf(int number) const;

private:
  Grid<2> here_, whole_;
  std::vector<Vector<2>> finePosition_; ///< of the whole lattice
  std::vector<int> fine_;               ///< number of each node of refined cells here
};

} // namespace Rhegma::energy_release
