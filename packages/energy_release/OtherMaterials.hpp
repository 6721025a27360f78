#pragma once
/// Materials next to that of a front.

#include "geometry/Frame.hpp"
#include "state/State.hpp"

#include <vector>

namespace Rhegma::energy_release
{

/// The nearest particle whose material has other moduli than that at a front.
struct OtherMaterial
{
  int material = -1;     ///< -1: there is none
  double distance = 0.0; ///< from the front, in 3D from the nearest of its nodes [m]
};

/// Where the materials of a scene are. Of a scene with a single one nothing is looked at. Collective.
template <int D>
class OtherMaterials
{
public:
  explicit OtherMaterials(const State<D>& state);

  /// Whether there are several materials.
  bool any() const { return !bounds_.empty(); }

  /// \param radius beyond which none is of interest [m]
  OtherMaterial nearest(const CrackFront<D>& front, double radius) const;

private:
  const State<D>& state_;
  std::vector<Geometry::Bounds<D>> bounds_; ///< of the particles of each material
};

} // namespace Rhegma::energy_release
