#include "material/OrthotropicStiffness.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace Rhegma
{

namespace
{

using Matrix = std::array<std::array<double, 3>, 3>;

std::string textOf(double value)
{
  std::ostringstream out;
  out << value;
  return out.str();
}

/// Component of the tensor of the stiffness.
double component(const Stiffness& C, int i, int j, int k, int l)
{
  return C[symmetricIndex<3>(i, j)][symmetricIndex<3>(k, l)];
}

/// Determinant of the part of the compliance of the three axes, times the three Young's moduli.
double normalDeterminant(const OrthotropicConstants& c)
{
  const double n12 = c.poisson[0], n23 = c.poisson[1], n13 = c.poisson[2];
  const double n21 = n12 * c.young[1] / c.young[0], n32 = n23 * c.young[2] / c.young[1],
               n31 = n13 * c.young[2] / c.young[0];
  return 1.0 - n12 * n21 - n23 * n32 - n13 * n31 - 2.0 * n21 * n32 * n13;
}

/// Along the material's own axes.
Stiffness stiffnessAlongAxes(const OrthotropicConstants& c)
{
  const double n12 = c.poisson[0], n23 = c.poisson[1], n13 = c.poisson[2];
  const double n21 = n12 * c.young[1] / c.young[0], n32 = n23 * c.young[2] / c.young[1],
               n31 = n13 * c.young[2] / c.young[0];
  const double scale = 1.0 / normalDeterminant(c);
  Stiffness C{};
  C[0][0] = c.young[0] * (1.0 - n23 * n32) * scale;
  C[1][1] = c.young[1] * (1.0 - n13 * n31) * scale;
  C[2][2] = c.young[2] * (1.0 - n12 * n21) * scale;
  C[0][1] = C[1][0] = c.young[0] * (n21 + n31 * n23) * scale;
  C[0][2] = C[2][0] = c.young[0] * (n31 + n21 * n32) * scale;
  C[1][2] = C[2][1] = c.young[1] * (n32 + n12 * n31) * scale;
  for (int k = 0; k < 3; ++k) // xy, yz, xz
    C[3 + k][3 + k] = c.shear[k];
  return C;
}

/// Acoustic tensor C_ijkl n_j n_l.
Matrix acousticTensor(const Stiffness& C, const Vector<3>& n)
{
  Matrix Q{};
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k)
      for (int j = 0; j < 3; ++j)
        for (int l = 0; l < 3; ++l)
          Q[i][k] += component(C, i, j, k, l) * n[j] * n[l];
  return Q;
}

/// One step of the power method; the matrix has no negative eigenvalue. \return the length before scaling
double iterate(const Matrix& Q, Vector<3>& m)
{
  Vector<3> next{};
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k)
      next[i] += Q[i][k] * m[k];
  const double size = norm(next);
  m = (1.0 / size) * next;
  return size;
}

/// Largest of (m n) : C : (m n) over unit vectors, from a start: it is the same with both exchanged, so that
/// steps of the power method for each in turn never lower it.
double climb(const Stiffness& C, Vector<3> n)
{
  Vector<3> m = n;
  double value = 0.0;
  constexpr int most = 5000;
  for (int turn = 0; turn < most; ++turn)
  {
    iterate(acousticTensor(C, n), m);
    const double next = iterate(acousticTensor(C, m), n);
    if (std::fabs(next - value) <= 1e-16 * next && turn > 20)
      return next;
    value = next;
  }
  return value;
}

/// Smallest eigenvalue of the first rows and columns of a symmetric matrix. In three dimensions by the
/// cosine of a third of an angle (Smith, Commun. ACM 4 (1961) 168).
double smallestEigenvalue(const Matrix& Q, int dimension)
{
  if (dimension == 2)
    return 0.5 * (Q[0][0] + Q[1][1]) - std::hypot(0.5 * (Q[0][0] - Q[1][1]), Q[0][1]);
  const double mean = (Q[0][0] + Q[1][1] + Q[2][2]) / 3.0;
  Matrix B = Q;
  double square = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    B[i][i] -= mean;
    for (int j = 0; j < 3; ++j)
      square += B[i][j] * B[i][j];
  }
  const double radius = std::sqrt(square / 6.0);
  if (!(radius > 1e-14 * mean))
    return mean;
  const double half =
      0.5 *
      (B[0][0] * (B[1][1] * B[2][2] - B[1][2] * B[2][1]) - B[0][1] * (B[1][0] * B[2][2] - B[1][2] * B[2][0]) +
       B[0][2] * (B[1][0] * B[2][1] - B[1][1] * B[2][0])) /
      (radius * radius * radius);
  const double third = std::acos(std::clamp(half, -1.0, 1.0)) / 3.0;
  return mean + 2.0 * radius * std::cos(third + 2.0 * std::acos(-1.0) / 3.0);
}

} // namespace

