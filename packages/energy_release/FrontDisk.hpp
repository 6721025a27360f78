#pragma once
/// The particles in a disk round a front in 2D, taken together.

#include "energy_release/CrackTipFields.hpp"
#include "energy_release/DomainIntegral.hpp"
#include "transfer/ParticleViews.hpp"

namespace Rhegma::energy_release
{

/// Mean motion and material of the disk.
struct FrontDisk
{
  double cosine = 1.0, sine = 0.0; ///< of its mean turn
  Vector<2> velocity{{0.0, 0.0}};  ///< mean [m/s]
  Vector<2> position{{0.0, 0.0}};  ///< mean [m]
  Vector<2> reference{{0.0, 0.0}}; ///< mean before deformation [m]
  bool empty = true;               ///< no particle lies in it
  TipModuli moduli;
  double effectiveModulus; ///< [Pa]
  double traceFactor;      ///< trace of Williams' stress over that of its part in the plane
};

KOKKOS_INLINE_FUNCTION double distance(const BorrowedView<double* [2]>& position, int p,
                                       const Vector<2>& from)
{
  const double x = position(p, 0) - from[0], y = position(p, 1) - from[1];
  return std::sqrt(x * x + y * y);
}

/// Means over the particles within the outer radius, and the material at the front, at its temperature.
/// Collective.
FrontDisk describeDisk(const State<2>& state, const CrackFront<2>& front, const ContourRadii& radii);

/// The material at a front, with its moduli at the front's temperature.
Properties lawAtFront(const State<2>& state, const CrackFront<2>& front);

} // namespace Rhegma::energy_release
