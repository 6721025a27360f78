#pragma once
/// One step of the law ViscoSCRAM (ViscoScram.hpp has its equations).

#include "material/ViscoScramParameters.hpp"

namespace Rhegma
{

/// The elements over one step.
struct ScramElements : MaxwellSteps<maxwellElements>
{
  KOKKOS_INLINE_FUNCTION ScramElements(const Properties& m, double dt, double temperature)
      : MaxwellSteps(m.own[ScramNumber::count], m.own + ScramNumber::time, m.own + ScramNumber::shift, dt,
                     temperature)
  {
  }
};

/// (c/a)^3 / (2 G), the compliance that cracks of a radius add to that of shear, 1 / (2 G) [1/Pa].
KOKKOS_INLINE_FUNCTION double crackCompliance(const Properties& m, double radius)
{
  const double ratio = radius / m.own[ScramNumber::scale];
  return ratio * ratio * ratio / (2.0 * m.mu);
}

/// S and E from Eb and e_i. \param compliance of the cracks [1/Pa] \param history starts with the e_i
template <int D>
KOKKOS_INLINE_FUNCTION void crackedStress(const Properties& m, const double* Eb, const double* history,
                                          double compliance, double* S, double* E)
{
  using namespace ScramNumber;
  const double twice = 2.0 * m.own[longShear];
  for (int k = 0; k < symmetricSize<D>; ++k)
  {
    double sum = twice * Eb[k];
    for (int i = 0; i < maxwellElements; ++i)
      sum += 2.0 * m.own[shear + i] * history[i * symmetricSize<D> + k];
    S[k] = sum / (1.0 + twice * compliance);
    E[k] = Eb[k] - compliance * S[k];
  }
}

/// The stress along a step in which Eb goes straight from its start to its end. Up to each instant the strain
/// E of the elements counts as one of constant rate, so that with H = 2 mu + sum 2 G_i gain_i
///
///     S = (2 mu E0 + sum 2 G_i (1 - loss_i) e_i + H (Eb - Eb0 + x0 S0)) / (1 + H x),
///
/// x the compliance of the cracks then, and 0 marking the start. This holds for steps of any length; its
/// error is of second order in the step over the whole path, and none where E has a constant rate.
template <int D>
class ScramStep
{
public:
  /// \param history e_i at the start; must live as long \param radius of the cracks at the start [m]
  KOKKOS_INLINE_FUNCTION ScramStep(const ScramElements& elements, const Properties& m,
                                   const IsochoricStrain<D>& start, const double* history, double radius)
      : elements_(elements),
        m_(m),
        start_(start),
        elastic_(history),
        radius_(radius),
        compliance_(crackCompliance(m, radius))
  {
    crackedStress<D>(m, start.E, history, compliance_, stress_, strain_);
    last_ = partAt(1.0);
  }

  KOKKOS_INLINE_FUNCTION void endAt(const IsochoricStrain<D>& now)
  {
    J_ = now.J;
    for (int k = 0; k < symmetricSize<D>; ++k)
      change_[k] = now.E[k] - start_.E[k];
  }

  /// Radius of the cracks at the end [m].
  KOKKOS_INLINE_FUNCTION double radiusAfter(double dt) const
  {
    return crackGrowth(m_).radiusAfter(radius_, dt,
                                       [this](double at, double radius) { return driveAt(at, radius); });
  }

  /// \param radius at the end \param history its e_i become those at the end \param S at the end
  /// \return what the elements and the cracks dissipate [J/m3]
  KOKKOS_INLINE_FUNCTION double finish(double radius, double* history, double* S) const
  {
    constexpr int n = symmetricSize<D>;
    const double compliance = crackCompliance(m_, radius);
    stressAt(last_, 1.0, compliance, S);
    double change[n];
    for (int k = 0; k < n; ++k)
      change[k] = change_[k] + compliance_ * stress_[k] - compliance * S[k];
    // (S0:S0 + S0:S + S:S) / 3, the mean of S:S on a straight line, is not negative.
    double lost = (compliance - compliance_) / 6.0 *
                  (squaredNorm<D>(stress_) + contraction<D>(stress_, S) + squaredNorm<D>(S));
    const double square = squaredNorm<D>(change);
    for (int i = 0; i < elements_.count; ++i)
    {
      double* const e = history + i * n;
      const MaxwellStep& at = elements_.step[i];
      lost += m_.own[ScramNumber::shear + i] *
              at.dissipated(squaredNorm<D>(e), contraction<D>(e, change), square);
      for (int k = 0; k < n; ++k)
        e[k] = (1.0 - at.loss) * e[k] + at.gain * change[k];
    }
    return lost;
  }

