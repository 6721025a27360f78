#include "geometry/VoxelPhase.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace Rhegma::Geometry
{

namespace
{

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Calls visit(offset) for all offsets of up to `reach` along each axis, the last axis fastest.
template <int D, class Visit>
void forEachOffset(int reach, const Visit& visit)
{
  std::array<std::int64_t, D> offset;
  offset.fill(-reach);
  for (;;)
  {
    visit(offset);
    int d = D - 1;
    while (d >= 0 && offset[d] == reach)
      offset[d--] = -reach;
    if (d < 0)
      return;
    ++offset[d];
  }
}

/// The number of a voxel on to the next one, the last axis fastest; false after the last one.
template <int D>
bool next(std::array<std::int64_t, D>& voxel, const std::array<std::int64_t, D>& first,
          const std::array<std::int64_t, D>& last)
{
  for (int d = D - 1; d >= 0; --d)
  {
    if (voxel[d] < last[d])
    {
      ++voxel[d];
      return true;
    }
    voxel[d] = first[d];
  }
  return false;
}

} // namespace

template <int D>
VoxelPhase<D>::VoxelPhase(const Index& count, std::vector<std::int16_t> inside)
    : count_(count), shell_(std::move(inside)), bounds_(emptyBounds<D>())
{
  measure();
}

template <int D>
bool VoxelPhase<D>::isInImage(const Index& voxel) const
{
  bool in = true;
  for (int d = 0; d < D; ++d)
    in = in && voxel[d] >= 0 && voxel[d] < count_[d];
  return in;
}

template <int D>
std::size_t VoxelPhase<D>::at(const Index& voxel) const
{
  std::int64_t number = voxel[0];
  for (int d = 1; d < D; ++d)
    number = number * count_[d] + voxel[d];
  return static_cast<std::size_t>(number);
}

/// Bounds, and distances in voxels by two passes over the image, one from each end: exact where diagonal
/// steps count as steps along an axis (A. Rosenfeld, J. L. Pfaltz: Pattern Recognit. 1 (1968) 33-61).
template <int D>
void VoxelPhase<D>::measure()
{
  constexpr int most = std::numeric_limits<std::int16_t>::max();
  std::vector<Index> before; // offsets of voxels that are passed first
  forEachOffset<D>(1,
                   [&](const Index& offset)
                   {
                     const auto first =
                         std::find_if(offset.begin(), offset.end(), [](std::int64_t o) { return o != 0; });
                     if (first != offset.end() && *first < 0)
                       before.push_back(offset);
                   });
  for (std::int16_t& shell : shell_)
    shell = static_cast<std::int16_t>(shell > 0 ? most : -most);
  Index first{}, last;
  for (int d = 0; d < D; ++d)
    last[d] = count_[d] - 1;
  const auto update = [&](const Index& voxel, int side)
  {
    std::int16_t& shell = shell_[at(voxel)];
    const bool inside = shell > 0;
    int least = std::abs(int(shell));
    for (const Index& offset : before)
    {
      Index other;
      for (int d = 0; d < D; ++d)
        other[d] = voxel[d] + side * offset[d];
      const int value = isInImage(other) ? int(shell_[at(other)]) : inside ? -1 : -most;
      least = std::min(least, (value > 0) == inside ? std::abs(value) + 1 : 1);
    }
    shell = static_cast<std::int16_t>(inside ? least : -least);
  };
  Index voxel = first;
  do
  {
    update(voxel, 1);
    if (shell_[at(voxel)] < 0)
      continue;
    Vector<D> low, high;
    for (int d = 0; d < D; ++d)
    {
      low[d] = static_cast<double>(voxel[d]);
      high[d] = low[d] + 1.0;
    }
    bounds_.include(low);
    bounds_.include(high);
  } while (next<D>(voxel, first, last));
  voxel = first;
  do
  {
    Index mirrored;
    for (int d = 0; d < D; ++d)
      mirrored[d] = last[d] - voxel[d];
    update(mirrored, -1);
  } while (next<D>(voxel, first, last));
}

template <int D>
bool VoxelPhase<D>::contains(const Vector<D>& x, double tolerance) const
{
  Index first, last;
  for (int d = 0; d < D; ++d)
  {
    if (!(x[d] >= bounds_.lower[d] - tolerance && x[d] <= bounds_.upper[d] + tolerance))
      return false;
    first[d] = static_cast<std::int64_t>(std::floor(x[d] - tolerance));
    last[d] = static_cast<std::int64_t>(std::floor(x[d] + tolerance));
  }
  Index voxel = first;
  do
    if (has(voxel))
      return true;
  while (next<D>(voxel, first, last));
  return false;
}

template <int D>
double VoxelPhase<D>::nearest(const Vector<D>& x, const Index& voxel, int shell, bool inside) const
{
  double least = infinity;
  forEachOffset<D>(shell,
                   [&](const Index& offset)
                   {
                     double distance = 0.0;
                     bool isInShell = false;
                     Index other;
                     for (int d = 0; d < D; ++d)
                     {
                       other[d] = voxel[d] + offset[d];
                       const double low = static_cast<double>(other[d]);
                       distance = std::max({distance, low - x[d], x[d] - (low + 1.0)});
                       isInShell = isInShell || std::abs(offset[d]) == shell;
                     }
                     if (isInShell && distance < least && has(other) == inside)
                       least = distance;
                   });
  return least;
}

template <int D>
double VoxelPhase<D>::depth(const Vector<D>& x) const
{
  double outside = 0.0; // distance from the image
  Index voxel;
  for (int d = 0; d < D; ++d)
  {
    const double most = static_cast<double>(count_[d]);
    outside = std::max({outside, -x[d], x[d] - most});
    voxel[d] = static_cast<std::int64_t>(std::floor(std::clamp(x[d], -exact - 2.0, most + exact + 2.0)));
  }
  if (isInImage(voxel))
  {
    const int shell = shell_[at(voxel)], away = std::abs(shell);
    const double distance = away > exact ? away - 1.0 : nearest(x, voxel, away, shell < 0);
    return shell > 0 ? distance : -distance;
  }
  if (outside > exact)
    return -outside;
  // All of a shell are nearer than those of the next one.
  for (int shell = 1; shell <= exact + 1; ++shell)
    if (const double distance = nearest(x, voxel, shell, true); distance < infinity)
      return -distance;
  return -(exact + 1.0);
}

template <int D>
BoxPart<D> VoxelPhase<D>::part(const Vector<D>& lower, const Vector<D>& upper) const
{
  Index first, last;
  BoxPart<D> result;
  for (int d = 0; d < D; ++d)
  {
    first[d] = std::max<std::int64_t>(0, static_cast<std::int64_t>(std::floor(lower[d])));
    last[d] = std::min<std::int64_t>(count_[d] - 1, static_cast<std::int64_t>(std::ceil(upper[d])) - 1);
    if (last[d] < first[d])
      return result;
  }
  Vector<D> sum{}, squares{};
  Index voxel = first;
  do
  {
    if (!has(voxel))
      continue;
    double fraction = 1.0;
    Vector<D> middle, length; // from the middle of the box, in its edges
    for (int d = 0; d < D; ++d)
    {
      const double edge = upper[d] - lower[d], at = static_cast<double>(voxel[d]);
      const double low = std::max(lower[d], at), high = std::min(upper[d], at + 1.0);
      length[d] = (high - low) / edge;
      middle[d] = (0.5 * (low + high) - 0.5 * (lower[d] + upper[d])) / edge;
      fraction *= length[d];
    }
    result.fraction += fraction;
    for (int d = 0; d < D; ++d)
    {
      sum[d] += fraction * middle[d];
      squares[d] += fraction * (middle[d] * middle[d] + length[d] * length[d] / 12.0);
    }
  } while (next<D>(voxel, first, last));
  for (int d = 0; d < D && result.fraction > 0.0; ++d)
  {
    result.centroid[d] = sum[d] / result.fraction;
    result.variance[d] = squares[d] / result.fraction - result.centroid[d] * result.centroid[d];
  }
  return result;
}

template class VoxelPhase<2>;
template class VoxelPhase<3>;

} // namespace Rhegma::Geometry
