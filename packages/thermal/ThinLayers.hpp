#pragma once
/// Steady temperatures in bodies that conduct next to nothing along some axis.

#include "state/State.hpp"

#include <Teuchos_ParameterList.hpp>

namespace Rhegma::thermal
{

/// Refuses conductivities that are too different for the cells. What is prescribed for a part of the ends of
/// a body of length L along an axis with the conductivity k spreads across it by about L sqrt(k' / k), where
/// k' is that of the other axis. If that is less than a cell h, temperatures jump from one row of nodes to
/// the next; the rows are coupled by the shape functions, as by a consistent mass matrix, and temperatures
/// leave the bounds of those prescribed, by up to 22 % of their difference. At k' = 0 rows that nothing
/// holds are not determined, either. So k' / k >= (h / L)^2 is needed. \param materials of the scene
/// \throws std::invalid_argument, with the parameter's path
template <int D>
void refuseThinLayers(const Teuchos::ParameterList& materials, const State<D>& state);

} // namespace Rhegma::thermal
