#pragma once
/// Cells to refine because the velocity or the temperature changes much in them.

#include "grid/Branches.hpp"
#include "state/State.hpp"

#include <array>
#include <string>
#include <vector>

namespace Rhegma::adaptivity
{

/// A cell of any level: coordinates count cells of the level from node 0 of the whole lattice.
template <int D>
struct LevelCell
{
  int level;
  std::array<int, D> at;
};

/// Cells over which a quantity changes too much: their edge times the Frobenius norm of its gradient,
/// averaged over the volume of the particles in the cell. The mean is what the nodes of the cell resolve;
/// gradients that alternate from particle to particle cancel in it. Collective: all ranks get all cells.
///
/// \param threshold of a leaf, in the unit of the quantity
/// \param keeping of a cell that is refined already: the mean is that over all of it
/// \param deepest leaves of this level and deeper are left as they are
/// \param gradient field of the particles that holds it
/// \return leaves above `threshold` and refined cells above `keeping`, by level and position
template <int D>
std::vector<LevelCell<D>> cellsOfFastChange(const State<D>& state, double threshold, double keeping,
                                            int deepest, const std::string& gradient = fields::rate);

} // namespace Rhegma::adaptivity
