#pragma once
/// Traction-separation laws of faces that hold together, without state.

#include "base/CohesiveLaw.hpp"
#include "base/Types.hpp"

#include <cmath>

namespace Rhegma::cohesive_faces
{

/// How the traction goes on after the linear start.
enum class Shape
{
  Trapezoidal, ///< constant over a part of the rest, then linear to zero; without that part: bilinear
  Exponential  ///< K x exp(-x / d), largest at x = d
};

/// Parts of a law in which it is smooth.
enum class Segment
{
  Elastic,
  Plateau,
  Fall,
  Failed,
  Exponential
};

/// Which part of the law a point is on.
struct Branch
{
  bool open = true;   ///< whether the normal traction is that of open faces
  bool grows = false; ///< whether damage grows with the jump; else the secant fraction stays
  Segment segment = Segment::Elastic;
};

/// Fractions of the energy at which a face counts as failed: an exponential law never ends.
constexpr double failedFraction = 0.999;

/// What the law is at one mode mixity.
struct LawOfMode
{
  double onset = 0.0;   ///< jump at the largest traction, where a plateau starts [m]
  double plateau = 0.0; ///< jump at its end [m]
  double end = 0.0;     ///< jump without traction; not of an exponential law [m]
  double energy = 0.0;  ///< G_c [J/m2]
};

/// Derivatives of `LawOfMode` with respect to the mixity.
struct LawOfModeSlope
{
  double onset = 0.0, plateau = 0.0, end = 0.0, energy = 0.0;
};

/// The jump between two faces, reduced to one number.
struct EffectiveJump
{
  double size = 0.0;   ///< lambda [m]
  double mixity = 0.0; ///< B [-]
};

/// The law of a crack's faces,
///
///     t_n = s Kn <g>,   t_s = s Ks u,
///
/// of opening g and slip u, with one secant fraction s = 1 - d that never grows (damage d does not heal;
/// unloading is to the origin). With the jump and mixity
///
///     lambda^2 = <g>^2 + Ks / Kn u^2,   B = Ks u^2 / (Kn lambda^2) = G_II / (G_I + G_II),
///
/// the work of both tractions is t dlambda, t = s Kn lambda, along any path, and B is constant along a
/// proportional one. So the energy there is the area below t(lambda), which is
///
///     G_c(B) = G_I + (G_II - G_I) B^eta
///
/// (Benzeggagh and Kenane, Compos. Sci. Technol. 56 (1996) 439). The elastic energy at the largest traction
/// follows the same rule from T^2 / 2 Kn to S^2 / 2 Ks (Turon, Camanho, Costa and Davila, Mech. Mater. 38
/// (2006) 1072), so that each law is that of its mode where the jump is of one mode.
///
/// Shapes: bilinear (Camanho and Davila, NASA TM-2002-211737), trapezoidal (Tvergaard and Hutchinson, J.
/// Mech. Phys. Solids 40 (1992) 1377), exponential (Xu and Needleman, J. Mech. Phys. Solids 42 (1994) 1397:
/// in mode I theirs; strength and energy are given, which determine the stiffness).
struct TractionLaw
{
  bool holds = false;         ///< whether the crack has a law
  bool resistsOverlap = true; ///< whether overlapping faces push back with Kn
  Shape shape = Shape::Trapezoidal;
  double normal = 0.0;            ///< Kn [Pa/m]
  double shear = 0.0;             ///< Ks [Pa/m]
  double energy[2] = {0.0, 0.0};  ///< G_I, G_II [J/m2]
  double elastic[2] = {0.0, 0.0}; ///< of the same at the largest traction [J/m2]
  double exponent = 2.0;          ///< eta
  double plateau = 0.0;           ///< part of the jump between onset and end with the largest traction

  /// \param opening g [m] \param slip size of u [m]
  KOKKOS_INLINE_FUNCTION EffectiveJump effective(double opening, double slip) const
  {
    const double g = opening > 0.0 ? opening : 0.0, along = shear / normal * slip * slip;
    const double square = g * g + along;
    return {std::sqrt(square), square > 0.0 ? along / square : 0.0};
  }

  KOKKOS_INLINE_FUNCTION LawOfMode atMixity(double mixity) const
  {
    const double power = std::pow(mixity, exponent);
    LawOfMode mode;
    mode.energy = energy[0] + (energy[1] - energy[0]) * power;
    if (shape == Shape::Exponential)
    {
      mode.onset = mode.plateau = std::sqrt(mode.energy / normal);
      return mode;
    }
    mode.onset = std::sqrt(2.0 * (elastic[0] + (elastic[1] - elastic[0]) * power) / normal);
    const double rest = restOf(mode);
    mode.plateau = mode.onset + plateau * rest;
    mode.end = mode.onset + rest;
    return mode;
  }

