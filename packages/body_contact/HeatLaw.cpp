#include "body_contact/HeatLaw.hpp"

#include "base/ReadList.hpp"

#include <algorithm>

namespace Rhegma::body_contact
{

namespace
{

const char* const conductanceName = "Conductance";

} // namespace

void addConductance(Section& section, bool ofPair)
{
  const std::string what = "Heat flux through faces that press on each other, over the difference of their "
                           "temperatures. Pressed metals have some 1e3 to 1e5.";
  if (ofPair)
    section.real(conductanceName)
        .unit("W/(m2 K)")
        .notNegative()
        .optional("that of the section")
        .meaning(what);
  else
    section.real(conductanceName)
        .unit("W/(m2 K)")
        .notNegative()
        .optional("0, they insulate")
        .meaning(what +
                 " Used with the section Thermal; heat by friction goes to both bodies without it, too.");
}

bool hasConductance(const Teuchos::ParameterList& section)
{
  const std::vector<std::string> pairs = sublistNames(section);
  return section.isParameter(conductanceName) ||
         std::any_of(pairs.begin(), pairs.end(),
                     [&](const std::string& pair)
                     { return section.sublist(pair).isParameter(conductanceName); });
}

Conductances readConductances(const Teuchos::ParameterList& section, const std::vector<NamedPair>& pairs,
                              int groups)
{
  const auto* const all = valueIf<double>(section, conductanceName);
  Conductances found{all != nullptr ? *all : 0.0, {}};
  if (pairs.empty())
    return found;
  found.ofGroups = View<double**>("rhegma::conductancesOfPairs", groups, groups);
  const auto host = Kokkos::create_mirror_view(found.ofGroups);
  Kokkos::deep_copy(host, found.others);
  for (const NamedPair& pair : pairs)
    if (const auto* const own = valueIf<double>(section.sublist(pair.name), conductanceName); own != nullptr)
      host(pair.one, pair.other) = host(pair.other, pair.one) = *own;
  Kokkos::deep_copy(found.ofGroups, host);
  return found;
}

} // namespace Rhegma::body_contact
