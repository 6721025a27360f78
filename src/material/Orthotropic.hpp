#pragma once
/// Orthotropic elasticity with finite rotations.

#include "material/AcousticBound.hpp"
#include "material/OrthotropicParameters.hpp"
#include "material/PlaneStiffness.hpp"

namespace Rhegma
{

/// Hooke's law with three planes of symmetry that turn with the material: W = 1/2 E : C : E, S = C : E,
/// tau = F S F^T, with Green's strain E = (F^T F - 1)/2 in the undeformed body.
///
/// C is constant, so that the law is for small strain, as Linear Elastic is, which it equals for isotropic
/// constants. In plane stress S_zz = 0 is closed: E_zz = -t : E, with which the stress is Q : E, Q the
/// stiffness of a thin plate; `stress` returns false where the thickness vanishes. Sources: Jones, Mechanics
/// of Composite Materials, chapter 2; Holzapfel, Nonlinear Solid Mechanics, section 6.5.
///
/// mu, lambda and bulk of Properties are Voigt's means over all directions, for estimates and penalties.
struct Orthotropic : LawDefaults
{
  static constexpr const char* name = "Orthotropic";
  static constexpr const char* meaning =
      "Orthotropic or transversely isotropic linear elasticity, such as that of wood and composites, for "
      "small strain; rotations may be large.";

  static constexpr bool linear = true;

  /// Indices in Properties::own: the upper half of the stiffness in the body's axes, row by row, of the
  /// order of symmetricIndex<D>: 21 numbers, 10 in 2D. In plane stress it is that of the thin plate, and its
  /// column of zz are the contractions t of the thickness.
  enum
  {
    axisAt = 10,    ///< cosine and sine of the fibres' direction, in 2D
    fastestAt = 21, ///< density times the square of the largest speed of waves [Pa]
    slowestAt = 22  ///< WaveModuli::slowest [Pa]
  };
  /// Index of the component of two rows.
  template <int D>
  KOKKOS_FORCEINLINE_FUNCTION static constexpr int at(int row, int column)
  {
    const int low = row < column ? row : column, high = row + column - low;
    return low * symmetricSize<D> - low * (low - 1) / 2 + high - low;
  }

  static const char* refusesHeat(const Properties&)
  {
    return "the law Orthotropic has no thermal expansion, which differs from axis to axis; use Linear "
           "Elastic, or remove the section Thermal";
  }
  /// Of LawStiffness.hpp.
  static double stiffestModulus(const Properties& m) { return m.own[fastestAt]; }
  static double surfaceWaveModulus(const Properties& m) { return m.own[slowestAt]; }
  static PlaneStiffness planeStiffness(const Properties& m)
  {
    const double c = m.own[axisAt], s = m.own[axisAt + 1];
    // Back along the fibres.
    const double xx = m.own[at<2>(0, 0)], xy = m.own[at<2>(0, 1)], yy = m.own[at<2>(1, 1)],
                 xs = m.own[at<2>(0, 2)], ys = m.own[at<2>(1, 2)], ss = m.own[at<2>(2, 2)];
    const double c2 = c * c, s2 = s * s, cs = c * s;
    PlaneStiffness own;
    own.axis = {{c, s}};
    own.xx = c2 * c2 * xx + s2 * s2 * yy + 2.0 * c2 * s2 * (xy + 2.0 * ss) + 4.0 * cs * (c2 * xs + s2 * ys);
    own.yy = s2 * s2 * xx + c2 * c2 * yy + 2.0 * c2 * s2 * (xy + 2.0 * ss) - 4.0 * cs * (s2 * xs + c2 * ys);
    own.xy = c2 * s2 * (xx + yy - 4.0 * ss) + (c2 * c2 + s2 * s2) * xy + 2.0 * cs * (c2 - s2) * (ys - xs);
    own.shear =
        c2 * s2 * (xx + yy - 2.0 * xy) + (c2 - s2) * (c2 - s2) * ss + 2.0 * cs * (c2 - s2) * (ys - xs);
    return own;
  }

  template <class Section>
  static void describe(Section& s)
  {
    describeOrthotropic(s);
  }

  template <class Reader>
  static void read(const Reader& reader, Properties& m)
  {
    const int dimension = m.plane == Plane::Solid ? 3 : 2;
    const OrthotropicConstants constants = readOrthotropicConstants(reader);
    const std::array<Vector<3>, 3> axes = readOrthotropicAxes(reader, dimension);
    const Stiffness solid = stiffnessOf(constants, axes);
    m.mu = meanShearModulus(solid);
    m.bulk = meanBulkModulus(solid);
    m.lambda = m.bulk - 2.0 / 3.0 * m.mu;
    std::array<double, 3> thickness{};
    const Stiffness C = m.plane == Plane::Stress ? reducedStiffness(solid, thickness) : solid;
    if (dimension == 3)
      store<3>(C, m);
    else
    {
      store<2>(C, m);
      for (int k = 0; k < 3 && m.plane == Plane::Stress; ++k)
        m.own[at<2>(k, 3)] = thickness[k];
      m.own[axisAt] = axes[0][0];
      m.own[axisAt + 1] = axes[0][1];
    }
    const WaveModuli waves = waveModuli(C, dimension);
    m.own[fastestAt] = waves.fastest;
    m.own[slowestAt] = waves.slowest;
  }

