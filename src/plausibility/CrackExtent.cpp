#include "plausibility/CrackExtent.hpp"

#include "geometry/Cross.hpp"
#include "plausibility/CrackBounds.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace Rhegma
{

namespace
{

template <int D>
using CrackVertices = typename View<double* [D]>::HostMirror;

template <int D>
CrackVertices<D> verticesOf(const State<D>& state)
{
  return Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, state.cracks.vertex);
}

/// Whether a crack has vertices in a view.
template <int D>
bool hasVertices(const Crack<D>& crack, const CrackVertices<D>& x)
{
  return crack.numVertices > 0 && crack.firstVertex + crack.numVertices <= static_cast<int>(x.extent(0));
}

template <int D>
Vector<D> vertexAt(const CrackVertices<D>& x, int v)
{
  Vector<D> at;
  for (int d = 0; d < D; ++d)
    at[d] = x(v, d);
  return at;
}

/// [m]
template <int D>
double extentAlong(const Crack<D>& crack, const CrackVertices<D>& x, const Vector<D>& direction)
{
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (int v = crack.firstVertex; v < crack.firstVertex + crack.numVertices; ++v)
  {
    const double at = dot(vertexAt<D>(x, v), direction);
    low = std::min(low, at);
    high = std::max(high, at);
  }
  return high - low;
}

template <int D>
bool liesIn(const BodyMeasure<D>& body, const Crack<D>& crack, const CrackVertices<D>& x)
{
  const Geometry::Bounds<D> bounds = boundsOfCrack(crack, x); // empty ones meet nothing
  bool meets = true;
  for (int d = 0; d < D; ++d)
    meets = meets && bounds.lower[d] < body.upper[d] && bounds.upper[d] > body.lower[d];
  return meets;
}

/// The body's axis nearest to a direction. \param taken an axis that is left out, or -1
template <int D>
int nearestAxis(const BodyMeasure<D>& body, const Vector<D>& direction, int taken)
{
  int nearest = -1;
  double most = -1.0;
  for (int k = 0; k < D; ++k)
  {
    double along = 0.0;
    for (int d = 0; d < D; ++d)
      along += body.axes[k][d] * direction[d];
    if (k != taken && std::fabs(along) > most)
    {
      most = std::fabs(along);
      nearest = k;
    }
  }
  return nearest;
}

/// Mean directions of the fronts of a crack, and how many it has.
template <int D>
struct FrontMeans
{
  Vector<D> direction{}, normal{}; ///< of its first front
  int fronts = 0;
  bool closed = false; ///< directions cancel along the first
};

template <int D>
FrontMeans<D> frontMeans(const State<D>& state, int crack)
{
  constexpr double open = 0.5; // of half a circle it is 2 / pi, of a circle 0
  FrontMeans<D> means;
  for (const CrackFront<D>& front : state.cracks.fronts)
  {
    if (front.crack != crack || front.ended || front.nodes.empty() || means.fronts++ > 0)
      continue;
    const double each = 1.0 / static_cast<double>(front.nodes.size());
    for (const FrontNode<D>& node : front.nodes)
    {
      means.direction = means.direction + each * node.direction;
      means.normal = means.normal + each * node.normal;
    }
    means.closed = D == 3 && norm(means.direction) < open;
    if (means.closed)
      means.direction = front.nodes.front().direction;
  }
  return means;
}

template <int D>
CrackedSection<D> sectionOf(const State<D>& state, const BodyMeasure<D>& body, int crack,
                            const CrackVertices<D>& x, const FrontMeans<D>& means)
{
  const Crack<D>& one = state.cracks.cracks[crack];
  const Vector<D> extents = body.ownUpper - body.ownLower;
  CrackedSection<D> section;
  section.crack = crack;
  section.depth = extentOf(state, crack);
  section.atBothEnds = means.closed || means.fronts > 1;
  section.direction = means.direction;
  const int normal = nearestAxis(body, means.normal, -1), along = nearestAxis(body, means.direction, normal);
  section.width = extents[along];
  double sectionArea = extents[along], middle = 0.0;
  for (int k = 0; k < D; ++k)
    if (k != normal && k != along)
    {
      sectionArea *= extents[k];
      section.alongFront = means.closed ? -1 : k;
    }
  // In 2D a crack divides by its depth, whatever its path.
  section.fraction =
      std::min(1.0, D == 2 ? section.depth / section.width : areaOf(state, crack) / sectionArea);
  for (int v = one.firstVertex; v < one.firstVertex + one.numVertices; ++v)
    for (int d = 0; d < D; ++d)
      middle += body.axes[normal][d] * x(v, d) / one.numVertices;
  section.below = std::max(0.0, middle - body.ownLower[normal]);
  section.above = std::max(0.0, body.ownUpper[normal] - middle);
  return section;
}

} // namespace

