#pragma once
/// Upper bounds of the acoustic tensor, from which the laws derive their wave speeds.
///
/// A plane wave of direction n and polarisation m (unit vectors) changes F to (1 + e m n^T) F. Its speed c in
/// space, relative to the material, obeys rho0 c^2 = d^2 W / de^2 at e = 0, with W the energy per undeformed
/// volume (Truesdell and Noll, The Non-Linear Field Theories of Mechanics, section 74, with the acoustic
/// tensor pushed forward). With p = m.n and b = F F^T the derivatives are those of
///     J -> J (1 + e p),   tr b -> tr b + 2 e m.b n + e^2 n.b n,   tr cof b likewise.
/// Plane stress relaxes the thickness, d^2 W / de^2 - (d^2 W / de dx)^2 / (d^2 W / dx^2) with x the logarithm
/// of the thickness stretch, which is the least value along any path x = x0 - theta p e; every theta gives a
/// bound.

#include "material/Tensors.hpp"

namespace Rhegma
{

/// The larger of two numbers; unlike std::fmax it is one instruction.
KOKKOS_FORCEINLINE_FUNCTION double larger(double a, double b) { return a > b ? a : b; }

struct EigenvalueRange
{
  double smallest;
  double largest;
};

/// Bounds of the eigenvalues in three dimensions from two invariants; equal to them where two of the three
/// coincide. Source: Wolkowicz and Styan, Linear Algebra Appl. 29 (1980) 471, theorem 2.1.
KOKKOS_FORCEINLINE_FUNCTION EigenvalueRange eigenvalueRange(double first, double second)
{
  const double spread = 2.0 * std::sqrt(larger(first * first - 3.0 * second, 0.0));
  return {(first - spread) / 3.0, (first + spread) / 3.0};
}

/// Range of n.a n over the directions n in which waves travel: exact in 2D (the plane), a bound in 3D.
template <int D>
KOKKOS_FORCEINLINE_FUNCTION EigenvalueRange directionalRange(const double* a)
{
  if constexpr (D == 2)
  {
    const double middle = 0.5 * (a[0] + a[1]);
    const double difference = 0.5 * (a[0] - a[1]);
    const double radius = std::sqrt(difference * difference + a[2] * a[2]);
    return {middle - radius, middle + radius};
  }
  else
    return eigenvalueRange(trace<3>(a), secondInvariant<3>(a));
}

/// Bound of the second derivative of J^(-2/3) tr b, where b is given as J^(-2/3) b:
///     2 n.b n - 8/3 p m.b n + 10/9 p^2 tr b.
KOKKOS_FORCEINLINE_FUNCTION double firstInvariantBound(double traceB, EigenvalueRange b)
{
  const double smallest = larger(b.smallest, 0.0);
  return larger(2.0 * b.largest, 10.0 / 9.0 * traceB - 2.0 / 3.0 * smallest) +
         2.0 / 3.0 * (b.largest - smallest);
}

/// Bound of the second derivative of J^(-4/3) tr cof b, where cof b is given as J^(-4/3) cof b:
///     2 m.c m + 4/3 p m.c n - 2/9 p^2 tr c, c = cof b.
KOKKOS_FORCEINLINE_FUNCTION double secondInvariantBound(double traceCofactor, double largestCofactor)
{
  return 10.0 / 3.0 * largestCofactor - 2.0 / 9.0 * traceCofactor;
}

/// Bound of alpha n.b n - beta p m.b n + gamma p^2 over the directions of the plane; alpha and beta not
/// negative.
KOKKOS_FORCEINLINE_FUNCTION double planeBound(double alpha, double beta, double gamma, EigenvalueRange b)
{
  const double slope = alpha - beta;
  const double dilatational = gamma + slope * (slope > 0.0 ? b.largest : b.smallest);
  return larger(alpha * b.largest, dilatational) + 0.25 * beta * (b.largest - b.smallest);
}

/// The fraction theta of the in-plane dilatation that the thickness compensates, at small strain.
/// \param isochoric second derivative of the isochoric energy by x, \param volumetric of the volumetric
/// energy
KOKKOS_FORCEINLINE_FUNCTION double relaxation(double isochoric, double volumetric)
{
  const double theta = (volumetric - 0.5 * isochoric) / (volumetric + isochoric);
  return theta > 0.0 && theta < 1.0 ? theta : 1.0;
}

/// Second derivative of mu/2 (tr be - 3) by the logarithm of the thickness [Pa].
/// \param be isochoric left tensor, of unit determinant, in 2D
KOKKOS_FORCEINLINE_FUNCTION double thicknessModulus(double mu, const double* be)
{
  return 0.5 * mu * (4.0 * (be[0] + be[1]) + 16.0 * be[3]) / 9.0;
}

/// Bound of rho0 c^2 in plane stress of mu/2 (tr be - 3) plus an energy of the volume [Pa].
/// \param range of the directions of be in the plane \param theta thickness that follows
/// \param volumetric second derivative of the energy of the volume by ln J \param dilatational the same along
/// J
/// -> J (1 + e)
KOKKOS_FORCEINLINE_FUNCTION double isochoricPlaneModulus(double mu, const double* be, EigenvalueRange range,
                                                         double theta, double volumetric, double dilatational)
{
  const double inPlane = be[0] + be[1];
  const double gamma =
      0.5 * mu * (10.0 * (inPlane + be[3]) - 2.0 * theta * (4.0 * inPlane - 8.0 * be[3])) / 9.0 +
      theta * theta * thicknessModulus(mu, be) + dilatational - 2.0 * theta * volumetric +
      theta * theta * volumetric;
  return planeBound(mu, 4.0 / 3.0 * mu * (1.0 - theta), gamma, range);
}

/// rho0 c^2 [Pa] -> c [m/s].
KOKKOS_FORCEINLINE_FUNCTION double speedOf(double modulus, double density)
{
  return std::sqrt(larger(modulus, 0.0) / density);
}

} // namespace Rhegma
