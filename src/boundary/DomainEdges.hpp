#pragma once
/// Bodies that have no room to move.

#include <Teuchos_ParameterList.hpp>

#include <string>
#include <vector>

namespace Rhegma
{

/// A sentence for each body and each face of the domain that it touches at the start, where no support holds
/// it across that face: it may not move beyond, and the run would end where it does.
/// \param scene validated
template <int D>
std::vector<std::string> warningsOfEdges(const Teuchos::ParameterList& scene);

} // namespace Rhegma
