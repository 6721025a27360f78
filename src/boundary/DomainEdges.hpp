#pragma once
/// Bodies that touch the edge of the domain.

#include <Teuchos_ParameterList.hpp>

#include <string>
#include <vector>

namespace Rhegma
{

/// A warning for each body and each face of the domain that it touches at the start without a support normal
/// to that face: it can't move beyond, and the run would end if it does.
/// \param scene validated
template <int D>
std::vector<std::string> warningsOfEdges(const Teuchos::ParameterList& scene);

} // namespace Rhegma