  /// Its derivative by the mixity.
  KOKKOS_INLINE_FUNCTION LawOfModeSlope slopeAtMixity(const LawOfMode& mode, double mixity) const
  {
    const double power = exponent * std::pow(mixity, exponent - 1.0);
    LawOfModeSlope slope;
    slope.energy = (energy[1] - energy[0]) * power;
    if (shape == Shape::Exponential)
    {
      slope.onset = slope.plateau = 0.5 * mode.onset * slope.energy / mode.energy;
      return slope;
    }
    slope.onset = (elastic[1] - elastic[0]) * power / (normal * mode.onset);
    const double strength = normal * mode.onset;
    const double rest =
        2.0 / (1.0 + plateau) *
        ((slope.energy - mode.energy * slope.onset / mode.onset) / strength - 0.5 * slope.onset);
    slope.plateau = slope.onset + plateau * rest;
    slope.end = slope.onset + rest;
    return slope;
  }

  /// The segment on which damage grows at a jump. \param size lambda [m]
  KOKKOS_INLINE_FUNCTION Segment segmentAt(const LawOfMode& mode, double size) const
  {
    if (shape == Shape::Exponential)
      return Segment::Exponential;
    if (size <= mode.onset)
      return Segment::Elastic;
    if (size <= mode.plateau)
      return Segment::Plateau;
    return size < mode.end ? Segment::Fall : Segment::Failed;
  }

  /// Secant fraction on a segment, also beyond its ends [-].
  KOKKOS_INLINE_FUNCTION double secantOn(Segment segment, const LawOfMode& mode, double size) const
  {
    switch (segment)
    {
    case Segment::Elastic:
      return 1.0;
    case Segment::Plateau:
      return mode.onset / size;
    case Segment::Fall:
      return fallOf(mode).falling(size) / normal;
    case Segment::Exponential:
      return std::exp(-size / mode.onset);
    default:
      return 0.0;
    }
  }

  /// Secant fraction where the jump grows [-].
  KOKKOS_INLINE_FUNCTION double secant(const LawOfMode& mode, double size) const
  {
    return secantOn(segmentAt(mode, size), mode, size);
  }

  /// Its derivative by lambda on a segment [1/m].
  KOKKOS_INLINE_FUNCTION double secantBySize(Segment segment, const LawOfMode& mode, double size) const
  {
    switch (segment)
    {
    case Segment::Plateau:
      return -mode.onset / (size * size);
    case Segment::Fall:
      return -mode.onset * mode.end / ((mode.end - mode.plateau) * size * size);
    case Segment::Exponential:
      return -std::exp(-size / mode.onset) / mode.onset;
    default:
      return 0.0;
    }
  }

  /// Its derivative by the mixity on a segment.
  KOKKOS_INLINE_FUNCTION double secantByMixity(Segment segment, const LawOfMode& mode,
                                               const LawOfModeSlope& slope, double size) const
  {
    const double length = mode.end - mode.plateau, left = mode.end - size;
    switch (segment)
    {
    case Segment::Plateau:
      return slope.onset / size;
    case Segment::Fall:
      return (slope.onset * left + mode.onset * slope.end -
              mode.onset * left * (slope.end - slope.plateau) / length) /
             (length * size);
    case Segment::Exponential:
      return std::exp(-size / mode.onset) * size * slope.onset / (mode.onset * mode.onset);
    default:
      return 0.0;
    }
  }

  /// Fraction of G_c that is dissipated once the secant fraction has fallen to s at a mixity.
  KOKKOS_INLINE_FUNCTION double dissipated(const LawOfMode& mode, double s) const
  {
    if (!(s > 0.0))
      return 1.0;
    if (shape == Shape::Exponential)
    {
      const double x = -std::log(s); // the area up to x, less the triangle of unloading
      return 1.0 - s * (1.0 + x + 0.5 * x * x);
    }
    if (s >= 1.0)
      return 0.0;
    const double onPlateau = mode.onset / s; // the jump there
    const double strength = normal * mode.onset;
    if (onPlateau <= mode.plateau)
      return 0.5 * strength * (onPlateau - mode.onset) / mode.energy;
    const double length = mode.end - mode.plateau;
    const double size = strength * mode.end / (s * normal * length + strength);
    return 1.0 - 0.5 * s * normal * size * mode.end / mode.energy;
  }

  /// Whether the traction has passed its largest value, where the plateau starts.
  KOKKOS_INLINE_FUNCTION bool isDamaged(double s) const
  {
    return shape == Shape::Exponential ? s < 0.36787944117144233 : s < 1.0;
  }