  template <int D, Plane P>
  KOKKOS_FORCEINLINE_FUNCTION static bool stress(const Properties& m, double* F, double* tau, double*)
  {
    double e[symmetricSize<D>];
    doubledStrain<D>(F, e);
    // Without a branch, for the same reason as below.
    bool good = (P == Plane::Stress ? planeDeterminant(F) : determinant<D>(F)) > 0.0;
    if constexpr (P == Plane::Stress)
    {
      const double square =
          1.0 - m.own[at<2>(0, 3)] * e[0] - m.own[at<2>(1, 3)] * e[1] - 2.0 * m.own[at<2>(2, 3)] * e[2];
      good = good && square > 0.0;
      F[4] = good ? std::sqrt(square) : F[4];
    }
    double S[symmetricSize<D>], pushed[symmetricSize<D>];
    secondStress<D, P>(m, e, S);
    pushForward<D>(F, S, pushed);
    for (int i = 0; i < symmetricSize<D>; ++i)
      tau[i] = good ? pushed[i] : 0.0;
    return good;
  }

  template <int D, Plane P>
  KOKKOS_FORCEINLINE_FUNCTION static double energy(const Properties& m, const double* F, const double*)
  {
    double e[symmetricSize<D>], S[symmetricSize<D>];
    doubledStrain<D>(F, e);
    secondStress<D, P>(m, e, S);
    return 0.25 * contraction<D>(S, e);
  }

  /// rho0 c^2 = n.tau n + (F^T m F^T n) : C : (F^T m F^T n): at most the largest stress plus the square of
  /// the largest eigenvalue of b times the largest (m n) : C : (m n), which is that of the fastest wave at
  /// F = 1.
  template <int D, Plane P>
  KOKKOS_FORCEINLINE_FUNCTION static double waveSpeed(const Properties& m, const double* F, const double*)
  {
    double e[symmetricSize<D>], S[symmetricSize<D>], tau[symmetricSize<D>];
    doubledStrain<D>(F, e);
    secondStress<D, P>(m, e, S);
    pushForward<D>(F, S, tau);
    leftStrain<D>(F, e);
    const double b = 1.0 + directionalRange<D>(e).largest;
    return speedOf(directionalRange<D>(tau).largest + m.own[fastestAt] * b * b, m.density);
  }

private:
  template <int D>
  static void store(const Stiffness& C, Properties& m)
  {
    constexpr int inPlane[4] = {0, 1, 3, 2}; // xx, yy, xy, zz
    for (int i = 0; i < symmetricSize<D>; ++i)
      for (int j = i; j < symmetricSize<D>; ++j)
        m.own[at<D>(i, j)] = D == 2 ? C[inPlane[i]][inPlane[j]] : C[i][j];
  }

  /// 2 E = F^T F - 1.
  template <int D>
  KOKKOS_FORCEINLINE_FUNCTION static void doubledStrain(const double* F, double* e)
  {
    if constexpr (D == 2)
    {
      const double turned[5] = {F[0], F[2], F[1], F[3], F[4]};
      leftStrain<2>(turned, e);
    }
    else
    {
      const double turned[9] = {F[0], F[3], F[6], F[1], F[4], F[7], F[2], F[5], F[8]};
      leftStrain<3>(turned, e);
    }
  }

  /// S from 2 E [Pa]; in plane stress without zz. Written out, so that the compiler can find the stress of
  /// several particles at once.
  template <int D, Plane P>
  KOKKOS_FORCEINLINE_FUNCTION static void secondStress(const Properties& m, const double* e, double* S)
  {
    const double* const C = m.own;
    const double x = 0.5 * e[0], y = 0.5 * e[1];
    if constexpr (D == 2)
    {
      const double z = P == Plane::Stress ? 0.0 : 0.5 * e[3], s = e[2];
      S[0] = C[0] * x + C[1] * y + C[2] * s;
      S[1] = C[1] * x + C[4] * y + C[5] * s;
      S[2] = C[2] * x + C[5] * y + C[7] * s;
      S[3] = 0.0;
      if constexpr (P != Plane::Stress)
      {
        S[3] = C[3] * x + C[6] * y + C[8] * s + C[9] * z;
        S[0] += C[3] * z;
        S[1] += C[6] * z;
        S[2] += C[8] * z;
      }
    }
    else
    {
      const double z = 0.5 * e[2], s = e[3], t = e[4], u = e[5];
      S[0] = C[0] * x + C[1] * y + C[2] * z + C[3] * s + C[4] * t + C[5] * u;
      S[1] = C[1] * x + C[6] * y + C[7] * z + C[8] * s + C[9] * t + C[10] * u;
      S[2] = C[2] * x + C[7] * y + C[11] * z + C[12] * s + C[13] * t + C[14] * u;
      S[3] = C[3] * x + C[8] * y + C[12] * z + C[15] * s + C[16] * t + C[17] * u;
      S[4] = C[4] * x + C[9] * y + C[13] * z + C[16] * s + C[18] * t + C[19] * u;
      S[5] = C[5] * x + C[10] * y + C[14] * z + C[17] * s + C[19] * t + C[20] * u;
    }
  }
};

} // namespace Rhegma
