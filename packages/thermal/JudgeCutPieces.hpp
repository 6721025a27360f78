#pragma once
/// Pieces of bodies whose temperature steady conduction does not determine, because cracks insulate them
/// (docs/reference/warnings-of-cracks-and-runs.md).

#include "thermal/Conduction.hpp"

#include <Teuchos_ParameterList.hpp>

namespace Rhegma::thermal
{

/// Warns of each piece that insulating cracks cut off at the start and that no prescribed temperature and no
/// convection reaches, to within a cell of its bounds. Call it before particles are divided among ranks.
/// \param scene its core and Thermal
template <int D>
void judgeCutPieces(const Teuchos::ParameterList& scene, const Conduction<D>& conduction, State<D>& state);

} // namespace Rhegma::thermal
