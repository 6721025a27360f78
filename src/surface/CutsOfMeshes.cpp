#include "surface/CutsOfMeshes.hpp"

#include "geometry/Cross.hpp"
#include "geometry/NearBoxes.hpp"
#include "surface/NearestOnSimplex.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>

namespace Rhegma::surface
{

namespace
{

constexpr double tiny = 1e-9; ///< of a length: rounding

/// A simplex of a crack.
template <int D>
struct CutSimplex
{
  int crack;
  Vector<D> corner[D];
  Vector<D> normal; ///< unit vector
  bool border[D];   ///< no simplex is beyond the facet opposite to each corner
  bool front[D];    ///< uncracked material is
};

Vector<2> unitNormal(const Vector<2> (&corner)[2])
{
  const Vector<2> along = corner[1] - corner[0];
  return {{-along[1] / norm(along), along[0] / norm(along)}};
}

Vector<3> unitNormal(const Vector<3> (&corner)[3])
{
  const Vector<3> n = cross(corner[1] - corner[0], corner[2] - corner[0]);
  return (1.0 / norm(n)) * n;
}

template <int D>
Geometry::Bounds<D> boundsOfPoints(const std::vector<Vector<D>>& points)
{
  Geometry::Bounds<D> bounds = Geometry::emptyBounds<D>();
  for (const Vector<D>& x : points)
    bounds.include(x);
  return bounds;
}

/// Whether a convex set of points (a point, a line or a triangle, by its corners) reaches the inside of a box
/// that is smaller by rounding: the polygon is clipped at one side of the box after the other (Sutherland and
/// Hodgman, Comm. ACM 17 (1974) 32).
template <int D>
bool reachesInto(std::vector<Vector<D>> polygon, const Geometry::OrientedBox<D>& box)
{
  for (int axis = 0; axis < D; ++axis)
    for (const double sign : {-1.0, 1.0})
    {
      const double half = (0.5 - tiny) * box.edge[axis];
      const auto depth = [&](const Vector<D>& x)
      { return half - sign * dot(x - box.centre, box.axes[axis]); };
      std::vector<Vector<D>> kept;
      for (std::size_t i = 0; i < polygon.size(); ++i)
      {
        const Vector<D>&a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
        const double da = depth(a), db = depth(b);
        if (da > 0.0)
          kept.push_back(a);
        if ((da > 0.0) != (db > 0.0))
          kept.push_back(a + (da / (da - db)) * (b - a));
      }
      polygon = std::move(kept);
      if (polygon.empty())
        return false;
    }
  return true;
}

template <int D>
class CutSimplices
{
public:
  explicit CutSimplices(const std::vector<CrackMesh<D>>& meshes)
      : pieces_(read(meshes)), near_(bounds(pieces_))
  {
  }

  /// The pieces whose bounds come within a distance of a box.
  std::vector<int> near(const Geometry::Bounds<D>& box, double gap) const { return near_.near(box, gap); }

  const CutSimplex<D>& operator[](int k) const { return pieces_[k]; }

private:
  static std::vector<CutSimplex<D>> read(const std::vector<CrackMesh<D>>& meshes)
  {
    std::vector<CutSimplex<D>> pieces;
    for (std::size_t c = 0; c < meshes.size(); ++c)
      for (std::size_t s = 0; s < meshes[c].simplices.size(); ++s)
      {
        CutSimplex<D> piece;
        piece.crack = static_cast<int>(c);
        for (int i = 0; i < D; ++i)
        {
          piece.corner[i] = meshes[c].vertices[meshes[c].simplices[s][i]];
          piece.border[i] = meshes[c].beyond[s][i] < 0;
          piece.front[i] = meshes[c].beyond[s][i] == facet::front;
        }
        piece.normal = unitNormal(piece.corner);
        pieces.push_back(piece);
      }
    return pieces;
  }

  static std::vector<Geometry::Bounds<D>> bounds(const std::vector<CutSimplex<D>>& pieces)
  {
    std::vector<Geometry::Bounds<D>> all;
    all.reserve(pieces.size());
    for (const CutSimplex<D>& piece : pieces)
      all.push_back(boundsOfPoints<D>({piece.corner, piece.corner + D}));
    return all;
  }

