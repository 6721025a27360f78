#pragma once
/// The part of J of each mode at a crack front, by the material there.

#include "material/CrackCompliance.hpp"
#include "material/LawStiffness.hpp"
#include "material/StartOfGrowth.hpp"
#include "transfer/NearestMaterial.hpp"

namespace Rhegma
{

/// Whether the stiffness of the material at a front is the same in all directions. Collective.
template <int D>
bool isIsotropicAt(const State<D>& state, const CrackFront<D>& front)
{
  return !isAnisotropic(state.materials.properties[materialAt(state, front.position)]);
}

/// In 3D by isotropic moduli: of anisotropic bodies no intensities are known there. Collective.
template <int D>
ModeRelease modeReleaseAt(const State<D>& state, const CrackFront<D>& front)
{
  const Properties& material = state.materials.properties[materialAt(state, front.position)];
  if constexpr (D == 2)
    if (isAnisotropic(material))
    {
      const CrackCompliance c = crackCompliance(planeStiffness(material), front.direction, front.normal);
      return {c.modeI, c.modeII, 0.0};
    }
  return modeRelease(elasticity(material));
}

} // namespace Rhegma
