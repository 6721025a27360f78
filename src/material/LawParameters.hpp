#pragma once
/// Parameters of several laws: their description in a scene, and their reading. Templates of a Section
/// (scene/Schema.hpp) and of a MaterialReader, so that kernels include neither.

#include "material/Law.hpp"

namespace Rhegma
{

template <class Section>
void describeDensity(Section& s)
{
  s.real("Density").unit("kg/m3").positive().meaning("Density of the undeformed material.");
}

/// Density and the two constants of isotropic elasticity.
template <class Section>
void describeElasticity(Section& s)
{
  describeDensity(s);
  s.real("Young Modulus").orTable().unit("Pa").positive().meaning("Young's modulus at small strain.");
  s.real("Poisson Ratio").orTable().above(-1.0).below(0.5).meaning("Poisson's ratio at small strain.");
}

/// For laws that have `scaleShear`, or no shear moduli of their own.
template <class Section>
void describeEntropic(Section& s)
{
  s.boolean("Entropic")
      .byDefault(false)
      .meaning("If true, the shear modulus is proportional to absolute temperature, as in ideal rubber, "
               "which warms when stretched. Needs the section Thermal.");
}

/// For laws that dissipate.
template <class Section>
void describeHeatOfDissipation(Section& s)
{
  s.real("Plastic Heat Fraction")
      .range(0.0, 1.0)
      .byDefault(0.9)
      .meaning("Fraction of the plastic work that becomes heat (Taylor-Quinney coefficient). Used with the "
               "section Thermal.");
}

/// Sets mu, lambda and bulk from Young's modulus and Poisson's ratio. \param leastPoisson open bound, but for
/// 0
template <class Reader>
void readElasticity(const Reader& reader, double leastPoisson, Properties& m)
{
  const double young = reader.positive("Young Modulus", "Young modulus [Pa]");
  const double poisson = reader.number("Poisson Ratio", "Poisson ratio");
  if (!(poisson > leastPoisson || poisson == 0.0) || !(poisson < 0.5))
    reader.refuse("Poisson Ratio", "is " + Reader::text(poisson) + "; give a number " +
                                       (leastPoisson < 0.0 ? "above -1" : "from 0") +
                                       " and below 0.5 (0.5 is incompressible; use for example 0.49).");
  m.mu = young / (2.0 * (1.0 + poisson));
  m.lambda = 2.0 * m.mu * poisson / (1.0 - 2.0 * poisson);
  m.bulk = young / (3.0 * (1.0 - 2.0 * poisson));
}

} // namespace Rhegma
