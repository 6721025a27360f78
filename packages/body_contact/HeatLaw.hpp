#pragma once
/// Conductance of faces of bodies that touch.

#include "body_contact/PairLaws.hpp"

namespace Rhegma::body_contact
{

/// The conductance of all pairs of groups, on the device [W/(m2 K)]; 0: touching faces insulate.
struct Conductances
{
  double others = 0.0;     ///< of pairs without one of their own
  View<double**> ofGroups; ///< by both numbers; empty where all pairs have the same

  KOKKOS_INLINE_FUNCTION double operator()(int one, int other) const
  {
    return ofGroups.extent(0) > 0 ? ofGroups(one, other) : others;
  }
};

/// Adds the parameter to the section, or to the list of a pair.
void addConductance(Section& section, bool ofPair);

/// Whether the section or the list of a pair has a conductance.
bool hasConductance(const Teuchos::ParameterList& section);

/// \param section Body Contact, validated
Conductances readConductances(const Teuchos::ParameterList& section, const std::vector<NamedPair>& pairs,
                              int groups);

} // namespace Rhegma::body_contact
