#include "geometry/PartOfBox.hpp"

#include "geometry/Cross.hpp"

#include <algorithm>
#include <cmath>

namespace Rhegma::Geometry
{
namespace
{

constexpr double linearTolerance = 2e-3; ///< of the shortest edge

template <int D>
constexpr int deepest = D == 2 ? 7 : 4; ///< halvings

/// A point in edges of the box from its centre, and the depth there.
template <int D>
struct Point
{
  Vector<D> u;
  double depth;
};

/// Moments about the box's centre, in its edges.
template <int D>
struct Sums
{
  double volume = 0.0;
  Vector<D> first{}, second{};

  /// A simplex: its second moments are V / ((D + 1)(D + 2)) (sum of squares + square of the sum).
  void add(const std::array<Point<D>, D + 1>& simplex)
  {
    Vector<D> side[D];
    for (int i = 0; i < D; ++i)
      side[i] = simplex[i + 1].u - simplex[0].u;
    double v = 0.0;
    if constexpr (D == 2)
      v = 0.5 * std::abs(side[0][0] * side[1][1] - side[0][1] * side[1][0]);
    else
      v = std::abs(dot(cross(side[0], side[1]), side[2])) / 6.0;
    volume += v;
    for (int d = 0; d < D; ++d)
    {
      double sum = 0.0, squares = 0.0;
      for (const Point<D>& p : simplex)
      {
        sum += p.u[d];
        squares += p.u[d] * p.u[d];
      }
      first[d] += v * sum / (D + 1);
      second[d] += v * (squares + sum * sum) / ((D + 1) * (D + 2));
    }
  }
};

/// Adds the part of a simplex where the depth, linear in it, is not negative: an edge whose ends have
/// different signs is divided where the depth is zero, and so the simplex, until no such edge is left.
template <int D>
void addPositive(const std::array<Point<D>, D + 1>& simplex, Sums<D>& sums)
{
  const auto in = std::find_if(simplex.begin(), simplex.end(), [](const auto& p) { return p.depth > 0.0; });
  const auto out = std::find_if(simplex.begin(), simplex.end(), [](const auto& p) { return p.depth < 0.0; });
  if (out == simplex.end())
    return sums.add(simplex);
  if (in == simplex.end())
    return;
  const double t = in->depth / (in->depth - out->depth);
  const Point<D> zero{in->u + t * (out->u - in->u), 0.0};
  for (const auto replaced : {in, out})
  {
    std::array<Point<D>, D + 1> half = simplex;
    half[replaced - simplex.begin()] = zero;
    addPositive<D>(half, sums);
  }
}

template <int D>
class Divider
{
public:
  Divider(const OrientedBox<D>& box, const Region<D>& region)
      : box_(box),
        region_(region),
        tolerance_(linearTolerance * *std::min_element(box.edge.c, box.edge.c + D))
  {
  }

  /// Adds the part of a cube about u. \param half half its edge \param level times that the box was halved
  void add(const Vector<D>& u, double half, int level)
  {
    BoxPoints<D> points;
    points.centre = toSpace(u);
    points.reach = half * norm(box_.edge);
    Cube cube{{u, 0.0}, {}};
    for (int k = 0; k < corners; ++k)
    {
      for (int d = 0; d < D; ++d)
        cube.corner[k].u[d] = u[d] + (((k >> d) & 1) != 0 ? half : -half);
      points.corners[k] = toSpace(cube.corner[k].u);
    }
    const Coverage coverage = region_.coverage(points);
    if (coverage == Coverage::None)
      return;
    if (coverage == Coverage::Whole)
      return addCube(u, half);
    cube.centre.depth = region_.depth(points.centre);
    for (int k = 0; k < corners; ++k)
      cube.corner[k].depth = region_.depth(points.corners[k]);
    const bool linear = isLinear(cube);
    if (level < deepest<D> && !linear)
      for (int k = 0; k < corners; ++k)
        add(0.5 * (u + cube.corner[k].u), 0.5 * half, level + 1);
    else if (linear && isInside(cube, 1.0))
      addCube(u, half);
    else if (!linear || !isInside(cube, -1.0))
      addCones(cube);
  }

