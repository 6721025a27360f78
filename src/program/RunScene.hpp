#pragma once
/// What the program does with a scene.

#include "program/Options.hpp"

#include <iosfwd>

namespace Rhegma::program
{

/// Does what the options ask. \return the program's exit code
int run(const Options& options, std::ostream& out, std::ostream& err);

} // namespace Rhegma::program
