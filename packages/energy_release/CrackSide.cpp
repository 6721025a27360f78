#include "energy_release/CrackSide.hpp"

#include <algorithm>
#include <limits>

namespace Rhegma::energy_release
{

namespace
{

double cross(const Vector<2>& a, const Vector<2>& b) { return a[0] * b[1] - a[1] * b[0]; }

} // namespace

CrackSide::CrackSide(const CrackSet<2>& cracks, const CrackFront<2>& front) : front_(front)
{
  if (front.crack >= static_cast<int>(cracks.cracks.size()) || cracks.vertex.extent(0) == 0)
    return;
  const auto vertex = onHost(cracks.vertex);
  const auto simplex = onHost(cracks.simplex);
  const Crack<2>& crack = cracks.cracks[front.crack];
  for (int s = crack.firstSimplex; s < crack.firstSimplex + crack.numSimplices; ++s)
  {
    const int a = simplex(s, 0), b = simplex(s, 1);
    const Segment segment{{{vertex(a, 0), vertex(a, 1)}}, {{vertex(b, 0), vertex(b, 1)}}};
    segments_.push_back(segment);
    if (a == front.vertex || b == front.vertex)
      orientation_ = cross(segment.end - segment.begin, front.normal) > 0.0 ? 1.0 : -1.0;
  }
}

int CrackSide::side(const Vector<2>& x) const
{
  const Vector<2> from = x - front_.position;
  double nearest = std::numeric_limits<double>::infinity();
  double value = dot(from, front_.normal);
  if (segments_.empty() || dot(from, front_.direction) >= 0.0)
    return value >= 0.0 ? 1 : -1;
  for (const Segment& s : segments_)
  {
    const Vector<2> along = s.end - s.begin;
    const double square = dot(along, along);
    const double fraction = square > 0.0 ? std::clamp(dot(x - s.begin, along) / square, 0.0, 1.0) : 0.0;
    const double r = norm(x - (s.begin + fraction * along));
    if (r < nearest)
    {
      nearest = r;
      value = orientation_ * cross(along, x - s.begin);
    }
  }
  return value >= 0.0 ? 1 : -1;
}

} // namespace Rhegma::energy_release
