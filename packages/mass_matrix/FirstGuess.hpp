#pragma once
/// The residual of a first guess.

#include "mass_matrix/MassSystem.hpp"

namespace Rhegma::mass_matrix
{

/// Sums over the free unknowns for a first guess x.
template <int D>
struct GuessSums
{
  double rightSquare = 0.0;    ///< b^2
  double residualSquare = 0.0; ///< (b - M x)^2
  double along = 0.0;          ///< x b
  double energy = 0.0;         ///< x M x
  double right[D] = {};        ///< b, along each axis
  double image[D] = {};        ///< M x, along each axis
  double weighted[D] = {};     ///< L b, along each axis
  double lumpedSquare = 0.0;   ///< L^2, over all coupled rows
  static constexpr int size = 5 + 3 * D;
};

/// Forms image = M x and the sums over all ranks. Collective. \param inverse 0 where an unknown is not free
template <int D>
GuessSums<D> checkGuess(const State<D>& state, const MassSystem<D>& system, const View<double*>& right,
                        const View<double*>& x, const View<double*>& inverse, const View<double*>& image);

} // namespace Rhegma::mass_matrix
