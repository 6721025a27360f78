#pragma once
/// The material at a position.

#include "state/BodyGroup.hpp"

namespace Rhegma
{

/// Number of the material of the particle, of all ranks, whose centre is nearest to x [m]. Collective.
/// \param among the particles that count
template <int D>
int materialAt(const State<D>& state, const Vector<D>& x, const ParticlesOfGroup& among = {});

} // namespace Rhegma
