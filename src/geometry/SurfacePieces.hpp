#pragma once
/// Many small pieces of a surface, gathered to points.

#include "geometry/SurfacePoints.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace Rhegma::Geometry
{

/// Pieces of a surface in any order and of any size, of which those in a cube of the spacing that look the
/// same way become one point: all of their area, at the piece that is nearest to their centroid, so that it
/// lies on the surface. Areas and resultants do not depend on the order or number of the pieces.
template <int D>
class Pieces
{
public:
  /// \param spacing edge of the cubes [m]
  explicit Pieces(double spacing) : spacing_(spacing) {}

  /// Adds a piece that is no longer than the spacing.
  void add(const SurfacePoint<D>& piece)
  {
    Piece one{piece, {}};
    for (int d = 0; d < D; ++d)
    {
      one.key[d] = static_cast<std::int64_t>(std::floor(piece.x[d] / spacing_));
      one.key[D + d] = static_cast<std::int64_t>(std::lround(directions * piece.normal[d]));
    }
    pieces_.push_back(one);
  }

  /// Adds a segment (2D) or triangle (3D), in halves of halves that are no longer than the spacing. \param
  /// size its length or area [m^(D-1)]
  void addDivided(const Vector<D> (&corner)[D], const Vector<D>& normal, double size)
  {
    int from = 0, to = 1;
    double longest = 0.0;
    for (int i = 0; i < D; ++i)
      for (int j = i + 1; j < D; ++j)
        if (const double length = norm(corner[j] - corner[i]); length > longest)
        {
          longest = length;
          from = i;
          to = j;
        }
    if (longest > spacing_)
    {
      const Vector<D> middle = 0.5 * (corner[from] + corner[to]);
      for (const int moved : {from, to})
      {
        Vector<D> half[D];
        std::copy(corner, corner + D, half);
        half[moved] = middle;
        addDivided(half, normal, 0.5 * size);
      }
      return;
    }
    Vector<D> centre{};
    for (const Vector<D>& x : corner)
      centre = centre + (1.0 / D) * x;
    add({centre, normal, size});
  }

  /// Appends the points. \param points those found so far
  void gather(std::vector<SurfacePoint<D>>& points)
  {
    std::stable_sort(pieces_.begin(), pieces_.end(),
                     [](const Piece& a, const Piece& b) { return a.key < b.key; });
    for (std::size_t begin = 0, end = 0; begin < pieces_.size(); begin = end)
    {
      while (end < pieces_.size() && pieces_[end].key == pieces_[begin].key)
        ++end;
      points.push_back(pointOf(begin, end));
    }
  }

private:
  static constexpr double directions = 4.0; ///< normals that differ by less than a quarter are alike

  struct Piece
  {
    SurfacePoint<D> point;
    std::array<std::int64_t, 2 * D> key; ///< cube and direction
  };

  SurfacePoint<D> pointOf(std::size_t begin, std::size_t end) const
  {
    SurfacePoint<D> sum{Vector<D>{}, Vector<D>{}, 0.0};
    for (std::size_t k = begin; k < end; ++k)
    {
      const SurfacePoint<D>& piece = pieces_[k].point;
      sum.x = sum.x + piece.size * piece.x;
      sum.normal = sum.normal + piece.size * piece.normal;
      sum.size += piece.size;
    }
    const Vector<D> centroid = (1.0 / sum.size) * sum.x;
    const auto nearest = std::min_element(pieces_.begin() + begin, pieces_.begin() + end,
                                          [&](const Piece& a, const Piece& b) {
                                            return norm(a.point.x - centroid) < norm(b.point.x - centroid);
                                          });
    return {nearest->point.x, (1.0 / norm(sum.normal)) * sum.normal, sum.size};
  }

  double spacing_; ///< [m]
  std::vector<Piece> pieces_;
};

} // namespace Rhegma::Geometry
