#pragma once
/// What effects do not have for bodies of revolution: rules that their sections add.

#include "scene/Schema.hpp"

#include <string>

namespace Rhegma
{

namespace when
{
/// The scene is one of bodies of revolution.
inline Condition axisymmetric() { return is("Domain", "Plane", {"Axisymmetric"}); }
} // namespace when

inline const char* const orInSpace = "; remove it, or compute a part of the body in 3D";

/// Refuses a section in scenes of bodies of revolution.
inline void refuseAxisymmetric(Section& section, const std::string& reason)
{
  section.refuse({when::present(section.name), when::axisymmetric()}, reason + orInSpace);
}

} // namespace Rhegma
