#pragma once
/// The particles in a disk round a front in 2D, taken together.

#include "energy_release/Contour.hpp"
#include "energy_release/CrackTipFields.hpp"
#include "energy_release/FrontRegion.hpp"
#include "transfer/BlocksInReach.hpp"
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
  CrackCompliance compliance;
  double traceFactor; ///< trace of the stress of the singular fields over that of its part in the plane
  /// W of a body at the front's temperature that is free in the plane, in plane strain [J/m3]: the energy of
  /// the stress across the plane. A constant adds nothing to the integral of W q,1 over a disk inside a body,
  /// and without this one a surface that cuts the edge of the disk hardly does.
  double misfit = 0.0;
};

/// Means over the particles within the outer radius, and the material at the front, at its temperature.
/// Collective. \param positions whether mean positions are wanted, too \param blocks with these particles
FrontDisk describeDisk(const State<2>& state, const CrackFront<2>& front, const ContourRadii& radii,
                       bool positions, const BlocksInReach<2>& blocks);

/// The material at a front, with its moduli at the front's temperature.
Properties lawAtFront(const State<2>& state, const CrackFront<2>& front);

/// Its compliance along the front. Collective.
CrackCompliance complianceAtFront(const State<2>& state, const CrackFront<2>& front);

} // namespace Rhegma::energy_release
