#pragma once
/// The picture of a scene that is only checked.

#include "parallel/Ranks.hpp"
#include "program/Options.hpp"

#include <iosfwd>

namespace Rhegma::program
{

/// Draws the scene of the options into the file options.picture by tools/rhegma-plot, from the state in the
/// folder options.state if there is one (CheckedState.hpp). It is looked for in
/// the folder RHEGMA_TOOLS, next to the program, in the folder tools of one of the folders that the program
/// is in, and on the PATH. \return exit code; a message says why there is no picture. On one rank
int drawScene(const Options& options, const Ranks& ranks, std::ostream& err);

} // namespace Rhegma::program
