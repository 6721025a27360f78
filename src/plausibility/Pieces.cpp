#include "plausibility/Pieces.hpp"

#include "plausibility/SupportReach.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace Rhegma
{

namespace
{

/// About a second.
constexpr double mostPairs = 1e7;

} // namespace

template <int D>
std::vector<Grains<D>> grainsOf(const State<D>& state, const std::vector<char>& wanted)
{
  const auto body = onHost(state.particles.integer(fields::body));
  const auto x = onHost(state.particles.template real<D>(fields::position));
  const auto edge = onHost(state.particles.template real<D>(fields::edge));
  const auto mass = onHost(state.particles.scalar(fields::mass));
  std::vector<Grains<D>> grains(wanted.size());
  for (int p = 0; p < state.particles.size(); ++p)
  {
    if (wanted[body(p)] == 0)
      continue;
    Vector<D> at, box;
    for (int d = 0; d < D; ++d)
    {
      at[d] = x(p, d);
      box[d] = edge(p, d);
    }
    Grains<D>& own = grains[body(p)];
    own.position.push_back(at);
    own.box.push_back(box);
    own.mass.push_back(mass(p));
  }
  return grains;
}

template <int D>
Pieces<D>::Pieces(const Grains<D>& grains, const BodyInfo<D>& body, int reach, const CrackWalls<D>* walls)
    : reach_(reach), edge_(body.edge)
{
  place(grains, body, walls);
  if (pairs() > mostPairs)
    return;
  fill(grains, walls);
  for (std::size_t p = 0; p < grains.position.size(); ++p)
  {
    Piece<D>& piece = all_[of(p)];
    piece.mass += grains.mass[p];
    piece.at = grains.position[p];
    piece.bounds.include(grains.position[p]);
  }
}

/// Pairs of particles near cracks in neighbouring cells, as if these had as many as the cell itself.
template <int D>
double Pieces<D>::pairs() const
{
  std::vector<double> count(first_.size(), 0.0);
  for (const Group& group : group_)
    count[group.cell] += group.particle >= 0 ? 1.0 : 0.0;
  double sum = 0.0;
  for (const double one : count)
    sum += one * one;
  return std::pow(2 * reach_ + 1, D) * sum;
}

template <int D>
const Piece<D>& Pieces<D>::smallest() const
{
  return *std::min_element(all_.begin(), all_.end(),
                           [](const auto& a, const auto& b) { return a.mass < b.mass; });
}

template <int D>
std::set<int> Pieces<D>::cutters() const
{
  std::set<int> cracks;
  for (const Wall& wall : walls_)
    if (group_[wall.one].piece != group_[wall.other].piece)
      cracks.insert(wall.crack);
  return cracks;
}

template <int D>
void Pieces<D>::place(const Grains<D>& grains, const BodyInfo<D>& body, const CrackWalls<D>* walls)
{
  const double near = 2.0 * reach_ * *std::max_element(edge_.c, edge_.c + D);
  std::vector<std::array<long long, D>> cells(grains.position.size());
  std::array<long long, D> low, high;
  low.fill(std::numeric_limits<long long>::max());
  high.fill(std::numeric_limits<long long>::min());
  for (std::size_t p = 0; p < cells.size(); ++p)
    for (int d = 0; d < D; ++d)
    {
      double along = 0.0;
      for (int e = 0; e < D; ++e)
        along += body.axes[d][e] * (grains.position[p][e] - grains.position[0][e]);
      cells[p][d] = std::llround(along / edge_[d]);
      low[d] = std::min(low[d], cells[p][d]);
      high[d] = std::max(high[d], cells[p][d]);
    }
  long long count = 1;
  for (int d = 0; d < D; ++d)
  {
    count_[d] = high[d] - low[d] + 1;
    count *= count_[d];
  }
  first_.assign(count, -1);
  groupOf_.reserve(cells.size());
  for (std::size_t p = 0; p < cells.size(); ++p)
  {
    long long cell = 0;
    for (int d = D - 1; d >= 0; --d)
      cell = cell * count_[d] + cells[p][d] - low[d];
    addToCell(cell, walls != nullptr && walls->isNear(grains.position[p], near) ? static_cast<int>(p) : -1);
  }
}

template <int D>
void Pieces<D>::addToCell(long long cell, int particle)
{
  int group = first_[cell];
  while (group >= 0 && group_[group].particle != particle)
    group = group_[group].next;
  if (group < 0)
  {
    group = static_cast<int>(group_.size());
    group_.push_back({particle, -1, first_[cell], cell});
    first_[cell] = group;
  }
  groupOf_.push_back(group);
}

template <int D>
void Pieces<D>::fill(const Grains<D>& grains, const CrackWalls<D>* walls)
{
  const auto crackBetween = [&](const Group& one, const Group& other)
  {
    return one.particle < 0 || other.particle < 0
               ? -1
               : walls->between(grains.position[one.particle], grains.position[other.particle]);
  };
  for (std::size_t g = 0; g < group_.size(); ++g)
  {
    if (group_[g].piece >= 0)
      continue;
    const int piece = static_cast<int>(all_.size());
    all_.emplace_back();
    group_[g].piece = piece;
    std::vector<int> pending{static_cast<int>(g)};
    while (!pending.empty())
    {
      const int from = pending.back();
      pending.pop_back();
      forEachNear(group_[from].cell,
                  [&](long long cell)
                  {
                    for (int to = first_[cell]; to >= 0; to = group_[to].next)
                    {
                      if (group_[to].piece == piece)
                        continue;
                      if (const int crack = crackBetween(group_[from], group_[to]); crack >= 0)
                        walls_.push_back({from, to, crack});
                      else if (group_[to].piece < 0)
                      {
                        group_[to].piece = piece;
                        pending.push_back(to);
                      }
                    }
                  });
    }
  }
}

template <int D>
template <class Visit>
void Pieces<D>::forEachNear(long long cell, const Visit& visit) const
{
  const int width = 2 * reach_ + 1;
  int cells = 1;
  for (int d = 0; d < D; ++d)
    cells *= width;
  for (int k = 0; k < cells; ++k)
  {
    long long at = 0, stride = 1, rest = cell;
    bool inside = true;
    for (int d = 0, offset = k; d < D; ++d, offset /= width)
    {
      const long long along = rest % count_[d] + offset % width - reach_;
      inside = inside && along >= 0 && along < count_[d];
      at += along * stride;
      stride *= count_[d];
      rest /= count_[d];
    }
    if (inside)
      visit(at);
  }
}

std::vector<BoundaryRegion> supportRegions(const Teuchos::ParameterList& scene)
{
  std::vector<BoundaryRegion> supports = boundaryRegions(scene);
  supports.erase(std::remove_if(supports.begin(), supports.end(),
                                [](const BoundaryRegion& region) {
                                  return region.kind == BoundaryRegion::Kind::Force ||
                                         region.kind == BoundaryRegion::Kind::Unknown;
                                }),
                 supports.end());
  return supports;
}

template <int D>
bool anyUnsupported(const std::vector<BoundaryRegion>& supports, const std::vector<Piece<D>>& pieces,
                    double cell)
{
  return std::any_of(pieces.begin(), pieces.end(),
                     [&](const Piece<D>& piece)
                     {
                       return std::none_of(supports.begin(), supports.end(),
                                           [&](const BoundaryRegion& support)
                                           { return reaches(support, piece.bounds, cell); });
                     });
}

template class Pieces<2>;
template class Pieces<3>;
template std::vector<Grains<2>> grainsOf(const State<2>&, const std::vector<char>&);
template std::vector<Grains<3>> grainsOf(const State<3>&, const std::vector<char>&);
template bool anyUnsupported(const std::vector<BoundaryRegion>&, const std::vector<Piece<2>>&, double);
template bool anyUnsupported(const std::vector<BoundaryRegion>&, const std::vector<Piece<3>>&, double);

} // namespace Rhegma
