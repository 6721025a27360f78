#pragma once
/// Runs, checks or describes a scene.

#include "program/Options.hpp"

#include <iosfwd>

namespace Rhegma::program
{

/// Executes the options. \return the program's exit code
int run(const Options& options, std::ostream& out, std::ostream& err);

} // namespace Rhegma::program
