#include "material/CrackCompliance.hpp"

#include <cmath>

namespace Rhegma
{

namespace
{

using Complex = Kokkos::complex<double>;

/// Component of a compliance with two planes of symmetry, by its tensor s_abcd p_a q_b v_c w_d.
struct OwnCompliance
{
  double xx, yy, xy, shear; // shear is that of 2 e_12

  double operator()(const double* p, const double* q, const double* v, const double* w) const
  {
    return xx * p[0] * q[0] * v[0] * w[0] + yy * p[1] * q[1] * v[1] * w[1] +
           xy * (p[0] * q[0] * v[1] * w[1] + p[1] * q[1] * v[0] * w[0]) +
           0.25 * shear * (p[0] * q[1] + p[1] * q[0]) * (v[0] * w[1] + v[1] * w[0]);
  }

  /// Roots along its own axes, of xx mu^4 + (2 xy + shear) mu^2 + yy = 0.
  void findRoots(Complex (&root)[2]) const
  {
    const double half = 0.5 * (2.0 * xy + shear) / xx, product = yy / xx, square = half * half - product;
    // A pair on the imaginary axis, or one that it mirrors: from the root of mu_1 mu_2 and the sum of both,
    // which is sqrt(2 half + 2 sqrt(product)) i, without cancellation where they are equal.
    const double between = std::sqrt(product), sum = std::sqrt(2.0 * (half + between));
    const double apart = std::sqrt(2.0 * std::fabs(square) / (half + between));
    const Complex difference = square > 0.0 ? Complex(0.0, apart) : Complex(apart, 0.0);
    root[0] = 0.5 * (Complex(0.0, sum) + difference);
    root[1] = 0.5 * (Complex(0.0, sum) - difference);
  }
};

} // namespace

CrackCompliance crackCompliance(const PlaneStiffness& stiffness, const Vector<2>& direction,
                                const Vector<2>& normal)
{
  const double determinant = stiffness.xx * stiffness.yy - stiffness.xy * stiffness.xy;
  const OwnCompliance own{stiffness.yy / determinant, stiffness.xx / determinant, -stiffness.xy / determinant,
                          1.0 / stiffness.shear};
  // The front's axes along those of the material.
  const Vector<2> axis = stiffness.axis, across{{-axis[1], axis[0]}};
  const double d[2] = {dot(direction, axis), dot(direction, across)};
  const double n[2] = {dot(normal, axis), dot(normal, across)};
  CrackCompliance c{};
  c.a11 = own(d, d, d, d);
  c.a12 = own(d, d, n, n);
  c.a16 = 2.0 * own(d, d, d, n);
  c.a22 = own(n, n, n, n);
  c.a26 = 2.0 * own(n, n, d, n);
  own.findRoots(c.root);
  for (Complex& root : c.root)
  {
    root = (n[0] + root * n[1]) / (d[0] + root * d[1]);
    if (root.imag() < 0.0) // the axes are left-handed
      root = Kokkos::conj(root);
  }
  const Complex sum = c.root[0] + c.root[1], product = c.root[0] * c.root[1];
  c.product = product;
  c.p[0] = c.a11 * c.root[0] * c.root[0] + c.a12 - c.a16 * c.root[0];
  c.p[1] = c.a12 * c.root[0] + c.a22 / c.root[0] - c.a26;
  c.slope[0] = c.a11 * sum - c.a16;
  c.slope[1] = c.a12 - c.a22 / product;
  c.modeI = -0.5 * c.a22 * (sum / product).imag();
  c.modeII = 0.5 * c.a11 * sum.imag();
  c.coupled = 0.25 * (c.a11 * product.imag() - c.a22 * (Complex(1.0) / product).imag());
  return c;
}

} // namespace Rhegma
