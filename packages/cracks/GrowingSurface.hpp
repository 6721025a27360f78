#pragma once
/// A crack surface while its fronts move on.

#include "cracks/CrackMesh.hpp"

#include <array>
#include <utility>
#include <vector>

namespace Rhegma::cracks
{

/// A vertex on a front.
struct LinePoint
{
  int vertex;             ///< of the surface
  int name, from;         ///< FrontNode
  bool joined = false;    ///< a piece of front runs from it to the next
  bool landed = false;    ///< it has reached the surface of the body
  double toughness = 0.0; ///< of the last face that it made [J/m2]
  FrontNode<3> node{};    ///< what it was before
};

/// The pieces of a front, one line after another; closed where the last point is joined to the first.
using FrontLines = std::vector<LinePoint>;

/// One crack, with what it takes to change it. Triangles keep their orientation, and area that is gained or
/// lost is told to the last digit.
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
  double advance(FrontLines& lines, std::size_t k, const Vector<3>& x, double row);

  /// Puts a point in the middle of the piece that begins at the k-th point; its name is `name`.
  void split(FrontLines& lines, std::size_t k, int name);

  /// Makes one point, in their middle or at an end of the line, of the two ends of the piece that begins at
  /// the k-th point, unless that would turn a triangle over. \param added area that this adds, negative as a
  /// rule [m2] \return whether it was done
  bool collapse(FrontLines& lines, std::size_t k, double& added);

  /// Length of the piece that begins at the k-th point [m].
  double pieceAt(const FrontLines& lines, std::size_t k) const;

  /// Leaves out what collapses have left, and tells the lines the new numbers.
  void tidy(const std::vector<FrontLines*>& lines);

  /// The surface with what lies beyond its edges: the fronts are those of the lines, the rest of the border
  /// are mouths.
  CrackMesh<3> mesh(const std::vector<const FrontLines*>& lines) const;

  static std::size_t next(const FrontLines& lines, std::size_t k) { return k + 1 < lines.size() ? k + 1 : 0; }

private:
  double areaOf(const std::array<int, 3>& t) const;
  double areaAround(int v) const;
  void addTriangle(const std::array<int, 3>& t);
  std::vector<int> trianglesAt(int a, int b) const;
  int addVertex(const Vector<3>& x);

  std::vector<std::vector<int>> stars_;
};

/// Mean of the toughness of two points, or that of the one that has made a face [J/m2].
double meanToughness(const LinePoint& a, const LinePoint& b);

/// The point before the k-th on its line, or -1.
int before(const FrontLines& lines, std::size_t k);

/// Cuts pieces between points that have reached the surface out of the lines; what has no piece left goes.
void cutLanded(FrontLines& lines);

} // namespace Rhegma::cracks
