#include "damping/SlowMotion.hpp"

#include "base/Numbers.hpp"
#include "base/ReadList.hpp"
#include "base/ShortNumber.hpp"

#include <algorithm>
#include <cmath>

namespace Rhegma::damping
{

namespace
{

constexpr double pi = 3.14159265358979;

/// Deeper cracks leave next to no ligament, and compliances grow without bound.
constexpr double deepest = 0.95;

/// K over sigma sqrt(pi a) in bending, 0.5 % off at any depth. \param x depth over width
double bendingFactor(double x)
{
  const double s = std::sin(0.5 * pi * x);
  return std::sqrt(std::tan(0.5 * pi * x) / (0.5 * pi * x)) * (0.923 + 0.199 * std::pow(1.0 - s, 4)) /
         std::cos(0.5 * pi * x);
}

/// The same in tension.
double tensionFactor(double x)
{
  const double s = std::sin(0.5 * pi * x);
  return std::sqrt(std::tan(0.5 * pi * x) / (0.5 * pi * x)) *
         (0.752 + 2.02 * x + 0.37 * std::pow(1.0 - s, 3)) / std::cos(0.5 * pi * x);
}

/// 1 / w^2 of two free rectangular plates, of the same width and the heights below and above the crack, on
/// the compliance between them: the larger eigenvalue of compliance times reduced masses [s2].
double openingOf(const SectionCompliance& c, double width, double below, double above, double density)
{
  const auto reduced = [](double a, double b) { return a > 0.0 && b > 0.0 ? a * b / (a + b) : 0.0; };
  const auto inertia = [&](double height)
  { return density * width * height * (width * width + height * height) / 12.0; };
  const double mass = reduced(density * width * below, density * width * above),
               turning = reduced(inertia(below), inertia(above));
  const double first = c.opening * mass, second = c.rotation * turning,
               both = c.coupling * c.coupling * mass * turning;
  return 0.5 * (first + second) + std::sqrt(0.25 * (first - second) * (first - second) + both);
}

/// Length of a beam with the stiffness of an arm next to an edge crack [m]: the root of a slender one gives
/// way as on a foundation, 0.64 h (Kanninen 1973); that of a short one is in the compliance of the section.
double lengthOfArm(double depth, double thin)
{
  return depth + 0.64 * thin * std::max(0.0, 1.0 - thin / depth);
}

template <int D>
bool isMirrored(const CrackedSection<D>& section, const std::vector<MirrorPlane>& planes)
{
  return std::any_of(planes.begin(), planes.end(),
                     [&](const MirrorPlane& plane)
                     { return std::fabs(section.direction[plane.axis]) > 0.5; });
}

template <int D>
SlowMotion motionAt(const CrackedSection<D>& section, const BodyMeasure<D>& body, bool mirrored)
{
  const auto square = [](double value) { return value * value; };
  const bool middle = section.atBothEnds || mirrored;
  const double whole = mirrored && !section.atBothEnds ? 2.0 : 1.0; // what is seen is half
  const double width = whole * section.width, depth = whole * section.depth, thin = section.thinner(),
               height = section.below + section.above;
  const double modulus = body.moduli.effectiveModulus, bar = std::sqrt(modulus / body.density);
  const SectionCompliance compliance =
      middle ? middleCrack(section.fraction, modulus) : edgeCrack(section.fraction, width, modulus);
  const double opening = openingOf(compliance, width, section.below, section.above, body.density);
  const double length = middle ? depth : lengthOfArm(depth, thin);
  const double arms = square(length * length * std::sqrt(12.0) / ((middle ? 22.4 : 3.52) * bar * thin));
  const double beam = middle ? 0.0 : square(height * height * std::sqrt(12.0) / (22.4 * bar * width));
  const double wave = square(body.longest / (pi * body.speed));
  const double frequency = 1.0 / std::sqrt(opening + arms + beam + wave);
  if (arms > opening)
    return {frequency, "the bending of arms of " + body.name + ", " + readableLength(thin) + " thick and " +
                           readableLength(depth) + " long, next to its crack"};
  return {frequency, "the opening of the crack of " + readableLength(section.depth) + " in " + body.name +
                         ", " + readableLength(section.width) + " wide"};
}

} // namespace

double slowRate(double damping, double frequency)
{
  const double half = 0.5 * damping, under = half * half - frequency * frequency;
  return under > 0.0 ? frequency * frequency / (half + std::sqrt(under)) : half;
}

SectionCompliance edgeCrack(double fraction, double width, double modulus)
{
  constexpr int intervals = 200;
  const double x = std::min(fraction, deepest), each = x / intervals;
  SectionCompliance sum;
  for (int k = 0; k < intervals; ++k)
  {
    // K = (N F + 6 M / W F') sqrt(pi x / W), and twice the energy is the integral of 2 K^2 / E' W.
    const double at = (k + 0.5) * each, tension = tensionFactor(at),
                 bending = 6.0 / width * bendingFactor(at), weight = 2.0 * pi * at * each / modulus;
    sum.opening += weight * tension * tension;
    sum.coupling += weight * tension * bending;
    sum.rotation += weight * bending * bending;
  }
  return sum;
}

SectionCompliance middleCrack(double fraction, double modulus)
{
  constexpr int intervals = 200;
  const double x = std::min(fraction, deepest), each = x / intervals;
  SectionCompliance sum;
  for (int k = 0; k < intervals; ++k)
  {
    const double at = (k + 0.5) * each;
    sum.opening += pi / modulus * at / std::cos(0.5 * pi * at) * each;
  }
  return sum;
}

Holding holdingOf(const Teuchos::ParameterList& scene)
{
  Holding holding{mirrorPlanes(scene), false};
  if (!scene.isSublist("Boundaries"))
    return holding;
  const Teuchos::ParameterList& boundaries = scene.sublist("Boundaries");
  for (const std::string& name : sublistNames(boundaries))
    holding.supported = holding.supported || boundaries.sublist(name).get<std::string>("Type") == "Velocity";
  return holding;
}

template <int D>
SlowMotion slowestMotion(const State<D>& state, const BodyMeasure<D>& body, const Holding& holding)
{
  SlowMotion slowest{pi * body.speed / body.longest, "the longest wave of " + body.name};
  bool cracked = false;
  if (holding.supported)
  {
    slowest.known = sectionsOf(state, body).empty();
    return slowest;
  }
  for (const CrackedSection<D>& section : sectionsOf(state, body))
  {
    const SlowMotion motion = motionAt(section, body, isMirrored(section, holding.mirrored));
    if (!cracked || motion.frequency < slowest.frequency)
      slowest = motion;
    cracked = true;
  }
  return slowest;
}

template SlowMotion slowestMotion(const State<2>&, const BodyMeasure<2>&, const Holding&);
template SlowMotion slowestMotion(const State<3>&, const BodyMeasure<3>&, const Holding&);

} // namespace Rhegma::damping
