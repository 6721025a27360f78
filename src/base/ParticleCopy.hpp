#pragma once
/// Fields of the particles as plain numbers on the host, for applications.

#include "base/FieldTable.hpp"

#include <string>
#include <vector>

namespace Rhegma
{

/// One field of the particles that a rank has, as it is at one time.
struct ParticleCopy
{
  Field field;                ///< its name, components, unit and meaning
  int particles = 0;          ///< number of particles
  std::vector<double> values; ///< components of the first particle, then of the next; whole numbers too
};

/// Copies a field. Throws std::invalid_argument, which lists the existing fields, where there is none of this
/// name.
ParticleCopy copyField(const FieldTable& table, const std::string& name);

} // namespace Rhegma
