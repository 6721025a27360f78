#include "cracks/Opening.hpp"

#include "geometry/Cross.hpp"

#include <algorithm>

namespace Rhegma::cracks
{

namespace
{

/// Behind a front the opening grows as the root of the distance: 2/3 of its end value in the mean, not 1/2.
constexpr double rootShape = 4.0 / 3.0;

double sizeOf(const Vector<2> (&corner)[2]) { return norm(corner[1] - corner[0]); }

double sizeOf(const Vector<3> (&corner)[3])
{
  return 0.5 * norm(cross(corner[1] - corner[0], corner[2] - corner[0]));
}

} // namespace

template <int D>
Opening measureOpening(const CrackSet<D>& cracks, int crack, double overlap)
{
  const auto vertex = onHost(cracks.vertex);
  const auto face = onHost(cracks.face);
  const auto neighbour = onHost(cracks.neighbour);
  const auto simplex = onHost(cracks.simplex);
  const auto normal = onHost(cracks.normal);
  const auto vertexNormal = onHost(cracks.vertexNormal);
  const Crack<D>& c = cracks.cracks[crack];
  Opening opening{0.0, 0.0, 0.0, 0.0};
  for (int v = c.firstVertex; v < c.firstVertex + c.numVertices; ++v)
  {
    double apart = 0.0;
    for (int d = 0; d < D; ++d)
      apart += vertexNormal(v, d) * (face(v, 1, d) - face(v, 0, d));
    opening.largest = std::max(opening.largest, apart);
    opening.smallest = std::min(opening.smallest, apart);
  }
  for (int s = c.firstSimplex; s < c.firstSimplex + c.numSimplices; ++s)
  {
    Vector<D> corner[D];
    double mean = 0.0;
    bool atFront = false;
    for (int i = 0; i < D; ++i)
      atFront = atFront || neighbour(s, i) == facet::front;
    for (int i = 0; i < D; ++i)
      for (int d = 0; d < D; ++d)
      {
        const int v = simplex(s, i);
        corner[i][d] = vertex(v, d);
        mean += normal(s, d) * (face(v, 1, d) - face(v, 0, d)) / D;
      }
    opening.volume += (D == 2 && atFront ? rootShape : 1.0) * mean * sizeOf(corner);
    opening.size += sizeOf(corner);
    opening.closed += mean < -overlap ? sizeOf(corner) : 0.0;
  }
  return opening;
}

template Opening measureOpening(const CrackSet<2>&, int, double);
template Opening measureOpening(const CrackSet<3>&, int, double);

} // namespace Rhegma::cracks