std::string failedInequality(const OrthotropicConstants& c)
{
  constexpr int first[3] = {0, 1, 0}, second[3] = {1, 2, 2};
  for (int k = 0; k < 3; ++k)
  {
    const double ratio = c.young[first[k]] / c.young[second[k]], nu = c.poisson[k];
    const std::string axes = std::to_string(first[k] + 1) + std::to_string(second[k] + 1);
    if (!(nu * nu < ratio))
      return "nu" + axes + "^2 < E" + axes.substr(0, 1) + "/E" + axes.substr(1) +
             " fails: " + textOf(nu * nu) + " > " + textOf(ratio);
  }
  if (const double rest = normalDeterminant(c); !(rest > 0.0))
    return "1 - nu12 nu21 - nu23 nu32 - nu13 nu31 - 2 nu21 nu32 nu13 > 0 fails: it is " + textOf(rest);
  return {};
}

Stiffness stiffnessOf(const OrthotropicConstants& constants, const std::array<Vector<3>, 3>& axes)
{
  const Stiffness own = stiffnessAlongAxes(constants);
  Stiffness C{};
  // Pairs of axes of the order of the rows.
  constexpr int one[6] = {0, 1, 2, 0, 1, 0}, other[6] = {0, 1, 2, 1, 2, 2};
  for (int I = 0; I < 6; ++I)
    for (int J = 0; J < 6; ++J)
      for (int a = 0; a < 3; ++a)
        for (int b = 0; b < 3; ++b)
          for (int c = 0; c < 3; ++c)
            for (int d = 0; d < 3; ++d)
              C[I][J] += axes[a][one[I]] * axes[b][other[I]] * axes[c][one[J]] * axes[d][other[J]] *
                         component(own, a, b, c, d);
  return C;
}

double meanBulkModulus(const Stiffness& C)
{
  return (C[0][0] + C[1][1] + C[2][2] + 2.0 * (C[0][1] + C[0][2] + C[1][2])) / 9.0;
}

double meanShearModulus(const Stiffness& C)
{
  return (C[0][0] + C[1][1] + C[2][2] - (C[0][1] + C[0][2] + C[1][2]) + 3.0 * (C[3][3] + C[4][4] + C[5][5])) /
         15.0;
}

Stiffness reducedStiffness(const Stiffness& C, std::array<double, 3>& thickness)
{
  constexpr int plane[3] = {0, 1, 3}, zz = 2; // xx, yy, xy
  Stiffness Q{};
  for (int a = 0; a < 3; ++a)
  {
    thickness[a] = C[zz][plane[a]] / C[zz][zz];
    for (int b = 0; b < 3; ++b)
      Q[plane[a]][plane[b]] = C[plane[a]][plane[b]] - C[plane[a]][zz] * C[zz][plane[b]] / C[zz][zz];
  }
  return Q;
}

WaveModuli waveModuli(const Stiffness& C, int dimension)
{
  const double pi = std::acos(-1.0);
  Stiffness used = C;
  if (dimension == 2) // neither waves across the plane nor motion across it
    for (const int out : {2, 4, 5})
      for (int J = 0; J < 6; ++J)
        used[out][J] = used[J][out] = 0.0;
  WaveModuli moduli{0.0, 0.0};
  const int rings = dimension == 2 ? 1 : 24, around = dimension == 2 ? 180 : 48;
  for (int ring = 0; ring < rings; ++ring)
  {
    const double z = dimension == 2 ? 0.0 : double(ring) / rings, flat = std::sqrt(1.0 - z * z);
    for (int k = 0; k < around; ++k)
    {
      const double angle = (dimension == 2 ? 1.0 : 2.0) * pi * k / around;
      const Vector<3> n{{flat * std::cos(angle), flat * std::sin(angle), z}};
      moduli.slowest = std::max(moduli.slowest, smallestEigenvalue(acousticTensor(used, n), dimension));
      if (ring % 4 == 0 && k % 6 == 0) // each climbs to a maximum
        moduli.fastest = std::max(moduli.fastest, climb(used, n));
    }
  }
  if (dimension == 3)
    moduli.fastest = std::max(moduli.fastest, climb(used, {{0.0, 0.0, 1.0}}));
  return moduli;
}

} // namespace Rhegma
