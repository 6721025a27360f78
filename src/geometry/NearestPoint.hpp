#pragma once
/// Finds the nearest of many points within a reach.

#include "base/Types.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace Rhegma
{

/// Points hashed by cells as large as the reach, so that a search checks 3^D cells, whatever the number of
/// points.
template <int D>
class NearestPoint
{
public:
  /// \param points  stored by reference; must outlive this object [m]
  /// \param reach   largest distance at which a point is found [m]
  NearestPoint(const std::vector<Vector<D>>& points, double reach);

  /// Index of the point nearest to x, of equally near ones the first; -1 where none is within reach.
  int find(const Vector<D>& x) const;

private:
  using Cell = std::array<std::int64_t, D>;
  Cell cellOf(const Vector<D>& x) const;
  std::size_t bucketOf(const Cell& cell) const;

  const std::vector<Vector<D>>& points_;
  double reach_;
  std::size_t mask_;
  std::vector<int> first_; ///< of each bucket, into order_
  std::vector<int> order_; ///< points by bucket
};

} // namespace Rhegma
