#pragma once
/// Which solver of linear systems a scene asks for.

namespace Rhegma::equilibrium
{

/// Time > Linear Solver
enum class SolverChoice
{
  Automatic, ///< by the size of the system
  Direct,    ///< wherever there is an order of the unknowns
  Iterative  ///< unless it fails
};

} // namespace Rhegma::equilibrium
