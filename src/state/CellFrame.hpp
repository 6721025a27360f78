#pragma once
/// Gradients and stresses of particles in the configuration in which the cells lie.

#include "material/Tensors.hpp"
#include "state/State.hpp"

#include <cmath>

namespace Rhegma
{

/// Inverse of the part of a deformation gradient in the axes of the cells. \param F of a particle
/// \param back becomes the inverse, row by row
template <int D>
KOKKOS_FORCEINLINE_FUNCTION void inverseInAxes(const double* F, double (&back)[D * D])
{
  if constexpr (D == 2)
  {
    const double scale = 1.0 / (F[0] * F[3] - F[1] * F[2]);
    back[0] = scale * F[3];
    back[1] = -scale * F[1];
    back[2] = -scale * F[2];
    back[3] = scale * F[0];
  }
  else
    inverse<3>(F, determinant<3>(F), back);
}

/// Largest factor by which a wave is faster along the axes of undeformed cells than in the deformed body: the
/// root of the largest eigenvalue of F^-1 F^-T, in 3D a bound of it by the sums of its rows, which rotations
/// leave at 1. \param F of a particle
template <int D>
KOKKOS_INLINE_FUNCTION double slowestStretch(const double* F)
{
  double back[D * D], square[D][D];
  inverseInAxes<D>(F, back);
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j)
    {
      square[i][j] = 0.0;
      for (int k = 0; k < D; ++k)
        square[i][j] += back[i * D + k] * back[j * D + k];
    }
  if constexpr (D == 2)
  {
    const double mean = 0.5 * (square[0][0] + square[1][1]), half = 0.5 * (square[0][0] - square[1][1]);
    return std::sqrt(mean + std::sqrt(half * half + square[0][1] * square[0][1]));
  }
  else
  {
    double largest = 0.0;
    for (int i = 0; i < D; ++i)
    {
      double sum = 0.0;
      for (int j = 0; j < D; ++j)
        sum += std::fabs(square[i][j]);
      largest = sum > largest ? sum : largest;
    }
    return std::sqrt(largest);
  }
}

/// Where the cells lie in the deformed body, slopes of shape functions are gradients with respect to present
/// positions, and the nodal force of a particle is -V0 tau grad N. Where they lie in the undeformed body
/// (Method::totalLagrangian) slopes are with respect to undeformed positions: their force is -V0 P Grad N
/// with the first Piola-Kirchhoff stress P = tau F^-T, and the gradient in the deformed body is Grad v F^-1
/// (Bonet and Wood, Nonlinear Continuum Mechanics for Finite Element Analysis, sections 3.4 and 5.5; de
/// Vaucorbeil, Nguyen, Hutchinson, Comput. Methods Appl. Mech. Eng. 360 (2020) 112783). What writes slopes
/// times stress calls this and is the same code for both.
template <int D>
struct CellFrame
{
  BorrowedView<double * [gradientSize<D>]> deformation; ///< of the particles
  bool undeformed = false;                              ///< whether the cells lie in the undeformed body

  CellFrame() = default;

  /// \param state whose particles are meant
  explicit CellFrame(const State<D>& state)
      : deformation(state.particles.template real<gradientSize<D>>(fields::deformation)),
        undeformed(state.method.totalLagrangian)
  {
  }

  /// Stress that slopes of the cells' functions turn into force. \param p a particle \param tau its Kirchhoff
  /// stress [Pa] \param T becomes it: row of the force, column of the slope [Pa]
  KOKKOS_FORCEINLINE_FUNCTION void stress(int p, const double* tau, double (&T)[D * D]) const
  {
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < D; ++j)
        T[i * D + j] = tau[symmetricIndex<D>(i, j)];
    if (undeformed)
      pullBack(p, T);
  }

  /// Factor of the hoop strain of axisymmetric scenes, and of its stress, from the cells to the deformed body
  /// and back. \param p a particle
  KOKKOS_FORCEINLINE_FUNCTION double hoopFactor(int p) const
  {
    return undeformed && D == 2 ? 1.0 / deformation(p, gradientSize<D> - 1) : 1.0;
  }

  /// T <- T F^-T, its columns from axes of the deformed body to those of the cells. \param p a particle
  /// \param T row by row
  KOKKOS_FORCEINLINE_FUNCTION void pullBack(int p, double* T) const
  {
    double back[D * D];
    inverseInAxes<D>(&deformation(p, 0), back);
    for (int i = 0; i < D; ++i)
    {
      double row[D];
      for (int j = 0; j < D; ++j)
      {
        row[j] = 0.0;
        for (int k = 0; k < D; ++k)
          row[j] += T[i * D + k] * back[j * D + k];
      }
      for (int j = 0; j < D; ++j)
        T[i * D + j] = row[j];
    }
  }

  /// G <- G F^-1, the gradient with respect to positions at F. \param p a particle \param G gradient with
  /// respect to the cells, row by row
  KOKKOS_FORCEINLINE_FUNCTION void pushForward(int p, double* G) const
  {
    double back[D * D];
    inverseInAxes<D>(&deformation(p, 0), back);
    for (int i = 0; i < D; ++i)
    {
      double row[D];
      for (int j = 0; j < D; ++j)
      {
        row[j] = 0.0;
        for (int k = 0; k < D; ++k)
          row[j] += G[i * D + k] * back[k * D + j];
      }
      for (int j = 0; j < D; ++j)
        G[i * D + j] = row[j];
    }
  }
};

} // namespace Rhegma
