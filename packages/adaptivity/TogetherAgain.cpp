#include "adaptivity/TogetherAgain.hpp"

#include "state/Ancestry.hpp"
#include "state/Migration.hpp"
#include "state/Subdomain.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <vector>

namespace Rhegma::adaptivity
{

namespace
{

constexpr double none = -1.0;

/// What ranks exchange about the parts of a particle: how many there are, which rank has the first, and the
/// cells of the lattice in which they lie.
template <int D>
struct Parts
{
  double count = 0.0, first = none;
  double low[D], high[D];

  static constexpr int width = 2 + 2 * D;

  Parts()
  {
    std::fill(low, low + D, 1e300);
    std::fill(high, high + D, -1e300);
  }

  void add(const Parts& other)
  {
    count += other.count;
    first = std::max(first, other.first);
    for (int d = 0; d < D; ++d)
    {
      low[d] = std::min(low[d], other.low[d]);
      high[d] = std::max(high[d], other.high[d]);
    }
  }

  void append(std::vector<double>& row) const
  {
    row.insert(row.end(), {count, first});
    row.insert(row.end(), low, low + D);
    row.insert(row.end(), high, high + D);
  }

  explicit Parts(const double* row) : count(row[0]), first(row[1])
  {
    std::copy(row + 2, row + 2 + D, low);
    std::copy(row + 2 + D, row + width, high);
  }

  /// Whether all parts exist and lie in cells that the rank of the first part knows.
  bool mayMeet(const Division<D>& division) const
  {
    bool may = count == (1 << D) && first >= 0.0;
    // The particle's box reaches half a cell further.
    constexpr int known = gridMargin - 2;
    for (int d = 0; d < D && may; ++d)
    {
      const CellBox<D>& box = division.boxes[static_cast<int>(first)];
      may = low[d] >= box.low[d] - known && high[d] < box.high[d] + known;
    }
    return may;
  }
};

using Parent = std::array<int, 3>; ///< ancestor, level of the parts, lineage of what they were

} // namespace

template <int D>
void bringTogether(State<D>& state, const View<int*>& small)
{
  if (!state.mesh.subdomain)
    return;
  const auto host = [](const auto& view) { return onHost(view); };
  const auto list = host(small);
  const auto fromAncestor = host(state.particles.integer(fields::ancestor)),
             fromLineage = host(state.particles.integer(fields::lineage)),
             fromLevel = host(state.particles.integer(fields::level));
  const auto position = host(state.particles.template real<D>(fields::position));
  const Division<D>& division = state.mesh.subdomain->division;
  std::map<Parent, std::vector<int>> own;
  for (std::size_t i = 0; i < list.extent(0); ++i)
    own[{fromAncestor(list(i)), fromLevel(list(i)), fromLineage(list(i)) >> D}].push_back(list(i));
  std::vector<double> reported;
  for (const auto& [parent, rows] : own)
  {
    if (rows.size() == 1 << D)
      continue;
    Parts<D> parts;
    for (const int p : rows)
    {
      Parts<D> one;
      one.count = 1.0;
      one.first = (fromLineage(p) & ((1 << D) - 1)) == 0 ? state.ranks.rank() : none;
      Vector<D> x;
      for (int d = 0; d < D; ++d)
        x[d] = position(p, d);
      int cell[D];
      division.cellAt(x, cell);
      for (int d = 0; d < D; ++d)
        one.low[d] = one.high[d] = cell[d];
      parts.add(one);
    }
    reported.insert(reported.end(), parent.begin(), parent.end());
    parts.append(reported);
  }
  reported = state.ranks.gatherOnAll(reported);
  std::map<Parent, Parts<D>> all;
  for (std::size_t k = 0; k < reported.size(); k += 3 + Parts<D>::width)
    all[{static_cast<int>(reported[k]), static_cast<int>(reported[k + 1]), static_cast<int>(reported[k + 2])}]
        .add(Parts<D>(&reported[k + 3]));
  if (std::none_of(all.begin(), all.end(), [&](const auto& one) { return one.second.mayMeet(division); }))
    return;
  std::vector<int> owner(state.particles.size(), state.ranks.rank());
  for (const auto& [parent, rows] : own)
    if (const auto found = all.find(parent); found != all.end() && found->second.mayMeet(division))
      for (const int p : rows)
        owner[p] = static_cast<int>(found->second.first);
  sendParticles(state, owner);
  state.particles.sorted = false;
}

template void bringTogether(State<2>&, const View<int*>&);
template void bringTogether(State<3>&, const View<int*>&);

} // namespace Rhegma::adaptivity
