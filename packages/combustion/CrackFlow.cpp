#include "combustion/CrackFlow.hpp"

#include "archive/Archive.hpp"

#include <cmath>
#include <limits>
#include <numeric>

namespace Rhegma::combustion
{

namespace
{

/// Ends of old and new cells that are closer than this fraction of a cell are the same.
constexpr double sameEnd = 0.25;

} // namespace

/// Arc length along the present cells nearest to a point [m].
template <int D>
double CrackFlow<D>::arcAt(const FacePoints<D>& points, const Vector<D>& point) const
{
  double found = 0.0;
  if constexpr (D == 2)
  {
    const auto position = onHost(points.position);
    const auto normal = onHost(points.normal);
    double nearest = std::numeric_limits<double>::max(), arc = 0.0;
    for (std::size_t k = 0; k < length_.size(); ++k)
    {
      const int p = first_ + static_cast<int>(k);
      const double x = point[0] - position(p, 0), y = point[1] - position(p, 1);
      // Side +1, to which the normal points, lies to the left of the crack's own direction.
      const double along = x * normal(p, 1) - y * normal(p, 0);
      if (std::hypot(x, y) < nearest)
      {
        nearest = std::hypot(x, y);
        found = arc + 0.5 * length_[k] + along;
      }
      arc += length_[k];
    }
  }
  return found;
}

template <int D>
void CrackFlow<D>::updateCells(const FacePoints<D>& points, int crack, double cavity, double gap,
                               double density)
{
  const auto of = onHost(points.crack);
  const auto size = onHost(points.currentSize);
  const auto position = onHost(points.position);
  const std::vector<double> before = length_;
  length_.clear();
  for (int k = 0; k < points.count(); ++k)
    if (of(k) == crack)
    {
      if (length_.empty())
        first_ = k;
      length_.push_back(size(k));
    }
  const double whole = std::accumulate(length_.begin(), length_.end(), 0.0);
  if (before.empty())
  {
    std::vector<double> capacity(length_.size());
    for (std::size_t k = 0; k < capacity.size(); ++k)
      capacity[k] = cavity * length_[k] / whole;
    channel_.setCells(length_, capacity);
  }
  else
  {
    double from = arcAt(points, begin_) - 0.5 * before.front();
    double to = arcAt(points, end_) + 0.5 * before.back();
    from = std::fabs(from) < sameEnd * before.front() ? 0.0 : from;
    to = std::fabs(whole - to) < sameEnd * before.back() ? whole : to;
    if (length_.size() != before.size() || from != 0.0 || to != whole)
      channel_.remesh(length_, from, to, gap, density);
  }
  channel_.updateVolumes(length_, gap, density);
  const int last = first_ + static_cast<int>(length_.size()) - 1;
  for (int d = 0; d < D; ++d)
  {
    begin_[d] = position(first_, d);
    end_[d] = position(last, d);
  }
}

template <int D>
void CrackFlow<D>::serialize(Archive& archive)
{
  channel_.serialize(archive);
  archive("first", first_);
  archive("lengths", length_);
  archive("begin", begin_);
  archive("end", end_);
}

template class CrackFlow<2>;
template class CrackFlow<3>;

} // namespace Rhegma::combustion
