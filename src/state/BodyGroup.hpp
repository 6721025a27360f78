#pragma once
/// Groups of bodies that are kept apart at common nodes, and what stencils know of them.

#include "base/FieldTable.hpp"

#include <string>

namespace Rhegma
{

namespace fields
{
/// Number, from 1 on, of the group of bonded bodies to which a particle belongs; only where an effect keeps
/// groups apart.
inline const std::string bodyGroup = "body group";
} // namespace fields

/// The field of particles that says on which side of a cut each lies: the side of a crack, or its group of
/// bodies. Empty where there is none.
inline std::string sideField(const FieldTable& particles)
{
  for (const std::string& name : {fields::side, fields::bodyGroup})
    if (particles.has(name))
      return name;
  return {};
}

} // namespace Rhegma
