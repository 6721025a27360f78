#pragma once
/// How much the stress alternates from particle to particle.

#include "state/State.hpp"

namespace Rhegma::measure
{

struct StressAlternation
{
  double deviation = 0.0; ///< root mean square, over the volume of a body, of what alternates [Pa]
  double largest = 0.0;   ///< largest mean stress around a node [Pa]

  /// NaN where there is no stress.
  double ratio() const { return deviation / largest; }
};

/// The part of the particles' stress that changes from particle to particle within the cells.
///
/// A linear function is fitted to the stress of the particles around each node, weighted by volume and shape
/// function: over the cells that meet at the node, on one side of a crack where the node has two fields. (In
/// a single cell two rows of particles would fit any linear function.) What alternates is the stress of a
/// particle less the mean of the functions of its nodes, weighted by their shape functions; zero where the
/// stress is linear. Sizes of stress are Frobenius norms, in 2D with the stress across the plane.
///
/// The field of a crack front, which no linear function fits, is part of the deviation: compare runs in the
/// same cells. Collective. Source of the patches: Zienkiewicz and Zhu, Int. J. Numer. Meth. Eng. 33 (1992)
/// 1331.
/// \param body only its particles count
template <int D>
StressAlternation stressAlternation(const State<D>& state, int body);

} // namespace Rhegma::measure
