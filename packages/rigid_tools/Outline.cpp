#include "rigid_tools/Outline.hpp"

#include <cmath>
#include <variant>

namespace Rhegma::rigid_tools
{

namespace
{

using namespace Geometry;

constexpr double tau = 6.283185307179586477;
constexpr int aroundDisk = 64, aroundBall = 32;
constexpr int piecesOfEdge = 32; ///< of a straight edge in 2D, and of an edge of a face in 3D divided by four

/// Adds the outlines of primitives in their own coordinates.
template <int D>
struct AddOutline
{
  ToolOutline<D>& outline;

  void operator()(const Box<D>& box) const
  {
    const auto corners = box.corners.corners();
    if constexpr (D == 2)
      for (const auto& [a, b] : {std::pair{0, 1}, {1, 3}, {3, 2}, {2, 0}})
        line(corners[a], corners[b]);
    else
      for (int d = 0; d < 3; ++d)
        for (int side = 0; side < 2; ++side)
        {
          const int a = 1 << ((d + 1) % 3), b = 1 << ((d + 2) % 3), from = side << d;
          face(corners[from], corners[from + a] - corners[from], corners[from + b] - corners[from]);
        }
  }

  void operator()(const Ball<D>& ball) const
  {
    if constexpr (D == 2)
      closed(
          [&](double angle) {
            return ball.centre + ball.radius * Vector<2>{{std::cos(angle), std::sin(angle)}};
          });
    else
      grid(aroundBall, aroundBall / 2,
           [&](double u, double v)
           {
             const double around = tau * u, up = 0.5 * tau * v;
             return ball.centre + ball.radius * Vector<3>{{std::sin(up) * std::cos(around),
                                                           std::sin(up) * std::sin(around), std::cos(up)}};
           });
  }

  void operator()(const Cylinder<D>& cylinder) const
  {
    if constexpr (D == 3)
    {
      const Vector<3> axis = cylinder.to - cylinder.from;
      int least = 0;
      for (int d = 1; d < 3; ++d)
        least = std::fabs(axis[d]) < std::fabs(axis[least]) ? d : least;
      Vector<3> first = -axis[least] / dot(axis, axis) * axis, second;
      first[least] += 1.0;
      first = cylinder.radius / norm(first) * first;
      for (int d = 0; d < 3; ++d)
        second[d] =
            (axis[(d + 1) % 3] * first[(d + 2) % 3] - axis[(d + 2) % 3] * first[(d + 1) % 3]) / norm(axis);
      const auto rim = [&](double u) { return std::cos(tau * u) * first + std::sin(tau * u) * second; };
      grid(aroundBall, piecesOfEdge / 4,
           [&](double u, double v) { return cylinder.from + v * axis + rim(u); });
      for (const Vector<3>& end : {cylinder.from, cylinder.to})
        grid(aroundBall, piecesOfEdge / 4, [&](double u, double v) { return end + v * rim(u); });
    }
  }

  void operator()(const Polygon<D>& polygon) const
  {
    const std::size_t count = polygon.points.size();
    for (std::size_t k = 0; k < count; ++k)
    {
      const Vector<2>&a = polygon.points[k], &b = polygon.points[(k + 1) % count];
      if constexpr (D == 2)
        line(a, b);
      else
        face({{a[0], a[1], polygon.bottom}}, {{b[0] - a[0], b[1] - a[1], 0.0}},
             {{0.0, 0.0, polygon.top - polygon.bottom}});
    }
  }

  void operator()(const FileShape<D>& shape) const
  {
    const auto& surface = shape.solid->surface();
    const int before = static_cast<int>(outline.points.size());
    for (const Vector<D>& point : surface.points)
      outline.points.push_back(shape.origin + shape.scale * point);
    for (std::array<int, D> item : surface.items)
    {
      for (int& corner : item)
        corner += before;
      outline.cells.push_back(item);
    }
  }

  void operator()(const VoxelShape<D>&) const {}

private:
  void line(const Vector<2>& a, const Vector<2>& b) const
  {
    for (int k = 0; k < piecesOfEdge; ++k)
      piece(a + (double(k) / piecesOfEdge) * (b - a), a + (double(k + 1) / piecesOfEdge) * (b - a));
  }

  template <class Curve>
  void closed(const Curve& curve) const
  {
    for (int k = 0; k < aroundDisk; ++k)
      piece(curve(tau * k / aroundDisk), curve(tau * (k + 1) / aroundDisk));
  }

  void piece(const Vector<2>& a, const Vector<2>& b) const
  {
    const int first = static_cast<int>(outline.points.size());
    outline.points.insert(outline.points.end(), {a, b});
    outline.cells.push_back({first, first + 1});
  }

  void face(const Vector<3>& corner, const Vector<3>& a, const Vector<3>& b) const
  {
    grid(piecesOfEdge / 4, piecesOfEdge / 4, [&](double u, double v) { return corner + u * a + v * b; });
  }

  /// Triangles of a surface with parameters from 0 to 1.
  template <class Surface>
  void grid(int across, int up, const Surface& surface) const
  {
    const int first = static_cast<int>(outline.points.size());
    for (int i = 0; i <= across; ++i)
      for (int j = 0; j <= up; ++j)
        outline.points.push_back(surface(double(i) / across, double(j) / up));
    for (int i = 0; i < across; ++i)
      for (int j = 0; j < up; ++j)
      {
        const int a = first + i * (up + 1) + j, b = a + up + 1;
        outline.cells.push_back({a, b, b + 1});
        outline.cells.push_back({a, b + 1, a + 1});
      }
  }
};

template <int D>
Vector<D> middleOf(const ToolOutline<D>& outline, const std::array<int, D>& cell)
{
  Vector<D> middle{};
  for (const int point : cell)
    middle = middle + (1.0 / D) * outline.points[point];
  return middle;
}

} // namespace

template <int D>
ToolOutline<D> outlineOf(const Shape<D>& shape)
{
  ToolOutline<D> whole;
  const auto bounds = shape.bounds();
  for (const Part<D>& part : shape.parts())
  {
    ToolOutline<D> own;
    const AddOutline<D> add{own};
    std::visit(add, part.primitive);
    for (Vector<D>& point : own.points)
      point = part.frame.toSpace(point);
    const int before = static_cast<int>(whole.points.size());
    for (std::array<int, D> cell : own.cells)
    {
      // A chord of a round part lies inside of it.
      const double chord = norm(own.points[cell[0]] - own.points[cell[1]]);
      if (shape.parts().size() > 1 && std::fabs(shape.depth(middleOf<D>(own, cell))) >
                                          0.1 * chord + 1e-9 * norm(bounds.upper - bounds.lower))
        continue;
      for (int& point : cell)
        point += before;
      whole.cells.push_back(cell);
    }
    whole.points.insert(whole.points.end(), own.points.begin(), own.points.end());
  }
  return whole;
}

template ToolOutline<2> outlineOf(const Shape<2>&);
template ToolOutline<3> outlineOf(const Shape<3>&);

} // namespace Rhegma::rigid_tools
