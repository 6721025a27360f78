#include "transfer/BlocksInReach.hpp"

#include <array>

namespace Rhegma
{

namespace
{

/// Cells by which particles that need not be sorted may be outside of their block, and more.
constexpr double strayCells = 2.0;

/// Cells by which boxes may move before blocks are listed anew.
constexpr double keptCells = 1.0;

template <int D>
bool isNear(const Grid<D>& grid, const int (&corner)[Blocks<D>::axes], const AxisBox<D>& box)
{
  for (int a = 0; a < Blocks<D>::axes; ++a)
  {
    const int axis = grid.axisOrder[a];
    if (grid.inCells(box.upper[axis], axis) < corner[a] - strayCells ||
        grid.inCells(box.lower[axis], axis) > corner[a] + Blocks<D>::edge + strayCells)
      return false;
  }
  return true;
}

template <int D>
bool isInside(const AxisBox<D>& inner, const AxisBox<D>& outer)
{
  return outer.holds(inner.lower) && outer.holds(inner.upper);
}

/// Adds the particles of a range that count, as ranges.
template <class Group>
void addRange(int begin, int end, int group, const Group& of, std::vector<std::array<int, 2>>& ranges)
{
  if (group == 0)
    return ranges.push_back({begin, end});
  for (int p = begin; p < end; ++p)
  {
    if (of(p) != group)
      continue;
    const int first = p;
    while (p < end && of(p) == group)
      ++p;
    ranges.push_back({first, p});
  }
}

} // namespace

template <int D>
bool BlocksInReach<D>::isKept(const State<D>& state, const std::vector<AxisBox<D>>& boxes) const
{
  return sorted_.data() != nullptr && state.particles.sorted &&
         sorted_.data() == state.mesh.blocks.first.data() && boxes.size() == found_.size() &&
         std::equal(boxes.begin(), boxes.end(), found_.begin(),
                    [since = state.mesh.grid.whole - node0_](AxisBox<D> box, const AxisBox<D>& found)
                    {
                      // Blocks move with the grid.
                      box.lower = box.lower - since;
                      box.upper = box.upper - since;
                      return isInside(box, found);
                    });
}

template <int D>
void BlocksInReach<D>::find(const State<D>& state, const std::vector<AxisBox<D>>& boxes,
                            const ParticlesOfGroup& own)
{
  if (own.group == group_ && isKept(state, boxes))
    return;
  group_ = own.group;
  const auto of = onHost(own.of);
  const Blocks<D>& blocks = state.mesh.blocks;
  std::vector<std::array<int, 2>> ranges;
  std::fill(std::begin(colourStart_), std::end(colourStart_), 0);
  found_.clear();
  node0_ = state.mesh.grid.whole;
  for (const AxisBox<D>& box : boxes)
    found_.push_back(box.widened(keptCells * state.mesh.grid.spacing));
  if (!state.particles.sorted)
  {
    sorted_ = View<int*>();
    addRange(0, state.particles.size(), group_, of, ranges);
    std::fill(std::begin(colourStart_) + 1, std::end(colourStart_), static_cast<int>(ranges.size()));
  }
  else
  {
    sorted_ = blocks.first;
    const auto first = onHost(blocks.first);
    const auto corner = onHost(blocks.corner);
    // Steps of equilibrium move particles by any distance between two sorts.
    const bool all = state.method.equilibrium();
    for (int colour = 0; colour < Blocks<D>::colours; ++colour)
    {
      for (int b = blocks.colourStart[colour]; b < blocks.colourStart[colour + 1]; ++b)
      {
        const int at[] = {corner(b, 0), corner(b, 1)};
        if (all || std::any_of(found_.begin(), found_.end(),
                               [&](const AxisBox<D>& box) { return isNear(state.mesh.grid, at, box); }))
          addRange(first(b), first(b + 1), group_, of, ranges);
      }
      colourStart_[colour + 1] = static_cast<int>(ranges.size());
    }
  }
  if (range_.extent(0) < ranges.size())
  {
    range_ = View<int* [2]>("rhegma::particlesInReach", ranges.size() + ranges.size() / 4);
    parts_ = View<double* [mostSums]>("rhegma::sumsOfBlocks", range_.extent(0));
  }
  const auto host = Kokkos::create_mirror_view(range_);
  for (std::size_t k = 0; k < ranges.size(); ++k)
    for (int i = 0; i < 2; ++i)
      host(k, i) = ranges[k][i];
  Kokkos::deep_copy(range_, host);
}

template class BlocksInReach<2>;
template class BlocksInReach<3>;

} // namespace Rhegma
