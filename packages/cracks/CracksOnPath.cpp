#include "cracks/CracksOnPath.hpp"

#include "geometry/NearestOnSimplex.hpp"

#include <algorithm>
#include <limits>

namespace Rhegma::cracks
{

template <int D>
CracksOnPath<D>::CracksOnPath(const CrackSet<D>& set, int own)
{
  const auto vertex = onHost(set.vertex);
  const auto simplex = onHost(set.simplex);
  for (int c = 0; c < static_cast<int>(set.cracks.size()); ++c)
  {
    const Crack<D>& crack = set.cracks[c];
    for (int s = crack.firstSimplex; s < crack.firstSimplex + crack.numSimplices && c != own; ++s)
    {
      Face face{{}, c};
      for (int i = 0; i < D; ++i)
        for (int d = 0; d < D; ++d)
          face.corner[i][d] = vertex(simplex(s, i), d);
      faces_.push_back(face);
    }
  }
}

template <int D>
CrackOnPath CracksOnPath<D>::nearest(const Vector<D>& x) const
{
  CrackOnPath found{-1, std::numeric_limits<double>::infinity()};
  for (const Face& face : faces_)
    if (const double distance = Geometry::distanceToSimplex(face.corner, x); distance < found.length)
      found = {face.crack, distance};
  return found;
}

/// Nothing lies nearer than the nearest face, so that the path may be followed by that distance at a time.
template <int D>
CrackOnPath CracksOnPath<D>::first(const Vector<D>& from, const Vector<D>& direction, double length,
                                   double near) const
{
  for (double along = 0.0; along < length && !faces_.empty();)
  {
    const CrackOnPath next = nearest(from + along * direction);
    if (next.length < near)
      return {next.crack, std::min(along + next.length, length)};
    along += next.length;
  }
  return {-1, length};
}

template class CracksOnPath<2>;
template class CracksOnPath<3>;

} // namespace Rhegma::cracks
