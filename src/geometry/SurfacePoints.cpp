#include "geometry/SurfacePoints.hpp"

#include "geometry/Cross.hpp"
#include "geometry/SurfacePieces.hpp"

#include <algorithm>
#include <cmath>

namespace Rhegma::Geometry
{
namespace
{

template <int D>
using Points = std::vector<SurfacePoint<D>>;

const double pi = std::acos(-1.0);

int countOf(double length, double spacing, int least)
{
  return std::max(least, static_cast<int>(std::ceil(length / spacing)));
}

/// Calls visit(s), in 0 .. 1, in the middle of pieces of a length.
template <class Visit>
void along(double length, double spacing, const Visit& visit)
{
  const int count = countOf(length, spacing, 2);
  for (int k = 0; k < count; ++k)
    visit((k + 0.5) / count);
}

/// Points of the surface of a primitive, in its own coordinates.
template <int D>
struct Sampler
{
  double spacing;
  Points<D> points{};

  /// Length of the pieces of a length [m].
  double pieceOf(double length) const { return length / countOf(length, spacing, 2); }

  void operator()(const Box<D>& box)
  {
    const Vector<D> extent = box.corners.upper - box.corners.lower;
    for (int axis = 0; axis < D; ++axis)
      for (const double side : {-1.0, 1.0})
      {
        const int a = (axis + 1) % D, b = (axis + D - 1) % D;
        const double size = D == 2 ? pieceOf(extent[a]) : pieceOf(extent[a]) * pieceOf(extent[b]);
        SurfacePoint<D> point{side < 0.0 ? box.corners.lower : box.corners.upper, Vector<D>{}, size};
        point.normal[axis] = side;
        along(extent[a], spacing,
              [&](double s)
              {
                point.x[a] = box.corners.lower[a] + s * extent[a];
                if constexpr (D == 2)
                  points.push_back(point);
                else
                  along(extent[b], spacing,
                        [&](double t)
                        {
                          point.x[b] = box.corners.lower[b] + t * extent[b];
                          points.push_back(point);
                        });
              });
      }
  }

  /// In 3D on a spiral, by the golden angle.
  void operator()(const Ball<D>& ball)
  {
    const int count = D == 2 ? countOf(2.0 * pi * ball.radius, spacing, 8)
                             : countOf(4.0 * pi * ball.radius * ball.radius, spacing * spacing, 24);
    const double size = (D == 2 ? 2.0 * pi * ball.radius : 4.0 * pi * ball.radius * ball.radius) / count;
    for (int k = 0; k < count; ++k)
    {
      const double turn = D == 2 ? 2.0 * pi * (k + 0.5) / count : pi * (3.0 - std::sqrt(5.0)) * k;
      const double height = D == 2 ? 0.0 : 1.0 - 2.0 * (k + 0.5) / count;
      const double across = std::sqrt(1.0 - height * height);
      Vector<D> normal{};
      normal[D - 1] = height;
      normal[0] = across * std::cos(turn);
      normal[1] = across * std::sin(turn);
      points.push_back({ball.centre + ball.radius * normal, normal, size});
    }
  }

  void operator()(const Cylinder<D>& cylinder)
  {
    if constexpr (D == 3)
    {
      const double length = norm(cylinder.to - cylinder.from);
      const Vector<3> axis = (1.0 / length) * (cylinder.to - cylinder.from);
      const int flat = std::abs(axis[0]) < 0.5 ? 0 : std::abs(axis[1]) < 0.9 ? 1 : 2;
      Vector<3> a{};
      a[flat] = 1.0;
      a = cross(axis, a);
      a = (1.0 / norm(a)) * a;
      const Vector<3> b = cross(axis, a);
      // Pieces of a ring of the given area, in 3D.
      const auto ring = [&](double radius, double area, const auto& add)
      {
        const int count = countOf(2.0 * pi * radius, spacing, 8);
        for (int k = 0; k < count; ++k)
        {
          const double turn = 2.0 * pi * (k + 0.5) / count;
          add(std::cos(turn) * a + std::sin(turn) * b, area / count);
        }
      };
      along(length, spacing,
            [&](double s)
            {
              ring(cylinder.radius, 2.0 * pi * cylinder.radius * pieceOf(length),
                   [&](const Vector<3>& out, double size) {
                     points.push_back({cylinder.from + s * length * axis + cylinder.radius * out, out, size});
                   });
            });
      along(cylinder.radius, spacing,
            [&](double s)
            {
              const double radius = s * cylinder.radius;
              ring(radius, 2.0 * pi * radius * pieceOf(cylinder.radius),
                   [&](const Vector<3>& out, double size)
                   {
                     points.push_back({cylinder.from + radius * out, -1.0 * axis, size});
                     points.push_back({cylinder.to + radius * out, axis, size});
                   });
            });
    }
  }

  void operator()(const Polygon<D>& polygon)
  {
    const double turn = signedArea(polygon.points) > 0.0 ? 1.0 : -1.0;
    for (std::size_t i = 0, j = polygon.points.size() - 1; i < polygon.points.size(); j = i++)
    {
      const Vector<2> a = polygon.points[j], edge = polygon.points[i] - a;
      const double length = norm(edge);
      if (length == 0.0)
        continue;
      SurfacePoint<D> point{};
      point.size = pieceOf(length) * (D == 2 ? 1.0 : pieceOf(polygon.top - polygon.bottom));
      point.normal[0] = turn * edge[1] / length;
      point.normal[1] = -turn * edge[0] / length;
      along(length, spacing,
            [&](double s)
            {
              point.x[0] = a[0] + s * edge[0];
              point.x[1] = a[1] + s * edge[1];
              if constexpr (D == 2)
                points.push_back(point);
              else
                along(polygon.top - polygon.bottom, spacing,
                      [&](double t)
                      {
                        point.x[2] = polygon.bottom + t * (polygon.top - polygon.bottom);
                        points.push_back(point);
                      });
            });
    }
    if constexpr (D == 3)
      addEnds(polygon);
  }

