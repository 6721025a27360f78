#pragma once
/// Parameters of the law ViscoSCRAM: their description in a scene, and their reading.

#include "material/CrackGrowth.hpp"
#include "material/RayleighSpeed.hpp"
#include "material/ViscoelasticParameters.hpp"

namespace Rhegma
{

/// Indices in Properties::own of the law ViscoSCRAM.
namespace ScramNumber
{
enum
{
  shear = 0,                          ///< shear modulus of each element [Pa]
  time = shear + maxwellElements,     ///< relaxation time of each element at the shift temperature [s]
  count = time + maxwellElements,     ///< of elements
  longShear,                          ///< shear modulus after relaxation, without cracks [Pa]
  shift,                              ///< the first ShiftNumber
  radius = shift + ShiftNumber::size, ///< of the cracks at the start [m]
  scale,                              ///< radius at which the cracks double the shear compliance, a [m]
  toughness,                          ///< K0 [Pa m^0.5]
  friction,                           ///< mu' of CrackGrowth
  exponent,                           ///< m
  speed,                              ///< greatest dc/dt [m/s]
  size
};
static_assert(size <= lawNumbers);
} // namespace ScramNumber

KOKKOS_INLINE_FUNCTION CrackGrowth crackGrowth(const Properties& m)
{
  using namespace ScramNumber;
  return {m.own[toughness], m.own[friction], m.own[exponent], m.own[speed]};
}

template <class Section>
void describeScram(Section& s)
{
  describeRelaxation(s);
  describeTimeShift(s);
  s.real("Initial Crack Radius")
      .unit("m")
      .positive()
      .meaning("Mean radius c of the small cracks of the undeformed material. Less than Crack Length Scale.");
  s.real("Crack Length Scale")
      .unit("m")
      .positive()
      .meaning("Radius a at which the cracks double the shear compliance, 1 + (c/a)^3 times that without.");
  s.real("Crack Toughness")
      .unit("Pa m^0.5")
      .positive()
      .meaning("Stress intensity K0 of the small cracks, from which they grow fast without friction.");
  s.real("Crack Friction")
      .notNegative()
      .byDefault(0.0)
      .meaning("Friction coefficient of closed cracks under pressure; below 1.22.");
  s.real("Crack Growth Exponent")
      .atLeast(1.0)
      .meaning("Exponent m of slow growth, dc/dt = Maximum Crack Speed (K / K1)^m.");
  s.real("Maximum Crack Speed")
      .unit("m/s")
      .positive()
      .meaning("Limit of dc/dt; below the speed of Rayleigh waves.");
}

namespace detail
{

template <class Reader>
void readCracks(const Reader& reader, Properties& m)
{
  using namespace ScramNumber;
  m.own[radius] = reader.positive("Initial Crack Radius", "radius [m]");
  m.own[scale] = reader.positive("Crack Length Scale", "length [m]");
  if (!(m.own[radius] < m.own[scale]))
    reader.refuse("Initial Crack Radius",
                  "is " + Reader::text(m.own[radius]) +
                      " m; it must be < Crack Length Scale = " + Reader::text(m.own[scale]) + " m.");
  m.own[toughness] = reader.positive("Crack Toughness", "stress intensity [Pa m^0.5]");
  // E = 9 K G / (3 K + G); (1 - nu^2) / E = (lambda + 2 mu) / (4 mu (lambda + mu)).
  const double energy =
      m.own[toughness] * m.own[toughness] * (m.lambda + 2.0 * m.mu) / (4.0 * m.mu * (m.lambda + m.mu));
  constexpr double surfaceEnergy = 1.0e-3; // of any solid [J/m2]
  if (!(energy >= surfaceEnergy))
    reader.refuse("Crack Toughness",
                  "is " + Reader::text(m.own[toughness]) + " Pa m^0.5: K0^2 (1 - nu^2) / E = " +
                      Reader::text(energy) + " J/m2 must be >= " + Reader::text(surfaceEnergy) +
                      " J/m2, the surface energy of any solid; some published inputs have K0 in kPa m^0.5.");
  const double mu = reader.optional("Crack Friction", "coefficient");
  if (!(2.0 * mu * mu < 3.0))
    reader.refuse("Crack Friction",
                  "is " + Reader::text(mu) + "; 2 mu^2 < 3 must hold: write less than 1.22.");
  m.own[friction] = std::sqrt(22.5 / (3.0 - 2.0 * mu * mu)) * mu;
  m.own[exponent] = reader.positive("Crack Growth Exponent", "exponent");
  m.own[speed] = reader.positive("Maximum Crack Speed", "speed [m/s]");
  Properties solid = m;
  solid.plane = Plane::Solid;
  setPlaneModuli(solid);
  if (const double most = rayleighSpeed(solid); !(m.own[speed] < most))
    reader.refuse("Maximum Crack Speed", "is " + Reader::text(m.own[speed]) + " m/s; it must be < " +
                                             Reader::text(most) +
                                             " m/s, the speed of Rayleigh waves before relaxation.");
}

} // namespace detail

template <class Reader>
void readScram(const Reader& reader, Properties& m)
{
  using namespace ScramNumber;
  readElasticity(reader, -1.0, m);
  const std::vector<double> times = detail::readTimes(reader);
  const std::vector<double> g = detail::readFractions(reader, "Shear Fractions", times.size(), false);
  m.own[count] = static_cast<double>(times.size());
  m.own[longShear] = m.mu;
  for (std::size_t i = 0; i < times.size(); ++i)
  {
    m.own[shear + i] = g[i] * m.mu;
    m.own[time + i] = times[i];
    m.own[longShear] -= g[i] * m.mu;
  }
  m.own[longShear] = m.own[longShear] > 0.0 ? m.own[longShear] : 0.0;
  readTimeShift(reader, m, m.own + shift);
  detail::readCracks(reader, m);
}

} // namespace Rhegma
