#pragma once
/// Parameters of the law High-Rate Solid: their description in a scene, and their reading.

#include "material/HighRateNumbers.hpp"
#include "material/LawParameters.hpp"

namespace Rhegma
{

template <class Section>
void describeJohnsonCook(Section& s)
{
  s.real("Johnson-Cook A")
      .unit("Pa")
      .positive()
      .optional("no flow")
      .meaning("Yield stress in tension of the unused material at Johnson-Cook Rate and the transition "
               "temperature. "
               "Without it "
               "the material does not flow.");
  s.real("Johnson-Cook B").unit("Pa").notNegative().byDefault(0.0).meaning("Hardening by plastic strain^n.");
  s.real("Johnson-Cook n").positive().byDefault(1.0).meaning("Exponent of the plastic strain.");
  s.real("Johnson-Cook C")
      .notNegative()
      .byDefault(0.0)
      .meaning("Increase of the flow stress, as a fraction, per unit of ln(plastic strain rate / "
               "Johnson-Cook Rate).");
  s.real("Johnson-Cook m")
      .positive()
      .optional("no thermal softening")
      .meaning("Exponent of thermal softening. Needs Melting Temperature and Specific Heat.");
  s.real("Johnson-Cook Rate")
      .unit("1/s")
      .positive()
      .byDefault(1.0)
      .meaning("Plastic strain rate below which the flow stress does not depend on it.");
  s.real("Transition Temperature")
      .unit("K")
      .positive()
      .optional("Reference Temperature")
      .meaning("Temperature below which the flow stress does not depend on temperature.");
  s.real("Melting Temperature")
      .unit("K")
      .positive()
      .optional()
      .meaning("Temperature at which the flow stress vanishes.");
  s.real("Voce Stress")
      .unit("Pa")
      .positive()
      .optional()
      .meaning("Voce hardening, which adds Voce Stress (1 - exp(-Voce Rate x plastic strain)) to A.");
  s.real("Voce Rate").positive().optional().meaning("Rate of Voce hardening.");
  s.allOrNoneOf({"Voce Stress", "Voce Rate"});
  s.allOrNoneOf({"Johnson-Cook m", "Melting Temperature"});
}

template <class Section>
void describeHighRate(Section& s)
{
  describeElasticity(s);
  describeJohnsonCook(s);
  describeHeatOfDissipation(s);
  s.choice("Equation Of State", {"Elastic", "Mie-Grueneisen"})
      .byDefault("Elastic")
      .meaning(
          "Pressure. Elastic: by the bulk modulus. Mie-Grueneisen: by the shock Hugoniot and the internal "
          "energy; the bulk modulus is then Density x Hugoniot Speed^2 instead of that of Young Modulus "
          "and Poisson Ratio, which give the shear modulus.");
  s.real("Hugoniot Speed")
      .unit("m/s")
      .positive()
      .optional()
      .meaning("c0 of the shock speed Us = c0 + s x particle speed. Required with Mie-Grueneisen.");
  s.real("Hugoniot Slope").positive().optional().meaning("s of it. Required with Mie-Grueneisen.");
  s.real("Grueneisen Coefficient")
      .notNegative()
      .optional()
      .meaning("Gamma_0; Gamma / volume is constant. Required with Mie-Grueneisen.");
  s.real("Linear Viscosity")
      .range(0.0, 10.0)
      .byDefault(0.2)
      .meaning("Linear coefficient of artificial bulk viscosity, which acts in compression with "
               "Mie-Grueneisen only.");
  s.real("Quadratic Viscosity")
      .range(0.0, 100.0)
      .byDefault(2.0)
      .meaning("Quadratic coefficient of artificial bulk viscosity.");
  s.allOrNoneOf({"Hugoniot Speed", "Hugoniot Slope", "Grueneisen Coefficient"});
}

template <class Reader>
void readJohnsonCook(const Reader& reader, Properties& m)
{
  using namespace HighRateNumber;
  const auto text = [](double value) { return Reader::text(value); };
  if (!reader.has("Johnson-Cook A"))
  {
    for (const char* other : {"Johnson-Cook B", "Johnson-Cook C", "Johnson-Cook m", "Voce Stress"})
      if (reader.optional(other, "number") > 0.0)
        reader.refuse("Johnson-Cook A",
                      std::string("is missing, and ") + other + " is given; give the yield stress [Pa] too.");
    return;
  }
  m.own[yield] = reader.positive("Johnson-Cook A", "yield stress [Pa]");
  m.own[hardening] = reader.optional("Johnson-Cook B", "hardening [Pa]");
  m.own[exponent] = reader.has("Johnson-Cook n") ? reader.positive("Johnson-Cook n", "exponent") : 1.0;
  m.own[rate] = reader.optional("Johnson-Cook C", "coefficient of the rate");
  m.own[referenceRate] =
      reader.has("Johnson-Cook Rate") ? reader.positive("Johnson-Cook Rate", "strain rate [1/s]") : 1.0;
  m.own[saturation] = reader.optional("Voce Stress", "stress [Pa]");
  m.own[saturationRate] = reader.optional("Voce Rate", "rate");
  if ((m.own[saturation] > 0.0) != (m.own[saturationRate] > 0.0))
    reader.refuse(m.own[saturation] > 0.0 ? "Voce Rate" : "Voce Stress",
                  "is missing; give both Voce Stress and Voce Rate, or neither.");
  if (!reader.has("Johnson-Cook m"))
    return;
  m.own[softening] = reader.positive("Johnson-Cook m", "exponent");
  m.own[transition] = reader.has("Transition Temperature")
                          ? reader.positive("Transition Temperature", "temperature [K]")
                          : m.temperature;
  m.own[meltTemperature] = reader.positive("Melting Temperature", "temperature [K]");
  if (!(m.own[meltTemperature] > m.own[transition]))
    reader.refuse("Melting Temperature", "is " + text(m.own[meltTemperature]) +
                                             " K; give Melting Temperature > " +
                                             "Transition Temperature = " + text(m.own[transition]) + " K.");
  if (!(m.own[heatCapacity] > 0.0))
    reader.refuse("Specific Heat", "is missing; thermal softening (Johnson-Cook m) follows from the heat of "
                                   "plastic work, which needs it [J/(kg K)].");
}

template <class Reader>
void readHighRate(const Reader& reader, Properties& m)
{
  using namespace HighRateNumber;
  const auto text = [](double value) { return Reader::text(value); };
  readElasticity(reader, -1.0, m);
  if (reader.has("Specific Heat"))
    m.own[heatCapacity] = m.density * reader.positive("Specific Heat", "specific heat [J/(kg K)]");
  m.own[heatFraction] =
      reader.has("Plastic Heat Fraction") ? reader.zeroOrMore("Plastic Heat Fraction", "fraction") : 0.9;
  readJohnsonCook(reader, m);
  const std::string state = reader.choice("Equation Of State", "Elastic");
  if (state == "Elastic")
    return;
  if (state != "Mie-Grueneisen")
    reader.refuse("Equation Of State", "is \"" + state + "\"; write Elastic or Mie-Grueneisen.");
  if (m.plane == Plane::Stress)
    reader.refuse("Equation Of State", "is Mie-Grueneisen, which is for shocks, and these are not in plane "
                                       "stress; write Domain > Plane = Strain, or Elastic here.");
  const double speed = reader.positive("Hugoniot Speed", "speed [m/s]");
  m.own[hugoniotSlope] = reader.positive("Hugoniot Slope", "slope s of Us = c0 + s up");
  m.own[grueneisen] = reader.zeroOrMore("Grueneisen Coefficient", "coefficient");
  if (!(m.own[grueneisen] < 2.0 * m.own[hugoniotSlope]))
    reader.refuse("Grueneisen Coefficient",
                  "is " + text(m.own[grueneisen]) + "; give Grueneisen Coefficient < 2 Hugoniot Slope = " +
                      text(2.0 * m.own[hugoniotSlope]) +
                      ", since the pressure of strong compression would be negative beyond it.");
  m.own[linearViscosity] =
      reader.has("Linear Viscosity") ? reader.zeroOrMore("Linear Viscosity", "coefficient") : 0.2;
  m.own[quadraticViscosity] =
      reader.has("Quadratic Viscosity") ? reader.zeroOrMore("Quadratic Viscosity", "coefficient") : 2.0;
  m.bulk = m.density * speed * speed;
  m.lambda = m.bulk - 2.0 / 3.0 * m.mu;
}

} // namespace Rhegma