  /// Thickness stretch of plane stress with cracks of a radius at the end. \param F in the plane; F[4] is
  /// where the search starts
  KOKKOS_INLINE_FUNCTION double thicknessStretch(const double* F, double radius) const
  {
    constexpr double widest = 1.0e3;
    const double H = last_.modulus, part = 1.0 / (1.0 + H * crackCompliance(m_, radius));
    ThicknessStress at{F[0] * F[0] + F[2] * F[2],
                       F[1] * F[1] + F[3] * F[3],
                       F[0] * F[1] + F[2] * F[3],
                       planeDeterminant(F),
                       {},
                       0.5 * H * part,
                       m_.bulk,
                       0.0,
                       0.0};
    for (int k = 0; k < 4; ++k)
      at.R[k] = part * (last_.stress[k] - H * start_.E[k]);
    return thicknessRoot(at, 1.0 / widest, widest, F[4]);
  }

private:
  /// The numerator of S without the change of Eb, and H, at a fraction of the step.
  struct Part
  {
    double stress[symmetricSize<D>];
    double modulus;
  };

  KOKKOS_INLINE_FUNCTION Part partAt(double fraction) const
  {
    using namespace ScramNumber;
    constexpr int n = symmetricSize<D>;
    Part part;
    part.modulus = 2.0 * m_.own[longShear];
    for (int k = 0; k < n; ++k)
      part.stress[k] = part.modulus * strain_[k];
    for (int i = 0; i < elements_.count; ++i)
    {
      const MaxwellStep& whole = elements_.step[i];
      const MaxwellStep at = fraction < 1.0 ? maxwellStep(fraction * whole.loss / whole.gain) : whole;
      const double twice = 2.0 * m_.own[shear + i], keep = twice * (1.0 - at.loss);
      part.modulus += twice * at.gain;
      for (int k = 0; k < n; ++k)
        part.stress[k] += keep * elastic_[i * n + k];
    }
    for (int k = 0; k < n; ++k)
      part.stress[k] += part.modulus * compliance_ * stress_[k];
    return part;
  }

  KOKKOS_INLINE_FUNCTION void stressAt(const Part& part, double fraction, double compliance, double* S) const
  {
    const double all = 1.0 / (1.0 + part.modulus * compliance);
    for (int k = 0; k < symmetricSize<D>; ++k)
      S[k] = all * (part.stress[k] + part.modulus * fraction * change_[k]);
  }

  /// What drives cracks of a radius at a fraction of the step.
  KOKKOS_INLINE_FUNCTION CrackDrive driveAt(double fraction, double radius) const
  {
    double S[symmetricSize<D>], C[symmetricSize<D>];
    if (fraction > 0.0)
      stressAt(fraction < 1.0 ? partAt(fraction) : last_, fraction, crackCompliance(m_, radius), S);
    const double* const stress = fraction > 0.0 ? S : stress_;
    for (int k = 0; k < symmetricSize<D>; ++k)
      C[k] = 2.0 * (start_.E[k] + fraction * change_[k]);
    for (int i = 0; i < 3; ++i)
      C[normalIndex<D>(i)] += 1.0;
    const double J = start_.J + fraction * (J_ - start_.J);
    return {deviatorSquared(C, stress) / (J * J), 0.5 * m_.bulk * (J - 1.0) * (J + 1.0) / J};
  }

  /// s:s of the deviator s of F S F^T, from C = F^T F.
  KOKKOS_INLINE_FUNCTION static double deviatorSquared(const double* C, const double* S)
  {
    const double first = contraction<D>(C, S);
    double second = 0.0, M[D][D];
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < D; ++j)
      {
        M[i][j] = 0.0;
        for (int k = 0; k < D; ++k)
          M[i][j] += C[symmetricIndex<D>(i, k)] * S[symmetricIndex<D>(k, j)];
      }
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < D; ++j)
        second += M[i][j] * M[j][i];
    if constexpr (D == 2)
      second += C[3] * S[3] * C[3] * S[3];
    return larger(second - first * first / 3.0, 0.0);
  }

  const ScramElements& elements_;
  const Properties& m_;
  const IsochoricStrain<D>& start_;
  const double* elastic_;
  double radius_, compliance_;
  double stress_[symmetricSize<D>], strain_[symmetricSize<D>]; ///< S and E at the start
  double change_[symmetricSize<D>] = {};                       ///< of Eb
  double J_ = 1.0;                                             ///< at the end
  Part last_;                                                  ///< at the end
};

} // namespace Rhegma
