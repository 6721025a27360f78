#pragma once
/// A polyline whose ends advance.

#include "surface/CrackMesh.hpp"
#include "surface/FrontLines.hpp"

#include <array>
#include <vector>

namespace Rhegma::surface
{

/// One growing crack in 2D; the counterpart of GrowingSurface in 3D.
class GrowingPolyline
{
public:
  std::vector<Vector<2>> vertices;
  std::vector<std::array<Vector<2>, 2>> faces;
  std::array<bool, 2> joined{}; ///< whether its first and its last end have met another crack

  /// Lists the vertices in their order. Call before all functions below.
  void prepare();

  /// The vertices from the first end to the last.
  const std::vector<int>& order() const { return order_; }

  /// Whether a vertex is the first end.
  bool isFirst(int vertex) const { return order_.front() == vertex; }

  /// Adds a segment from the front point to x. \return the given length of it [m]
  double advance(FrontLines<2>& lines, std::size_t k, const Vector<2>& x, double length);

  /// Opening of the crack a distance behind an end [m]. Up to the first vertex behind it is proportional to
  /// the square root of the distance.
  double openingBehind(int vertex, double distance) const;

  /// Sorts the vertices along the crack, and updates the numbers in the lines.
  void tidy(const std::vector<FrontLines<2>*>& lines);

  /// The mesh of segments. Ends in the lines are fronts.
  CrackMesh<2> mesh(const std::vector<const FrontLines<2>*>& lines) const;

private:
  std::vector<int> order_;
};

} // namespace Rhegma::surface
