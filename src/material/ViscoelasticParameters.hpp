#pragma once
/// Parameters of the law Viscoelastic: their description in a scene, and their reading.

#include "material/LawParameters.hpp"
#include "material/MaxwellElements.hpp"
#include "material/TimeShift.hpp"

#include <vector>

namespace Rhegma
{

/// Indices in Properties::own of the law Viscoelastic.
namespace PronyNumber
{
enum
{
  shear = 0,                      ///< shear modulus of each element [Pa]
  bulk = shear + maxwellElements, ///< bulk modulus of each element [Pa]
  time = bulk + maxwellElements,  ///< relaxation time of each element at the shift temperature [s]
  count = time + maxwellElements, ///< of elements
  longShear,                      ///< shear modulus after relaxation [Pa]
  longBulk,                       ///< bulk modulus after relaxation [Pa]
  volumetric,                     ///< 1 where the bulk modulus relaxes, else 0
  shift,                          ///< the first ShiftNumber
  size = shift + ShiftNumber::size
};
static_assert(size <= lawNumbers);
} // namespace PronyNumber

/// Elasticity at once, and how the shear modulus relaxes.
template <class Section>
void describeRelaxation(Section& s)
{
  describeDensity(s);
  s.real("Young Modulus").unit("Pa").positive().meaning("Young's modulus at once, before relaxation.");
  s.real("Poisson Ratio").above(-1.0).below(0.5).meaning("Poisson's ratio at once, before relaxation.");
  s.realArray("Relaxation Times")
      .unit("s")
      .meaning("Relaxation time of each term of the Prony series; up to 5 terms.");
  s.realArray("Shear Fractions")
      .meaning(
          "Fraction of the shear modulus that relaxes with each time: G(t) / G(0) = 1 - sum g (1 - exp(-t / "
          "time)). Not negative; their sum is at most 1.");
}

/// How relaxation times depend on temperature, and heat of what is dissipated.
template <class Section>
void describeTimeShift(Section& s)
{
  s.choice("Time Shift", {"None", "Williams-Landel-Ferry", "Arrhenius"})
      .byDefault("None")
      .meaning("How relaxation times depend on temperature.");
  s.real("Shift Temperature")
      .unit("K")
      .positive()
      .optional("Reference Temperature")
      .meaning("Temperature at which Relaxation Times are given.");
  s.real("WLF C1").positive().optional().meaning(
      "C1 of log10 a = -C1 (T - Shift Temperature) / (C2 + T - Shift Temperature).");
  s.real("WLF C2").unit("K").temperatureDifference().positive().optional().meaning("C2 of it.");
  s.real("Activation Temperature")
      .unit("K")
      .temperatureDifference()
      .positive()
      .optional()
      .meaning("Activation energy over the gas constant: ln a = B (1/T - 1/Shift Temperature).");
  s.real("Plastic Heat Fraction")
      .range(0.0, 1.0)
      .byDefault(1.0)
      .meaning("Fraction of the dissipated work that becomes heat. Used with the section Thermal.");
  s.allOrNoneOf({"WLF C1", "WLF C2"});
}

template <class Section>
void describeViscoelasticity(Section& s)
{
  describeRelaxation(s);
  s.realArray("Bulk Fractions")
      .optional("all 0")
      .meaning("The same for the bulk modulus. Their sum must be below 1.");
  describeTimeShift(s);
}

namespace detail
{

/// Fractions of one modulus, one for each relaxation time. \param open whether their sum must be below one
template <class Reader>
std::vector<double> readFractions(const Reader& reader, const std::string& name, std::size_t count, bool open)
{
  std::vector<double> values = reader.numbers(name);
  if (values.empty())
    values.assign(count, 0.0);
  if (values.size() != count)
    reader.refuse(name, "has " + std::to_string(values.size()) + " numbers, but Relaxation Times has " +
                            std::to_string(count) + "; give one for each term.");
  double sum = 0.0;
  for (const double value : values)
  {
    if (!(value >= 0.0))
      reader.refuse(name, "has " + Reader::text(value) + "; every fraction must be >= 0.");
    sum += value;
  }
  constexpr double rounding = 1.0e-12;
  if (open ? !(sum < 1.0) : !(sum <= 1.0 + rounding))
    reader.refuse(name, "has the sum " + Reader::text(sum) + "; the sum of the fractions must be " +
                            (open ? "< 1, since a solid resists compression for good."
                                  : "<= 1, since the modulus after relaxation can't be negative."));
  return values;
}

/// Relaxation times, 1 to maxwellElements.
template <class Reader>
std::vector<double> readTimes(const Reader& reader)
{
  std::vector<double> times = reader.numbers("Relaxation Times");
  if (times.empty() || times.size() > maxwellElements)
    reader.refuse("Relaxation Times", "has " + std::to_string(times.size()) + " numbers; give 1 to " +
                                          std::to_string(maxwellElements) + " relaxation times [s].");
  for (const double t : times)
    if (!(t > 0.0))
      reader.refuse("Relaxation Times", "has " + Reader::text(t) + "; every time must be > 0 s.");
  return times;
}

} // namespace detail

/// Sets the numbers that `inverseTimeShift` needs. \param numbers ShiftNumber of them, in Properties::own
template <class Reader>
void readTimeShift(const Reader& reader, Properties& m, double* numbers)
{
  using namespace ShiftNumber;
  numbers[reference] = reader.has("Shift Temperature")
                           ? reader.positive("Shift Temperature", "temperature [K]")
                           : m.temperature;
  const std::string kind = reader.choice("Time Shift", "None");
  const bool hasWlf = reader.has("WLF C1") || reader.has("WLF C2");
  if (hasWlf && kind != "Williams-Landel-Ferry")
    reader.refuse("Time Shift", "is " + kind +
                                    ", and WLF C1 or C2 is given; write Williams-Landel-Ferry, or "
                                    "remove them.");
  if (reader.has("Activation Temperature") && kind != "Arrhenius")
    reader.refuse("Time Shift", "is " + kind +
                                    ", and Activation Temperature is given; write Arrhenius, or "
                                    "remove it.");
  if (kind == "Williams-Landel-Ferry")
  {
    numbers[shift] = ShiftKind::williamsLandelFerry;
    numbers[first] = reader.positive("WLF C1", "constant");
    numbers[second] = reader.positive("WLF C2", "constant [K]");
    if (!(m.temperature > numbers[reference] - numbers[second]))
      reader.refuse("WLF C2", "is " + Reader::text(numbers[second]) +
                                  " K: the shift of Williams, Landel and " +
                                  "Ferry holds for Reference Temperature = " + Reader::text(m.temperature) +
                                  " K > Shift Temperature - WLF C2 = " +
                                  Reader::text(numbers[reference] - numbers[second]) + " K only.");
  }
  else if (kind == "Arrhenius")
  {
    numbers[shift] = ShiftKind::arrhenius;
    numbers[first] = reader.positive("Activation Temperature", "activation energy over the gas constant [K]");
  }
  else if (kind != "None")
    reader.refuse("Time Shift", "is \"" + kind + "\"; write None, Williams-Landel-Ferry or Arrhenius.");
}

template <class Reader>
void readViscoelasticity(const Reader& reader, Properties& m)
{
  using namespace PronyNumber;
  readElasticity(reader, -1.0, m);
  const std::vector<double> times = detail::readTimes(reader);
  const std::vector<double> g = detail::readFractions(reader, "Shear Fractions", times.size(), false);
  const std::vector<double> k = detail::readFractions(reader, "Bulk Fractions", times.size(), true);
  m.own[count] = static_cast<double>(times.size());
  m.own[longShear] = m.mu;
  m.own[longBulk] = m.bulk;
  for (std::size_t i = 0; i < times.size(); ++i)
  {
    m.own[shear + i] = g[i] * m.mu;
    m.own[bulk + i] = k[i] * m.bulk;
    m.own[time + i] = times[i];
    m.own[longShear] -= g[i] * m.mu;
    m.own[longBulk] -= k[i] * m.bulk;
    m.own[volumetric] = k[i] > 0.0 ? 1.0 : m.own[volumetric];
  }
  m.own[longShear] = m.own[longShear] > 0.0 ? m.own[longShear] : 0.0;
  readTimeShift(reader, m, m.own + shift);
}

} // namespace Rhegma
