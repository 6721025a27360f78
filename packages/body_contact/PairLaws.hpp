#pragma once
/// How two groups of bodies act on each other where they touch.

#include "body_contact/InterfaceLaw.hpp"
#include "material/FrictionLaw.hpp"
#include "scene/BondedGroups.hpp"
#include "scene/Schema.hpp"

#include <Teuchos_ParameterList.hpp>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace Rhegma::body_contact
{

/// The laws of all pairs of groups, on the device.
struct PairLaws
{
  int groups = 0;               ///< number of groups
  FrictionLaw others;           ///< of pairs without one of their own
  View<FrictionLaw**> ofGroups; ///< by both numbers; empty where all pairs have the same law

  /// The law of a pair, by the numbers of its groups from 0 on.
  KOKKOS_INLINE_FUNCTION FrictionLaw operator()(int one, int other) const
  {
    return ofGroups.extent(0) > 0 ? ofGroups(one, other) : others;
  }
};

/// Checks the laws of a scene and the names of bodies in them.
void checkLaws(const Teuchos::ParameterList& scene, std::vector<SceneError>& errors);

/// A pair that has a sublist of its own: its name and its groups.
struct NamedPair
{
  std::string name;       ///< of its list
  int one = 0, other = 0; ///< numbers of groups, the lower one first
  bool inverted = false;  ///< whether the list has the other group first
  std::optional<InterfaceLaw> interface {
  }; ///< if an elastic interface joins the two
};

/// \param section Body Contact, validated \param names of the bodies
std::vector<NamedPair> namedPairs(const Teuchos::ParameterList& section, const BondedGroups& groups,
                                  const std::vector<std::string>& names);

/// Pairs that an interface joins have the law of the section away from it. \param section Body Contact,
/// validated
PairLaws readLaws(const Teuchos::ParameterList& section, const std::vector<NamedPair>& pairs, int groups);

} // namespace Rhegma::body_contact
