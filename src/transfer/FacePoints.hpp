#pragma once
/// Points along the faces of cracks, for what acts between the faces: contact, pressure.

#include "state/State.hpp"

namespace Rhegma
{

/// Points on the segments of all cracks, about half a cell apart, with a stencil on each face.
///
/// A point is fixed to a place on its segment. Its two faces lie on the normal through that place, half the
/// separation of the faces away on either side, so that opposite forces on them have no moment, however far
/// the faces have slid. Points whose face meets no node with mass (at a mouth) have no stencil on either
/// side: what acts between faces stays in balance.
class FacePoints
{
public:
  /// Follows the cracks and makes the stencils for this step; needs the masses of the nodes. Where the pieces
  /// of a crack have changed, its points are placed anew.
  /// \return true when they were; `before` then tells from which earlier point each may inherit
  bool update(const State<2>& state);

  int count() const { return count_; }

  View<int*> crack;            ///< crack of each point
  View<double*> length;        ///< undeformed length of crack that each point stands for [m]
  View<double*> currentLength; ///< the same now [m]
  View<double* [2]> position;  ///< midway between the faces [m]
  View<double* [2]> normal;    ///< unit normal from side -1 to side +1, now
  View<double*> separation;    ///< of the faces along the normal, negative where they overlap [m]
  StencilTable<2> below;       ///< on side -1; no entries where a point is left out
  StencilTable<2> above;       ///< on side +1
  View<int*> before;           ///< earlier point in the same place, or -1

private:
  void place(const CrackSet<2>& cracks, double spacing);
  void follow(const CrackSet<2>& cracks);

  View<int*> segment_;
  View<double*> along_; ///< place on the segment, 0 to 1
  View<double*> share_; ///< of the segment's length
  ObservedPoints<2> lower_, upper_;
  int count_ = 0;
  int segments_ = -1;
};

/// The tangent t of a point with normal n: side +1 slides along t when the crack's own direction is t.
KOKKOS_INLINE_FUNCTION Vector<2> tangentOf(const Vector<2>& normal) { return {normal[1], -normal[0]}; }

/// Jump of a nodal velocity (its first two columns) from side -1 to side +1 at point k.
template <class Velocity>
KOKKOS_INLINE_FUNCTION Vector<2> jumpAt(const StencilTable<2>& below, const StencilTable<2>& above, int k,
                                        const Velocity& velocity)
{
  Vector<2> jump{0.0, 0.0};
  for (int e = 0; e < above.count(k); ++e)
    for (int d = 0; d < 2; ++d)
      jump[d] += above.weight(k, e) * velocity(above.node(k, e), d);
  for (int e = 0; e < below.count(k); ++e)
    for (int d = 0; d < 2; ++d)
      jump[d] -= below.weight(k, e) * velocity(below.node(k, e), d);
  return jump;
}

/// Adds a force [N] to the nodes of one face at point k.
KOKKOS_INLINE_FUNCTION void addFaceForce(const Nodes<2>& nodes, const StencilTable<2>& face, int k,
                                         const Vector<2>& force)
{
  for (int e = 0; e < face.count(k); ++e)
    for (int d = 0; d < 2; ++d)
      Kokkos::atomic_add(&nodes.sums(face.node(k, e), Nodes<2>::forceAt + d), face.weight(k, e) * force[d]);
}

} // namespace Rhegma
