#pragma once
/// Groups of bodies that move as one.

#include <Teuchos_ParameterList.hpp>

#include <string>
#include <vector>

namespace Rhegma
{

/// Bodies that the scene bonds to each other, directly or by way of others, are one group.
struct BondedGroups
{
  std::vector<int> of;            ///< group of each body, in the order of the scene
  std::vector<std::string> names; ///< of each group: its bodies, joined by " + "
  /// Number of groups.
  int count() const { return static_cast<int>(names.size()); }
};

/// \param bodies the section Bodies \param names of the bodies, in the order of their numbers
BondedGroups bondedGroups(const Teuchos::ParameterList& bodies, const std::vector<std::string>& names);

/// Names that the parameter Bonded To of a body lists.
std::vector<std::string> splitNames(const std::string& list);

} // namespace Rhegma
