#include "adaptivity/VelocityCriterion.hpp"

#include "grid/Branches.hpp"
#include "state/Subdomain.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace Rhegma::adaptivity
{

namespace
{

/// Volume and integral of the gradient, of which some components may not be in use.
template <int D>
struct GradientSum
{
  double volume = 0.0, gradient[D * D] = {};

  void add(const GradientSum& other)
  {
    volume += other.volume;
    for (int k = 0; k < D * D; ++k)
      gradient[k] += other.gradient[k];
  }

  double mean() const
  {
    double square = 0.0;
    for (const double g : gradient)
      square += g * g;
    return volume > 0.0 ? std::sqrt(square) / volume : 0.0;
  }
};

/// Leaf of every particle: its number or, for cells of the lattice, -1 - the lowest node.
template <int D>
View<int*> leavesOf(const State<D>& state)
{
  const int n = state.particles.size();
  View<int*> leaf("rhegma::leafOfParticle", n);
  const TreeSight<D> sight(state.mesh.grid, state.mesh.tree);
  const auto position = state.particles.template real<D>(fields::position);
  Kokkos::parallel_for(
      "rhegma::adaptivity::findLeaves", Kokkos::RangePolicy<ExecSpace>(0, n), KOKKOS_LAMBDA(const int p) {
        Vector<D> x;
        for (int d = 0; d < D; ++d)
          x[d] = position(p, d);
        leaf(p) = sight.leafAt(x).number;
      });
  return leaf;
}

/// Cells of one level with their sums, ordered by their position.
template <int D>
using LevelSums = std::vector<std::pair<std::array<int, D>, GradientSum<D>>>;

template <int D>
void sortByCell(LevelSums<D>& sums)
{
  std::sort(sums.begin(), sums.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
}

/// Sums of cells that come in any order and several times.
template <int D>
class SumsByCell
{
public:
  void add(const std::array<int, D>& cell, const GradientSum<D>& sum)
  {
    std::uint64_t key = 0;
    for (int d = 0; d < D; ++d)
      key = key << Branches<D>::bitsPerAxis | static_cast<std::uint64_t>(cell[d]);
    const auto number = static_cast<std::size_t>(cells_.add(key));
    if (number == sums_.size())
      sums_.push_back({cell, {}});
    sums_[number].second.add(sum);
  }

  LevelSums<D> sorted() const
  {
    LevelSums<D> sums = sums_;
    sortByCell<D>(sums);
    return sums;
  }

private:
  KeyNumbers cells_;
  LevelSums<D> sums_;
};

/// The cells of the lattice that hold particles. \param sums of all, by their lowest node
template <int D>
LevelSums<D> occupiedCells(const Grid<D>& grid, const std::vector<GradientSum<D>>& sums)
{
  LevelSums<D> occupied;
  int all = 1;
  for (int d = 0; d < D; ++d)
    all *= grid.cells[d];
  int at[D] = {};
  for (int i = 0; i < all; ++i)
  {
    const GradientSum<D>& sum = sums[grid.nodeIndex(at)];
    if (sum.volume > 0.0)
    {
      std::array<int, D> cell;
      std::copy(at, at + D, cell.begin());
      occupied.push_back({cell, sum});
    }
    for (int d = D - 1; d >= 0 && ++at[d] == grid.cells[d]; --d) // in the order of LevelSums
      at[d] = 0;
  }
  return occupied;
}

/// Sums of all leaves that hold particles, by level. Added on the host in the order of the particles, so that
/// what is refined does not depend on the number of threads.
template <int D>
std::vector<LevelSums<D>> sumOverLeaves(const State<D>& state, const std::string& gradient)
{
  const auto host = [](const auto& view) { return onHost(view); };
  const auto leafOf = host(leavesOf(state));
  const auto volume = host(state.particles.scalar(fields::volume));
  const auto rate = host(state.particles.table(gradient));
  const int components = static_cast<int>(rate.extent(1));
  std::vector<GradientSum<D>> lattice(state.mesh.grid.numNodes), leaves(state.mesh.tree.leafLevel.extent(0));
  for (int p = 0; p < state.particles.size(); ++p)
  {
    GradientSum<D>& sum = leafOf(p) < 0 ? lattice[-1 - leafOf(p)] : leaves[leafOf(p)];
    sum.volume += volume(p);
    for (int k = 0; k < components; ++k)
      sum.gradient[k] += volume(p) * rate(p, k);
  }
  std::vector<LevelSums<D>> sums(state.mesh.tree.deepest + 1);
  sums[0] = occupiedCells(state.mesh.grid, lattice);
  const auto level = host(state.mesh.tree.leafLevel);
  const auto corner = host(state.mesh.tree.leafCorner);
  for (std::size_t l = 0; l < leaves.size(); ++l)
    if (leaves[l].volume > 0.0)
    {
      std::array<int, D> cell;
      for (int d = 0; d < D; ++d)
        cell[d] =
            static_cast<int>(std::lround(std::ldexp(state.mesh.grid.inCells(corner(l, d), d), level(l))));
      sums[level(l)].push_back({cell, leaves[l]});
    }
  for (int below = 1; below <= state.mesh.tree.deepest; ++below)
    sortByCell<D>(sums[below]);
  return sums;
}

/// The sums of all ranks, on each of them.
template <int D>
std::vector<LevelSums<D>> ofAllRanks(const State<D>& state, const std::vector<LevelSums<D>>& own)
{
  if (!state.mesh.subdomain)
    return own;
  constexpr int width = 1 + D + 1 + D * D; // level, cell, volume, gradient
  std::vector<double> rows;
  for (std::size_t level = 0; level < own.size(); ++level)
    for (const auto& [cell, sum] : own[level])
    {
      rows.push_back(static_cast<double>(level));
      for (int d = 0; d < D; ++d)
        rows.push_back(cell[d] + std::ldexp(state.mesh.grid.before[d], static_cast<int>(level)));
      rows.push_back(sum.volume);
      rows.insert(rows.end(), sum.gradient, sum.gradient + D * D);
    }
  rows = state.ranks.gatherOnAll(rows);
  std::vector<SumsByCell<D>> all(own.size());
  for (auto row = rows.begin(); row != rows.end(); row += width)
  {
    std::array<int, D> cell;
    for (int d = 0; d < D; ++d)
      cell[d] = static_cast<int>(row[1 + d]);
    GradientSum<D> sum;
    sum.volume = row[1 + D];
    std::copy(row + 2 + D, row + width, sum.gradient);
    all[static_cast<int>(row[0])].add(cell, sum);
  }
  std::vector<LevelSums<D>> sums;
  for (const SumsByCell<D>& level : all)
    sums.push_back(level.sorted());
  return sums;
}

} // namespace

template <int D>
std::vector<LevelCell<D>> cellsOfFastChange(const State<D>& state, double threshold, double keeping,
                                            int deepest, const std::string& gradient)
{
  const std::vector<LevelSums<D>> leaves = ofAllRanks<D>(state, sumOverLeaves(state, gradient));
  std::vector<LevelCell<D>> wanted;
  LevelSums<D> refined; // of the level that is checked
  for (int level = state.mesh.tree.deepest; level >= 0; --level)
  {
    const double edge = std::ldexp(state.mesh.grid.spacing, -level);
    SumsByCell<D> parents;
    const auto selectAbove = [&](const LevelSums<D>& cells, double bound)
    {
      for (const auto& cell : cells)
      {
        if (level < deepest && edge * cell.second.mean() > bound)
          wanted.push_back({level, cell.first});
        std::array<int, D> parent;
        for (int d = 0; d < D; ++d)
          parent[d] = cell.first[d] >> 1;
        parents.add(parent, cell.second);
      }
    };
    selectAbove(leaves[level], threshold);
    selectAbove(refined, keeping);
    refined = parents.sorted();
  }
  return wanted;
}

template std::vector<LevelCell<2>> cellsOfFastChange(const State<2>&, double, double, int,
                                                     const std::string&);
template std::vector<LevelCell<3>> cellsOfFastChange(const State<3>&, double, double, int,
                                                     const std::string&);

} // namespace Rhegma::adaptivity