  /// Points that stand for the pieces of a surface that are near each other and look the same way, as files
  /// have them in any order and size.
  void operator()(const FileShape<D>& shape)
  {
    const Simplices<D>& surface = shape.solid->surface();
    Pieces<D> pieces(spacing);
    for (int k = 0; k < static_cast<int>(surface.items.size()); ++k)
    {
      Vector<D> corner[D];
      surface.corners(k, corner);
      for (Vector<D>& x : corner)
        x = shape.origin + shape.scale * x;
      const Vector<D> normal = surface.normalOf(k);
      const double length = norm(normal);
      const double size = (D == 2 ? 1.0 : 0.5) * length * std::pow(shape.scale, D - 1);
      if (size > 0.0)
        pieces.addDivided(corner, (1.0 / length) * normal, size);
    }
    pieces.gather(points);
  }

  /// The same of the faces between voxels of the value and others.
  void operator()(const VoxelShape<D>& shape)
  {
    const int across = countOf(shape.size, spacing, 1);
    const Bounds<D>& bounds = shape.phase->bounds();
    std::int64_t first[3] = {}, last[3] = {1, 1, 1};
    for (int d = 0; d < D; ++d)
    {
      first[d] = static_cast<std::int64_t>(bounds.lower[d]);
      last[d] = static_cast<std::int64_t>(bounds.upper[d]);
    }
    Pieces<D> pieces(spacing);
    typename VoxelPhase<D>::Index voxel;
    for (std::int64_t i = first[0]; i < last[0]; ++i)
      for (std::int64_t j = first[1]; j < last[1]; ++j)
        for (std::int64_t k = first[2]; k < last[2]; ++k)
        {
          const std::int64_t at[3] = {i, j, k};
          std::copy(at, at + D, voxel.begin());
          if (!shape.phase->has(voxel))
            continue;
          for (int axis = 0; axis < D; ++axis)
            for (const int side : {-1, 1})
            {
              auto next = voxel;
              next[axis] += side;
              if (!shape.phase->has(next))
                addFace(shape, voxel, axis, side, across, pieces);
            }
        }
    pieces.gather(points);
  }

  void addFace(const VoxelShape<D>& shape, const typename VoxelPhase<D>::Index& voxel, int axis, int side,
               int across, Pieces<D>& pieces)
  {
    const double size = std::pow(shape.size / across, D - 1);
    for (int k = 0; k < (D == 2 ? across : across * across); ++k)
    {
      Vector<D> x{}, normal{};
      for (int d = 0, rest = k; d < D; ++d)
      {
        x[d] = static_cast<double>(voxel[d]) +
               (d == axis ? (side > 0 ? 1.0 : 0.0) : (rest % across + 0.5) / across);
        rest = d == axis ? rest : rest / across;
      }
      normal[axis] = side;
      pieces.add({shape.corner + shape.size * x, normal, size});
    }
  }

  void addEnds(const Polygon<D>& polygon)
  {
    Bounds<2> bounds = emptyBounds<2>();
    for (const Vector<2>& x : polygon.points)
      bounds.include(x);
    const Vector<2> extent = bounds.upper - bounds.lower;
    const std::size_t first = points.size();
    along(extent[0], spacing,
          [&](double s)
          {
            along(extent[1], spacing,
                  [&](double t)
                  {
                    Vector<D> x{};
                    x[0] = bounds.lower[0] + s * extent[0];
                    x[1] = bounds.lower[1] + t * extent[1];
                    for (const double side : {-1.0, 1.0})
                    {
                      x[D - 1] = side < 0.0 ? polygon.bottom : polygon.top;
                      Vector<D> normal{};
                      normal[D - 1] = side;
                      if (polygon.contains(x))
                        points.push_back({x, normal, 0.0});
                    }
                  });
          });
    const double both = 2.0 * std::abs(signedArea(polygon.points));
    for (std::size_t k = first; k < points.size(); ++k)
      points[k].size = both / (points.size() - first);
  }
};

} // namespace

template <int D>
std::vector<SurfacePoint<D>> surfacePoints(const Shape<D>& shape, std::size_t part, double spacing)
{
  const Part<D>& one = shape.parts()[part];
  Sampler<D> sampler{spacing};
  std::visit(sampler, one.primitive);
  const double aside = 1e-6 * spacing;
  Points<D> found;
  for (const SurfacePoint<D>& own : sampler.points)
  {
    SurfacePoint<D> point{one.frame.toSpace(own.x), Vector<D>{}, own.size};
    for (int e = 0; e < D; ++e)
      point.normal = point.normal + own.normal[e] * one.frame.axes[e];
    const bool behind = shape.contains(point.x - aside * point.normal);
    if (behind == shape.contains(point.x + aside * point.normal))
      continue;
    if (!behind)
      point.normal = -1.0 * point.normal;
    found.push_back(point);
  }
  return found;
}

template std::vector<SurfacePoint<2>> surfacePoints(const Shape<2>&, std::size_t, double);
template std::vector<SurfacePoint<3>> surfacePoints(const Shape<3>&, std::size_t, double);

} // namespace Rhegma::Geometry
