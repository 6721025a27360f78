#pragma once
/// The slowest motion of bodies, which damping must bring to rest.

#include "boundary/MirrorPlanes.hpp"
#include "plausibility/CrackExtent.hpp"

#include <string>
#include <vector>

namespace Rhegma::damping
{

/// Rate at which a mode of the angular frequency w falls to rest with mass damping r [1/s]: r / 2 up to
/// critical damping r = 2 w; above it the slower of two rates, which falls towards w^2 / r.
double slowRate(double damping, double frequency);

/// Relative compliances of a section with a crack that has no tractions, per thickness: the opening [m] and
/// the rotation [rad] of the two parts against each other under a normal force [N/m] and a moment [N].
struct SectionCompliance
{
  double opening = 0.0;  ///< by the force [m / (N/m)]
  double coupling = 0.0; ///< rotation by the force, opening by the moment [1 / (N/m)]
  double rotation = 0.0; ///< by the moment [rad / N]
};

/// Of an edge crack: the derivatives of the energy, the integral of K^2 / E' over the depth, with K of Tada,
/// Paris and Irwin (The Stress Analysis of Cracks Handbook, sections 2.10 and 2.13) for a strip under tension
/// and bending. \param fraction depth of the crack over the width \param width [m] \param modulus E' [Pa]
SectionCompliance edgeCrack(double fraction, double width, double modulus);

/// Of a crack in the middle of a strip, with K = sigma sqrt(pi a sec(pi a / W)) (Feddersen 1966); it does not
/// rotate.
SectionCompliance middleCrack(double fraction, double modulus);

/// The slowest motion of a body.
struct SlowMotion
{
  double frequency = 0.0; ///< angular [1/s]
  std::string name;       ///< for a message
  bool known = true;      ///< false: the frequency is an upper bound, of a body with a crack in supports
};

/// What holds the bodies of a scene.
struct Holding
{
  std::vector<MirrorPlane> mirrored; ///< planes of symmetry
  bool supported = false;            ///< prescribed velocities
};

/// By its boundaries. \param scene its core
Holding holdingOf(const Teuchos::ParameterList& scene);

/// The slowest motion of a body: without a crack its longest wave, pi c / L. With one the sum of 1 / w^2 of
/// what makes it slow (Dunkerley 1894, a lower bound of the frequency of the sum of compliances):
/// - the two parts that the crack divides, as rigid masses on its compliance: an edge crack opens and the
///   parts rock about the ligament;
/// - the bending of the thinner part next to the crack as a cantilever, 3.52 / sqrt(12) c h / a^2 with a
/// longer by the give of its root (Kanninen 1973), or, with
///   fronts at both ends, as a beam with fixed ends, 22.4 / sqrt(12) c h / a^2 (Timoshenko, Vibration
///   Problems in Engineering, 1928);
/// - the bending of the body as a free beam of length L along the normal and height W, 22.4 / sqrt(12) c W /
///   L^2, with an edge crack;
/// - the longest wave.
/// With several cracks the slowest of them. Where a plane of symmetry is normal to the direction of a front,
/// the crack is half of one with two fronts, or one of two. Supports keep cracks from opening, by as much as
/// their places say: with them the longest wave is given, as a bound.
template <int D>
SlowMotion slowestMotion(const State<D>& state, const BodyMeasure<D>& body, const Holding& holding);

} // namespace Rhegma::damping
