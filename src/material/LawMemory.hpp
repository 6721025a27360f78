#pragma once
/// Which laws have a memory.

#include "material/Materials.hpp"

namespace Rhegma
{

/// The kind of a law that is known when a kernel is compiled, as `withLaw` has it.
template <class Law>
constexpr LawKind kindOf = LawKind::LinearElastic;
template <>
inline constexpr LawKind kindOf<NeoHookean> = LawKind::NeoHookean;
template <>
inline constexpr LawKind kindOf<MooneyRivlin> = LawKind::MooneyRivlin;
template <>
inline constexpr LawKind kindOf<J2Plastic> = LawKind::J2Plastic;

/// Whether a law keeps numbers per particle.
template <class Law>
constexpr bool remembers = historySize(kindOf<Law>, 2) > 0;

} // namespace Rhegma
