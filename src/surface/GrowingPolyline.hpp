#pragma once
/// A polyline while its ends move on.

#include "surface/CrackMesh.hpp"
#include "surface/FrontLines.hpp"

#include <array>
#include <vector>

namespace Rhegma::surface
{

/// One crack in 2D, with what it takes to change it; as GrowingSurface in 3D.
class GrowingPolyline
{
public:
  std::vector<Vector<2>> vertices;
  std::vector<std::array<Vector<2>, 2>> faces;
  std::array<bool, 2> joined{}; ///< whether its first and its last end have ended on another crack

  /// Lists the vertices in their order. Belongs before all that follows.
  void prepare();

  /// The vertices from the first end to the last.
  const std::vector<int>& order() const { return order_; }

  /// Whether a vertex is the first end.
  bool isFirst(int vertex) const { return order_.front() == vertex; }

  /// Adds a segment from the front point to x. \return the given length of it [m]
  double advance(FrontLines<2>& lines, std::size_t k, const Vector<2>& x, double length);

  /// Opening of the crack a distance behind an end [m]. It grows as the root of the distance up to the first
  /// vertex behind.
  double openingBehind(int vertex, double distance) const;

  /// Puts the vertices in their order, and gives the lines the new numbers.
  void tidy(const std::vector<FrontLines<2>*>& lines);

  /// The segments, with what lies beyond both ends: the fronts are those of the lines.
  CrackMesh<2> mesh(const std::vector<const FrontLines<2>*>& lines) const;

private:
  std::vector<int> order_;
};

} // namespace Rhegma::surface
