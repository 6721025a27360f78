#pragma once
/// The bodies of a scene, checked together before they become particles.

#include "geometry/Seeds.hpp"
#include "state/State.hpp"

#include <Teuchos_ParameterList.hpp>

#include <string>
#include <vector>

namespace Rhegma
{

/// A body and the positions of its particles.
template <int D>
struct PlacedBody
{
  std::string name;
  const Teuchos::ParameterList* list = nullptr; ///< its section
  Shape<D> shape;
  Seeds<D> seeds{};

  std::string where() const { return "Bodies > " + name; }
  int particlesPerCell() const { return list->get<int>("Particles Per Cell"); }
};

/// Places the bodies of the section `Bodies`.
/// \param state has its grid and the fields of its particles, from which memory is estimated
/// \param rules what divides their particles
///
/// Throws std::invalid_argument, a line per error: a body that has no particle, leaves the domain or overlaps
/// another, and a scene that is too large for the machine.
template <int D>
std::vector<PlacedBody<D>> placeBodies(const Teuchos::ParameterList& section, const State<D>& state,
                                       const SeedRules<D>& rules);

} // namespace Rhegma