  /// Largest stiffness [Pa/m].
  KOKKOS_INLINE_FUNCTION double stiffest() const { return normal > shear ? normal : shear; }

private:
  /// Jump between onset and end, by the area.
  KOKKOS_INLINE_FUNCTION double restOf(const LawOfMode& mode) const
  {
    return 2.0 / (1.0 + plateau) * (mode.energy / (normal * mode.onset) - 0.5 * mode.onset);
  }
  /// The linear fall to zero, per area: that of new faces, without an elastic start.
  KOKKOS_INLINE_FUNCTION CohesiveLaw fallOf(const LawOfMode& mode) const
  {
    return {normal * mode.onset, mode.end - mode.plateau, mode.plateau};
  }
};

/// Tractions and damage at a point, D - 1 tangents.
template <int D>
struct Cohesion
{
  double tension = 0.0;        ///< normal traction, negative where faces press [Pa]
  Vector<D - 1> shear{};       ///< that holds back side +1, along the tangents [Pa]
  double secant = 1.0;         ///< s
  double spent = 0.0;          ///< fraction of G_c that is dissipated
  double lost[2] = {0.0, 0.0}; ///< dissipated since, by opening and by slip [J/m2]
  bool presses = false;        ///< whether it is on the branch of faces that press
};

/// The branch of the law at a jump. \param gap opening [m] \param slip of side +1 against side -1 [m]
/// \param secant so far
template <int D>
KOKKOS_INLINE_FUNCTION Branch branchAt(const TractionLaw& law, double gap, const Vector<D - 1>& slip,
                                       double secant)
{
  Branch branch;
  branch.open = gap >= 0.0;
  const EffectiveJump jump = law.effective(gap, norm(slip));
  if (!(jump.size > 0.0) || !(secant > 0.0))
    return branch;
  const LawOfMode mode = law.atMixity(jump.mixity);
  branch.segment = law.segmentAt(mode, jump.size);
  branch.grows = law.secantOn(branch.segment, mode, jump.size) < secant;
  return branch;
}

/// The law at a point on a branch, which is that of `branchAt` or goes on beyond its ends. \param
/// secant,spent so far
template <int D>
KOKKOS_INLINE_FUNCTION Cohesion<D> cohesionOn(const Branch& branch, const TractionLaw& law, double gap,
                                              const Vector<D - 1>& slip, double secant, double spent)
{
  Cohesion<D> now;
  now.secant = secant;
  now.spent = spent;
  now.presses = !branch.open;
  const EffectiveJump jump = law.effective(gap, norm(slip));
  if (branch.grows && jump.size > 0.0)
  {
    const LawOfMode mode = law.atMixity(jump.mixity);
    now.secant = law.secantOn(branch.segment, mode, jump.size);
    const double lost = law.dissipated(mode, now.secant);
    now.spent = lost > spent ? lost : spent;
    now.lost[0] = (1.0 - jump.mixity) * mode.energy * (now.spent - spent);
    now.lost[1] = jump.mixity * mode.energy * (now.spent - spent);
  }
  now.tension = branch.open ? now.secant * law.normal * gap : law.resistsOverlap ? law.normal * gap : 0.0;
  now.shear = now.secant * law.shear * slip;
  return now;
}

/// The law at a point.
template <int D>
KOKKOS_INLINE_FUNCTION Cohesion<D> cohesionAt(const TractionLaw& law, double gap, const Vector<D - 1>& slip,
                                              double secant, double spent)
{
  return cohesionOn<D>(branchAt<D>(law, gap, slip, secant), law, gap, slip, secant, spent);
}

/// Derivative of the tractions (tension, shear) by the jump (gap, slip) on a branch [Pa/m]; unsymmetric where
/// damage grows and the energy depends on the mode. \param now of cohesionOn
template <int D>
KOKKOS_INLINE_FUNCTION void stiffnessAt(const Branch& branch, const TractionLaw& law, double gap,
                                        const Vector<D - 1>& slip, const Cohesion<D>& now, double (&C)[D][D])
{
  const double open = gap > 0.0 ? gap : 0.0;
  double ratio[D], at[D];
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j)
      C[i][j] = 0.0;
  for (int i = 0; i < D; ++i)
  {
    ratio[i] = i == 0 ? 1.0 : law.shear / law.normal;
    at[i] = i == 0 ? open : slip[i > 0 ? i - 1 : 0];
    C[i][i] = now.secant * ratio[i] * law.normal;
  }
  if (!branch.open)
    C[0][0] = law.resistsOverlap ? law.normal : 0.0;
  const EffectiveJump jump = law.effective(gap, norm(slip));
  if (!branch.grows || !(jump.size > 0.0))
    return;
  const LawOfMode mode = law.atMixity(jump.mixity);
  const LawOfModeSlope slope = law.slopeAtMixity(mode, jump.mixity);
  const double bySize = law.secantBySize(branch.segment, mode, jump.size);
  const double byMixity = law.secantByMixity(branch.segment, mode, slope, jump.size);
  for (int j = 0; j < D; ++j)
  {
    const double part = ratio[j] * at[j] / jump.size; // of lambda
    const double turn = 2.0 * part / jump.size * (j == 0 ? -jump.mixity : 1.0 - jump.mixity);
    const double change = bySize * part + byMixity * turn;
    for (int i = 0; i < D; ++i)
      C[i][j] += ratio[i] * law.normal * at[i] * change;
  }
}

} // namespace Rhegma::cohesive_faces
