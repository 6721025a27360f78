#pragma once
/// Bodies that do not fit into the domain, or leave it.

#include "state/State.hpp"

#include <string>

namespace Rhegma
{

/// The error of a body with material at a position outside the domain, without the body's name.
template <int D>
std::string textOfOutside(const Vector<D>& position, const Grid<D>& grid);

/// Why a run can't go on one of whose particles has just left the domain: the body, where, and what helps.
/// `otherwise` where none of this rank has.
template <int D>
std::string failureOutsideDomain(const State<D>& state, const std::string& otherwise);

} // namespace Rhegma
