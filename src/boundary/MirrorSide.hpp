#pragma once
/// Which side of a plane of symmetry is the mirror image.

#include <Teuchos_ParameterList.hpp>

#include <string>

namespace Rhegma
{

/// Whether it is the lower side: as `Side` says, otherwise that of the nearer end of the domain. \param list
/// of a Symmetry boundary \param lower, upper ends of the domain along its axis [m]
inline bool mirrorIsBelow(const Teuchos::ParameterList& list, double lower, double upper)
{
  const double position = list.get<double>("Position");
  return list.isParameter("Side") ? list.get<std::string>("Side") == "Lower"
                                  : position - lower < upper - position;
}

} // namespace Rhegma
