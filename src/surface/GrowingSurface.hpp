#pragma once
/// A crack surface while its fronts move on.

#include "surface/CrackMesh.hpp"
#include "surface/FrontLines.hpp"

#include <array>
#include <vector>

namespace Rhegma::surface
{

/// One crack, with what it takes to change it. Triangles keep their orientation, and each function returns
/// the area that it adds, to rounding.
class GrowingSurface
{
public:
  std::vector<Vector<3>> vertices;
  std::vector<std::array<Vector<3>, 2>> faces;
  std::vector<std::array<int, 3>> triangles;

  /// Lists which triangles are at each vertex. Belongs before all that follows.
  void prepare();

  /// Takes the k-th point of the lines to x: moves its vertex, whose triangles stretch, or, where these would
  /// become longer than `row` or turn by more than ten degrees, puts a new vertex there.
  /// \return the area that this adds [m2]
  double advance(FrontLines<3>& lines, std::size_t k, const Vector<3>& x, double row);

  /// Puts a point in the middle of the piece that begins at the k-th point; its name is `name`.
  void split(FrontLines<3>& lines, std::size_t k, int name);

  /// Makes one point, in their middle or at an end of the line, of the two ends of the piece that begins at
  /// the k-th point, unless that would turn a triangle over. \param added area that this adds, negative as a
  /// rule [m2] \return whether it was done
  bool collapse(FrontLines<3>& lines, std::size_t k, double& added);

  /// Length of the piece that begins at the k-th point [m].
  double pieceAt(const FrontLines<3>& lines, std::size_t k) const;

  /// Leaves out what collapses have left, and gives the lines the new numbers.
  void tidy(const std::vector<FrontLines<3>*>& lines);

  /// The surface with what lies beyond its edges: the fronts are those of the lines, the rest of the border
  /// is surface-breaking.
  CrackMesh<3> mesh(const std::vector<const FrontLines<3>*>& lines) const;

private:
  double areaOf(const std::array<int, 3>& t) const;
  double areaAround(int v) const;
  void addTriangle(const std::array<int, 3>& t);
  std::vector<int> trianglesAt(int a, int b) const;
  int addVertex(const Vector<3>& x);

  bool mayMerge(int a, int b, const Vector<3>& x, int shared) const;

  std::vector<std::vector<int>> stars_; ///< triangles at each vertex
};

} // namespace Rhegma::surface
