#include "adaptivity/VelocityCriterion.hpp"

#include "grid/Branches.hpp"
#include "state/Subdomain.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

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

/// Position of a leaf, or of a cell of the lattice, by its number as in TreeSight, in cells of its level.
template <int D>
class LeafCells
{
public:
  explicit LeafCells(const State<D>& state)
      : grid_(state.mesh.grid),
        level_(onHost(state.mesh.tree.leafLevel)),
        corner_(onHost(state.mesh.tree.leafCorner))
  {
  }

  int levelOf(int leaf) const { return leaf < 0 ? 0 : level_(leaf); }

  std::array<int, D> cellOf(int leaf) const
  {
    std::array<int, D> cell;
    int at[D];
    if (leaf < 0)
      grid_.nodeCoordinates(-1 - leaf, at);
    for (int d = 0; d < D; ++d)
      cell[d] =
          leaf < 0
              ? at[d]
              : static_cast<int>(std::lround(std::ldexp(grid_.inCells(corner_(leaf, d), d), level_(leaf))));
    return cell;
  }

  int numLeaves() const { return static_cast<int>(level_.extent(0)); }

private:
  Grid<D> grid_;
  decltype(onHost(std::declval<View<int*>>())) level_;
  decltype(onHost(std::declval<View<double* [D]>>())) corner_;
};

/// Sums of all leaves that hold particles, by level. Added on the host in the order of the particles, so that
/// what is refined does not depend on the number of threads.
template <int D>
std::vector<LevelSums<D>> sumOverLeaves(const State<D>& state, const std::string& gradient)
{
  const auto host = [](const auto& view) { return onHost(view); };
  const auto leafOf = host(leavesOf(state));
  const auto volume = host(state.particles.scalar(fields::volume));
  const auto rate = host(state.particles.table(gradient));
  const int components = static_cast<int>(rate.extent(1)), lattice = state.mesh.grid.numNodes;
  const LeafCells<D> cells(state);
  std::vector<int> number(lattice + cells.numLeaves(), -1), leaves; // leaves in the order of their particles
  std::vector<GradientSum<D>> sumOf;
  for (int p = 0; p < state.particles.size(); ++p)
  {
    int& known = number[lattice + leafOf(p)]; // -1 - lowest node, or the number of the leaf
    if (known < 0)
    {
      known = static_cast<int>(leaves.size());
      leaves.push_back(leafOf(p));
      sumOf.emplace_back();
    }
    GradientSum<D>& sum = sumOf[known];
    sum.volume += volume(p);
    for (int k = 0; k < components; ++k)
      sum.gradient[k] += volume(p) * rate(p, k);
  }
  std::vector<LevelSums<D>> sums(state.mesh.tree.deepest + 1);
  for (std::size_t l = 0; l < leaves.size(); ++l)
    if (sumOf[l].volume > 0.0)
      sums[cells.levelOf(leaves[l])].push_back({cells.cellOf(leaves[l]), sumOf[l]});
  for (LevelSums<D>& level : sums)
    sortByCell<D>(level);
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
        if (level > 0)
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