  std::vector<CutSimplex<D>> pieces_;
  Geometry::NearBoxes<D> near_;
};

/// Whether the foot of a point lies on a facet or at a vertex beyond which there is no simplex.
template <int D>
bool isAtBorder(const CutSimplex<D>& piece, const Foot<D>& foot)
{
  bool found = foot.facet >= 0 && piece.border[foot.facet];
  for (int i = 0; i < D && foot.vertex >= 0; ++i) // a vertex is on all facets but the one opposite to it
    found = found || (i != foot.vertex && piece.border[i]);
  return found;
}

/// Distance of a point from the continued pieces of one crack.
template <int D>
double signedDistance(const std::vector<CutSimplex<D>>& pieces, const Vector<D>& x)
{
  double nearest = 1e300, plane = 0.0, value = 0.0;
  for (const CutSimplex<D>& piece : pieces)
  {
    const Foot<D> foot = footOn(piece.corner, x);
    const Vector<D> away = x - pointAt<D>(piece.corner, foot);
    const double distance = norm(away), side = dot(away, piece.normal);
    const bool equally = std::fabs(distance - nearest) <= tiny * nearest;
    if (equally ? std::fabs(side) <= std::fabs(plane) : distance > nearest)
      continue;
    nearest = distance;
    plane = side;
    value = isAtBorder(piece, foot) ? side : std::copysign(distance, side);
  }
  return value;
}

/// Whether the line from a to b meets a piece.
template <int D>
bool meets(const CutSimplex<D>& piece, const Vector<D>& a, const Vector<D>& b)
{
  const double da = dot(a - piece.corner[0], piece.normal), db = dot(b - piece.corner[0], piece.normal);
  if ((da > 0.0) == (db > 0.0))
    return false;
  const Vector<D> x = a + (da / (da - db)) * (b - a);
  return norm(x - pointAt<D>(piece.corner, footOn(piece.corner, x))) <= tiny * norm(b - a);
}

template <int D>
Geometry::BoxCuts<D> cutsOfBox(const CutSimplices<D>& pieces, const Geometry::OrientedBox<D>& box)
{
  Vector<D> half{};
  for (int d = 0; d < D; ++d)
    for (int e = 0; e < D; ++e)
      half[d] += 0.5 * std::fabs(box.axes[e][d]) * box.edge[e];
  const Geometry::Bounds<D> bounds{box.centre - half, box.centre + half};
  if (pieces.near(bounds, 0.0).empty())
    return {};
  std::map<int, std::vector<CutSimplex<D>>> ofCrack;
  std::map<int, bool> enters, hasFront;
  for (const int k : pieces.near(bounds, norm(box.edge))) // those that a corner may be nearest to
  {
    const CutSimplex<D>& piece = pieces[k];
    ofCrack[piece.crack].push_back(piece);
    enters[piece.crack] |= reachesInto<D>({piece.corner, piece.corner + D}, box);
    for (int i = 0; i < D; ++i)
    {
      std::vector<Vector<D>> facet;
      for (int j = 0; j < D && piece.front[i]; ++j)
        if (j != i)
          facet.push_back(piece.corner[j]);
      hasFront[piece.crack] |= !facet.empty() && reachesInto<D>(facet, box);
    }
  }
  Geometry::BoxCuts<D> found;
  for (const auto& [crack, own] : ofCrack)
  {
    found.any = found.any || enters[crack];
    if (enters[crack] && !hasFront[crack])
      found.through.push_back([own = own](const Vector<D>& x) { return signedDistance<D>(own, x); });
  }
  return found;
}

} // namespace

template <int D>
Geometry::Cuts<D> cutsOfMeshes(const std::vector<CrackMesh<D>>& meshes)
{
  if (meshes.empty())
    return {};
  const auto pieces = std::make_shared<const CutSimplices<D>>(meshes);
  Geometry::Cuts<D> cuts;
  cuts.ofBox = [pieces](const Geometry::OrientedBox<D>& box) { return cutsOfBox(*pieces, box); };
  cuts.separate = [pieces](const Vector<D>& a, const Vector<D>& b)
  {
    const std::vector<int> near = pieces->near(boundsOfPoints<D>({a, b}), 0.0);
    return std::any_of(near.begin(), near.end(), [&](int k) { return meets((*pieces)[k], a, b); });
  };
  return cuts;
}

template Geometry::Cuts<2> cutsOfMeshes(const std::vector<CrackMesh<2>>&);
template Geometry::Cuts<3> cutsOfMeshes(const std::vector<CrackMesh<3>>&);

} // namespace Rhegma::surface
