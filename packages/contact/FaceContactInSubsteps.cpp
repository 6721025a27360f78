/// Contact of faces whose nodes move in substeps.

#include "contact/FaceContact.hpp"
#include "transfer/FaceTractions.hpp"

namespace Rhegma::contact
{

namespace
{

/// Whether all nodes of a point move in substeps. Open faces may lie on two ranks, each of which knows one
/// face: such points are handled at the next step.
template <int D>
KOKKOS_INLINE_FUNCTION bool allNodesMove(const FacePoints<D>& points, const NodeSlots& slots, int k)
{
  for (int e = 0; e < points.above.count(k); ++e)
    if (!slots.moves(points.above.node(k, e)))
      return false;
  for (int e = 0; e < points.below.count(k); ++e)
    if (!slots.moves(points.below.node(k, e)))
      return false;
  return points.above.count(k) > 0 && points.below.count(k) > 0;
}

/// Adds a force [N] on one face of a point to the nodes of it that move in substeps.
template <int D>
KOKKOS_INLINE_FUNCTION void addToSlots(const StencilTable<D>& face, const NodeSlots& slots, int k,
                                       const Vector<D>& force, const View<double* [D]>& forces)
{
  for (int e = 0; e < face.count(k); ++e)
    if (slots.moves(face.node(k, e)))
      for (int d = 0; d < D; ++d)
        Kokkos::atomic_add(&forces(slots.of(face.node(k, e)), d), face.weight(k, e) * force[d]);
}

/// Movement of side +1 against side -1 at a point all of whose nodes move in substeps.
template <int D>
KOKKOS_INLINE_FUNCTION Vector<D> jumpOfSlots(const FacePoints<D>& points, const NodeSlots& slots, int k,
                                             const View<double* [D]>& displacement)
{
  Vector<D> jump{};
  for (int e = 0; e < points.above.count(k); ++e)
    for (int d = 0; d < D; ++d)
      jump[d] += points.above.weight(k, e) * displacement(slots.of(points.above.node(k, e)), d);
  for (int e = 0; e < points.below.count(k); ++e)
    for (int d = 0; d < D; ++d)
      jump[d] -= points.below.weight(k, e) * displacement(slots.of(points.below.node(k, e)), d);
  return jump;
}

} // namespace

template <int D>
void FaceContact<D>::addFrozenForces(const State<D>&, const NodeSlots& slots,
                                     const View<double* [D]>& force) const
{
  const FacePoints<D> points = points_;
  const View<double*> pressure = pressure_;
  const View<double * [D - 1]> shear = shear_;
  const double thickness = thickness_;
  forEachPushing(
      "rhegma::contact::frozenForces", points.count(), KOKKOS_LAMBDA(const int k) {
        if (pressure(k) == 0.0 || allNodesMove(points, slots, k))
          return;
        const Vector<D> onUpper = (points.size(k) * thickness) * tractionAt(points, pressure, shear, k);
        addToSlots<D>(points.above, slots, k, onUpper, force);
        addToSlots<D>(points.below, slots, k, -1.0 * onUpper, force);
      });
}

template <int D>
void FaceContact<D>::addChange(const State<D>&, const NodeSlots& slots, const View<double* [D]>& displacement,
                               const View<double* [D]>& force) const
{
  const FacePoints<D> points = points_;
  const View<double*> gap = gap_, pressure = pressure_;
  const View<double * [D - 1]> slip = slip_, shear = shear_;
  const View<Stiffness*> stiffness = stiffness_;
  const Law law = law_;
  const double friction = friction_, thickness = thickness_;
  forEachPushing(
      "rhegma::contact::changeOfContact", points.count(), KOKKOS_LAMBDA(const int k) {
        if (!allNodesMove(points, slots, k))
          return;
        const Vector<D> jump = jumpOfSlots(points, slots, k, displacement);
        double opening = gap(k);
        for (int d = 0; d < D; ++d)
          opening += jump[d] * points.normal(k, d);
        if (opening >= 0.0 && pressure(k) == 0.0)
          return;
        Vector<D - 1> moved, before, elastic;
        for (int t = 0; t < D - 1; ++t)
        {
          moved[t] = dot(jump, tangentOf(points, k, t));
          before[t] = shear(k, t);
          elastic[t] = slip(k, t);
        }
        const Return<D - 1> now = returnMap(law, friction, stiffness(points.crack(k)), opening, gap(k) < 0.0,
                                            moved, elastic, before);
        Vector<D> onUpper;
        for (int d = 0; d < D; ++d)
          onUpper[d] = (now.pressure - pressure(k)) * points.normal(k, d);
        for (int t = 0; t < D - 1; ++t)
          onUpper = onUpper - (now.shear[t] - shear(k, t)) * tangentOf(points, k, t);
        onUpper = (points.size(k) * thickness) * onUpper;
        addToSlots<D>(points.above, slots, k, onUpper, force);
        addToSlots<D>(points.below, slots, k, -1.0 * onUpper, force);
      });
}

// FaceContact.cpp instantiates the rest of the class. Where both files are compiled as one it must come
// first, as it does by its name.
template void FaceContact<2>::addFrozenForces(const State<2>&, const NodeSlots&,
                                              const View<double* [2]>&) const;
template void FaceContact<3>::addFrozenForces(const State<3>&, const NodeSlots&,
                                              const View<double* [3]>&) const;
template void FaceContact<2>::addChange(const State<2>&, const NodeSlots&, const View<double* [2]>&,
                                        const View<double* [2]>&) const;
template void FaceContact<3>::addChange(const State<3>&, const NodeSlots&, const View<double* [3]>&,
                                        const View<double* [3]>&) const;

} // namespace Rhegma::contact
