#pragma once
/// Points along the faces of cracks, for contact and pressure between the faces.

#include "state/State.hpp"

namespace Rhegma
{

class Archive;

/// Points on the segments (2D) or triangles (3D) of all cracks, about half a cell apart, with a stencil on
/// each face: the middles of equal pieces, so that sums over them are midpoint rules.
///
/// A point is fixed to a position on its simplex. Its two faces lie on the normal through that position, half
/// the separation of the faces away on either side (linear between vertices, and behind a front as the root
/// of the distance; together while they touch), so that opposite forces on them have no moment, however far
/// the faces have slid. Points one of whose faces has no node with mass (at a surface-breaking end) have no
/// stencil on either side, so that forces between faces stay in balance.
///
/// All ranks have all points. The stencil of a face is on the rank that owns its position: sums over stencils
/// must be added over the ranks.
template <int D>
class FacePoints
{
public:
  /// Moves the points with the cracks and makes the stencils for this step; needs the masses of the nodes. If
  /// the simplices of the cracks have changed, all points are placed anew. Collective.
  /// \return true if they were; `before` is then the earlier point whose data each point may take, `after`
  /// the new point that may take the data of each earlier point
  bool update(const State<D>& state);

  int count() const { return count_; }
  const View<int*>& simplex() const { return simplex_; }      ///< simplex of each point
  const View<double*>& fraction() const { return fraction_; } ///< of the simplex's size that each stands for

  /// Saves or loads the points; stencils are made by the next update.
  void serialize(Archive& archive);

  /// Part of `update`; public because compilers for devices want kernels in public functions.
  void moveWithCracks(const CrackSet<D>& cracks, bool inCells);

  View<int*> crack;           ///< crack of each point
  View<double*> size;         ///< undeformed length or area of crack that each point stands for [m, m2]
  View<double*> currentSize;  ///< the same now [m, m2]
  View<double* [D]> position; ///< midway between the faces [m]
  View<double* [D]> normal;   ///< unit normal from side -1 to side +1, now
  View<double* [D]> edge;     ///< unit vector along the first edge of the simplex, now
  View<double*> separation;   ///< of the faces along the normal, negative where they overlap [m]
  StencilTable<D> below;      ///< on side -1; no entries where a point is left out or another rank's
  StencilTable<D> above;      ///< on side +1
  View<int*> acts;            ///< 0 where a point is left out
  View<int*> before;          ///< earlier point at the same position, or -1
  View<int*> after;           ///< of each earlier point, the new one at the same position, or -1

private:
  void place(const CrackSet<D>& cracks, double spacing);
  void reserveRows(int count);

  View<int*> simplex_;
  View<double* [D]> weight_; ///< of the simplex's vertices at the point
  View<double*> fraction_;   ///< of the simplex's size
  View<double*> reached_;    ///< of each point, below and above, whether the face has a node with mass
  ObservedPoints<D> lower_, upper_;
  int count_ = 0;
  int simplices_ = -1;
  double required_ = 0.0; ///< energy of new faces when the points were placed [J]
  double spacing_ = 0.0;  ///< of the smallest cells when the points were placed [m]
};

/// Unit tangents of a face: in 2D along the direction of the crack; in 3D the edge of its simplex and a
/// vector at a right angle to it, which rotate with it.
KOKKOS_INLINE_FUNCTION Vector<2> faceTangent(const Vector<2>& normal, const Vector<2>&, int)
{
  return {normal[1], -normal[0]};
}

KOKKOS_INLINE_FUNCTION Vector<3> faceTangent(const Vector<3>& n, const Vector<3>& edge, int which)
{
  if (which == 0)
    return edge;
  return {n[1] * edge[2] - n[2] * edge[1], n[2] * edge[0] - n[0] * edge[2], n[0] * edge[1] - n[1] * edge[0]};
}

/// Unit tangents of a point.
template <int D>
KOKKOS_INLINE_FUNCTION Vector<D> tangentOf(const FacePoints<D>& points, int k, int which)
{
  Vector<D> normal, edge;
  for (int d = 0; d < D; ++d)
  {
    normal[d] = points.normal(k, d);
    edge[d] = points.edge(k, d);
  }
  return faceTangent(normal, edge, which);
}

/// Jump of a nodal velocity (its first D columns) from side -1 to side +1 at point k.
template <int D, class Velocity>
KOKKOS_INLINE_FUNCTION Vector<D> jumpAt(const StencilTable<D>& below, const StencilTable<D>& above, int k,
                                        const Velocity& velocity)
{
  Vector<D> jump{};
  for (int e = 0; e < above.count(k); ++e)
    for (int d = 0; d < D; ++d)
      jump[d] += above.weight(k, e) * velocity(above.node(k, e), d);
  for (int e = 0; e < below.count(k); ++e)
    for (int d = 0; d < D; ++d)
      jump[d] -= below.weight(k, e) * velocity(below.node(k, e), d);
  return jump;
}

/// Forces of nodes in a step, called as a view of a row a node.
template <int D>
struct StepForces
{
  Nodes<D> nodes;
  KOKKOS_INLINE_FUNCTION double& operator()(int node, int axis) const
  {
    return nodes.sums(node, Nodes<D>::forceAt + axis);
  }
};

/// Adds a force [N] to the nodes of the face of side +1 at point k, and its opposite to those of side -1.
/// \param force of nodes: StepForces, or a view of a row a node
template <int D, class Force>
KOKKOS_INLINE_FUNCTION void addFaceForces(const Force& force, const StencilTable<D>& below,
                                          const StencilTable<D>& above, int k, const Vector<D>& onUpper)
{
  for (int e = 0; e < above.count(k); ++e)
    for (int d = 0; d < D; ++d)
      Kokkos::atomic_add(&force(above.node(k, e), d), above.weight(k, e) * onUpper[d]);
  for (int e = 0; e < below.count(k); ++e)
    for (int d = 0; d < D; ++d)
      Kokkos::atomic_add(&force(below.node(k, e), d), -below.weight(k, e) * onUpper[d]);
}

} // namespace Rhegma
