#pragma once
/// Heat by friction on tools.

#include "rigid_tools/ToolContacts.hpp"

namespace Rhegma::rigid_tools
{

/// Gives the particles near a tool a fraction of the energy that friction on it has taken in this step: each
/// contact that of its nodes, each node its particles in proportion to their heat capacity there. A tool has
/// no temperature; the rest of the heat is lost to it.
///
/// \param rows buffer of heat capacity and heat of each row of nodal values, zero between calls
/// \return the heat of the particles [J], all of what is given to nodes that they touch
template <int D>
double heatByFriction(State<D>& state, const ToolContacts<D>& contacts, const CellsNearTool<D>& near,
                      double fraction, View<double* [2]>& rows);

} // namespace Rhegma::rigid_tools
