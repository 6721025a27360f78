#include "geometry/NearestPoint.hpp"

namespace Rhegma
{

template <int D>
NearestPoint<D>::NearestPoint(const std::vector<Vector<D>>& points, double reach)
    : points_(points), reach_(reach)
{
  std::size_t buckets = 1;
  while (buckets < points.size())
    buckets *= 2;
  mask_ = buckets - 1;

  first_.assign(buckets + 1, 0);
  for (const auto& x : points)
    ++first_[bucketOf(cellOf(x)) + 1];
  for (std::size_t b = 0; b < buckets; ++b)
    first_[b + 1] += first_[b];
  order_.resize(points.size());
  std::vector<int> next(first_.begin(), first_.end() - 1);
  for (std::size_t p = 0; p < points.size(); ++p)
    order_[next[bucketOf(cellOf(points[p]))]++] = static_cast<int>(p);
}

template <int D>
typename NearestPoint<D>::Cell NearestPoint<D>::cellOf(const Vector<D>& x) const
{
  Cell cell;
  for (int d = 0; d < D; ++d)
    cell[d] = static_cast<std::int64_t>(std::floor(x[d] / reach_));
  return cell;
}

template <int D>
std::size_t NearestPoint<D>::bucketOf(const Cell& cell) const
{
  std::uint64_t hash = 0;
  for (int d = 0; d < D; ++d)
  {
    hash ^= static_cast<std::uint64_t>(cell[d]);
    hash *= 0x9E3779B97F4A7C15u; // 2^64 over the golden ratio (Knuth's multiplicative hashing)
    hash ^= hash >> 32;
  }
  return static_cast<std::size_t>(hash) & mask_;
}

template <int D>
int NearestPoint<D>::find(const Vector<D>& x) const
{
  const Cell centre = cellOf(x);
  const double roundOff = 1.0 + 1.0e-12; // distances equal but for rounding are equal
  int nearest = -1;
  double best = reach_ * reach_ * roundOff;
  constexpr int cells = D == 2 ? 9 : 27;
  for (int n = 0; n < cells; ++n)
  {
    Cell cell = centre;
    cell[0] += n % 3 - 1;
    cell[1] += n / 3 % 3 - 1;
    if (D == 3)
      cell[D - 1] += n / 9 - 1;
    const std::size_t bucket = bucketOf(cell);
    for (int at = first_[bucket]; at < first_[bucket + 1]; ++at)
    {
      const int p = order_[at];
      const Vector<D> arm = x - points_[p];
      const double squared = dot(arm, arm);
      if (nearest < 0 ? squared <= best
                      : squared * roundOff < best || (squared <= best * roundOff && p < nearest))
      {
        nearest = p;
        best = squared;
      }
    }
  }
  return nearest;
}

template class NearestPoint<2>;
template class NearestPoint<3>;

} // namespace Rhegma