template <int D>
double extentOf(const State<D>& state, int crack)
{
  const auto x = verticesOf(state);
  const Crack<D>& one = state.cracks.cracks[crack];
  if (!hasVertices<D>(one, x))
    return 0.0;
  double shortest = std::numeric_limits<double>::infinity();
  if constexpr (D == 3)
    for (const CrackFront<D>& front : state.cracks.fronts)
      for (std::size_t k = 0; k < front.nodes.size() && front.crack == crack && !front.ended; ++k)
        shortest = std::min(shortest, extentAlong<D>(one, x, front.nodes[k].direction));
  const Geometry::Bounds<D> bounds = boundsOfCrack(one, x);
  return std::isfinite(shortest) ? shortest : norm(bounds.upper - bounds.lower);
}

template <int D>
double longestCrack(const State<D>& state)
{
  double longest = 0.0;
  for (std::size_t c = 0; c < state.cracks.cracks.size(); ++c)
    longest = std::max(longest, extentOf(state, static_cast<int>(c)));
  return longest;
}

template <int D>
double areaOf(const State<D>& state, int crack)
{
  if constexpr (D == 2)
  {
    const Crack<D>& one = state.cracks.cracks[crack];
    const auto x = verticesOf(state);
    if (!hasVertices<D>(one, x))
      return 0.0;
    const Geometry::Bounds<D> bounds = boundsOfCrack(one, x);
    return extentOf(state, crack) * state.method.depth().at(0.5 * (bounds.lower[0] + bounds.upper[0]));
  }
  else
  {
    const auto x = verticesOf(state);
    const auto simplex = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, state.cracks.simplex);
    const Crack<D>& one = state.cracks.cracks[crack];
    double area = 0.0;
    for (int s = one.firstSimplex; hasVertices<D>(one, x) && s < one.firstSimplex + one.numSimplices; ++s)
    {
      const Vector<3> a = vertexAt<3>(x, simplex(s, 0));
      area += 0.5 * norm(cross(vertexAt<3>(x, simplex(s, 1)) - a, vertexAt<3>(x, simplex(s, 2)) - a));
    }
    return area;
  }
}

template <int D>
std::vector<BodyMeasure<D>> crackedBodies(const State<D>& state)
{
  const auto x = verticesOf(state);
  const std::vector<BodyMeasure<D>> bodies = measureBodies(state);
  std::vector<BodyMeasure<D>> cracked;
  for (const BodyMeasure<D>& body : bodies)
    if (std::any_of(state.cracks.cracks.begin(), state.cracks.cracks.end(),
                    [&](const Crack<D>& crack) { return liesIn<D>(body, crack, x); }))
      cracked.push_back(body);
  return cracked.empty() ? bodies : cracked;
}

template <int D>
std::vector<CrackedSection<D>> sectionsOf(const State<D>& state, const BodyMeasure<D>& body)
{
  const auto x = verticesOf(state);
  std::vector<CrackedSection<D>> sections;
  for (std::size_t c = 0; c < state.cracks.cracks.size(); ++c)
  {
    const Crack<D>& crack = state.cracks.cracks[c];
    const FrontMeans<D> means = frontMeans(state, static_cast<int>(c));
    if (means.fronts > 0 && hasVertices<D>(crack, x) && liesIn<D>(body, crack, x))
      sections.push_back(sectionOf<D>(state, body, static_cast<int>(c), x, means));
  }
  return sections;
}

template <int D>
double shortestAcrossFronts(const State<D>& state, const BodyMeasure<D>& body)
{
  if (D == 2)
    return body.shortest;
  double shortest = std::numeric_limits<double>::infinity();
  for (const CrackedSection<D>& section : sectionsOf(state, body))
    for (int k = 0; k < D; ++k)
      if (k != section.alongFront)
        shortest = std::min(shortest, body.ownUpper[k] - body.ownLower[k]);
  return std::isfinite(shortest) ? shortest : body.shortest;
}

template double extentOf(const State<2>&, int);
template double extentOf(const State<3>&, int);
template double longestCrack(const State<2>&);
template double longestCrack(const State<3>&);
template double areaOf(const State<2>&, int);
template double areaOf(const State<3>&, int);
template std::vector<BodyMeasure<2>> crackedBodies(const State<2>&);
template std::vector<BodyMeasure<3>> crackedBodies(const State<3>&);
template std::vector<CrackedSection<2>> sectionsOf(const State<2>&, const BodyMeasure<2>&);
template std::vector<CrackedSection<3>> sectionsOf(const State<3>&, const BodyMeasure<3>&);
template double shortestAcrossFronts(const State<2>&, const BodyMeasure<2>&);
template double shortestAcrossFronts(const State<3>&, const BodyMeasure<3>&);

} // namespace Rhegma