  const Sums<D>& sums() const { return sums_; }

private:
  static constexpr int corners = 1 << D;

  struct Cube
  {
    Point<D> centre;
    std::array<Point<D>, corners> corner;
  };

  Vector<D> toSpace(const Vector<D>& u) const
  {
    Vector<D> x = box_.centre;
    for (int d = 0; d < D; ++d)
      x = x + (u[d] * box_.edge[d]) * box_.axes[d];
    return x;
  }

  /// Whether the depth is linear along the diagonals of the cube and of its faces.
  bool isLinear(const Cube& cube) const
  {
    for (int k = 0; k < corners / 2; ++k)
      if (!isBetween(cube.centre.depth, cube.corner[k], cube.corner[corners - 1 - k]))
        return false;
    for (int d = 0; d < D && D == 3; ++d)
      for (const int side : {0, 1})
      {
        const auto c = cornersOfFace(d, side);
        const double sum = cube.corner[c[0]].depth + cube.corner[c[2]].depth;
        if (!isBetween(0.5 * sum, cube.corner[c[1]], cube.corner[c[3]]))
          return false;
      }
    return true;
  }

  /// Whether all depths have the given sign.
  static bool isInside(const Cube& cube, double sign)
  {
    return sign * cube.centre.depth > 0.0 &&
           std::all_of(cube.corner.begin(), cube.corner.end(),
                       [&](const Point<D>& p) { return sign * p.depth > 0.0; });
  }

  bool isBetween(double middle, const Point<D>& a, const Point<D>& b) const
  {
    return std::abs(middle - 0.5 * (a.depth + b.depth)) <= tolerance_;
  }

  /// The corners of a face, round it; in 2D the two ends of a side, twice.
  static std::array<int, 4> cornersOfFace(int axis, int side)
  {
    const int a = 1 << ((axis + 1) % D), b = D == 3 ? 1 << ((axis + 2) % D) : 0, fixed = side << axis;
    return {fixed, fixed | a, fixed | a | b, fixed | b};
  }

  void addCube(const Vector<D>& u, double half)
  {
    const double v = std::pow(2.0 * half, D);
    sums_.volume += v;
    for (int d = 0; d < D; ++d)
    {
      sums_.first[d] += v * u[d];
      sums_.second[d] += v * (u[d] * u[d] + half * half / 3.0);
    }
  }

  /// Cuts the cube as cones from its centre: over its sides in 2D, over the four triangles about the middle
  /// of each face in 3D, so that mirror images stay mirror images.
  void addCones(const Cube& cube)
  {
    for (int axis = 0; axis < D; ++axis)
      for (const int side : {0, 1})
      {
        const auto c = cornersOfFace(axis, side);
        if constexpr (D == 2)
          addPositive<D>({cube.centre, cube.corner[c[0]], cube.corner[c[1]]}, sums_);
        else
        {
          Point<D> middle{};
          for (const int k : c)
            middle.u = middle.u + 0.25 * cube.corner[k].u;
          middle.depth = region_.depth(toSpace(middle.u));
          for (int k = 0; k < 4; ++k)
            addPositive<D>({cube.centre, middle, cube.corner[c[k]], cube.corner[c[(k + 1) % 4]]}, sums_);
        }
      }
  }

  const OrientedBox<D>& box_;
  const Region<D>& region_;
  double tolerance_;
  Sums<D> sums_;
};

} // namespace

template <int D>
BoxPart<D> partOfBox(const OrientedBox<D>& box, const Region<D>& region)
{
  Divider<D> divider(box, region);
  divider.add(Vector<D>{}, 0.5, 0);
  const Sums<D>& sums = divider.sums();
  BoxPart<D> part;
  part.fraction = sums.volume;
  if (!(sums.volume > 0.0))
    return part;
  for (int d = 0; d < D; ++d)
  {
    part.centroid[d] = sums.first[d] / sums.volume;
    part.variance[d] = std::max(0.0, sums.second[d] / sums.volume - part.centroid[d] * part.centroid[d]);
  }
  return part;
}

template BoxPart<2> partOfBox(const OrientedBox<2>&, const Region<2>&);
template BoxPart<3> partOfBox(const OrientedBox<3>&, const Region<3>&);

} // namespace Rhegma::Geometry
