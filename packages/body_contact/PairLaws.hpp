#pragma once
/// How two groups of bodies act on each other where they touch.

#include "base/Types.hpp"
#include "scene/BondedGroups.hpp"
#include "scene/Schema.hpp"

#include <Teuchos_ParameterList.hpp>

#include <string>
#include <utility>
#include <vector>

namespace Rhegma::body_contact
{

/// Coefficients of friction of a pair: infinite where it sticks, zero where it slides freely.
struct PairLaw
{
  double atRest = 0.0;  ///< up to which it sticks [-]
  double sliding = 0.0; ///< while it slides [-]
};

/// The laws of all pairs of groups, on the device.
struct PairLaws
{
  PairLaw others;           ///< of pairs without one of their own
  View<PairLaw**> ofGroups; ///< by both numbers; empty where all pairs have the same law

  /// The law of a pair, by the numbers of its groups from 0 on.
  KOKKOS_INLINE_FUNCTION PairLaw operator()(int one, int other) const
  {
    return ofGroups.extent(0) > 0 ? ofGroups(one, other) : others;
  }
};

/// Adds the parameters Law, Friction Coefficient and Static Friction Coefficient.
void addLawParameters(Section& section);

/// The same for a pair, whose law is that of the section if it has none of its own.
void addLawParametersOfPair(Section& pair);

/// Checks the laws of a scene and the names of bodies in them.
void checkLaws(const Teuchos::ParameterList& scene, std::vector<SceneError>& errors);

/// A pair that has a sublist of its own: its name and its groups.
struct NamedPair
{
  std::string name;       ///< of its list
  int one = 0, other = 0; ///< numbers of groups, the lower one first
  bool inverted = false;  ///< whether the list has the other group first
};

/// \param section Body Contact, validated \param names of the bodies
std::vector<NamedPair> namedPairs(const Teuchos::ParameterList& section, const BondedGroups& groups,
                                  const std::vector<std::string>& names);

/// \param section Body Contact, validated
PairLaws readLaws(const Teuchos::ParameterList& section, const std::vector<NamedPair>& pairs, int groups);

} // namespace Rhegma::body_contact
