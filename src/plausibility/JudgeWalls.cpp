#include "plausibility/JudgeWalls.hpp"

#include "base/Numbers.hpp"
#include "base/PointText.hpp"
#include "base/ShortNumber.hpp"
#include "geometry/SurfacePoints.hpp"
#include "transfer/LocalSpacing.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace Rhegma
{

namespace
{

using namespace Geometry;

constexpr double fewest = 2.0;  ///< cells of a wall or a gap
constexpr double longest = 4.0; ///< cells over which it may have less
constexpr double rounding = 1e-6;
constexpr double most = 2e4; ///< points of a part, about

/// Points where a wall or a gap is thin that lie in one block of two cells.
template <int D>
struct Thin
{
  Bounds<D> bounds = emptyBounds<D>();
  Vector<D> at{};
  double width = std::numeric_limits<double>::infinity(), cell = 1.0;
  bool counted = false; ///< in a wall

  void include(const Thin& other)
  {
    bounds.include(other.bounds);
    if (other.width / other.cell >= width / cell)
      return;
    at = other.at;
    width = other.width;
    cell = other.cell;
  }
};

template <int D>
using Block = std::array<long long, D>;
template <int D>
using Blocks = std::map<Block<D>, Thin<D>>;

/// All blocks that are connected to one, over corners too.
template <int D>
Thin<D> gather(Blocks<D>& blocks, const Block<D>& first)
{
  Thin<D> all = blocks.at(first);
  std::vector<Block<D>> pending{first};
  blocks.at(first).counted = true;
  while (!pending.empty())
  {
    const Block<D> from = pending.back();
    pending.pop_back();
    int cells = 1;
    for (int d = 0; d < D; ++d)
      cells *= 3;
    for (int k = 0; k < cells; ++k)
    {
      Block<D> at = from;
      for (int d = 0, rest = k; d < D; ++d, rest /= 3)
        at[d] += rest % 3 - 1;
      const auto found = blocks.find(at);
      if (found == blocks.end() || found->second.counted)
        continue;
      found->second.counted = true;
      all.include(found->second);
      pending.push_back(at);
    }
  }
  return all;
}

template <int D>
class Walls
{
public:
  Walls(const State<D>& state, const MirroredSides& mirrored, const Shape<D>& shape)
      : state_(state),
        mirrored_(mirrored),
        shape_(shape),
        bounds_(shape.bounds()),
        cell_(state.mesh.grid.spacing)
  {
  }

  void add(std::size_t part)
  {
    for (const SurfacePoint<D>& point : surfacePoints(shape_, part, spacingOf(part)))
      if (mirrors(point.x) == 0)
        for (const bool wall : {true, false})
          addWidth(point, wall);
  }

  void report(const std::string& name, Messages& messages)
  {
    for (const bool wall : {true, false})
    {
      Thin<D> worst;
      double over = 0.0;
      Blocks<D>& blocks = wall ? walls_ : gaps_;
      for (const auto& [block, thin] : blocks)
      {
        if (thin.counted)
          continue;
        const Thin<D> found = gather<D>(blocks, block);
        const double extent = norm(found.bounds.upper - found.bounds.lower);
        if (extent < longest * found.cell || isEdge(found) ||
            found.width / found.cell >= worst.width / worst.cell)
          continue;
        worst = found;
        over = extent;
      }
      if (over > 0.0)
        messages.push_back("Bodies > " + name + (wall ? ": a wall" : ": a gap") +
                           " of it is less than two cells wide over " + readableLength(over) + ", such as " +
                           readableLength(worst.width) + " at " + formatPoint(worst.at) + ", " +
                           formatShort(worst.width / worst.cell) + " cells of " + readableLength(worst.cell) +
                           "; two cells are the least that the grid " +
                           (wall ? "bends and strains" : "keeps open") +
                           ": use smaller cells (Domain > Cell Size), or check its size (metres)");
    }
  }

private:
  /// Whether it is the edge of a body in 3D at which a curved side ends at another: thin next to it, but wide
  /// less than two cells from it, if the edge has 45 degrees or more.
  bool isEdge(const Thin<D>& thin) const
  {
    Vector<D> extent = thin.bounds.upper - thin.bounds.lower;
    std::sort(extent.c, extent.c + D);
    return D == 3 && extent[1] < fewest * thin.cell;
  }

  /// About a cell, larger on a part that would have too many points.
  double spacingOf(std::size_t part) const
  {
    const Vector<D> extent = shape_.parts()[part].bounds().upper - shape_.parts()[part].bounds().lower;
    double sum = 0.0, square = 0.0;
    for (int d = 0; d < D; ++d)
    {
      sum += extent[d];
      square += extent[d] * extent[d];
    }
    const double surface = D == 2 ? 2.0 * sum : sum * sum - square;
    return std::max(cell_, std::pow(surface / most, 1.0 / (D - 1)));
  }

  /// On how many mirrored sides of the body a point lies.
  int mirrors(const Vector<D>& x) const
  {
    const double slack = 1e-3 * cell_;
    int count = 0;
    for (int d = 0; d < D; ++d)
      for (const bool upper : {false, true})
        count += std::abs(x[d] - (upper ? bounds_.upper[d] : bounds_.lower[d])) < slack &&
                         mirrored_.has(bounds_, d, upper, slack)
                     ? 1
                     : 0;
    return count;
  }

  /// Width of the wall behind a point or of the gap in front of it, as far as it is below two of the largest
  /// cells; twice that up to a mirror.
  double widthAt(const SurfacePoint<D>& point, bool wall) const
  {
    constexpr int samples = 8;
    const Vector<D> along = wall ? -1.0 * point.normal : point.normal;
    const double reach = fewest * cell_;
    double before = 1e-6 * cell_;
    for (int k = 1; k <= samples; ++k)
    {
      double beyond = reach * k / samples;
      if (shape_.contains(point.x + beyond * along) == wall)
      {
        before = beyond;
        continue;
      }
      for (int halving = 0; halving < 30; ++halving)
      {
        const double middle = 0.5 * (before + beyond);
        (shape_.contains(point.x + middle * along) == wall ? before : beyond) = middle;
      }
      return (wall && mirrors(point.x + beyond * along) > 0 ? 2.0 : 1.0) * beyond;
    }
    return std::numeric_limits<double>::infinity();
  }

  /// What is at two cells from a point along the surface.
  enum class Neighbour
  {
    Nothing,
    Thin,
    Wide
  };

  /// \param tangent unit vector
  Neighbour neighbourOf(const SurfacePoint<D>& point, const Vector<D>& tangent) const
  {
    constexpr int samples = 8; // of a cell: a round body falls away from the tangent by less
    const double reach = fewest * cell_;
    for (int k = 0; k < samples; ++k)
    {
      const double depth = cell_ * std::max(1e-3, static_cast<double>(k) / samples);
      const SurfacePoint<D> next{point.x + reach * tangent - depth * point.normal, point.normal, 0.0};
      if (shape_.contains(next.x))
        return widthAt(next, true) < reach ? Neighbour::Thin : Neighbour::Wide;
    }
    return Neighbour::Nothing;
  }

  /// Whether the body ends to one side of a point and is wide to the other: next to an edge of 45 degrees or
  /// more it is thin, and that is no wall.
  bool isNextToEdge(const SurfacePoint<D>& point) const
  {
    int steepest = 0;
    for (int d = 1; d < D; ++d)
      steepest = std::fabs(point.normal[d]) > std::fabs(point.normal[steepest]) ? d : steepest;
    for (int d = 0; d < D; ++d)
    {
      if (d == steepest)
        continue;
      Vector<D> tangent = -point.normal[d] * point.normal;
      tangent[d] += 1.0;
      tangent = (1.0 / norm(tangent)) * tangent;
      const Neighbour one = neighbourOf(point, tangent), other = neighbourOf(point, -1.0 * tangent);
      if ((one == Neighbour::Nothing && other == Neighbour::Wide) ||
          (one == Neighbour::Wide && other == Neighbour::Nothing))
        return true;
    }
    return false;
  }

  void addWidth(const SurfacePoint<D>& point, bool wall)
  {
    const double width = widthAt(point, wall);
    if (!(width < fewest * cell_ * (1.0 - rounding)) || (wall && isNextToEdge(point)))
      return;
    Thin<D> thin;
    thin.cell = spacingAt(state_, point.x);
    if (!(width < fewest * thin.cell * (1.0 - rounding)))
      return;
    thin.at = point.x;
    thin.width = width;
    thin.bounds.include(point.x);
    Block<D> block;
    for (int d = 0; d < D; ++d)
      block[d] = static_cast<long long>(std::floor((point.x[d] - bounds_.lower[d]) / (2.0 * cell_)));
    (wall ? walls_ : gaps_)[block].include(thin);
  }

  const State<D>& state_;
  const MirroredSides& mirrored_;
  const Shape<D>& shape_;
  Bounds<D> bounds_;
  double cell_; ///< the largest [m]
  Blocks<D> walls_, gaps_;
};

} // namespace

template <int D>
void judgeWalls(const State<D>& state, const MirroredSides& mirrored, const Shape<D>& shape,
                const std::vector<char>& judged, const std::string& name, Messages& messages)
{
  const auto mayHaveWalls = [](const Part<D>& part)
  {
    return std::holds_alternative<Polygon<D>>(part.primitive) ||
           std::holds_alternative<FileShape<D>>(part.primitive);
  };
  if (shape.parts().size() == 1 && !mayHaveWalls(shape.base()))
    return;
  Walls<D> walls(state, mirrored, shape);
  for (std::size_t k = 0; k < shape.parts().size(); ++k)
    if (judged[k] == 0)
      walls.add(k);
  walls.report(name, messages);
}

template void judgeWalls(const State<2>&, const MirroredSides&, const Shape<2>&, const std::vector<char>&,
                         const std::string&, Messages&);
template void judgeWalls(const State<3>&, const MirroredSides&, const Shape<3>&, const std::vector<char>&,
                         const std::string&, Messages&);

} // namespace Rhegma
