#include "surface/Returns.hpp"

#include "geometry/NearestPoint.hpp"
#include "surface/NearestOnSimplex.hpp"

#include <functional>
#include <limits>
#include <queue>
#include <utility>

namespace Rhegma::surface
{

namespace
{

constexpr double infinity = std::numeric_limits<double>::infinity();

template <int D>
void cornersOf(const CrackMesh<D>& mesh, int s, Vector<D> (&corner)[D])
{
  for (int i = 0; i < D; ++i)
    corner[i] = mesh.vertices[mesh.simplices[s][i]];
}

template <int D>
std::vector<Geometry::Bounds<D>> boundsOf(const CrackMesh<D>& mesh)
{
  std::vector<Geometry::Bounds<D>> bounds(mesh.simplices.size(), Geometry::emptyBounds<D>());
  for (std::size_t s = 0; s < bounds.size(); ++s)
    for (const int v : mesh.simplices[s])
      bounds[s].include(mesh.vertices[v]);
  return bounds;
}

/// Distances from points; infinite where they are of no interest.
template <int D>
class Distances
{
public:
  Distances(const CrackMesh<D>& mesh, const std::vector<Vector<D>>& points, double reach)
      : mesh_(mesh), points_(points), nearest_(points_, reach)
  {
  }

  double ofSimplex(int s) const
  {
    Vector<D> corner[D];
    cornersOf(mesh_, s, corner);
    Vector<D> middle{};
    for (int i = 0; i < D; ++i)
      middle = middle + (1.0 / D) * corner[i];
    const int k = nearest_.find(middle);
    return k < 0 ? infinity : distanceToSimplex(corner, points_[k]);
  }

  /// Of the facet opposite to a corner.
  double ofFacet(int s, int opposite) const
  {
    Vector<D> corner[D];
    cornersOf(mesh_, s, corner);
    const Vector<D>&a = corner[(opposite + 1) % D], &b = corner[(opposite + D - 1) % D];
    const int k = nearest_.find(0.5 * (a + b));
    if (k < 0)
      return infinity;
    return D == 2 ? norm(points_[k] - a) : distanceToSegment(points_[k], a, b);
  }

private:
  const CrackMesh<D>& mesh_;
  const std::vector<Vector<D>>& points_;
  NearestPoint<D> nearest_;
};

/// How far one must go from the points, at least, to reach each of some simplices along them [m].
/// \param near their numbers, in their order
template <int D>
std::vector<double> farthestOnTheWay(const CrackMesh<D>& mesh, const std::vector<int>& near,
                                     const std::vector<int>& start, const Distances<D>& distances)
{
  std::vector<double> way(near.size(), infinity);
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> next;
  const auto reach = [&](double far, int s)
  {
    const auto at = std::lower_bound(near.begin(), near.end(), s);
    if (at == near.end() || *at != s || !(far < way[at - near.begin()]))
      return;
    way[at - near.begin()] = far;
    next.emplace(far, static_cast<int>(at - near.begin()));
  };
  for (const int s : start)
    reach(0.0, s);
  while (!next.empty())
  {
    const auto [far, k] = next.top();
    next.pop();
    for (int i = 0; i < D && far == way[k]; ++i)
      if (const int t = mesh.beyond[near[k]][i]; t >= 0)
        reach(std::max(far, distances.ofFacet(near[k], i)), t);
  }
  return way;
}

} // namespace

template <int D>
Returns<D>::Returns(const CrackMesh<D>& mesh) : mesh_(mesh), boxes_(boundsOf(mesh))
{
  for (const auto& simplex : mesh.simplices)
    for (int i = 0; i < D; ++i)
      longest_ = std::max(longest_, norm(mesh.vertices[simplex[(i + 1) % D]] - mesh.vertices[simplex[i]]));
}

template <int D>
double Returns<D>::find(const std::vector<int>& start, const std::vector<Vector<D>>& points, double radius,
                        double slack) const
{
  Geometry::Bounds<D> bounds = Geometry::emptyBounds<D>();
  for (const Vector<D>& x : points)
    bounds.include(x);
  const std::vector<int> near = boxes_.near(bounds, radius + slack);
  const Distances<D> distances(mesh_, points, radius + slack + longest_);
  const std::vector<double> way = farthestOnTheWay(mesh_, near, start, distances);
  double nearest = radius;
  for (std::size_t k = 0; k < near.size(); ++k)
    if (const double distance = distances.ofSimplex(near[k]); distance < nearest && way[k] > distance + slack)
      nearest = distance;
  return nearest;
}

template class Returns<2>;
template class Returns<3>;

} // namespace Rhegma::surface
