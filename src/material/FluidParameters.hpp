#pragma once
/// Parameters of the law Fluid: their description in a scene, and their reading.

#include "material/FluidStates.hpp"
#include "material/LawParameters.hpp"

namespace Rhegma
{

template <class Section>
void describeFluid(Section& s)
{
  describeDensity(s);
  s.choice("Equation Of State", {"Ideal Gas", "Tait"})
      .meaning("Pressure. Ideal Gas: p J^gamma is constant without heat. Tait: Initial Pressure + Bulk "
               "Modulus / n "
               "(J^-n - 1), such as that of water.");
  s.real("Initial Pressure")
      .unit("Pa")
      .notNegative()
      .optional("of a gas Density x Specific Gas Constant x Reference Temperature; Tait 0")
      .meaning("Pressure of the undeformed fluid.");
  s.real("Specific Gas Constant")
      .unit("J/(kg K)")
      .positive()
      .optional()
      .meaning("Ideal Gas, instead of Initial Pressure; 287 of air.");
  s.real("Heat Capacity Ratio").above(1.0).optional().meaning("gamma. Required with Ideal Gas; 1.4 of air.");
  s.real("Bulk Modulus")
      .unit("Pa")
      .positive()
      .optional()
      .meaning("At J = 1. Required with Tait; 2.2e9 of water.");
  s.real("Tait Exponent").above(1.0).optional("7.15").meaning("n of Tait.");
  s.real("Cut-Off Pressure")
      .unit("Pa")
      .optional("none: the liquid bears tension up to Bulk Modulus / n - Initial Pressure")
      .meaning(
          "Least pressure of Tait, at which voids open in the liquid and close again; 0, or that of vapour.");
  s.real("Viscosity").unit("Pa s").notNegative().byDefault(0.0).meaning("Newton's viscosity; 1e-3 of water.");
  s.real("Linear Viscosity")
      .range(0.0, 10.0)
      .byDefault(0.2)
      .meaning("Linear coefficient of artificial bulk viscosity, which acts in compression.");
  s.real("Quadratic Viscosity")
      .range(0.0, 100.0)
      .byDefault(2.0)
      .meaning("Quadratic coefficient of artificial bulk viscosity.");
}

namespace detail
{

template <class Reader>
void refuseOthers(const Reader& reader, const char* state, std::initializer_list<const char*> others)
{
  for (const char* other : others)
    if (reader.has(other))
      reader.refuse(other,
                    std::string("is not of Equation Of State = ") + state + "; remove one of the two.");
}

template <class Reader>
void readIdealGas(const Reader& reader, Properties& m)
{
  using namespace FluidNumber;
  refuseOthers(reader, "Ideal Gas", {"Bulk Modulus", "Tait Exponent", "Cut-Off Pressure"});
  m.own[state] = static_cast<double>(FluidState::idealGas);
  const bool byConstant = reader.has("Specific Gas Constant");
  if (byConstant && reader.has("Initial Pressure"))
    reader.refuse("Initial Pressure", "and Specific Gas Constant are both given; remove one of the two.");
  m.own[initialPressure] =
      byConstant
          ? m.density * m.temperature * reader.positive("Specific Gas Constant", "gas constant [J/(kg K)]")
          : reader.positive("Initial Pressure", "pressure of the gas at its Density [Pa]");
  m.own[exponent] = reader.number("Heat Capacity Ratio", "ratio of specific heats");
  if (!(m.own[exponent] > 1.0))
    reader.refuse("Heat Capacity Ratio",
                  "is " + Reader::text(m.own[exponent]) + "; give a number above 1, such as 1.4 of air.");
  m.bulk = m.own[exponent] * m.own[initialPressure];
}

template <class Reader>
void readTait(const Reader& reader, Properties& m)
{
  using namespace FluidNumber;
  refuseOthers(reader, "Tait", {"Specific Gas Constant", "Heat Capacity Ratio"});
  m.own[state] = static_cast<double>(FluidState::tait);
  m.bulk = reader.positive("Bulk Modulus", "bulk modulus [Pa]");
  m.own[initialPressure] = reader.optional("Initial Pressure", "pressure [Pa]");
  m.own[exponent] = reader.has("Tait Exponent") ? reader.number("Tait Exponent", "exponent n") : 7.15;
  if (!(m.own[exponent] > 1.0))
    reader.refuse("Tait Exponent",
                  "is " + Reader::text(m.own[exponent]) + "; give a number above 1, such as 7.15 of water.");
  constexpr double none = -1.0e300;
  m.own[cutOff] = reader.has("Cut-Off Pressure") ? reader.number("Cut-Off Pressure", "pressure [Pa]") : none;
  if (m.own[cutOff] > m.own[initialPressure])
    reader.refuse("Cut-Off Pressure", "is " + Reader::text(m.own[cutOff]) + " Pa, above Initial Pressure = " +
                                          Reader::text(m.own[initialPressure]) +
                                          " Pa: the liquid would have voids at the start; give less.");
}

} // namespace detail

template <class Reader>
void readFluid(const Reader& reader, Properties& m)
{
  using namespace FluidNumber;
  const std::string kind = reader.choice("Equation Of State", "");
  if (kind == "Ideal Gas")
    detail::readIdealGas(reader, m);
  else if (kind == "Tait")
    detail::readTait(reader, m);
  else
    reader.refuse("Equation Of State", "is \"" + kind + "\"; write Ideal Gas or Tait.");
  m.own[viscosity] = reader.optional("Viscosity", "viscosity [Pa s]");
  m.own[linearViscosity] =
      reader.has("Linear Viscosity") ? reader.zeroOrMore("Linear Viscosity", "coefficient") : 0.2;
  m.own[quadraticViscosity] =
      reader.has("Quadratic Viscosity") ? reader.zeroOrMore("Quadratic Viscosity", "coefficient") : 2.0;
  m.mu = 0.0;
  m.lambda = m.bulk;
}

} // namespace Rhegma
