#pragma once
/// Bodies that touch the edge of the domain.

#include <Teuchos_ParameterList.hpp>

#include <string>
#include <vector>

namespace Rhegma
{

/// Whether a support holds nodes across the plane where an axis has this value, within a slack [m].
/// \param scene validated
bool isSupportedPlane(const Teuchos::ParameterList& scene, int axis, double value, double slack);

/// A warning for each body and each face of the domain that it touches at the start without a support normal
/// to that face: it can't move beyond, and the run would end if it does.
/// \param scene validated
template <int D>
std::vector<std::string> warningsOfEdges(const Teuchos::ParameterList& scene);

} // namespace Rhegma
