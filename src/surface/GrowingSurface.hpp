#pragma once
/// A crack surface whose fronts advance.

#include "surface/CrackMesh.hpp"
#include "surface/FrontLines.hpp"

#include <array>
#include <vector>

namespace Rhegma::surface
{

/// One growing crack. Triangles keep their orientation, and each function returns the area that it adds, to
/// rounding.
class GrowingSurface
{
public:
  std::vector<Vector<3>> vertices;
  std::vector<std::array<Vector<3>, 2>> faces;
  std::vector<std::array<int, 3>> triangles;

  /// Lists the triangles at each vertex. Call before all functions below.
  void prepare();

  /// Advances the k-th point of the lines to x: moves its vertex, or adds a new one if the triangles would
  /// become longer than `row` or turn by more than ten degrees.
  /// \return the added area [m2]
  double advance(FrontLines<3>& lines, std::size_t k, const Vector<3>& x, double row);

  /// Moves a vertex with its triangles. \return the added area [m2]
  double shift(int vertex, const Vector<3>& by);

  /// Splits the piece that begins at the k-th point in the middle; the new point gets `name`.
  void split(FrontLines<3>& lines, std::size_t k, int name);

  /// Collapses the piece that begins at the k-th point to its middle, or to an end of the line, unless that
  /// would invert a triangle. \param added added area, usually negative [m2] \return whether it was done
  bool collapse(FrontLines<3>& lines, std::size_t k, double& added);

  /// Length of the piece that begins at the k-th point [m].
  double pieceAt(const FrontLines<3>& lines, std::size_t k) const;

  /// Removes unused vertices and triangles, and updates the numbers in the lines.
  void tidy(const std::vector<FrontLines<3>*>& lines);

  /// The mesh of the surface. Edges in the lines are fronts, the rest of the border is surface-breaking.
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
