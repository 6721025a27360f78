#pragma once
/// The effect `Cohesive Faces`: faces of cracks that hold together by a traction-separation law.

#include "plan/Effect.hpp"

namespace Rhegma::cohesive_faces
{

EffectEntry cohesiveFacesEntry();

} // namespace Rhegma::cohesive_faces
